// How coarse our rays may be before our picture is farther from the reference than VTK's.
#pragma once

#include <opencv2/core/mat.hpp>

#include "processing/picture/picture.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/plain_reference.h"

namespace echolucent::bench {

/// Fewer rays, and fewer samples along each.
struct RayCoarseness {
    double reduction = 1.0;  ///< pixels of the picture for each ray, along each edge, >= 1
    double step = 1.0;       ///< units between samples
    double rmse = 0.0;       ///< of the picture so made, 8-bit levels from the reference
};

/// The settings with that coarseness: a picture of fewer pixels of the same camera.
[[nodiscard]] RayCastSettings coarsened(const RayCastSettings& settings, const RayCoarseness& coarseness);

/// The cheapest of some coarsenesses (the least samples) with which our picture, enlarged to the settings' size, is no
/// farther from the reference than `rmse`. Where none is, the one that is nearest to the reference.
[[nodiscard]] RayCoarseness coarsestWithin(double rmse, const Volume& volume, const OpacityCurve& curve,
                                           const RayCastSettings& settings, const ReferencePicture& reference);

/// The picture's four floats a pixel on size x size pixels, linear between pixel centres, by OpenCV: what a picture of
/// fewer rays takes more than one of all of them. That one's own pixels are given as they are.
[[nodiscard]] cv::Mat onScreen(const Picture& picture, int size);

}  // namespace echolucent::bench
