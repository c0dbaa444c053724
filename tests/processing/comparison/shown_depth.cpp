// The shown depth against closed forms: where half of the light is held back.
#include "processing/comparison/shown_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/processing/comparison/small_volumes.h"

namespace echolucent {
namespace {

constexpr double noData = std::numeric_limits<double>::quiet_NaN();

OpacityTable tableOf(const Classification& classification) { return OpacityTable(classification); }
/// Clear below an intensity of 0.4, opaque from there on.
OpacityTable step() { return tableOf(ManualCurve{{{0.4, 0.0}, {0.4, 1.0}}}); }

TEST(ShownDepth, OfOneOpacityIsWhereTheSeriesReachesOneHalf) {
    const RaySamples ray{std::vector<double>(400, 0.5), {}};
    for (const double opacity : {0.01, 0.07, 0.2, 0.6}) {
        const auto shown = shownSample(ray, tableOf(constantOpacity(opacity)));
        // So many samples hold half of the light back. The last one counts in part, along a line.
        const double exact = std::log(0.5) / std::log(1.0 - opacity), whole = std::ceil(exact) - 1.0;
        const double left = std::pow(1.0 - opacity, whole);
        ASSERT_TRUE(shown);
        EXPECT_NEAR(*shown, whole - 1.0 + (left - 0.5) / (left * opacity), 1e-9) << opacity;
        EXPECT_NEAR(*shown, exact - 1.0, 0.1) << "a line is near the power";
    }
}

TEST(ShownDepth, OfAnOpaqueStepIsTheMiddleBetweenItsSamples) {
    std::vector<double> intensities(20, 0.1);
    intensities.insert(intensities.end(), 20, 0.8);
    EXPECT_DOUBLE_EQ(*shownSample({intensities, {}}, step()), 19.5);
    EXPECT_DOUBLE_EQ(*shownSample({{0.8, 0.8}, {}}, step()), -0.5) << "opaque from the first sample on";
}

TEST(ShownDepth, IsNotThereWhereHalfOfTheLightComesThrough) {
    const RaySamples ray{std::vector<double>(6, 0.5), {}};
    EXPECT_FALSE(shownSample(ray, tableOf(constantOpacity(0.0))));
    EXPECT_FALSE(shownSample(ray, tableOf(constantOpacity(0.1)))) << "0.9^6 is above one half";
    EXPECT_TRUE(shownSample(ray, tableOf(constantOpacity(0.2)))) << "0.8^6 is below one half";
    EXPECT_FALSE(shownSample({}, step()));
    EXPECT_DOUBLE_EQ(*shownSample({{0.5, 0.5}, {}}, tableOf(constantOpacity(0.5))), 0.0) << "exactly one half";
}

TEST(ShownDepth, SamplesWithoutDataHoldNothingBack) {
    EXPECT_DOUBLE_EQ(*shownSample({{noData, noData, 0.1, noData, 0.9}, {}}, step()), 3.5);
    EXPECT_FALSE(shownSample({std::vector<double>(9, noData), {}}, tableOf(constantOpacity(1.0))));
    const RaySamples holed{{0.5, noData, 0.5, 0.5}, {}};  // 0.4, 0.64: reaches one half a share of 0.1/0.24 of the way
    EXPECT_NEAR(*shownSample(holed, tableOf(constantOpacity(0.4))), 1.0 + 0.1 / 0.24, 1e-9);
}

TEST(ShownDepth, HazeBeforeAWallMovesItForward) {
    std::vector<double> intensities(10, 0.3);
    intensities.insert(intensities.end(), 5, 1.0);
    const auto hazed = [&](double haze) { return tableOf(ManualCurve{{{0.3, haze}, {0.9, haze}, {0.9, 1.0}}}); };
    const double left = std::pow(1.0 - 0.05, 10);  // 0.599 comes to the wall
    EXPECT_NEAR(*shownSample({intensities, {}}, hazed(0.05)), 9.0 + (left - 0.5) / left, 1e-6);
    EXPECT_EQ(shownSurfaceAt(*shownSample({intensities, {}}, hazed(0.05)) - 9.5), ShownSurface::right);
    EXPECT_EQ(shownSurfaceAt(*shownSample({intensities, {}}, hazed(0.10)) - 9.5), ShownSurface::early)
        << "0.9^7 is below one half: the haze holds it back";
}

TEST(ShownDepth, AsksTheGradientOfATwoDimensionalOtf) {
    const RaySamples ray{{0.5, 0.5, 0.5, 0.5}, {0.0, 0.0, 0.6, 0.0}};
    EXPECT_NEAR(*shownSample(ray, tableOf(opacityOfGradient(0.6))), 1.5, 1e-6);
}

TEST(ShownDepth, IsRightWithinTwoUnitsAndTheLimitsCount) {
    EXPECT_EQ(shownSurfaceAt(0.0), ShownSurface::right);
    EXPECT_EQ(shownSurfaceAt(-2.0), ShownSurface::right);
    EXPECT_EQ(shownSurfaceAt(2.0), ShownSurface::right);
    EXPECT_EQ(shownSurfaceAt(std::nextafter(-2.0, -3.0)), ShownSurface::early);
    EXPECT_EQ(shownSurfaceAt(std::nextafter(2.0, 3.0)), ShownSurface::late);
    EXPECT_EQ(shownSurfaceAt(std::nullopt), ShownSurface::never);
}

TEST(ShownDepth, CountsRaysAndTellsShares) {
    ShownDepth depth;
    EXPECT_FALSE(depth.share(ShownSurface::right)) << "there is no ray";
    for (const ShownSurface one : {ShownSurface::right, ShownSurface::early, ShownSurface::right, ShownSurface::never,
                                   ShownSurface::late, ShownSurface::right, ShownSurface::right, ShownSurface::never})
        depth.count(one);
    EXPECT_EQ(depth, (ShownDepth{.right = 4, .early = 1, .late = 1, .never = 2}));
    EXPECT_EQ(depth.share(ShownSurface::right), 0.5);
    EXPECT_EQ(depth.share(ShownSurface::early), 0.125);
    EXPECT_EQ(depth.share(ShownSurface::late), 0.125);
    EXPECT_EQ(depth.share(ShownSurface::never), 0.25);
    depth += ShownDepth{.right = 1, .early = 2, .late = 3, .never = 4};
    EXPECT_EQ(depth, (ShownDepth{.right = 5, .early = 3, .late = 4, .never = 6}));
    EXPECT_EQ(depth.rays(), 18);
}

}  // namespace
}  // namespace echolucent
