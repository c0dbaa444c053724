// Pixels that are interpolated between rays.
#include "processing/ray_caster/between_rays.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <limits>
#include <stdexcept>

#include "processing/ray_caster/ray_caster.h"
#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

using namespace ray_casting;

/// A picture with value(column, row) in all channels of even columns and rows, and nothing else.
template <typename Value>
Picture everySecond(int width, int height, const Value& value) {
    Picture picture = emptyPicture(width, height);
    for (int row = 0; row < height; row += raysApart)
        for (int column = 0; column < width; column += raysApart)
            std::fill_n(&picture.rgba[static_cast<std::size_t>((row * width + column) * 4)], 4,
                        static_cast<float>(value(column, row)));
    return picture;
}

TEST(BetweenRays, AnEvenSlopeIsFilledExactly) {
    const auto slope = [](int column, int row) { return 0.1 + 0.01 * column + 0.02 * row; };
    for (const int width : {1, 2, 3, 16, 17})
        for (const int height : {1, 2, 9, 14}) {
            Picture picture = everySecond(width, height, slope);
            const PixelsLeft left = fillBetweenRays(picture, {0, width, 0, height}, 0.4);
            std::size_t chosen = 0;
            for (int row = 0; row < height; ++row)
                for (int column = 0; column < width; ++column) {
                    const bool isLeft = left.chosen[static_cast<std::size_t>(row * width + column)] != 0;
                    chosen += isLeft ? 1 : 0;
                    // At the picture's end the slope ends, which bends the neighbours of its last rays.
                    if (column > 2 && row > 2 && column + 4 < width && row + 4 < height) {
                        EXPECT_FALSE(isLeft) << column << ' ' << row;
                    }
                    if (!isLeft) {
                        EXPECT_NEAR(pixelAt(picture, column, row)[2], slope(column, row), 1e-6);
                    }
                    // The last column and row of an even size lie beyond the last rays.
                    if (column == width - 1 && width % 2 == 0) {
                        EXPECT_TRUE(isLeft);
                    }
                }
            EXPECT_EQ(left.count, chosen);
        }
}

TEST(BetweenRays, AnEdgeIsCastAndWhatLiesBesideItIsNot) {
    Picture picture = everySecond(33, 33, [](int column, int) { return column < 16 ? 0.0 : 1.0; });
    const PixelsLeft left = fillBetweenRays(picture, {0, 33, 0, 33}, 1.0);
    for (int row = 0; row < 33; ++row)
        for (int column = 1; column < 32; column += 2)
            EXPECT_EQ(left.chosen[static_cast<std::size_t>(row * 33 + column)] != 0, column >= 13 && column <= 17)
                << column << ' ' << row;
}

TEST(BetweenRays, NothingIsChosenBeyondTheBoxAndNotANumberIsCast) {
    Picture picture = everySecond(32, 32, [](int, int) { return std::numeric_limits<double>::quiet_NaN(); });
    const PixelsLeft left = fillBetweenRays(picture, {5, 20, 8, 11}, 1.0);
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 32; ++column) {
            const bool within = column >= 4 && column < 20 && row >= 8 && row < 11;
            EXPECT_EQ(left.chosen[static_cast<std::size_t>(row * 32 + column)] != 0,
                      within && (column % 2 == 1 || row % 2 == 1));
        }
}

/// A view so near that rays of every second pixel lie less than a unit apart.
RayCastSettings nearSettings(const Volume& volume, int width, int height) {
    RayCastSettings settings = obliqueSettings(volume, width, height);
    settings.camera.heightMm = 0.3 * height * volume.geometry().unit();
    settings.shading = Shading{.reaching = {0.75, 0.75, 0.3}};
    return settings;
}

