// How well a picture sets the surface off from haze before it and leakage behind it: CNR_S.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "processing/classification.h"
#include "processing/comparison/line_samples.h"
#include "processing/opacity_curve.h"
#include "processing/phantom/phantom.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The light of rays whose surface is known. In a simulated scan objectRays() gives these rays.
struct SurfaceContrast {
    /// Mean composited intensity from 2 units before to 6 units behind the surface, over these rays; levels of 255.
    double meanSurface = 0.0;
    double meanRest = 0.0;  ///< the same from elsewhere
    double varianceSurface = 0.0, varianceRest = 0.0;
    int rays = 0;
    /// (meanSurface - meanRest) / sqrt(varianceSurface + varianceRest); empty without rays or without variance.
    [[nodiscard]] std::optional<double> contrastToNoise() const;
};

/// A ray whose surface is known, and the part of it that a picture shows. Depths are mm along the view's forward, from
/// the grid's origin.
struct SurfaceRay {
    Vec3 pointMm{0, 0, 0};        ///< a point of the ray, grid mm; its direction is the view's forward
    double surfaceDepthMm = 0.0;  ///< depth of the surface
    /// Only this range is shown; the near cut and the volume's box may leave less.
    double fromDepthMm = -std::numeric_limits<double>::infinity();
    double toDepthMm = std::numeric_limits<double>::infinity();
};
/// What a ray's first interface (PhantomTruth::firstInterface) may lead into. The simulated fetus is covered with skin,
/// which is tissue; only its bones are object.
enum class InterfaceInto { object, objectOrTissue };
/// The rays of a simulated scan whose surface is known: parallel, one per unit across the view, row by row. They are
/// those whose first interface leads from fluid into object; with objectOrTissue also those whose first interface leads
/// into tissue.
[[nodiscard]] std::vector<SurfaceRay> objectRays(const VolumeGeometry& geometry, const PhantomTruth& truth,
                                                 const Viewpoint& view, InterfaceInto into = InterfaceInto::object);
/// The contrast of each classification on given rays. Samples lie one unit apart, are trilinear and not shaded. Light
/// is composited by eq. 3, white for full intensity, on a black ground (docs/experiments.md, "The curve"). The volume
/// is sampled once, so each has the bits that it has alone. Gradient magnitudes, if a classification needs them, come
/// from `volume`.
[[nodiscard]] std::vector<SurfaceContrast> surfaceContrasts(const Volume& volume, std::span<const SurfaceRay> rays,
                                                            const Viewpoint& view,
                                                            std::span<const Classification> classifications);
[[nodiscard]] std::vector<SurfaceContrast> surfaceContrasts(const Volume& volume, std::span<const SurfaceRay> rays,
                                                            const Viewpoint& view,
                                                            std::span<const OpacityCurve> curves);
/// The same on a sampler that other measures share. The sampler must read gradient magnitudes if a table needs them.
[[nodiscard]] std::vector<SurfaceContrast> surfaceContrasts(const RaySampler& sampler, std::span<const SurfaceRay> rays,
                                                            const Viewpoint& view,
                                                            std::span<const OpacityTable> tables);

}  // namespace echolucent
