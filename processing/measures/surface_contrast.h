// How well a picture sets the surface off from haze before it and leakage behind it: CNR_S.
#pragma once

#include <optional>

#include "processing/opacity_curve.h"
#include "processing/phantom.h"
#include "processing/view.h"
#include "processing/volume.h"

namespace echolucent {

/// Over the rays whose first interface (PhantomTruth::firstInterface) leads from fluid into object.
struct SurfaceContrast {
    double meanSurface = 0.0;  ///< mean over these rays of the composited intensity that comes from -2 ... +6 units
                               ///< around the true surface; levels of 255
    double meanRest = 0.0;     ///< ... from before and behind
    double varianceSurface = 0.0, varianceRest = 0.0;
    int rays = 0;
    /// (meanSurface - meanRest) / sqrt(varianceSurface + varianceRest); none: no such ray or no variance.
    [[nodiscard]] std::optional<double> contrastToNoise() const;
};

/// Parallel rays, one per unit across the view, samples one unit apart, trilinear, no shading; eq. 3 with white for
/// full intensity, on a black ground (docs/method.md).
[[nodiscard]] SurfaceContrast surfaceContrast(const Volume& volume, const PhantomTruth& truth, const View& view,
                                              const OpacityCurve& curve);

}  // namespace echolucent
