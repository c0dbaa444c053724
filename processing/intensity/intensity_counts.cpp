#include "processing/intensity/intensity_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr std::size_t pieces = 8;
constexpr std::size_t floatIntensities = 1 << 16;

/// Counts the places of all voxels with data. If `placeOf(voxel)` is not below `places`, the voxel does not count.
template <typename Value, typename PlaceOf>
std::vector<std::uint64_t> countPlaces(const VoxelArray<Value>& voxels, const std::uint8_t* mask, std::size_t places,
                                       const PlaceOf& placeOf) {
    // Neighbouring voxels often hold one byte, and a count must be stored before it can grow again. So neighbours of
    // bytes count in different tables.
    constexpr std::size_t tables = sizeof(Value) == 1 ? 4 : 1;
    std::array<std::vector<std::uint64_t>, pieces> counted;
    parallelFor(std::size_t{0}, pieces, [&](std::size_t piece) {
        std::vector<std::uint64_t>& counts = counted[piece];
        counts.resize(tables * places);
        const std::size_t begin = voxels.size() / pieces * piece;
        const std::size_t end = piece + 1 < pieces ? begin + voxels.size() / pieces : voxels.size();
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t place = placeOf(voxels[i]);
            if constexpr (!std::is_integral_v<Value>)
                if (place >= places) continue;
            counts[i % tables * places + place] += mask == nullptr || mask[i] != 0 ? 1 : 0;
        }
    });
    std::vector<std::uint64_t> sums(places);
    for (const auto& counts : counted)
        for (std::size_t i = 0; i < counts.size(); ++i) sums[i % places] += counts[i];
    return sums;
}

/// Appends an intensity that is not below the last one.
void append(double intensity, std::uint64_t times, IntensityCounts& counts) {
    if (times == 0) return;
    if (counts.intensities.empty() || counts.intensities.back() < intensity) {
        counts.intensities.push_back(intensity);
        counts.counts.push_back(0);
    }
    counts.counts.back() += times;
    counts.total += times;
}

}  // namespace

IntensityCounts intensityCounts(const Volume& volume) {
    IntensityCounts counts;
    const double white = volume.whiteLevel();
    const std::uint8_t* mask = volume.dataMaskOrNull();
    std::visit(
        [&]<typename Value>(const VoxelArray<Value>& voxels) {
            if constexpr (std::is_integral_v<Value>) {
                const auto times = countPlaces(voxels, mask, std::size_t{std::numeric_limits<Value>::max()} + 1,
                                               [](Value value) { return std::size_t{value}; });
                for (std::size_t value = 0; value < times.size(); ++value)
                    append(std::min(static_cast<double>(value) / white, 1.0), times[value], counts);
            } else {
                constexpr double steps = floatIntensities - 1;
                const auto times = countPlaces(voxels, mask, floatIntensities, [white](Value value) {
                    if (!std::isfinite(value)) return floatIntensities;
                    const double share = std::clamp(static_cast<double>(value) / white, 0.0, 1.0);
                    return static_cast<std::size_t>(std::lround(share * steps));
                });
                for (std::size_t place = 0; place < times.size(); ++place)
                    append(static_cast<double>(place) / steps, times[place], counts);
            }
        },
        volume.voxels());
    return counts;
}

double percentileOf(const IntensityCounts& counts, double percent) {
    if (counts.total == 0) throw std::invalid_argument("percentileOf: no voxel was counted");
    if (!(percent >= 0.0 && percent <= 100.0)) throw std::invalid_argument("percentileOf: it must be 0 to 100 %");
    const double enough = percent * static_cast<double>(counts.total) / 100.0;
    std::uint64_t reached = 0;
    for (std::size_t i = 0; i < counts.counts.size(); ++i) {
        reached += counts.counts[i];
        if (static_cast<double>(reached) >= enough) return counts.intensities[i];
    }
    return counts.intensities.back();
}

}  // namespace echolucent
