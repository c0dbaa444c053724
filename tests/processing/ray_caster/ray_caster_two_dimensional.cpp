// Pictures of two-dimensional OTFs: against the references, and against curves where the gradient plays no part.
#include <gtest/gtest.h>

#include "processing/ray_caster/packed/empty_space.h"
#include "processing/ray_caster/packed/packed_gradients.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/volume/filled_volume.h"
#include "ray_caster_scenes.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

/// Opaque where intensity and gradient both say so; it changes slowly, so that what bytes of gradients lose is small.
TwoDimensionalOtf boundaries(double largestGradient = 0.4) {
    return tabulated(64, 48, largestGradient, [&](double f, double g) {
        return 0.5 * (g / largestGradient) * std::clamp(1.0 - std::abs(f - 0.5) / 0.4, 0.0, 1.0);
    });
}
/// The same curve as nodes of a curve and of a two-dimensional OTF that knows no gradient.
SampledCurve curveOfNodes() {
    SampledCurve curve;
    for (int i = 0; i < 256; ++i) curve.opacities.push_back(i < 60 ? 0.0 : 0.4 * std::pow((i - 60) / 195.0, 1.5));
    return curve;
}
TwoDimensionalOtf withoutGradient() {
    const SampledCurve curve = curveOfNodes();
    return tabulated(256, 7, 0.3, [&](double f, double) { return opacityAt(curve, f); });
}

template <typename Voxel>
void expectReferenceOfBoundaries() {
    const Volume whole = speckledShell<Voxel>({31, 27, 35}, {1, 1.2, 0.8}, 5);
    const Classification otf(boundaries());
    for (const Volume& volume : {whole, sectorOf(whole)})
        for (const Projection projection : {Projection::parallel, Projection::perspective})
            for (const double step : {0.4, 1.0, 2.3}) {
                if (takesSomeInputs && step < 1.0) continue;
                RayCastSettings settings = obliqueSettings(volume, 41, 37);
                settings.camera.projection = projection;
                settings.step = step;
                // Gradients are rounded to 255 steps: an opacity is off by at most half of one, 0.5 / 510 a unit.
                EXPECT_LT(largestDifference(volume, otf, settings), isOfBytes(volume) ? 0.01 : 0.004) << step;
                settings.findDepth = true;
                settings.shading = Shading{};
                EXPECT_LT(largestDifference(volume, otf, settings), isOfBytes(volume) ? 0.03 : 0.01) << step << " lit";
            }
}
TEST(RayCasterTwoDimensional, BytesAreShownAsTheReferenceShowsThem) { expectReferenceOfBoundaries<std::uint8_t>(); }
TEST(RayCasterTwoDimensional, WordsAreShownAsTheReferenceShowsThem) { expectReferenceOfBoundaries<std::uint16_t>(); }
TEST(RayCasterTwoDimensional, FloatsAreShownAsTheReferenceShowsThem) { expectReferenceOfBoundaries<float>(); }

TEST(RayCasterTwoDimensional, TheNearestVoxelHasItsOwnGradient) {
    const Volume volume = speckledShell<float>({21, 23, 19}, {1, 1, 1}, 2);
    RayCastSettings settings = obliqueSettings(volume, 23, 21);
    settings.interpolation = Interpolation::nearest;
    // Beside a face between voxels either is the nearest, by rounding.
    const Classification otf(boundaries());
    const Apart difference = apart(*castRays(volume, otf, settings), *castRaysPlainly(volume, otf, settings));
    EXPECT_LT(difference.rootMeanSquare, 0.5);
}

TEST(RayCasterTwoDimensional, ThePlainRouteIsTheReference) {
    const Volume volume = sectorOf(speckledShell<std::uint16_t>({21, 23, 19}, {1, 0.7, 1.1}, 8));
    for (const bool lit : {false, true}) {
        RayCastSettings settings = obliqueSettings(volume, 19, 17);
        if (lit) settings.shading = Shading{};
        const PlainCasting casting{.leastLitOpacity = 1.0 / 128};
        const Classification otf(boundaries());
        EXPECT_LT(largestDifference(*castRaysPlainly(volume, otf, settings, casting), volume, otf, settings), 2e-5);
    }
}

