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

ClassificationMeasures measured(const Volume& volume, const AdaptiveOtf& otf, const Classification& classification) {
    return measuresOf(volume, otf, std::span(&classification, 1))->front();
}

TEST(ClassificationMeasures, AreTheSeriesOfTheOneRayOfATubeCore) {
    constexpr double opacity = 0.07;
    const ClassificationMeasures measures = measured(twoLayers(51, 204), oneTube(20, 0.1), constantOpacity(opacity));
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
}

TEST(ClassificationMeasures, OfOpacityByTheGradientAreThoseOfTheStep) {
    const ClassificationMeasures measures = measured(twoLayers(51, 204), oneTube(20, 0.1), opacityOfGradient(0.6));
    EXPECT_NEAR(measures.contrast.meanSurface, 0.5 * 51 + 0.25 * 204, 1e-4);
    EXPECT_EQ(measures.contrast.meanRest, 0.0);
    EXPECT_EQ(measures.light.meanShare, 1.0);
}

TEST(ClassificationMeasures, WhatTheViewCutsOffIsNotThere) {
    constexpr double opacity = 0.1;
    const auto expected = [](int first, int last) {
        double all = 0.0;
        for (int k = first; k <= last; ++k) all += std::pow(1 - opacity, k - first) * opacity * (k < 20 ? 51 : 204);
        return all;
    };
    AdaptiveOtf boxed = oneTube(20, 0.1), cut = boxed, surface = boxed;
    boxed.view.box = OrientedBox{.centreMm = {2.5, 2.5, 19.5}, .sizeMm = {10, 10, 20}};  // slices 10 to 29
    cut.view = withFrontAcross(cut.view, 15);                                            // slices 15 to 39
    surface.view.cutSurface = CutSurface{.frame = frameOf(Viewpoint{}),
                                         .firstRightMm = -10,
                                         .firstDownMm = -10,
                                         .spacingMm = 30,
                                         .columns = 2,
                                         .rows = 2,
                                         .depthMm = {7.5f, 7.5f, 7.5f, 7.5f}};  // slices 8 to 39
    const auto begin = [](AdaptiveOtf& otf, int slice) {
        (*otf.tubes.front().entryVoxel)[2] = slice - 0.5;
        otf.tubes.front().firstSampleVoxel[2] = slice;
    };
    begin(boxed, 10);
    begin(cut, 15);
    begin(surface, 8);
    struct Case {
        const AdaptiveOtf& otf;
        int first, last;
    };
    for (const Case& one : {Case{boxed, 10, 29}, Case{cut, 15, 39}, Case{surface, 8, 39}}) {
        const auto measures = measured(twoLayers(51, 204), one.otf, constantOpacity(opacity));
        const double all = measures.contrast.meanSurface + measures.contrast.meanRest;
        EXPECT_NEAR(all, expected(one.first, one.last), 1e-9) << one.first;
        EXPECT_NEAR(measures.light.meanIntensity * 255, expected(one.first, one.last), 1e-9) << one.first;
    }
}

TEST(TubeCoreRays, AreThoseWithASurfaceAndAWeightAndLieOnIt) {
    PlaneVolume plane;
    plane.normal = normalized(Vec3(0.2, -0.15, 1.0));
    plane.distanceMm = plane.normal.dot(plane.geometry().centreMm());
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 12, .elevationDegrees = -9}}) {
        AdaptiveOtf otf = adapted(plane.make(), view);
        std::size_t weighing = 0;
        for (const TubeCore& tube : otf.tubes) weighing += tube.d > 0.0 ? 1 : 0;
        ASSERT_GT(weighing, 100u);
        const Vec3 forward = frameOf(view).forward;
        const auto rays = tubeCoreRays(plane.geometry(), otf);
        ASSERT_EQ(rays.size(), weighing);
        std::size_t onPlane = 0;
        for (const SurfaceRay& ray : rays) {
            const Vec3 surface = ray.pointMm + forward * (ray.surfaceDepthMm - forward.dot(ray.pointMm));
            onPlane += std::abs(plane.normal.dot(surface) - plane.distanceMm) < 3.0 ? 1 : 0;
            EXPECT_LT(ray.fromDepthMm, ray.surfaceDepthMm);
            EXPECT_GT(ray.toDepthMm, ray.surfaceDepthMm);
        }
        EXPECT_GT(onPlane, weighing * 9 / 10);
        for (TubeCore& tube : otf.tubes) tube.d = 0.0;
        EXPECT_TRUE(tubeCoreRays(plane.geometry(), otf).empty());
    }
}

