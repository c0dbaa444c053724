// The measures of a picture against closed forms, on volumes small enough to work them out by hand.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <array>
#include <cmath>
#include <cstring>

#include "app/measuring/measures/detection_quality.h"
#include "app/measuring/measures/line_samples.h"
#include "app/measuring/measures/surface_contrast.h"
#include "app/measuring/measures/surface_light.h"
#include "processing/adaptive/adaptive_otf.h"

namespace echolucent {
namespace {

constexpr std::int64_t width = 6, depth = 40;
constexpr int surfaceSlice = 20;
/// The true surface lies between slices 19 and 20.
constexpr double surfaceDepth = surfaceSlice - 0.5;

VolumeGeometry smallGeometry() {
    VolumeGeometry geometry;
    geometry.size = {width, width, depth};
    return geometry;
}

/// The voxels hold `before` up to the surface and `behind` from it on.
Volume twoLayers(std::uint8_t before, std::uint8_t behind) {
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(width * width * depth), before);
    std::fill(voxels.begin() + width * width * surfaceSlice, voxels.end(), behind);
    return {smallGeometry(), voxels};
}

/// There is one ray through each voxel of the front face.
std::vector<ObjectRay> allRays() {
    std::vector<ObjectRay> rays;
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) rays.push_back({Vec3(x, y, 0), surfaceDepth});
    return rays;
}

SurfaceContrast contrastOf(const Volume& volume, const OpacityCurve& curve) {
    return surfaceContrasts(volume, allRays(), Viewpoint{}, {&curve, 1}).front();
}

OpacityCurve constantOpacity(double opacity) { return ManualCurve{{{0.0, opacity}}}; }

TEST(SurfaceContrast, LayersOfOneOpacityGiveAGeometricSeries) {
    // Samples lie on voxel centres. Of the true surface at 19.5 slices 18 (1.5 units before) to 25 (5.5 behind) count.
    constexpr double opacity = 0.07, before = 51, behind = 204;
    const SurfaceContrast contrast = contrastOf(twoLayers(before, behind), constantOpacity(opacity));
    double surface = 0.0, rest = 0.0;
    for (int k = 0; k < depth; ++k) {
        const double light = std::pow(1 - opacity, k) * opacity * (k < surfaceSlice ? before : behind);
        (k >= 18 && k <= 25 ? surface : rest) += light;
    }
    EXPECT_EQ(contrast.rays, width * width);
    EXPECT_NEAR(contrast.meanSurface, surface, 1e-9);
    EXPECT_NEAR(contrast.meanRest, rest, 1e-9);
    EXPECT_NEAR(contrast.varianceSurface, 0.0, 1e-18);
}

TEST(SurfaceContrast, AnOpaqueSurfaceBehindClearFluidHasAllTheLight) {
    const OpacityCurve step = ManualCurve{{{0.4, 0.0}, {0.4, 1.0}}};
    const SurfaceContrast contrast = contrastOf(twoLayers(30, 150), step);
    EXPECT_NEAR(contrast.meanSurface, 150.0, 1e-9);
    EXPECT_EQ(contrast.meanRest, 0.0);
}

TEST(SurfaceContrast, NothingOpaqueGivesNoLight) {
    const SurfaceContrast contrast = contrastOf(twoLayers(30, 150), constantOpacity(0.0));
    EXPECT_EQ(contrast.meanSurface, 0.0);
    EXPECT_EQ(contrast.meanRest, 0.0);
    EXPECT_FALSE(contrast.contrastToNoise());
    EXPECT_FALSE(SurfaceContrast{}.contrastToNoise());
}

TEST(SurfaceContrast, OpaqueFluidHidesTheSurface) {
    const SurfaceContrast contrast = contrastOf(twoLayers(30, 150), constantOpacity(1.0));
    EXPECT_EQ(contrast.meanSurface, 0.0);
    EXPECT_NEAR(contrast.meanRest, 30.0, 1e-9);
}

TEST(SurfaceContrast, ContrastToNoiseIsTheFormula) {
    const SurfaceContrast contrast{
        .meanSurface = 120, .meanRest = 30, .varianceSurface = 9, .varianceRest = 16, .rays = 2};
    EXPECT_DOUBLE_EQ(*contrast.contrastToNoise(), 18.0);
}

