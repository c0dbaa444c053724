#include "processing/sampling/gradient_magnitude.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <variant>
#include <vector>

#include "processing/parallel.h"

namespace echolucent {

namespace {

/// Normalised intensities of a row of voxels.
template <typename Voxel>
void intensitiesOf(const Voxel* voxels, std::size_t count, float perWhite, float* intensities) {
    for (std::size_t x = 0; x < count; ++x) {
        const float share = static_cast<float>(voxels[x]) * perWhite;
        // Written so that NaN becomes 0.
        intensities[x] = share > 0.0f ? std::min(share, 1.0f) : 0.0f;
    }
}

}  // namespace

GradientMagnitude::GradientMagnitude(const Volume& filled) : m_volume(filled) {}

void GradientMagnitude::row(std::int64_t y, std::int64_t z, std::span<float> magnitudes) const {
    const VolumeGeometry& geometry = m_volume.geometry();
    const auto columns = static_cast<std::size_t>(geometry.size[0]);
    if (magnitudes.size() != columns) throw std::invalid_argument("GradientMagnitude: a row has one value a voxel");
    const auto perWhite = static_cast<float>(1.0 / m_volume.whiteLevel());
    std::vector<float> before(columns), after(columns);
    const auto load = [&](std::int64_t ofY, std::int64_t ofZ, std::vector<float>& row) {
        std::visit(
            [&](const auto& voxels) {
                intensitiesOf(voxels.data() + geometry.offset(0, ofY, ofZ), columns, perWhite, row.data());
            },
            m_volume.voxels());
    };
    // Along y and z, subtract whole rows from each other.
    const auto addAcross = [&](std::size_t axis, std::int64_t at) {
        const std::int64_t low = std::max<std::int64_t>(at - 1, 0), high = std::min(at + 1, geometry.size[axis] - 1);
        if (low == high) return;
        load(axis == 1 ? low : y, axis == 2 ? low : z, before);
        load(axis == 1 ? high : y, axis == 2 ? high : z, after);
        const auto perUnit = static_cast<float>(
            geometry.unit() / (geometry.spacing[static_cast<int>(axis)] * static_cast<double>(high - low)));
        for (std::size_t x = 0; x < columns; ++x) {
            const float derivative = (after[x] - before[x]) * perUnit;
            magnitudes[x] += derivative * derivative;
        }
    };
    std::ranges::fill(magnitudes, 0.0f);
    addAcross(1, y);
    addAcross(2, z);
    load(y, z, before);
    const double voxelsPerUnit = geometry.unit() / geometry.spacing[0];
    const auto addAlong = [&](std::size_t x, std::size_t low, std::size_t high) {
        const float derivative =
            (before[high] - before[low]) * static_cast<float>(voxelsPerUnit / static_cast<double>(high - low));
        magnitudes[x] = std::sqrt(magnitudes[x] + derivative * derivative);
    };
    if (columns == 1) {
        magnitudes[0] = std::sqrt(magnitudes[0]);
        return;
    }
    addAlong(0, 0, 1);
    for (std::size_t x = 1; x + 1 < columns; ++x) addAlong(x, x - 1, x + 1);
    addAlong(columns - 1, columns - 2, columns - 1);
}

namespace {

/// The gradient magnitude of one voxel, by the arithmetic of a row.
template <typename Voxel>
double magnitudeOf(const VolumeGeometry& geometry, const Voxel* voxels, float perWhite,
                   const std::array<std::int64_t, 3>& voxel) {
    const auto intensity = [&](const std::array<std::int64_t, 3>& at) {
        float value = 0.0f;
        intensitiesOf(voxels + geometry.offset(at[0], at[1], at[2]), 1, perWhite, &value);
        return value;
    };
    float squares = 0.0f;
    for (const std::size_t axis : {1u, 2u, 0u}) {
        std::array<std::int64_t, 3> before = voxel, after = voxel;
        before[axis] = std::max<std::int64_t>(voxel[axis] - 1, 0);
        after[axis] = std::min(voxel[axis] + 1, geometry.size[axis] - 1);
        if (before[axis] == after[axis]) continue;
        const auto perUnit = static_cast<float>(geometry.unit() / (geometry.spacing[static_cast<int>(axis)] *
                                                                   static_cast<double>(after[axis] - before[axis])));
        const float derivative = (intensity(after) - intensity(before)) * perUnit;
        squares += derivative * derivative;
    }
    return static_cast<double>(std::sqrt(squares));
}

}  // namespace

double GradientMagnitude::at(const Vec3& voxel) const {
    const VolumeGeometry& geometry = m_volume.geometry();
    const auto perWhite = static_cast<float>(1.0 / m_volume.whiteLevel());
    std::array<std::int64_t, 3> low{}, high{};
    std::array<double, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t last = geometry.size[axis] - 1;
        const double inside = std::clamp(voxel[static_cast<int>(axis)], 0.0, static_cast<double>(last));
        low[axis] = static_cast<std::int64_t>(inside);
        high[axis] = std::min(low[axis] + 1, last);
        share[axis] = inside - static_cast<double>(low[axis]);
    }
    return std::visit(
        [&](const auto& voxels) {
            double mean = 0.0;
            for (unsigned corner = 0; corner < 8; ++corner) {
                double weight = 1.0;
                std::array<std::int64_t, 3> place = low;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const bool behind = (corner >> axis & 1u) != 0;
                    weight *= behind ? share[axis] : 1.0 - share[axis];
                    if (behind) place[axis] = high[axis];
                }
                if (weight > 0.0) mean += weight * magnitudeOf(geometry, voxels.data(), perWhite, place);
            }
            return mean;
        },
        m_volume.voxels());
}