TEST(RayCasterTwoDimensional, WithoutAWordOfTheGradientThePictureIsTheCurves) {
    const Volume whole = speckledShell<std::uint16_t>({41, 37, 45}, {1, 1.2, 0.8}, 5);
    for (const Volume& volume : {whole, sectorOf(whole)})
        for (const double step : {0.25, 1.0, 1.7})
            for (const bool lit : {false, true}) {
                if (takesSomeInputs && step != 1.0) continue;
                RayCastSettings settings = obliqueSettings(volume, 61, 53);
                settings.step = step;
                settings.findDepth = true;
                if (lit) settings.shading = Shading{};
                if (lit) settings.shading->reaching = {0.7, 0.7, 0.3};
                const auto curve = castRays(volume, curveOfNodes(), settings);
                const auto table = castRays(volume, Classification(withoutGradient()), settings);
                const Apart difference = apart(*curve, *table);
                EXPECT_LT(difference.largest, lit ? 2.0 : 0.1) << step;
                EXPECT_LT(difference.rootMeanSquare, lit ? 0.1 : 0.01) << step;
                EXPECT_GT(largestAlpha(*table), 0.3f);
            }
}

TEST(RayCasterTwoDimensional, FullOpacityStaysFullAtAnyStep) {
    const Volume volume = constantVolume<std::uint8_t>({12, 12, 12}, 0.6);
    const Classification opaque(tabulated(2, 2, 0.1, [](double, double) { return 1.0; }));
    for (const double step : {0.01, 0.3, 1.0, 7.0}) {
        RayCastSettings settings = settingsFor(volume, Viewpoint{}, 9, 9);
        settings.step = step;
        EXPECT_FLOAT_EQ(pixelAt(*castRays(volume, opaque, settings), 4, 4)[3], 1.0f) << step;
    }
}

TEST(RayCasterTwoDimensional, TinyOpacitiesAddUpOverManySteps) {
    const Volume volume = constantVolume<std::uint8_t>({4, 4, 4000}, 0.6);
    const Classification thin(tabulated(2, 2, 0.1, [](double, double) { return 1e-5; }));
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 3, 3);
    settings.camera.heightMm = 3;
    for (const double step : {0.3, 1.0, 3.0}) {
        settings.step = step;
        const double expected = -std::expm1(4000 * std::log1p(-1e-5));
        EXPECT_NEAR(pixelAt(*castRays(volume, thin, settings), 1, 1)[3], expected, 2e-5) << step;
    }
}

/// Half of the volume has no gradient at all.
Volume halfFlat() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> noise(0.0, 0.5);
    return volumeOf<std::uint8_t>({64, 60, 70}, {1, 1, 1},
                                  [&](auto x, auto, auto) { return x < 32 ? 0.5 : 0.3 + noise(random); });
}

TEST(RayCasterTwoDimensional, JumpsOverWhatShowsNothingChangeNothingThatCanBeSeen) {
    const Volume volume = halfFlat();
    for (const bool lit : {false, true}) {
        RayCastSettings settings = obliqueSettings(volume, 61, 53);
        if (lit) settings.shading = Shading{};
        settings.skipEmptySpace = true;
        const auto skipped = castRays(volume, Classification(boundaries()), settings);
        settings.skipEmptySpace = false;
        // Runs begin at other corners, so that positions differ in their last bit.
        const Apart difference = apart(*skipped, *castRays(volume, Classification(boundaries()), settings));
        EXPECT_LT(difference.largest, 1.0);
        EXPECT_LT(difference.rootMeanSquare, 0.05);
    }
}

TEST(RayCasterTwoDimensional, BricksWithoutGradientAreEmpty) {
    using namespace ray_casting;
    const Volume volume = halfFlat();
    const BrickRanges ranges(filledVoxels(volume), PackedPresence(volume));
    const TwoDimensionalOtf otf = boundaries();
    const auto levels = std::make_shared<const GradientLevels>(*gradientLevels(volume, otf.largestGradient));
    const PackedGradients gradients(volume, levels, ranges.grid());
    EmptySpace space(ranges.grid());
    space.update(ranges, gradients, VisibleNodes(otf));
    int empty = 0, full = 0;
    for (std::int64_t x = 0; x < ranges.grid().size[0]; ++x)
        for (std::int64_t y = 0; y < 7; ++y) {
            const bool isEmpty = space.distances()[ranges.grid().offset(x, y, 4)] > 0;
            // Bricks 0 to 2 hold voxels up to 24, brick 4 begins with voxel 31, whose right neighbour is noise.
            if (x <= 2) empty += isEmpty ? 1 : 0;
            if (x >= 4 && x < 8) full += isEmpty ? 0 : 1;
        }
    EXPECT_EQ(empty, 21);
    EXPECT_EQ(full, 28);
}