TEST(SurfaceContrast, VarianceIsThatOfTheRays) {
    // Half the columns end in an object of 100, half in one of 200: mean 150, variance 50^2.
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(width * width * depth), 0);
    for (std::int64_t i = width * width * surfaceSlice; i < width * width * depth; ++i)
        voxels[static_cast<std::size_t>(i)] = i % 2 == 0 ? 100 : 200;
    const OpacityCurve step = ManualCurve{{{0.2, 0.0}, {0.2, 1.0}}};
    const SurfaceContrast contrast = contrastOf(Volume(smallGeometry(), voxels), step);
    EXPECT_NEAR(contrast.meanSurface, 150.0, 1e-9);
    EXPECT_NEAR(contrast.varianceSurface, 2500.0, 1e-6);
    EXPECT_NEAR(*contrast.contrastToNoise(), 3.0, 1e-9);
}

TEST(SurfaceContrast, TheNearCutTakesWhatLiesBeforeItAway) {
    constexpr double opacity = 0.1;
    const OpacityCurve curve = constantOpacity(opacity);
    const SurfaceContrast cut =
        surfaceContrasts(twoLayers(100, 200), allRays(), Viewpoint{.nearCutMm = 15}, {&curve, 1}).front();
    double rest = 0.0;
    for (int k = 15; k < 18; ++k) rest += std::pow(1 - opacity, k - 15) * opacity * 100;
    for (int k = 26; k < depth; ++k) rest += std::pow(1 - opacity, k - 15) * opacity * 200;
    EXPECT_NEAR(cut.meanRest, rest, 1e-9);
}

TEST(SurfaceContrast, NoDataIsClear) {
    const Volume volume = twoLayers(100, 200);
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(width * width * depth), 1);
    std::fill(mask.begin(), mask.begin() + width * width * surfaceSlice, std::uint8_t{0});
    const SurfaceContrast contrast = contrastOf(volume.withDataMask(mask), constantOpacity(1.0));
    EXPECT_NEAR(contrast.meanSurface, 200.0, 1e-9);
    EXPECT_EQ(contrast.meanRest, 0.0);
}

PhantomConfig smallShapes() {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {64, 60, 66};
    return config;
}

TEST(SurfaceContrast, RaysAreThoseWhoseFirstInterfaceIsObject) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const Volume volume = *makePhantom(config);
    const Viewpoint view{.azimuthDegrees = 12};
    const Vec3 forward = frameOf(view).forward;
    const auto rays = objectRays(volume.geometry(), truth, view);
    ASSERT_GT(rays.size(), 100U);
    EXPECT_LT(rays.size(), 64U * 60U);
    for (std::size_t i = 0; i < rays.size(); i += 37) {
        const Vec3 surface = rays[i].pointMm + forward * (rays[i].surfaceDepthMm - forward.dot(rays[i].pointMm));
        EXPECT_EQ(truth.materialAt(surface - forward * 0.01), PhantomMaterial::fluid);
        EXPECT_EQ(truth.materialAt(surface + forward * 1e-4), PhantomMaterial::object);
        EXPECT_NEAR(truth.fluidDistance(surface), 0.0, 1e-9);
    }
    EXPECT_TRUE(objectRays(volume.geometry(), PhantomTruth([] {
                               PhantomConfig none = smallShapes();
                               none.scene = PhantomScene::empty;
                               return none;
                           }()),
                           view)
                    .empty());
}

TEST(SurfaceContrast, SameBitsForAnyNumberOfThreads) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const Volume volume = *makePhantom(config);
    const Viewpoint view{.azimuthDegrees = 20, .elevationDegrees = -8};
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return surfaceContrast(volume, truth, view, PowerCurve{2, 1.0}); });
    };
    const SurfaceContrast one = with(1);
    EXPECT_GT(one.rays, 0);
    for (const int threads : {2, 7}) {
        const SurfaceContrast other = with(threads);
        EXPECT_EQ(one.meanSurface, other.meanSurface);
        EXPECT_EQ(one.meanRest, other.meanRest);
        EXPECT_EQ(one.varianceSurface, other.varianceSurface);
        EXPECT_EQ(one.varianceRest, other.varianceRest);
    }
}

TEST(SurfaceContrast, ManyCurvesAtOnceEqualEachAlone) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const Volume volume = *makePhantom(config);
    const std::array<OpacityCurve, 3> curves{PowerCurve{2, 1.0}, LinearCurve{}, PowerCurve{4, 0.5}};
    const auto together = surfaceContrasts(volume, objectRays(volume.geometry(), truth, {}), {}, curves);
    for (std::size_t i = 0; i < curves.size(); ++i)
        EXPECT_EQ(together[i].contrastToNoise(), surfaceContrast(volume, truth, {}, curves[i]).contrastToNoise());
}

