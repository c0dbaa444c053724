#include "app/measuring/measures/line_samples.h"

#include <algorithm>
#include <limits>

#include "processing/volume/sampler.h"

namespace echolucent {

void sampleLine(const Volume& volume, const Vec3& firstVoxel, const Vec3& stepVoxel, std::span<double> intensities) {
    const VolumeSampler sampler(volume);
    for (std::size_t i = 0; i < intensities.size(); ++i) {
        const Vec3 voxel = firstVoxel + stepVoxel * static_cast<double>(i);
        const auto intensity = inBox(volume.geometry(), voxel) ? sampler.intensityAt(voxel) : std::nullopt;
        intensities[i] = intensity.value_or(std::numeric_limits<double>::quiet_NaN());
    }
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
