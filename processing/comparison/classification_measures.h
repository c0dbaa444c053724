// What stands under a picture that is compared with others: how well it sets surfaces off, and where its light is from.
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

/// The rays along the axes of the tube cores that have a surface and a weight, in the order of the tube cores, with the
/// surface that each found in the place of the true one. What the view cuts off (near cut, cut surface, box) is not
/// shown. `geometry` is that of the volume that the tube cores read.
[[nodiscard]] std::vector<SurfaceRay> tubeCoreRays(const VolumeGeometry& geometry, const AdaptiveOtf& otf);

/// Measures of a classification on a volume whose true surfaces nobody knows.
///
/// They take the surfaces that the tube cores found for true, and look along the tube cores alone. That favours the
/// adaptive OTF, which is made of these very surfaces; it says nothing of surfaces that the tube cores missed, and
/// where they took speckle for a surface it praises whoever shows speckle. Values compare classifications on one
/// volume, from one view, with one set of tube cores, and nothing else (docs/comparison.md).
struct ClassificationMeasures {
    SurfaceContrast contrast;  ///< CNR_S with the tube cores' surfaces, over tubeCoreRays()
    SurfaceLight light;        ///< the share of a ray's light that comes from near them
};
/// One a classification, in their order; without a ray where no tube core has a surface and a weight. `shown` is what
/// the picture is made of, on the grid of the volume that the tube cores read: it is sampled along the rays, and
/// gradient magnitudes are taken of it. The result is empty only where progress.cancel was raised, and has the same
/// bits for any number of threads.
[[nodiscard]] std::optional<std::vector<ClassificationMeasures>> measuresOf(
    const Volume& shown, const AdaptiveOtf& otf, std::span<const Classification> classifications,
    const Progress& progress = {});

}  // namespace echolucent
