// The samples along rays whose surface is known.
#pragma once

#include "processing/comparison/line_samples.h"
#include "processing/comparison/shown_depth.h"
#include "processing/comparison/surface_rays.h"
#include "processing/viewpoint/shown_stretch.h"

namespace echolucent {

/// The samples of a ray, one unit apart, and how many units the first one lies behind the surface. There are none if
/// the view shows nothing of the ray.
struct SurfaceSamples {
    RaySamples samples{};
    double firstBehind = 0.0;
};
/// What a picture with these opacities does with the surface.
[[nodiscard]] ShownSurface shownSurfaceOf(const SurfaceSamples& ray, const OpacityTable& table);

/// Samples a volume along rays of a view, where the view shows something.
class SurfaceSampler {
public:
    /// The volume must outlive the sampler. `withGradients` is as for RaySampler.
    SurfaceSampler(const Volume& volume, const Viewpoint& view, bool withGradients);
    /// Several threads may call it at once.
    [[nodiscard]] SurfaceSamples along(const SurfaceRay& ray) const;

private:
    RaySampler m_sampler;
    Vec3 m_forward;
    double m_nearPlane;  ///< nearPlaneDepthMm() of the view
    ShownStretches m_shown;
};

}  // namespace echolucent
