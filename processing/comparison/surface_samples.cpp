#include "processing/comparison/surface_samples.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

ShownSurface shownSurfaceOf(const SurfaceSamples& ray, const OpacityTable& table) {
    const auto sample = shownSample(ray.samples, table);
    return shownSurfaceAt(sample ? std::optional(ray.firstBehind + *sample) : std::nullopt);
}

SurfaceSampler::SurfaceSampler(const Volume& volume, const Viewpoint& view, bool withGradients)
    : m_sampler(volume, withGradients),
      m_forward(frameOf(view).forward),
      m_nearPlane(nearPlaneDepthMm(view, volume.geometry())),
      m_shown(view, volume.geometry()) {}

SurfaceSamples SurfaceSampler::along(const SurfaceRay& ray) const {
    const VolumeGeometry& geometry = m_sampler.volume().geometry();
    const double unit = geometry.unit();
    const auto stretch = m_shown.of(ray.pointMm);
    if (!stretch) return {};
    constexpr double rounding = 1e-9;  // units
    const double pointDepth = m_forward.dot(ray.pointMm);
    // Samples lie in the middle of steps counted from the near plane.
    const double first = std::max(0.0, std::ceil((pointDepth + stretch->begin - m_nearPlane) / unit - 0.5 - rounding));
    const double last = std::floor((pointDepth + stretch->end - m_nearPlane) / unit - 0.5 + rounding);
    if (last < first) return {};
    const double firstDepth = m_nearPlane + (first + 0.5) * unit;
    const Vec3 firstMm = ray.pointMm + m_forward * (firstDepth - pointDepth);
    return {m_sampler.along(geometry.voxelFromGridMm(firstMm), geometry.voxelFromGridMm(m_forward * unit),
                            static_cast<std::size_t>(last - first) + 1),
            (firstDepth - ray.surfaceDepthMm) / unit};
}

}  // namespace echolucent
