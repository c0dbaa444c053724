#include "tests/benchmarks/coarsest_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "processing/ray_caster.h"

namespace echolucent::bench {

namespace {

constexpr std::array reductions{1.0, 1.25, 1.5, 2.0};
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
    std::optional<RayCoarseness> cheapest;
    RayCoarseness nearest;
    nearest.rmse = -1.0;
    for (const double reduction : reductions)
        for (const double step : steps) {
            RayCoarseness coarseness{reduction, step};
            const Picture picture = *castRays(volume, curve, coarsened(settings, coarseness));
            coarseness.rmse = errorOf(screenOf(picture, settings.width), reference, settings).rmse;
            if (nearest.rmse < 0.0 || coarseness.rmse < nearest.rmse) nearest = coarseness;
            const bool cheaper = !cheapest || samplesOf(coarseness) < samplesOf(*cheapest);
            if (coarseness.rmse <= rmse && cheaper) cheapest = coarseness;
        }
    return cheapest.value_or(nearest);
}

std::vector<float> screenOf(const Picture& picture, int size) {
    if (picture.width == size) return rgbOf(picture);
    const cv::Mat small(picture.height, picture.width, CV_32FC4, const_cast<float*>(picture.rgba.data()));
    cv::Mat large, colours;
    cv::resize(small, large, {size, size}, 0, 0, cv::INTER_LINEAR);
    cv::cvtColor(large, colours, cv::COLOR_BGRA2BGR);
    const auto* first = colours.ptr<float>();
    return {first, first + colours.total() * 3};
}

}  // namespace echolucent::bench
