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

/// A picture with value(column, row) in all channels of each `apart`-th column and row, and nothing else.
template <typename Value>
Picture raysOnly(int width, int height, int apart, const Value& value) {
    Picture picture = emptyPicture(width, height);
    for (int row = 0; row < height; row += apart)
        for (int column = 0; column < width; column += apart)
            std::fill_n(&picture.rgba[static_cast<std::size_t>((row * width + column) * 4)], 4,
                        static_cast<float>(value(column, row)));
    return picture;
}

void expectSlopeIsFilled(int width, int height, int apart) {
    SCOPED_TRACE(testing::Message() << width << 'x' << height << ", " << apart << " apart");
    const auto slope = [](int column, int row) { return 0.1 + 0.01 * column + 0.02 * row; };
    const int half = apart / 2;
    Picture picture = raysOnly(width, height, apart, slope);
    const PixelsLeft left = fillBetweenRays(picture, {0, width, 0, height}, apart, 0.4);
    std::size_t chosen = 0;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const bool isLeft = left.chosen[static_cast<std::size_t>(row * width + column)] != 0;
            chosen += isLeft ? 1 : 0;
            if (column % half != 0 || row % half != 0) {
                EXPECT_TRUE(!isLeft && pixelAt(picture, column, row)[2] == 0.0f) << "another time's";
                continue;
            }
            // At the picture's end the slope ends, which bends the neighbours of its last rays.
            if (column > apart && row > apart && column + 2 * apart < width && row + 2 * apart < height) {
                EXPECT_FALSE(isLeft) << column << ' ' << row;
            }
            if (!isLeft) {
                EXPECT_NEAR(pixelAt(picture, column, row)[2], slope(column, row), 1e-6);
            }
            // What lies beyond the last rays is cast.
            if (column % apart != 0 && column + half >= width) {
                EXPECT_TRUE(isLeft);
            }
        }
    EXPECT_EQ(left.count, chosen);
}
TEST(BetweenRays, AnEvenSlopeIsFilledExactly) {
    for (const int apart : {2, 4})
        for (const int width : {1, 2, 3, 16, 17, 24})
            for (const int height : {1, 2, 9, 14, 23}) expectSlopeIsFilled(width, height, apart);
}

TEST(BetweenRays, AnEdgeIsCastAndWhatLiesBesideItIsNot) {
    Picture picture = raysOnly(33, 33, 2, [](int column, int) { return column < 16 ? 0.0 : 1.0; });
    const PixelsLeft left = fillBetweenRays(picture, {0, 33, 0, 33}, 2, 1.0);
    for (int row = 0; row < 33; ++row)
        for (int column = 1; column < 32; column += 2)
            EXPECT_EQ(left.chosen[static_cast<std::size_t>(row * 33 + column)] != 0, column >= 13 && column <= 17)
                << column << ' ' << row;
}

TEST(BetweenRays, NothingIsChosenBeyondTheBoxAndNotANumberIsCast) {
    for (const int apart : {2, 4}) {
        Picture picture = raysOnly(32, 32, apart, [](int, int) { return std::numeric_limits<double>::quiet_NaN(); });
        const PixelsLeft left = fillBetweenRays(picture, {5, 20, 9, 15}, apart, 1.0);
        for (int row = 0; row < 32; ++row)
            for (int column = 0; column < 32; ++column) {
                const bool within = column >= 4 && column < 20 && row >= 8 && row < 15;
                const bool halfWay = column % (apart / 2) == 0 && row % (apart / 2) == 0;
                EXPECT_EQ(left.chosen[static_cast<std::size_t>(row * 32 + column)] != 0,
                          within && halfWay && (column % apart != 0 || row % apart != 0))
                    << apart << ": " << column << ' ' << row;
            }
    }
}

TEST(BetweenRays, FirstRaysAreAUnitApartAtMost) {
    EXPECT_EQ(raysApart(0.1), 4);
    EXPECT_EQ(raysApart(0.25), 4);
    EXPECT_EQ(raysApart(0.26), 2);
    EXPECT_EQ(raysApart(0.5), 2);
    EXPECT_EQ(raysApart(0.51), 1);
    EXPECT_EQ(raysApart(std::numeric_limits<double>::quiet_NaN()), 1);
}

