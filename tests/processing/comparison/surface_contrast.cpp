// CNR_S against closed forms, on volumes small enough to work them out by hand.
#include "processing/comparison/surface_contrast.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <array>
#include <cmath>

#include "tests/processing/comparison/small_volumes.h"

namespace echolucent {
namespace {

/// There is one ray through each voxel of the front face.
std::vector<SurfaceRay> allRays() {
    std::vector<SurfaceRay> rays;
    for (int y = 0; y < width; ++y)
        for (int x = 0; x < width; ++x) rays.push_back({.pointMm = Vec3(x, y, 0), .surfaceDepthMm = surfaceDepth});
    return rays;
}

SurfaceContrast contrastOf(const Volume& volume, const Classification& classification) {
    return surfaceContrasts(volume, allRays(), Viewpoint{}, std::span(&classification, 1)).front();
}

SurfaceContrast contrastOf(const Volume& volume, const PhantomTruth& truth, const Viewpoint& view,
                           const Classification& classification) {
    const auto rays = objectRays(volume.geometry(), truth, view);
    return surfaceContrasts(volume, rays, view, std::span(&classification, 1)).front();
}

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
        surfaceContrasts(twoLayers(100, 200), allRays(), withFrontAcross({}, 15), {&curve, 1}).front();
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
        return arena.execute([&] { return contrastOf(volume, truth, view, PowerCurve{2, 1.0}); });
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
        EXPECT_EQ(together[i].contrastToNoise(), contrastOf(volume, truth, {}, curves[i]).contrastToNoise());
}

/// A table of 256 intensities that says the same as a curve of as many samples, whatever the gradient magnitude.
std::pair<OpacityCurve, Classification> sameInBothKinds(int gradients) {
    SampledCurve curve;
    for (int i = 0; i < 256; ++i)
        curve.opacities.push_back(static_cast<double>(static_cast<float>(0.3 * i * i / 65025)));
    const auto otf = tabulated(256, gradients, 0.4, [&](double f, double) { return opacityAt(curve, f); });
    return {curve, Classification(otf)};
}

TEST(SurfaceContrast, ATableThatDoesNotAskTheGradientIsTheCurve) {
    const PhantomConfig config = smallShapes();
    const Volume volume = *makePhantom(config);
    const PhantomTruth truth(config);
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 25, .elevationDegrees = 10}}) {
        const auto [curve, table] = sameInBothKinds(3);
        const SurfaceContrast ofCurve = contrastOf(volume, truth, view, curve);
        const SurfaceContrast ofTable = contrastOf(volume, truth, view, table);
        ASSERT_GT(ofCurve.rays, 100);
        EXPECT_NEAR(ofTable.meanSurface, ofCurve.meanSurface, 1e-5);
        EXPECT_NEAR(ofTable.meanRest, ofCurve.meanRest, 1e-5);
        EXPECT_NEAR(*ofTable.contrastToNoise(), *ofCurve.contrastToNoise(), 1e-6);
    }
}

TEST(SurfaceContrast, OpacityOfTheGradientShowsTheStepAlone) {
    // g is (0.8 - 0.2) / 2 in slices 19 and 20 and 0 elsewhere: half opaque twice.
    const SurfaceContrast contrast = contrastOf(twoLayers(51, 204), opacityOfGradient(0.6));
    EXPECT_NEAR(contrast.meanSurface, 0.5 * 51 + 0.5 * 0.5 * 204, 1e-4);
    EXPECT_EQ(contrast.meanRest, 0.0);
}

TEST(SurfaceContrast, NoEdgeStandsWhereTheDataEnd) {
    const Volume volume = twoLayers(0, 204);
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(width * width * depth), 1);
    std::fill(mask.begin(), mask.begin() + width * width * surfaceSlice, std::uint8_t{0});
    EXPECT_NEAR(contrastOf(volume, opacityOfGradient(0.6)).meanSurface, (1.0 / 3) * (2.0 / 3) * 204, 1e-4);
    EXPECT_NEAR(contrastOf(volume.withDataMask(mask), opacityOfGradient(0.6)).meanSurface, 0.0, 1e-9);
}

TEST(SurfaceContrast, WhatIsNotShownOfARayGivesNoLight) {
    constexpr double opacity = 0.1;
    const Classification curve = constantOpacity(opacity);
    std::vector<SurfaceRay> rays = allRays();
    // From slice 12 on and up to slice 29: faces lie half a voxel beside the centres.
    for (SurfaceRay& ray : rays) {
        ray.fromDepthMm = 11.5;
        ray.toDepthMm = 29.5;
    }
    const auto contrast = surfaceContrasts(twoLayers(100, 200), rays, {}, std::span(&curve, 1)).front();
    double surface = 0.0, rest = 0.0;
    for (int k = 12; k <= 29; ++k)
        (k >= 18 && k <= 25 ? surface : rest) += std::pow(1 - opacity, k - 12) * opacity * (k < 20 ? 100 : 200);
    EXPECT_NEAR(contrast.meanSurface, surface, 1e-9);
    EXPECT_NEAR(contrast.meanRest, rest, 1e-9);
    for (SurfaceRay& ray : rays) ray.toDepthMm = 11.0;
    EXPECT_EQ(surfaceContrasts(twoLayers(100, 200), rays, {}, std::span(&curve, 1)).front().meanSurface, 0.0);
}

TEST(SurfaceContrast, BothKindsAtOnceEqualEachAlone) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const Volume volume = *makePhantom(config);
    const std::array<Classification, 3> mixed{PowerCurve{2, 1.0}, opacityOfGradient(0.3), LinearCurve{}};
    const auto together = surfaceContrasts(volume, objectRays(volume.geometry(), truth, {}), {}, mixed);
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        const SurfaceContrast alone = contrastOf(volume, truth, {}, mixed[i]);
        EXPECT_EQ(together[i].meanSurface, alone.meanSurface);
        EXPECT_EQ(together[i].contrastToNoise(), alone.contrastToNoise());
    }
}

}  // namespace
}  // namespace echolucent
