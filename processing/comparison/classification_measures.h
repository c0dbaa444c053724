// The measures under a compared picture: where the picture stands, how well it sets surfaces off, and where its light
// comes from.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/classification.h"
#include "processing/comparison/shown_depth.h"
#include "processing/comparison/surface_rays.h"
#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How well a picture sets the surface off from haze before it and leakage behind it.
struct SurfaceContrast {
    /// Mean composited intensity from 2 units before to 6 units behind the surface, over the rays; levels of 255.
    double meanSurface = 0.0;
    double meanRest = 0.0;  ///< the same from elsewhere
    double varianceSurface = 0.0, varianceRest = 0.0;
    int rays = 0;
    /// CNR_S, (meanSurface - meanRest) / sqrt(varianceSurface + varianceRest); empty without rays or without variance.
    [[nodiscard]] std::optional<double> contrastToNoise() const;
};

/// How much of a picture's light comes from the surfaces. A ray's share is the part of its composited intensity from
/// within 3 units of its surface (0 if the ray has no light).
struct NearLight {
    double meanShare = 0.0;      ///< mean over the rays, [0,1]
    double meanIntensity = 0.0;  ///< mean composited intensity, [0,1]
};

/// What is measured of a classification on rays whose surface is known. With the surfaces of tube cores the measures
/// say nothing of surfaces that the tube cores missed. If tube cores took speckle for a surface, the measures praise
/// whatever shows this speckle. Compare values only of one volume, from one view (docs/comparison.md).
struct ClassificationMeasures {
    ShownDepth depth;
    SurfaceContrast contrast;
    NearLight light;
    std::vector<ShownSurface> shown{};  ///< of each ray, in their order; `depth` counts them
};
/// One a classification, in order. `shown` holds the picture's voxels, from which samples and gradient magnitudes come.
/// Samples lie one unit apart along the rays of the view, where the view shows something. They are trilinear and not
/// shaded. Light is composited by eq. 3 of Petersch 2005, white for full intensity, on a black ground. The volume is
/// sampled once, so each classification has the bits that it has alone, for any number of threads. The result is empty
/// only if progress.cancel was raised.
[[nodiscard]] std::optional<std::vector<ClassificationMeasures>> measuresOf(
    const Volume& shown, const Viewpoint& view, std::span<const SurfaceRay> rays,
    std::span<const Classification> classifications, const Progress& progress = {});

}  // namespace echolucent
