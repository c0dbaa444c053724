// The share of light near the tube cores' surfaces against closed forms.
#include "processing/comparison/surface_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/processing/comparison/small_volumes.h"

namespace echolucent {
namespace {

TEST(SurfaceLight, IsTheShareOfAGeometricSeries) {
    constexpr double opacity = 0.07;
    const SurfaceLight light = surfaceLight(twoLayers(51, 204), oneTube(20, 0.1), constantOpacity(opacity));
    double all = 0.0, near = 0.0;
    for (int k = 0; k < depth; ++k) {
        const double own = std::pow(1 - opacity, k) * opacity * (k < surfaceSlice ? 0.2 : 0.8);
        all += own;
        if (std::abs(k - 20) <= 3) near += own;
    }
    EXPECT_EQ(light.rays, 1);
    EXPECT_NEAR(light.meanIntensity, all, 1e-12);
    EXPECT_NEAR(light.meanShare, near / all, 1e-12);
}

TEST(SurfaceLight, AllOfItBehindAnOpaqueSurfaceAndNoneWhereNothingIsOpaque) {
    const OpacityCurve step = ManualCurve{{{0.4, 0.0}, {0.4, 1.0}}};
    EXPECT_EQ(surfaceLight(twoLayers(30, 150), oneTube(20, 0.1), step).meanShare, 1.0);
    EXPECT_EQ(surfaceLight(twoLayers(30, 150), oneTube(10, 0.1), step).meanShare, 0.0);
    const SurfaceLight none = surfaceLight(twoLayers(30, 150), oneTube(20, 0.1), constantOpacity(0.0));
    EXPECT_EQ(none.rays, 1);
    EXPECT_EQ(none.meanShare, 0.0);
    EXPECT_EQ(none.meanIntensity, 0.0);
}

TEST(SurfaceLight, TubesWithoutWeightOrSurfaceAreLeftOut) {
    EXPECT_EQ(surfaceLight(twoLayers(30, 150), oneTube(20, 0.0), constantOpacity(0.5)).rays, 0);
    AdaptiveOtf otf = oneTube(20, 0.1);
    otf.tubes.front().surfaceVoxel.reset();
    EXPECT_EQ(surfaceLight(twoLayers(30, 150), otf, constantOpacity(0.5)).rays, 0);
}

TEST(SurfaceLight, OpacityOfTheGradientShowsTheStepAlone) {
    const SurfaceLight light = surfaceLight(twoLayers(51, 204), oneTube(20, 0.1), opacityOfGradient(0.6));
    EXPECT_NEAR(light.meanIntensity, 0.5 * 0.2 + 0.25 * 0.8, 1e-6);
    EXPECT_EQ(light.meanShare, 1.0);
    EXPECT_EQ(surfaceLight(twoLayers(51, 204), oneTube(10, 0.1), opacityOfGradient(0.6)).meanShare, 0.0);
}

TEST(SurfaceLight, EndsWhereTheBoxOfTheViewEnds) {
    constexpr double opacity = 0.07;
    AdaptiveOtf otf = oneTube(20, 0.1);
    otf.view.box = OrientedBox{.centreMm = {2.5, 2.5, 19.5}, .sizeMm = {10, 10, 20}};  // slices 10 to 29
    (*otf.tubes.front().entryVoxel)[2] = 9.5;
    otf.tubes.front().firstSampleVoxel[2] = 10;
    const SurfaceLight light = surfaceLight(twoLayers(51, 204), otf, constantOpacity(opacity));
    double all = 0.0;
    for (int k = 10; k <= 29; ++k) all += std::pow(1 - opacity, k - 10) * opacity * (k < surfaceSlice ? 0.2 : 0.8);
    EXPECT_NEAR(light.meanIntensity, all, 1e-12);
}

TEST(SurfaceLight, ManyAtOnceEqualEachAlone) {
    const std::vector<Classification> all{PowerCurve{2, 1.0}, opacityOfGradient(0.6), constantOpacity(0.2)};
    const auto together = surfaceLights(twoLayers(51, 204), oneTube(20, 0.1), all);
    ASSERT_EQ(together.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(together[i].meanShare, surfaceLight(twoLayers(51, 204), oneTube(20, 0.1), all[i]).meanShare);
    EXPECT_EQ(surfaceLights(twoLayers(51, 204), oneTube(20, 0.0), all).size(), all.size());
}

}  // namespace
}  // namespace echolucent
