#include "processing/comparison/line_samples.h"

#include <algorithm>
#include <limits>

#include "processing/sampling/sampler.h"
#include "processing/volume/filled_volume.h"

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

OpacityTable::OpacityTable(const Classification& classification) : m_twoDimensional(classification.twoDimensional()) {
    if (!classification.isTwoDimensional()) m_opacities = sampledOpacities(classification.curve(), 256);
}

double OpacityTable::at(double intensity, double gradient) const {
    if (m_twoDimensional != nullptr) return opacityAt(*m_twoDimensional, intensity, gradient);
    const double place = intensity * static_cast<double>(m_opacities.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(place), m_opacities.size() - 2);
    const double share = place - static_cast<double>(left);
    return m_opacities[left] + share * (m_opacities[left + 1] - m_opacities[left]);
}

std::vector<OpacityTable> tablesOf(std::span<const Classification> classifications) {
    std::vector<OpacityTable> tables;
    tables.reserve(classifications.size());
    for (const Classification& classification : classifications) tables.emplace_back(classification);
    return tables;
}

bool anyTwoDimensional(std::span<const OpacityTable> tables) {
    return std::ranges::any_of(tables, &OpacityTable::isTwoDimensional);
}

RaySampler::RaySampler(const Volume& volume, bool withGradients) : m_volume(volume) {
    if (!withGradients) return;
    m_filled.emplace(filledVoxels(volume));
    m_gradients.emplace(*m_filled);
}

RaySamples RaySampler::along(const Vec3& firstVoxel, const Vec3& stepVoxel, std::size_t count) const {
    RaySamples ray;
    ray.intensities.resize(count);
    sampleLine(m_volume, firstVoxel, stepVoxel, ray.intensities);
    if (!m_gradients) return ray;
    ray.gradients.resize(count, 0.0);
    for (std::size_t i = 0; i < count; ++i)
        if (!std::isnan(ray.intensities[i]))
            ray.gradients[i] = m_gradients->at(firstVoxel + stepVoxel * static_cast<double>(i));
    return ray;
}

}  // namespace echolucent
