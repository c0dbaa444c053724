// The measures of a comparison against closed forms, and the rays that they are made on.
#include "processing/comparison/classification_measures.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "tests/processing/comparison/small_volumes.h"
#include "tests/processing/tube_core/plane_detection.h"

namespace echolucent {
namespace {

TEST(ClassificationMeasures, AreTheSeriesOfTheOneRay) {
    constexpr double opacity = 0.07;
    const ClassificationMeasures measures = measured(twoLayers(51, 204), {}, oneRay(20), constantOpacity(opacity));
    double surface = 0.0, rest = 0.0, near = 0.0;
    for (int k = 0; k < depth; ++k) {
        const double light = std::pow(1 - opacity, k) * opacity * (k < surfaceSlice ? 51 : 204);
        (k >= 18 && k <= 26 ? surface : rest) += light;
        near += std::abs(k - 20) <= 3 ? light : 0.0;
    }
    EXPECT_EQ(measures.contrast.rays, 1);
    EXPECT_NEAR(measures.contrast.meanSurface, surface, 1e-9);
    EXPECT_NEAR(measures.contrast.meanRest, rest, 1e-9);
    EXPECT_FALSE(measures.contrast.contrastToNoise()) << "one ray has no variance";
    EXPECT_NEAR(measures.light.meanShare, near / (surface + rest), 1e-12);
    EXPECT_NEAR(measures.light.meanIntensity, (surface + rest) / 255, 1e-12);
    // 0.93^9 is above one half and 0.93^10 below, so that the light is held back 10 units before the surface.
    EXPECT_EQ(measures.depth, ShownDepth{.early = 1});
}

TEST(ClassificationMeasures, OfAnOpaqueStepAreTheSurfaces) {
    const OpacityCurve step = ManualCurve{{{0.4, 0.0}, {0.4, 1.0}}};
    const auto at = [&](double surfaceDepthMm) {
        return measured(twoLayers(30, 150), {}, oneRay(surfaceDepthMm), step);
    };
    EXPECT_EQ(at(20).light.meanShare, 1.0);
    EXPECT_EQ(at(10).light.meanShare, 0.0);
    const ClassificationMeasures none = measured(twoLayers(30, 150), {}, oneRay(20), constantOpacity(0.0));
    EXPECT_EQ(none.light.meanShare, 0.0);
    EXPECT_EQ(none.light.meanIntensity, 0.0);
    EXPECT_EQ(none.depth, ShownDepth{.never = 1});
    // The picture stands at 19.5, to the bit, and the limits are two units.
    for (const double right : {17.5, 19.5, 21.5}) EXPECT_EQ(at(right).depth, ShownDepth{.right = 1}) << right;
    EXPECT_EQ(at(21.5625).depth, ShownDepth{.early = 1});
    EXPECT_EQ(at(17.4375).depth, ShownDepth{.late = 1});
}

TEST(ClassificationMeasures, OfOpacityByTheGradientAreThoseOfTheStep) {
    const ClassificationMeasures measures = measured(twoLayers(51, 204), {}, oneRay(20), opacityOfGradient(0.6));
    EXPECT_NEAR(measures.contrast.meanSurface, 0.5 * 51 + 0.25 * 204, 1e-4);
    EXPECT_EQ(measures.contrast.meanRest, 0.0);
    EXPECT_EQ(measures.light.meanShare, 1.0);
    EXPECT_EQ(measures.depth, ShownDepth{.right = 1});
    EXPECT_EQ(measured(twoLayers(51, 204), {}, oneRay(10), opacityOfGradient(0.6)).light.meanShare, 0.0);
}

TEST(ClassificationMeasures, WhatTheViewCutsOffIsNotThere) {
    constexpr double opacity = 0.1;
    const auto expected = [](int first, int last) {
        double all = 0.0;
        for (int k = first; k <= last; ++k) all += std::pow(1 - opacity, k - first) * opacity * (k < 20 ? 51 : 204);
        return all;
    };
    Viewpoint boxed, bowed;
    boxed.box = OrientedBox{.centreMm = {2.5, 2.5, 19.5}, .sizeMm = {10, 10, 20}};  // slices 10 to 29
    bowed.cutSurface = CutSurface{.frame = frameOf(Viewpoint{}),
                                  .firstRightMm = -10,
                                  .firstDownMm = -10,
                                  .spacingMm = 30,
                                  .columns = 2,
                                  .rows = 2,
                                  .depthMm = {7.5f, 7.5f, 7.5f, 7.5f}};  // slices 8 to 39
    struct Case {
        Viewpoint view;
        int first, last;
    };
    for (const Case& one : {Case{boxed, 10, 29}, Case{withFrontAcross({}, 15), 15, 39}, Case{bowed, 8, 39}}) {
        const auto measures = measured(twoLayers(51, 204), one.view, oneRay(20), constantOpacity(opacity));
        const double all = measures.contrast.meanSurface + measures.contrast.meanRest;
        EXPECT_NEAR(all, expected(one.first, one.last), 1e-9) << one.first;
        EXPECT_NEAR(measures.light.meanIntensity * 255, expected(one.first, one.last), 1e-9) << one.first;
        // 0.9^6 is above one half: the light is held back in the seventh slice.
        const double shownAt = one.first + 5 + (std::pow(0.9, 6) - 0.5) / (0.1 * std::pow(0.9, 6));
        const auto depthOf = [&](double surface) {
            return measured(twoLayers(51, 204), one.view, oneRay(surface), constantOpacity(opacity)).depth;
        };
        EXPECT_EQ(depthOf(shownAt + 2.01), ShownDepth{.early = 1}) << one.first;
        EXPECT_EQ(depthOf(shownAt + 1.99), ShownDepth{.right = 1}) << one.first;
        EXPECT_EQ(depthOf(shownAt - 1.99), ShownDepth{.right = 1}) << one.first;
        EXPECT_EQ(depthOf(shownAt - 2.01), ShownDepth{.late = 1}) << one.first;
    }
}

TEST(ClassificationMeasures, OfATableThatDoesNotAskTheGradientAreTheCurves) {
    const PlaneVolume plane;
    const Viewpoint view{.azimuthDegrees = 20};
    const AdaptiveOtf otf = adapted(plane.make(), view);
    const auto table = tabulated(256, 5, 0.3, [&](double f, double) { return opacityAt(otf.curve, f); });
    const auto both = *measuresOf(plane.make(), view, tubeCoreRays(plane.geometry(), otf),
                                  std::vector<Classification>{otf.curve, Classification(table)});
    ASSERT_GT(both[0].contrast.rays, 100);
    EXPECT_NEAR(*both[1].contrast.contrastToNoise(), *both[0].contrast.contrastToNoise(), 1e-4);
    EXPECT_NEAR(both[1].light.meanShare, both[0].light.meanShare, 1e-6);
    EXPECT_EQ(both[1].depth, both[0].depth);
}

TEST(ClassificationMeasures, PraiseTheCurveThatKeepsFluidClear) {
    const PlaneVolume plane;
    const AdaptiveOtf otf = adapted(plane.make());
    const auto both = *measuresOf(plane.make(), {}, tubeCoreRays(plane.geometry(), otf),
                                  std::vector<Classification>{otf.curve, constantOpacity(0.05)});
    EXPECT_GT(*both[0].contrast.contrastToNoise(), *both[1].contrast.contrastToNoise() + 1.0);
    EXPECT_GT(both[0].light.meanShare, both[1].light.meanShare + 0.3);
    EXPECT_GT(*both[0].depth.share(ShownSurface::right), 0.9);
    EXPECT_EQ(*both[1].depth.share(ShownSurface::early), 1.0) << "0.95^14 is below one half, and fluid is 50 deep";
}

TEST(ClassificationMeasures, SayOfEachRayWhatTheySayOfAll) {
    const Classification haze = constantOpacity(0.1);  // shown at 5.6
    std::vector<SurfaceRay> rays;
    for (const double surface : {20.0, 5.0, 1.0, 4.0}) rays.push_back(oneRay(surface).front());
    rays.push_back({.pointMm = {90, 0, 0}, .surfaceDepthMm = 5});  // beside the volume
    const ClassificationMeasures measures = measured(twoLayers(51, 204), {}, rays, haze);
    const std::vector<ShownSurface> expected{ShownSurface::early, ShownSurface::right, ShownSurface::late,
                                             ShownSurface::right, ShownSurface::never};
    EXPECT_EQ(measures.shown, expected);
    EXPECT_EQ(measures.depth, (ShownDepth{.right = 2, .early = 1, .late = 1, .never = 1}));
}

TEST(ClassificationMeasures, OfNoRayAreEmpty) {
    const std::vector<Classification> three(3, PowerCurve{});
    const auto measures = *measuresOf(twoLayers(51, 204), {}, {}, three);
    ASSERT_EQ(measures.size(), 3u);
    for (const ClassificationMeasures& one : measures) {
        EXPECT_EQ(one.contrast.rays, 0);
        EXPECT_EQ(one.depth.rays(), 0);
        EXPECT_EQ(one.light.meanShare, 0.0);
        EXPECT_FALSE(one.contrast.contrastToNoise());
    }
    EXPECT_TRUE(measuresOf(twoLayers(51, 204), {}, oneRay(20), {})->empty());
}

TEST(ClassificationMeasures, OfTinyAndEmptyVolumesAreFinite) {
    VolumeGeometry one;
    std::vector<float> holes(27, NAN);
    VolumeGeometry three;
    three.size = {3, 3, 3};
    for (const Volume& volume : {Volume(one, std::vector<std::uint8_t>{0}), Volume(one, std::vector<std::uint16_t>{9}),
                                 Volume(three, holes), Volume(three, std::vector<std::uint8_t>(27, 0))}) {
        EXPECT_TRUE(foundSurfaces(volume, {})->empty());
        // One ray passes through the volume and one beside it.
        const std::vector<SurfaceRay> rays{{.pointMm = {0, 0, 0}}, {.pointMm = {9, 9, 9}}};
        const auto measures =
            *measuresOf(volume, {}, rays, std::vector<Classification>{PowerCurve{}, opacityOfGradient(1)});
        for (const ClassificationMeasures& each : measures) {
            EXPECT_EQ(each.depth.rays(), 2);
            EXPECT_GE(each.depth.never, 1) << "beside the volume nothing is shown";
            EXPECT_TRUE(std::isfinite(each.contrast.meanSurface) && std::isfinite(each.light.meanShare));
        }
    }
}

TEST(ClassificationMeasures, HaveTheSameBitsForAnyNumberOfThreadsAndEndWhereCancelled) {
    const PhantomConfig config = smallShapes();
    const Volume volume = *makePhantom(config);
    const Viewpoint view{.azimuthDegrees = 20, .elevationDegrees = -8};
    const auto rays = trueSurfaces(volume.geometry(), PhantomTruth(config), view, InterfaceInto::objectOrTissue);
    const std::vector<Classification> all{PowerCurve{2, 1.0}, opacityOfGradient(0.1), LinearCurve{}};
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return *measuresOf(volume, view, rays, all); });
    };
    const auto one = with(1);
    EXPECT_GT(one[0].depth.rays(), 500);
    for (const int threads : {2, 7}) {
        const auto many = with(threads);
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(one[i].contrast.meanSurface, many[i].contrast.meanSurface);
            EXPECT_EQ(one[i].contrast.meanRest, many[i].contrast.meanRest);
            EXPECT_EQ(one[i].contrast.varianceSurface, many[i].contrast.varianceSurface);
            EXPECT_EQ(one[i].contrast.varianceRest, many[i].contrast.varianceRest);
            EXPECT_EQ(one[i].light.meanShare, many[i].light.meanShare);
            EXPECT_EQ(one[i].depth, many[i].depth);
            EXPECT_EQ(one[i].shown, many[i].shown);
        }
    }
    const std::atomic<bool> raised = true;
    EXPECT_FALSE(measuresOf(volume, view, rays, all, {{}, &raised}));
}

TEST(ClassificationMeasures, OfManyAtOnceEqualEachAlone) {
    const PhantomConfig config = smallShapes();
    const Volume volume = *makePhantom(config);
    const auto rays = trueSurfaces(volume.geometry(), PhantomTruth(config), {}, InterfaceInto::objectOrTissue, 2.0);
    const std::vector<Classification> mixed{PowerCurve{2, 1.0}, opacityOfGradient(0.3), LinearCurve{},
                                            PowerCurve{4, 0.5}};
    const auto together = *measuresOf(volume, {}, rays, mixed);
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        const ClassificationMeasures alone = measured(volume, {}, rays, mixed[i]);
        EXPECT_EQ(together[i].contrast.meanSurface, alone.contrast.meanSurface);
        EXPECT_EQ(together[i].contrast.contrastToNoise(), alone.contrast.contrastToNoise());
        EXPECT_EQ(together[i].light.meanShare, alone.light.meanShare);
        EXPECT_EQ(together[i].depth, alone.depth);
        EXPECT_EQ(together[i].shown, alone.shown);
    }
}

}  // namespace
}  // namespace echolucent
