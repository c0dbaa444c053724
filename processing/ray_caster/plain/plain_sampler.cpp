#include "processing/ray_caster/plain/plain_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace echolucent::plain_casting {

namespace {

/// A voxel that weighs no more is not missed: places on a voxel centre differ from it by rounding.
constexpr double vanishingWeight = 1e-5;

}  // namespace

Sampler::Sampler(const Volume& volume, Interpolation interpolation)
    : m_geometry(volume.geometry()),
      m_whiteLevel(volume.whiteLevel()),
      m_interpolation(interpolation),
      m_stored(static_cast<std::size_t>(m_geometry.voxelCount())) {
    for (std::int64_t i = 0; i < m_geometry.voxelCount(); ++i) {
        const double stored = volume.storedValue(i);
        m_stored[static_cast<std::size_t>(i)] = volume.hasData(i) && std::isfinite(stored)
                                                    ? static_cast<float>(stored)
                                                    : std::numeric_limits<float>::quiet_NaN();
    }
}

std::optional<double> Sampler::nearest(const Vec3& voxel) const {
    std::array<std::int64_t, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        at[axis] = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(voxel[static_cast<int>(axis)] + 0.5)),
                                            0, m_geometry.size[axis] - 1);
    const float stored = m_stored[static_cast<std::size_t>(m_geometry.offset(at[0], at[1], at[2]))];
    if (std::isnan(stored)) return std::nullopt;
    return static_cast<double>(stored);
}

std::optional<double> Sampler::trilinear(const Vec3& voxel, bool& complete) const {
    std::array<std::int64_t, 3> low{}, high{};
    std::array<double, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t last = m_geometry.size[axis] - 1;
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
        const float stored = m_stored[static_cast<std::size_t>(
            m_geometry.offset(right ? high[0] : low[0], down ? high[1] : low[1], behind ? high[2] : low[2]))];
        if (std::isnan(stored)) {
            complete = complete && weight <= vanishingWeight;
            continue;
        }
        sum += weight * static_cast<double>(stored);
        weights += weight;
    }
    if (weights < 0.5) return std::nullopt;
    return sum / weights;
}

std::optional<double> Sampler::intensityAt(const Vec3& voxel) const {
    bool complete = true;
    const auto stored = m_interpolation == Interpolation::nearest ? nearest(voxel) : trilinear(voxel, complete);
    if (!stored) return std::nullopt;
    return std::clamp(*stored / m_whiteLevel, 0.0, 1.0);
}

Vec3 Sampler::gradientAt(const Vec3& voxel, double reach) const {
    Vec3 gradient{0, 0, 0};
    bool complete = true;
    for (int axis = 0; axis < 3; ++axis) {
        const double unitsPerVoxel = m_geometry.spacing[axis] / m_geometry.unit();
        const auto last = static_cast<double>(m_geometry.size[static_cast<std::size_t>(axis)] - 1);
        Vec3 before = voxel, after = voxel;
        before[axis] = std::clamp(voxel[axis] - reach / unitsPerVoxel, 0.0, last);
        after[axis] = std::clamp(voxel[axis] + reach / unitsPerVoxel, 0.0, last);
        const auto low = trilinear(before, complete), high = trilinear(after, complete);
        if (!complete) return {0, 0, 0};
        const double units = (after[axis] - before[axis]) * unitsPerVoxel;
        if (units > 0.0) gradient[axis] = (*high - *low) / (units * m_whiteLevel);
    }
    return gradient;
}

}  // namespace echolucent::plain_casting
