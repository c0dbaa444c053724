// The light held back before surfaces against closed forms: which intensity holds it, and how much.
#include "processing/comparison/early_light.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "tests/processing/comparison/small_volumes.h"

namespace echolucent {
namespace {

constexpr std::uint8_t hazeVoxel = 51, wallVoxel = 204;  // intensities 0.2 and 0.8
constexpr std::size_t hazeBin = 12;                      // 0.2 * 64 is 12.8

/// Some opacity up to an intensity of 0.5, opaque from there on.
Classification hazed(double opacity) { return OpacityCurve(ManualCurve{{{0.5, opacity}, {0.5, 1.0}}}); }

EarlyLight light(const std::vector<SurfaceRay>& rays, const Classification& classification) {
    return *earlyLightOf(twoLayers(hazeVoxel, wallVoxel), {}, rays, classification);
}

TEST(EarlyLight, OfHazeBeforeAWallIsInItsBinAndNowhereElse) {
    // Slices 0 to 17 lie more than 2 units before the surface at 19.5.
    for (const double opacity : {0.1, 0.3}) {
        const EarlyLight held = light(allRays(), hazed(opacity));
        EXPECT_EQ(held.rays, width * width);
        EXPECT_EQ(held.early, width * width);
        EXPECT_NEAR(held.held[hazeBin], 1.0 - std::pow(1.0 - opacity, 18), 1e-9) << opacity;
        EXPECT_DOUBLE_EQ(held.sum(), held.held[hazeBin]) << opacity;
    }
}

TEST(EarlyLight, OfACurveThatIsClearBeforeTheWallIsNone) {
    const EarlyLight clear = light(allRays(), hazed(0.0));
    EXPECT_EQ(clear.early, 0);
    EXPECT_EQ(clear.sum(), 0.0);
    const EarlyLight thin = light(allRays(), hazed(0.02));  // 0.98^20 is above one half: the wall is shown right
    EXPECT_EQ(thin.early, 0);
    EXPECT_EQ(thin.sum(), 0.0) << "haze through which the wall is seen is not early";
}

TEST(EarlyLight, IsAMeanOverAllRaysWhetherTheyAreEarlyOrNot) {
    std::vector<SurfaceRay> rays = oneRay(surfaceDepth);
    rays.push_back({.pointMm = {1, 1, 0}, .surfaceDepthMm = 4.5});  // shown at 5.6: right
    const EarlyLight held = light(rays, hazed(0.1));
    EXPECT_EQ(held.rays, 2);
    EXPECT_EQ(held.early, 1);
    EXPECT_NEAR(held.sum(), 0.5 * (1.0 - std::pow(0.9, 18)), 1e-9);
}

TEST(EarlyLight, EndsTwoUnitsBeforeTheSurface) {
    // Opaque everywhere: the first sample holds all of it back.
    const Classification opaque = constantOpacity(1.0);
    EXPECT_NEAR(light(oneRay(3.0), opaque).sum(), 1.0, 1e-9);
    EXPECT_EQ(light(oneRay(1.0), opaque).sum(), 0.0) << "the first sample is within 2 units of the surface";
}

TEST(EarlyLight, AsksTheGradientOfATwoDimensionalOtf) {
    const EarlyLight before = light(oneRay(surfaceDepth), opacityOfGradient(0.6));
    EXPECT_EQ(before.sum(), 0.0) << "even layers have no gradient";
    const EarlyLight edge = light(oneRay(surfaceDepth + 5), opacityOfGradient(0.3));
    EXPECT_NEAR(edge.sum(), 1.0, 1e-6) << "the edge of the two layers lies 5 units before this surface";
}

TEST(EarlyLight, OfNoRayIsNone) {
    const EarlyLight none = light({}, hazed(0.1));
    EXPECT_EQ(none.rays, 0);
    EXPECT_EQ(none.sum(), 0.0);
}

TEST(EarlyLight, HasTheSameBitsForAnyNumberOfThreadsAndEndsWhereCancelled) {
    const PhantomConfig config = smallShapes();
    const Volume volume = *makePhantom(config);
    const auto rays = trueSurfaces(volume.geometry(), PhantomTruth(config), {}, InterfaceInto::objectOrTissue);
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return *earlyLightOf(volume, {}, rays, constantOpacity(0.1)); });
    };
    const EarlyLight one = with(1);
    EXPECT_GT(one.early, 500);
    EXPECT_GT(one.sum(), 0.3);
    EXPECT_EQ(with(2), one);
    EXPECT_EQ(with(7), one);
    const std::atomic<bool> raised = true;
    EXPECT_FALSE(earlyLightOf(volume, {}, rays, constantOpacity(0.1), {{}, &raised}));
}

}  // namespace
}  // namespace echolucent
