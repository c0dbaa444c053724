#include "tests/benchmarks/coarsest_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "processing/ray_caster/ray_caster.h"

namespace echolucent::bench {

namespace {

constexpr std::array reductions{1.0, 1.1, 1.25, 1.4, 1.5, 1.75, 2.0, 2.5};
constexpr std::array steps{0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0};

/// How many samples a picture has, in shares of those of one with all rays at step 1.
double samplesOf(const RayCoarseness& coarseness) {
    return 1.0 / (coarseness.reduction * coarseness.reduction * coarseness.step);
}

}  // namespace

RayCastSettings coarsened(const RayCastSettings& settings, const RayCoarseness& coarseness) {
    RayCastSettings coarse = settings;
    coarse.width = std::max(1, static_cast<int>(std::lround(settings.width / coarseness.reduction)));
    coarse.height = std::max(1, static_cast<int>(std::lround(settings.height / coarseness.reduction)));
    coarse.step = coarseness.step;
    return coarse;
}

RayCoarseness coarsestWithin(double rmse, const Volume& volume, const OpacityCurve& curve,
                             const RayCastSettings& settings, const ReferencePicture& reference) {
    std::vector<RayCoarseness> candidates;
    for (const double reduction : reductions)
        for (const double step : steps) candidates.push_back({reduction, step});
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const RayCoarseness& a, const RayCoarseness& b) { return samplesOf(a) < samplesOf(b); });
    RayCaster caster(std::make_shared<const Volume>(volume));
    RayCoarseness nearest;
    nearest.rmse = std::numeric_limits<double>::infinity();
    for (RayCoarseness coarseness : candidates) {
        const Picture picture = *caster.cast(curve, coarsened(settings, coarseness));
        const bool whole = picture.width == settings.width;
        coarseness.rmse = errorOf(whole ? rgbOf(picture) : enlarged(picture, settings.width), reference, settings).rmse;
        if (coarseness.rmse < nearest.rmse) nearest = coarseness;
        if (coarseness.rmse <= rmse) break;
    }
    return nearest;
}

cv::Mat onScreen(const Picture& picture, int size) {
    const cv::Mat small(picture.height, picture.width, CV_32FC4, const_cast<float*>(picture.rgba.data()));
    if (picture.width == size) return small;
    cv::Mat large;
    cv::resize(small, large, {size, size}, 0, 0, cv::INTER_LINEAR);
    return large;
}

}  // namespace echolucent::bench