TEST(ClassificationMeasures, OfATableThatDoesNotAskTheGradientAreTheCurves) {
    const PlaneVolume plane;
    const AdaptiveOtf otf = adapted(plane.make(), Viewpoint{.azimuthDegrees = 20});
    const auto table = tabulated(256, 5, 0.3, [&](double f, double) { return opacityAt(otf.curve, f); });
    const auto both = *measuresOf(plane.make(), otf, std::vector<Classification>{otf.curve, Classification(table)});
    ASSERT_GT(both[0].contrast.rays, 100);
    EXPECT_NEAR(*both[1].contrast.contrastToNoise(), *both[0].contrast.contrastToNoise(), 1e-4);
    EXPECT_NEAR(both[1].light.meanShare, both[0].light.meanShare, 1e-6);
}

TEST(ClassificationMeasures, PraiseTheCurveThatKeepsFluidClear) {
    const PlaneVolume plane;
    const AdaptiveOtf otf = adapted(plane.make());
    const auto both = *measuresOf(plane.make(), otf, std::vector<Classification>{otf.curve, constantOpacity(0.05)});
    EXPECT_GT(*both[0].contrast.contrastToNoise(), *both[1].contrast.contrastToNoise() + 1.0);
    EXPECT_GT(both[0].light.meanShare, both[1].light.meanShare + 0.3);
}

TEST(ClassificationMeasures, HaveNoRayWhereNoTubeCoreHasAWeight) {
    const auto measures =
        *measuresOf(twoLayers(51, 204), oneTube(20, 0.0), std::vector<Classification>(3, PowerCurve{}));
    ASSERT_EQ(measures.size(), 3u);
    for (const ClassificationMeasures& one : measures) {
        EXPECT_EQ(one.contrast.rays, 0);
        EXPECT_EQ(one.light.rays, 0);
        EXPECT_FALSE(one.contrast.contrastToNoise());
    }
    EXPECT_TRUE(measuresOf(twoLayers(51, 204), oneTube(20, 0.1), {})->empty());
}

TEST(ClassificationMeasures, OfTinyAndEmptyVolumesAreFinite) {
    VolumeGeometry one;
    std::vector<float> holes(27, NAN);
    VolumeGeometry three;
    three.size = {3, 3, 3};
    for (const Volume& volume : {Volume(one, std::vector<std::uint8_t>{0}), Volume(one, std::vector<std::uint16_t>{9}),
                                 Volume(three, holes), Volume(three, std::vector<std::uint8_t>(27, 0))}) {
        const AdaptiveOtf otf = adapted(volume);
        const auto measures = measuresOf(volume, otf, std::vector<Classification>{otf.curve, opacityOfGradient(1)});
        ASSERT_TRUE(measures);
        EXPECT_EQ(measures->front().contrast.rays, 0);
    }
}

TEST(ClassificationMeasures, HaveTheSameBitsForAnyNumberOfThreadsAndEndWhereCancelled) {
    const PlaneVolume plane;
    const Volume volume = plane.make();
    const AdaptiveOtf otf = adapted(volume, Viewpoint{.azimuthDegrees = 8});
    const std::vector<Classification> all{otf.curve, opacityOfGradient(0.1)};
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return *measuresOf(volume, otf, all); });
    };
    const auto one = with(1), many = with(5);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(one[i].contrast.meanSurface, many[i].contrast.meanSurface);
        EXPECT_EQ(one[i].contrast.varianceRest, many[i].contrast.varianceRest);
        EXPECT_EQ(one[i].light.meanShare, many[i].light.meanShare);
    }
    const std::atomic<bool> raised = true;
    EXPECT_FALSE(measuresOf(volume, otf, all, {{}, &raised}));
}

}  // namespace
}  // namespace echolucent
