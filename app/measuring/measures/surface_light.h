// How much of a picture's light comes from the surfaces that the tube cores found.
#pragma once

#include "processing/adaptive/adaptive_otf.h"
#include "processing/opacity_curve.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Each tube core with a surface and a weight has a ray along its axis. Its share is that of the composited intensity
/// which comes from within 3 units of the surface found (0 where the ray has no light at all). The rays begin at the
/// tube core's first sample and are sampled where it is, one unit apart, trilinear, without shading.
struct SurfaceLight {
    double meanShare = 0.0;  ///< mean over these rays, [0,1]
    double medianShare = 0.0;
    double meanIntensity = 0.0;  ///< mean composited intensity, [0,1]
    int rays = 0;
};
[[nodiscard]] SurfaceLight surfaceLight(const Volume& volume, const AdaptiveOtf& otf, const OpacityCurve& curve);

}  // namespace echolucent
