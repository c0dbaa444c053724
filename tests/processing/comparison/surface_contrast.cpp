// CNR_S against closed forms, on volumes small enough to work them out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "processing/comparison/classification_measures.h"
#include "processing/comparison/surface_rays.h"
#include "tests/processing/comparison/small_volumes.h"

namespace echolucent {
namespace {

SurfaceContrast contrastOf(const Volume& volume, const Classification& classification) {
    return measured(volume, Viewpoint{}, allRays(), classification).contrast;
}

SurfaceContrast contrastOf(const Volume& volume, const PhantomTruth& truth, const Viewpoint& view,
                           const Classification& classification) {
    const auto rays = trueSurfaces(volume.geometry(), truth, view, InterfaceInto::object);
    return measured(volume, view, rays, classification).contrast;
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
    const SurfaceContrast cut =
        measured(twoLayers(100, 200), withFrontAcross({}, 15), allRays(), constantOpacity(opacity)).contrast;
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

}  // namespace
}  // namespace echolucent
