// The measures under a compared picture: how well the picture sets surfaces off, and where its light comes from.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/classification.h"
#include "processing/comparison/surface_contrast.h"
#include "processing/comparison/surface_light.h"
#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The rays along the axes of the tube cores with a surface and a weight, in the order of the tube cores. The surface
/// found stands in for the true one. What the view cuts off (near cut, cut surface, box) is not shown. `geometry` is
/// that of the volume that the tube cores read.
[[nodiscard]] std::vector<SurfaceRay> tubeCoreRays(const VolumeGeometry& geometry, const AdaptiveOtf& otf);

/// Measures of a classification on a volume whose true surfaces nobody knows.
///
/// The measures take the surfaces that the tube cores found for true, and look only along the tube cores. This favours
/// the adaptive OTF, which is made from these surfaces. The measures say nothing about surfaces that the tube cores
/// missed. If tube cores took speckle for a surface, the measures praise whatever shows speckle. Compare values only on
/// one volume, from one view, with one set of tube cores (docs/comparison.md).
struct ClassificationMeasures {
    SurfaceContrast contrast;  ///< CNR_S with the tube cores' surfaces, over tubeCoreRays()
    SurfaceLight light;        ///< the share of a ray's light that comes from near these surfaces
};
/// One a classification, in order; without rays if no tube core has a surface and a weight. `shown` holds the picture's
/// voxels, on the grid of the volume that the tube cores read: samples and gradient magnitudes come from these voxels.
/// The result is empty only if progress.cancel was raised. Its bits are the same for any number of threads.
[[nodiscard]] std::optional<std::vector<ClassificationMeasures>> measuresOf(
    const Volume& shown, const AdaptiveOtf& otf, std::span<const Classification> classifications,
    const Progress& progress = {});

}  // namespace echolucent
