// Finds how coarse our rays may be before our picture is farther from the reference than VTK's.
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
    double rmse = 0.0;       ///< of the resulting picture, 8-bit levels from the reference
};

/// The settings with that coarseness: a picture of fewer pixels of the same camera.
[[nodiscard]] RayCastSettings coarsened(const RayCastSettings& settings, const RayCoarseness& coarseness);

/// The coarseness with the fewest samples whose picture, enlarged to the settings' size, is no farther from the
/// reference than `rmse`. If there is none, the one nearest to the reference.
[[nodiscard]] RayCoarseness coarsestWithin(double rmse, const Volume& volume, const OpacityCurve& curve,
                                           const RayCastSettings& settings, const ReferencePicture& reference);

/// The picture's four floats a pixel on size x size pixels, linear between pixel centres, by OpenCV. A picture of fewer
/// rays needs this extra work; one of all rays keeps its pixels.
[[nodiscard]] cv::Mat onScreen(const Picture& picture, int size);

}  // namespace echolucent::bench