std::optional<GradientRange> gradientRange(const Volume& volume, const Volume& filled, const Progress& progress) {
    // The largest possible gradient: two voxels at least a unit apart differ by at most 1, along each of three axes.
    constexpr std::size_t bins = 1 << 16;
    const double largestPossible = std::sqrt(3.0);
    const VolumeGeometry& geometry = volume.geometry();
    const GradientMagnitude gradients(filled);
    const auto slices = static_cast<std::size_t>(geometry.size[2]);
    struct Slice {
        float largest = 0.0f;
        std::vector<std::uint32_t> counts;
    };
    constexpr std::size_t parts = 16;
    std::vector<Slice> found(std::min(parts, slices));
    parallelFor(std::size_t{0}, found.size(), [&](std::size_t part) {
        Slice& here = found[part];
        here.counts.resize(bins);
        std::vector<float> row(static_cast<std::size_t>(geometry.size[0]));
        for (std::size_t z = part; z < slices && !progress.cancelled(); z += found.size())
            for (std::int64_t y = 0; y < geometry.size[1]; ++y) {
                gradients.row(y, static_cast<std::int64_t>(z), row);
                const std::int64_t first = geometry.offset(0, y, static_cast<std::int64_t>(z));
                for (std::size_t x = 0; x < row.size(); ++x) {
                    if (!volume.hasData(first + static_cast<std::int64_t>(x))) continue;
                    here.largest = std::max(here.largest, row[x]);
                    const double share = static_cast<double>(row[x]) / largestPossible;
                    ++here.counts[std::min(static_cast<std::size_t>(share * bins), bins - 1)];
                }
            }
    });
    if (progress.cancelled()) return std::nullopt;
    GradientRange range;
    std::vector<std::uint64_t> counts(bins);
    for (const Slice& part : found) {
        range.largest = std::max(range.largest, static_cast<double>(part.largest));
        for (std::size_t bin = 0; bin < bins; ++bin) counts[bin] += part.counts[bin];
    }
    const std::uint64_t total = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    std::uint64_t below = 0;
    for (std::size_t bin = 0; bin < bins && total > 0; ++bin) {
        below += counts[bin];
        if (static_cast<double>(below) < 0.99 * static_cast<double>(total)) continue;
        range.quantile99 = std::min(range.largest, largestPossible * static_cast<double>(bin + 1) / bins);
        break;
    }
    return range;
}

}  // namespace echolucent
