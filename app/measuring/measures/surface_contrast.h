// How well a picture sets the surface off from haze before it and leakage behind it: CNR_S.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/phantom/phantom.h"
#include "processing/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The light of the rays whose first interface (PhantomTruth::firstInterface) leads from fluid into object.
struct SurfaceContrast {
    double meanSurface = 0.0;  ///< mean over these rays of the composited intensity that comes from 2 units before to 6
                               ///< units behind the true surface; levels of 255
    double meanRest = 0.0;     ///< mean of the composited intensity from before and behind; levels of 255
    double varianceSurface = 0.0, varianceRest = 0.0;
    int rays = 0;
    /// (meanSurface - meanRest) / sqrt(varianceSurface + varianceRest); nothing without such a ray or without variance.
    [[nodiscard]] std::optional<double> contrastToNoise() const;
};

/// Rays are parallel, one per unit across the view; samples lie one unit apart, are trilinear and not shaded. Light is
/// composited by eq. 3 with white for full intensity on a black ground (docs/experiments.md, "The curve").
[[nodiscard]] SurfaceContrast surfaceContrast(const Volume& volume, const PhantomTruth& truth, const Viewpoint& view,
                                              const OpacityCurve& curve);

/// One of the rays that surfaceContrast() looks at.
struct ObjectRay {
    Vec3 pointMm{0, 0, 0};        ///< a point of the ray, grid mm; its direction is the view's forward
    double surfaceDepthMm = 0.0;  ///< depth of the true surface along forward, from the grid's origin
};
/// What a ray's first interface may lead into: a fetus is all skin, with its bones behind.
enum class InterfaceInto { object, objectOrTissue };
/// The rays that surfaceContrast() looks at, row by row, so that the truth is asked once for many curves; or those
/// whose first interface leads into tissue, too.
[[nodiscard]] std::vector<ObjectRay> objectRays(const VolumeGeometry& geometry, const PhantomTruth& truth,
                                                const Viewpoint& view, InterfaceInto into = InterfaceInto::object);
/// The contrast of each curve on given rays; each equals surfaceContrast()'s, bit for bit. The volume is sampled once.
[[nodiscard]] std::vector<SurfaceContrast> surfaceContrasts(const Volume& volume, std::span<const ObjectRay> rays,
                                                            const Viewpoint& view,
                                                            std::span<const OpacityCurve> curves);

}  // namespace echolucent