TEST(LineSamples, AreTrilinearBetweenVoxelsWithData) {
    VolumeGeometry geometry;
    geometry.size = {2, 1, 1};
    const Volume volume(geometry, std::vector<float>{0.25f, 0.75f}, 1.0);
    std::array<double, 6> samples{};
    sampleLine(volume, {-0.75, 0, 0}, {0.5, 0, 0}, samples);
    EXPECT_TRUE(std::isnan(samples[0]));  // -0.75: outside
    EXPECT_DOUBLE_EQ(samples[1], 0.25);   // -0.25: clamped
    EXPECT_DOUBLE_EQ(samples[2], 0.375);
    EXPECT_DOUBLE_EQ(samples[3], 0.625);
    EXPECT_DOUBLE_EQ(samples[4], 0.75);
    EXPECT_TRUE(std::isnan(samples[5]));
    const Volume half(geometry, std::vector<float>{NAN, 0.75f}, 1.0);
    std::array<double, 2> near{};
    sampleLine(half, {0.4, 0, 0}, {0.2, 0, 0}, near);
    EXPECT_TRUE(std::isnan(near[0]));
    EXPECT_DOUBLE_EQ(near[1], 0.75);
}

/// One tube core along z through the middle of a volume, with its surface in a given slice.
AdaptiveOtf oneTube(double slice, double d) {
    AdaptiveOtf otf;
    otf.config.grid.columns = otf.config.grid.rows = 1;
    otf.config.grid.spacing = 5;
    TubeCore tube;
    tube.status = TubeStatus::surface;
    const Vec3 middle = tubeAxes(smallGeometry(), {}, otf.config.grid, otf.config.cells.size).front().pointMm;
    tube.entryVoxel = Vec3(middle[0], middle[1], -0.5);
    tube.firstSampleVoxel = Vec3(middle[0], middle[1], 0);
    tube.surfaceVoxel = Vec3(middle[0], middle[1], slice);
    tube.d = d;
    otf.tubes = {tube};
    return otf;
}

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
    EXPECT_EQ(light.medianShare, light.meanShare);
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

/// A run of the method on the small shapes whose tubes all claim their surface `off` units behind the truth.
DetectionQuality qualityOfClaims(double off) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const Volume volume = *makePhantom(config);
    AdaptiveOtfConfig method;
    method.grid.columns = method.grid.rows = 7;
    AdaptiveOtf otf = *adaptOpacity(volume, {}, method);
    const auto truths = tubeTruths(truth, volume.geometry(), {}, method);
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) {
        otf.tubes[t].d = 0.01;
        if (!truths[t].interfaceDepthMm) continue;
        const Vec3 first = otf.tubes[t].firstSampleVoxel;
        const double z = (*truths[t].interfaceDepthMm + off * volume.geometry().unit()) / config.spacing[2];
        otf.tubes[t].surfaceVoxel = Vec3(first[0], first[1], z);
    }
    return detectionQuality(otf, truth, volume.geometry());
}

TEST(DetectionQuality, WhatIsClaimedAtTheTruthIsRight) {
    const DetectionQuality right = qualityOfClaims(0);
    ASSERT_GT(right.tubesWithInterface, 5);
    EXPECT_EQ(right.foundShare(), 1.0);
    EXPECT_NEAR(right.meanDistanceUnits(), 0.0, 1e-9);
    EXPECT_NEAR(right.rightShare() + right.emptyShare(), 1.0, 1e-12);
    EXPECT_GT(right.emptyShare(), 0.0);
    EXPECT_NEAR(right.rightWeight, 0.01 * right.tubesWithInterface, 1e-12);
}

TEST(DetectionQuality, ThreeUnitsAreTheBorder) {
    EXPECT_EQ(qualityOfClaims(2.99).foundShare(), 1.0);
    const DetectionQuality wrong = qualityOfClaims(3.01);
    EXPECT_EQ(wrong.tubesRight, 0);
    EXPECT_EQ(wrong.rightShare(), 0.0);
    EXPECT_NEAR(wrong.meanDistanceUnits(), 3.01, 1e-9);
}

}  // namespace
}  // namespace echolucent
