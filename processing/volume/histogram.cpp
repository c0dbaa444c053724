#include "processing/volume/histogram.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <variant>
#include <vector>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr std::size_t pieces = 8;

/// Counts the values of whole numbers, as they are stored, of data.
template <typename Value>
std::vector<std::uint64_t> countValues(const VoxelArray<Value>& voxels, const std::uint8_t* mask) {
    constexpr std::size_t values = std::size_t{std::numeric_limits<Value>::max()} + 1;
    // Neighbours often hold one byte, and a count cannot go on before the one before it is stored.
    constexpr std::size_t tables = sizeof(Value) == 1 ? 4 : 1;
    std::array<std::vector<std::uint64_t>, pieces> counted;
    parallelFor(std::size_t{0}, pieces, [&](std::size_t piece) {
        std::vector<std::uint64_t>& counts = counted[piece];
        counts.resize(tables * values);
        const std::size_t begin = voxels.size() / pieces * piece;
        const std::size_t end = piece + 1 < pieces ? begin + voxels.size() / pieces : voxels.size();
        for (std::size_t i = begin; i < end; ++i)
            counts[i % tables * values + voxels[i]] += mask == nullptr || mask[i] != 0 ? 1 : 0;
    });
    std::vector<std::uint64_t> sums(values);
    for (const auto& counts : counted)
        for (std::size_t i = 0; i < counts.size(); ++i) sums[i % values] += counts[i];
    return sums;
}

void count(double stored, double white, std::uint64_t times, IntensityHistogram& histogram) {
    const double intensity = stored / white;
    const double bounded = intensity > 0.0 ? std::min(intensity, 1.0) : 0.0;
    histogram.counts[std::min<std::size_t>(255, static_cast<std::size_t>(bounded * 256.0))] += times;
    histogram.total += times;
}

}  // namespace

IntensityHistogram intensityHistogram(const Volume& volume) {
    IntensityHistogram histogram;
    const double white = volume.whiteLevel();
    const std::uint8_t* mask = volume.dataMaskOrNull();
    std::visit(
        [&]<typename Value>(const VoxelArray<Value>& voxels) {
            if constexpr (std::is_integral_v<Value>) {
                const std::vector<std::uint64_t> counts = countValues(voxels, mask);
                for (std::size_t value = 0; value < counts.size(); ++value)
                    if (counts[value] > 0) count(static_cast<double>(value), white, counts[value], histogram);
            } else {
                for (std::size_t i = 0; i < voxels.size(); ++i)
                    if (mask == nullptr || mask[i] != 0) count(static_cast<double>(voxels[i]), white, 1, histogram);
            }
        },
        volume.voxels());
    return histogram;
}

}  // namespace echolucent
