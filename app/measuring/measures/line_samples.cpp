#include "app/measuring/measures/line_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace echolucent {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <typename Voxel>
double intensityAt(const Volume& volume, const std::vector<Voxel>& voxels, const Vec3& position) {
    const VolumeGeometry& geometry = volume.geometry();
    std::array<std::int64_t, 3> low, high;
    std::array<double, 3> share;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double rounding = 1e-9;
        const double at = position[static_cast<int>(axis)], last = static_cast<double>(geometry.size[axis] - 1);
        if (!(at >= -0.5 - rounding && at <= last + 0.5 + rounding)) return none;
        const double inside = std::clamp(at, 0.0, last);
        low[axis] = static_cast<std::int64_t>(inside);
        high[axis] = std::min(low[axis] + 1, geometry.size[axis] - 1);
        share[axis] = inside - static_cast<double>(low[axis]);
    }
    double sum = 0.0, weights = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const bool right = corner & 1, down = corner & 2, behind = corner & 4;
        const double weight =
            (right ? share[0] : 1 - share[0]) * (down ? share[1] : 1 - share[1]) * (behind ? share[2] : 1 - share[2]);
        if (weight == 0.0) continue;
        const std::int64_t offset =
            geometry.offset(right ? high[0] : low[0], down ? high[1] : low[1], behind ? high[2] : low[2]);
        const double stored = static_cast<double>(voxels[static_cast<std::size_t>(offset)]);
        if (!volume.hasData(offset) || !std::isfinite(stored)) continue;
        sum += weight * std::clamp(stored, 0.0, volume.whiteLevel());
        weights += weight;
    }
    return weights < 0.5 ? none : std::min(1.0, sum / (weights * volume.whiteLevel()));
}

}  // namespace

void sampleLine(const Volume& volume, const Vec3& firstVoxel, const Vec3& stepVoxel, std::span<double> intensities) {
    std::visit(
        [&](const auto& voxels) {
            for (std::size_t i = 0; i < intensities.size(); ++i)
                intensities[i] = intensityAt(volume, voxels, firstVoxel + stepVoxel * static_cast<double>(i));
        },
        volume.voxels());
}

std::optional<LineSpan> spanInBox(const VolumeGeometry& geometry, const Vec3& pointMm, const Vec3& directionMm) {
    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
    LineSpan span{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        if (directionMm[axis] == 0.0) {
            if (pointMm[axis] < low[axis] || pointMm[axis] > high[axis]) return std::nullopt;
            continue;
        }
        const double a = (low[axis] - pointMm[axis]) / directionMm[axis];
        const double b = (high[axis] - pointMm[axis]) / directionMm[axis];
        span = {std::max(span.from, std::min(a, b)), std::min(span.to, std::max(a, b))};
    }
    if (!(span.from < span.to)) return std::nullopt;
    return span;
}

OpacityTable::OpacityTable(const OpacityCurve& curve) : m_opacities(sampledOpacities(curve, 256)) {}

double OpacityTable::at(double intensity) const {
    const double place = intensity * static_cast<double>(m_opacities.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(place), m_opacities.size() - 2);
    const double share = place - static_cast<double>(left);
    return m_opacities[left] + share * (m_opacities[left + 1] - m_opacities[left]);
}

}  // namespace echolucent