TEST(RayCasterTwoDimensional, OneCasterShowsCurvesAndTablesInTurnAsFreshOnesDo) {
    const auto volume = held(sectorOf(speckledShell<std::uint8_t>({41, 37, 45}, {1, 1, 1}, 5)));
    RayCaster caster(volume);
    RayCastSettings settings = obliqueSettings(*volume, 41, 37);
    settings.shading = Shading{};
    settings.shading->reaching = {0.7, 0.7, 0.3};
    const std::vector<Classification> otfs{PowerCurve{2, 0.5}, Classification(boundaries(0.4)),
                                           Classification(boundaries(0.2)), curveOfNodes(),
                                           Classification(boundaries(0.4))};
    for (const Classification& otf : otfs) {
        const auto picture = caster.cast(otf, settings);
        if (otf.isTwoDimensional()) {
            EXPECT_EQ(picture->rgba, castRays(*volume, otf, settings)->rgba);
        } else {
            EXPECT_LT(apart(*picture, *castRays(*volume, otf, settings)).largest, 1.0);
        }
    }
}

TEST(RayCasterTwoDimensional, SamplesAreNotKept) {
    const auto volume = held(speckledShell<std::uint8_t>({41, 37, 45}, {1, 1, 1}, 5));
    RayCaster caster(volume);
    const RayCastSettings settings = obliqueSettings(*volume, 41, 37);
    const auto first = caster.cast(Classification(boundaries()), settings);
    for (int again = 0; again < 3; ++again)
        EXPECT_EQ(caster.cast(Classification(boundaries()), settings)->rgba, first->rgba);
    EXPECT_EQ(caster.keptSampleBytes(), 0U);
}

TEST(RayCasterTwoDimensional, AScalpelsCutIsFollowed) {
    const Volume whole = speckledShell<std::uint8_t>({41, 37, 45}, {1, 1, 1}, 5);
    std::vector<std::uint8_t> left(static_cast<std::size_t>(whole.geometry().voxelCount()), 1);
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = i % 41 < 20 ? 1 : 0;
    const Volume cut = whole.withCut(std::make_shared<const DataMask>(std::move(left)));
    RayCaster caster(held(whole));
    RayCastSettings settings = obliqueSettings(whole, 41, 37);
    settings.shading = Shading{};
    settings.shading->reaching = {0.7, 0.7, 0.3};
    const Classification otf(boundaries());
    const auto before = caster.cast(otf, settings);
    caster.setCut(held(cut));
    const auto after = caster.cast(otf, settings);
    EXPECT_EQ(after->rgba, castRays(cut, otf, settings)->rgba);
    EXPECT_NE(after->rgba, before->rgba);
}

TEST(RayCasterTwoDimensional, CastersThatShareVoxelsKnowNothingOfEachOther) {
    const Volume whole = sectorOf(speckledShell<std::uint16_t>({41, 37, 45}, {1, 1, 1}, 5));
    std::vector<std::uint8_t> left(static_cast<std::size_t>(whole.geometry().voxelCount()));
    for (std::size_t i = 0; i < left.size(); ++i)
        left[i] = whole.hasData(static_cast<std::int64_t>(i)) && i % 41 < 20 ? 1 : 0;
    const Volume cut = whole.withCut(std::make_shared<const DataMask>(std::move(left)));
    RayCastSettings settings = obliqueSettings(whole, 41, 37);
    settings.shading = Shading{};
    settings.shading->reaching = {0.7, 0.7, 0.3};
    const Classification otf(boundaries());
    RayCaster first(held(whole));
    (void)first.cast(PowerCurve{2, 0.5}, settings);
    RayCaster second = first.sharing();
    EXPECT_EQ(second.volume(), first.volume());
    EXPECT_EQ(second.cast(otf, settings)->rgba, castRays(whole, otf, settings)->rgba);
    second.setCut(held(cut));
    EXPECT_EQ(second.cast(otf, settings)->rgba, castRays(cut, otf, settings)->rgba);
    EXPECT_EQ(first.cast(otf, settings)->rgba, castRays(whole, otf, settings)->rgba);
}

TEST(RayCasterTwoDimensional, OtherModesDoNotReadIt) {
    const Volume volume = speckledShell<std::uint8_t>({21, 27, 25}, {1, 1, 1}, 5);
    RayCastSettings settings = obliqueSettings(volume, 41, 37);
    settings.mode = RenderMode::maximum;
    EXPECT_EQ(castRays(volume, Classification(boundaries()), settings)->rgba,
              castRays(volume, PowerCurve{2, 1.0}, settings)->rgba);
}

}  // namespace
}  // namespace echolucent