template <typename Voxel>
void expectInterpolatedPixelsNearCastOnes(Projection projection) {
    const auto volume = held(sectorOf(speckledShell<Voxel>({41, 43, 39}, {1, 1, 1}, 4)));
    RayCastSettings settings = nearSettings(*volume, 131, 118);
    settings.camera.projection = projection;
    if (projection == Projection::perspective) settings.camera.viewAngleDegrees = 12.0;
    const OpacityCurve curve = PowerCurve{2, 0.5};
    const auto all = castRays(*volume, curve, settings);
    settings.pixelTolerance = 0.5;
    RayCaster caster(volume);
    const auto some = caster.cast(curve, settings);
    EXPECT_LT(caster.castShare(), 0.95);
    EXPECT_GT(caster.castShare(), 0.25);
    const Apart difference = apart(*some, *all);
    EXPECT_LT(difference.rootMeanSquare, 0.6);
    EXPECT_LT(difference.largest, 8.0);
    EXPECT_GT(difference.largest, 0.0);
    for (std::size_t i = 0; i < some->rgba.size(); ++i)
        ASSERT_LE(some->rgba[i], some->rgba[i / 4 * 4 + 3] + 1e-6f) << "premultiplied";
}
TEST(BetweenRays, InterpolatedPixelsOfBytesAreNearCastOnes) {
    expectInterpolatedPixelsNearCastOnes<std::uint8_t>(Projection::parallel);
}
TEST(BetweenRays, InterpolatedPixelsOfFloatsAreNearCastOnes) {
    expectInterpolatedPixelsNearCastOnes<float>(Projection::parallel);
}
TEST(BetweenRays, InterpolatedPixelsInPerspectiveAreNearCastOnes) {
    expectInterpolatedPixelsNearCastOnes<std::uint8_t>(Projection::perspective);
}

TEST(BetweenRays, AllPixelsAreCastIfRaysLieFarApartOrDepthsAreAsked) {
    const auto volume = held(speckledShell<std::uint8_t>({41, 43, 39}, {1, 1, 1}, 4));
    const OpacityCurve curve = PowerCurve{2, 0.5};
    const auto expectAll = [&](RayCastSettings settings, const char* what) {
        settings.pixelTolerance = 0.0;
        const auto all = castRays(*volume, curve, settings);
        settings.pixelTolerance = 3.0;
        RayCaster caster(volume);
        EXPECT_EQ(caster.cast(curve, settings)->rgba, all->rgba) << what;
        EXPECT_EQ(caster.castShare(), 1.0) << what;
    };
    RayCastSettings settings = nearSettings(*volume, 60, 50);
    settings.camera.heightMm *= 2.0;
    expectAll(settings, "far apart");
    settings = nearSettings(*volume, 60, 50);
    settings.findDepth = true;
    expectAll(settings, "depths");
    settings = nearSettings(*volume, 60, 50);
    settings.mode = RenderMode::maximum;
    expectAll(settings, "another mode");
}

TEST(BetweenRays, SamplesThatAreKeptAreThoseOfAllPixels) {
    const auto volume = held(speckledShell<std::uint8_t>({41, 43, 39}, {1, 1, 1}, 4));
    RayCastSettings settings = nearSettings(*volume, 60, 50);
    const auto all = castRays(*volume, PowerCurve{2, 0.7}, settings);
    settings.pixelTolerance = 2.0;
    RayCaster caster(volume);
    (void)caster.cast(PowerCurve{2, 0.5}, settings);
    EXPECT_LT(caster.castShare(), 1.0) << "the first picture of a view keeps nothing";
    (void)caster.cast(PowerCurve{2, 0.6}, settings);
    const auto kept = caster.cast(PowerCurve{2, 0.7}, settings);
    EXPECT_EQ(caster.sampleUse(), SampleUse::kept);
    EXPECT_EQ(caster.castShare(), 1.0);
    EXPECT_LT(apart(*kept, *all).largest, 1.0);
}

TEST(BetweenRays, SamePixelsForAnyNumberOfThreads) {
    const auto volume = held(sectorOf(speckledShell<std::uint8_t>({41, 43, 39}, {1, 1, 1}, 6)));
    RayCastSettings settings = nearSettings(*volume, 150, 130);
    settings.pixelTolerance = 0.5;
    const OpacityCurve curve = PowerCurve{2, 0.5};
    std::vector<float> alone;
    tbb::task_arena(1).execute([&] { alone = castRays(*volume, curve, settings)->rgba; });
    tbb::task_arena(4).execute([&] { EXPECT_EQ(castRays(*volume, curve, settings)->rgba, alone); });
}

TEST(BetweenRays, AToleranceThatMakesNoSenseIsRefused) {
    const auto volume = held(constantVolume<std::uint8_t>({4, 4, 4}, 0.5));
    RayCastSettings settings = settingsFor(*volume, Viewpoint{}, 8, 8);
    for (const double wrong : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
        settings.pixelTolerance = wrong;
        EXPECT_THROW((void)castRays(*volume, PowerCurve{1, 1}, settings), std::invalid_argument);
    }
}

}  // namespace
}  // namespace echolucent