/// A view so near that pixels lie so many units apart.
RayCastSettings nearSettings(const Volume& volume, int width, int height, double pixelUnits = 0.3) {
    RayCastSettings settings = obliqueSettings(volume, width, height);
    settings.camera.heightMm = pixelUnits * height * volume.geometry().unit();
    settings.shading = Shading{.reaching = {0.75, 0.75, 0.3}};
    return settings;
}

template <typename Voxel>
void expectInterpolatedPixelsNearCastOnes(Projection projection, double pixelUnits = 0.3) {
    const auto volume = held(sectorOf(speckledShell<Voxel>({41, 43, 39}, {1, 1, 1}, 4)));
    RayCastSettings settings = nearSettings(*volume, 131, 118, pixelUnits);
    settings.camera.projection = projection;
    if (projection == Projection::perspective) settings.camera.viewAngleDegrees = 12.0;
    const OpacityCurve curve = PowerCurve{2, 0.5};
    const auto all = castRays(*volume, curve, settings);
    settings.pixelTolerance = 0.5;
    RayCaster caster(volume);
    const auto some = caster.cast(curve, settings);
    const int apartFirst = raysApart(pixelUnits);
    EXPECT_LT(caster.castShare(), apartFirst > 2 ? 0.8 : 0.95);
    EXPECT_GT(caster.castShare(), 1.0 / (apartFirst * apartFirst));
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
TEST(BetweenRays, InterpolatedPixelsOfVeryCloseRaysAreNearCastOnes) {
    expectInterpolatedPixelsNearCastOnes<std::uint8_t>(Projection::parallel, 0.15);
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

/// The box's corner lies at whatever column and row.
TEST(BetweenRays, NothingIsMissedAtTheRimOfABox) {
    const auto volume = held(speckledShell<std::uint8_t>({41, 43, 39}, {1, 1, 1}, 4));
    RayCastSettings settings = nearSettings(*volume, 131, 118, 0.2);
    const OpacityCurve curve = PowerCurve{2, 0.9};
    for (int i = 0; i < 5; ++i) {
        settings.box = RenderBox{Vec3::all(14.0 + 0.17 * i), Vec3::all(24.0 + 0.13 * i)};
        settings.pixelTolerance = 0.0;
        const auto all = castRays(*volume, curve, settings);
        settings.pixelTolerance = 0.5;
        RayCaster caster(volume);
        const auto some = caster.cast(curve, settings);
        EXPECT_LT(caster.castShare(), 0.9);
        const Apart difference = apart(*some, *all);
        EXPECT_LT(difference.rootMeanSquare, 0.6) << i;
        EXPECT_LT(difference.largest, 20.0) << i << ": a pixel that nobody cast or filled is off by a hundred";
    }
}

TEST(BetweenRays, APictureWithoutTheVolumeSaysThatAllWasCast) {
    const auto volume = held(constantVolume<std::uint8_t>({8, 8, 8}, 0.5));
    RayCastSettings settings = nearSettings(*volume, 40, 30, 0.1);
    settings.pixelTolerance = 0.5;
    settings.camera.focalPoint += settings.camera.frame.right * 1000.0;
    RayCaster caster(volume);
    const auto picture = caster.cast(PowerCurve{1, 1}, settings);
    EXPECT_EQ(picture->rgba, std::vector<float>(picture->rgba.size(), 0.0f));
    EXPECT_EQ(caster.castShare(), 1.0);
}

TEST(BetweenRays, SamePixelsForAnyNumberOfThreads) {
    const auto volume = held(sectorOf(speckledShell<std::uint8_t>({41, 43, 39}, {1, 1, 1}, 6)));
    const OpacityCurve curve = PowerCurve{2, 0.5};
    for (const double pixelUnits : {0.3, 0.15}) {
        RayCastSettings settings = nearSettings(*volume, 150, 130, pixelUnits);
        settings.pixelTolerance = 0.5;
        std::vector<float> alone;
        tbb::task_arena(1).execute([&] { alone = castRays(*volume, curve, settings)->rgba; });
        tbb::task_arena(4).execute([&] { EXPECT_EQ(castRays(*volume, curve, settings)->rgba, alone); });
    }
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
