#include "processing/sampling/sampler.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace echolucent {

namespace {

/// The sampler does not miss a voxel of at most this weight, since places on a voxel centre differ from it by rounding.
constexpr double vanishingWeight = 1e-5;

/// The stored value of a voxel. Empty if it has no data.
std::optional<double> dataAt(const Volume& volume, std::int64_t offset) {
    if (!volume.hasData(offset)) return std::nullopt;
    const double stored = volume.storedValue(offset);
    return std::isfinite(stored) ? std::optional(stored) : std::nullopt;
}

}  // namespace

std::optional<double> VolumeSampler::nearest(const Vec3& voxel) const {
    const VolumeGeometry& geometry = m_volume.geometry();
    std::array<std::int64_t, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        at[axis] = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(voxel[static_cast<int>(axis)] + 0.5)),
                                            0, geometry.size[axis] - 1);
    return dataAt(m_volume, geometry.offset(at[0], at[1], at[2]));
}

std::optional<double> VolumeSampler::trilinear(const Vec3& voxel, bool& complete) const {
    const VolumeGeometry& geometry = m_volume.geometry();
    std::array<std::int64_t, 3> low{}, high{};
    std::array<double, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t last = geometry.size[axis] - 1;
        const double inside = std::clamp(voxel[static_cast<int>(axis)], 0.0, static_cast<double>(last));
        low[axis] = static_cast<std::int64_t>(inside);
        high[axis] = std::min(low[axis] + 1, last);
        share[axis] = inside - static_cast<double>(low[axis]);
    }
    double sum = 0.0, weights = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const bool right = corner & 1, down = corner & 2, behind = corner & 4;
        const double weight = (right ? share[0] : 1.0 - share[0]) * (down ? share[1] : 1.0 - share[1]) *
                              (behind ? share[2] : 1.0 - share[2]);
        if (weight == 0.0) continue;
        const std::optional<double> stored = dataAt(
            m_volume, geometry.offset(right ? high[0] : low[0], down ? high[1] : low[1], behind ? high[2] : low[2]));
        if (!stored) {
            complete = complete && weight <= vanishingWeight;
            continue;
        }
        sum += weight * *stored;
        weights += weight;
    }
    if (weights < 0.5) return std::nullopt;
    return sum / weights;
}

std::optional<double> VolumeSampler::intensityAt(const Vec3& voxel) const {
    bool complete = true;
    const auto stored = m_interpolation == Interpolation::nearest ? nearest(voxel) : trilinear(voxel, complete);
    if (!stored) return std::nullopt;
    return std::clamp(*stored / m_volume.whiteLevel(), 0.0, 1.0);
}

Vec3 VolumeSampler::gradientAt(const Vec3& voxel, double reach) const {
    const VolumeGeometry& geometry = m_volume.geometry();
    Vec3 gradient{0, 0, 0};
    bool complete = true;
    for (int axis = 0; axis < 3; ++axis) {
        const double unitsPerVoxel = geometry.spacing[axis] / geometry.unit();
        const auto last = static_cast<double>(geometry.size[static_cast<std::size_t>(axis)] - 1);
        Vec3 before = voxel, after = voxel;
        before[axis] = std::clamp(voxel[axis] - reach / unitsPerVoxel, 0.0, last);
        after[axis] = std::clamp(voxel[axis] + reach / unitsPerVoxel, 0.0, last);
        const auto low = trilinear(before, complete), high = trilinear(after, complete);
        if (!complete) return {0, 0, 0};
        const double units = (after[axis] - before[axis]) * unitsPerVoxel;
        if (units > 0.0) gradient[axis] = (*high - *low) / (units * m_volume.whiteLevel());
    }
    return gradient;
}

bool inBox(const VolumeGeometry& geometry, const Vec3& voxel) {
    constexpr double rounding = 1e-9;
    for (int axis = 0; axis < 3; ++axis) {
        const double last = static_cast<double>(geometry.size[static_cast<std::size_t>(axis)] - 1);
        if (!(voxel[axis] >= -0.5 - rounding && voxel[axis] <= last + 0.5 + rounding)) return false;
    }
    return true;
}

}  // namespace echolucent
