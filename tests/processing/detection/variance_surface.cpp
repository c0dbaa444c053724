#include "processing/detection/variance_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace echolucent {
namespace {

/// From 1 on, by `perSample` from each sample to the next.
std::vector<double> slopeOf(int count, double perSample) {
    std::vector<double> function;
    for (int i = 0; i < count; ++i) function.push_back(1.0 + perSample * i);
    return function;
}

std::vector<double> stairs(std::initializer_list<std::pair<int, double>> steps) {
    std::vector<double> function;
    for (const auto& [count, value] : steps) function.insert(function.end(), static_cast<std::size_t>(count), value);
    return function;
}

std::vector<int> track(const std::vector<double>& function, const VarianceRule& rule = {}) {
    DetectionScratch scratch;
    const ScaleSpace space(rule);
    ScaleSmoother smoother(space);
    return trackSurface(function, smoother, rule, scratch);
}

TEST(FirstSignificantMaximum, TakesTheFirstThatIsLargeEnough) {
    const std::vector<double> function{0, 1, 0, 5, 2, 10, 3};
    EXPECT_EQ(firstSignificantMaximum(function, {0, 6}, 0.4), 3);
    EXPECT_EQ(firstSignificantMaximum(function, {0, 6}, 0.6), 5);
    EXPECT_EQ(firstSignificantMaximum(function, {0, 6}, 0.0), 1);
    EXPECT_EQ(firstSignificantMaximum(function, {0, 2}, 1.0), 1) << "significance is relative to the range";
    EXPECT_EQ(firstSignificantMaximum(function, {4, 6}, 0.4), 5);
}

TEST(FirstSignificantMaximum, CountsAPlateauOnceAtItsMiddle) {
    const auto function = stairs({{3, 0.0}, {5, 1.0}, {4, 0.5}});
    EXPECT_EQ(firstSignificantMaximum(function, {0, 11}, 0.4), 5);
    EXPECT_EQ(firstSignificantMaximum(function, {6, 11}, 0.4), std::nullopt);
}

TEST(FirstSignificantMaximum, NeverTakesTheEnds) {
    EXPECT_FALSE(firstSignificantMaximum(std::vector<double>{3, 2, 1}, {0, 2}, 0.0));
    EXPECT_FALSE(firstSignificantMaximum(std::vector<double>{1, 2, 3}, {0, 2}, 0.0));
    EXPECT_FALSE(firstSignificantMaximum(std::vector<double>{3, 3, 1, 2, 2}, {0, 4}, 0.0));
    EXPECT_FALSE(firstSignificantMaximum(std::vector<double>{1}, {0, 0}, 0.0));
    EXPECT_FALSE(firstSignificantMaximum(std::vector<double>{}, {0, -1}, 0.0));
    EXPECT_FALSE(firstSignificantMaximum(stairs({{20, 0.0}}), {0, 19}, 0.0));
    EXPECT_FALSE(firstSignificantMaximum(slopeOf(20, 0.1), {0, 19}, 0.0));
}

TEST(ValleyToValley, GoesDownBothSidesOnly) {
    const std::vector<double> function{5, 1, 0.5, 2, 7, 3, 3, 1, 4};
    const IndexRange range = valleyToValley(function, 4);
    EXPECT_EQ(range.first, 2);
    EXPECT_EQ(range.last, 7);
}

TEST(TrackSurface, FindsNoSurfaceInConstantsRampsAndStairs) {
    EXPECT_TRUE(track(stairs({{195, 0.0}})).empty());
    EXPECT_TRUE(track(stairs({{195, 0.37}})).empty());
    EXPECT_TRUE(track(slopeOf(195, 0.01)).empty());
    EXPECT_TRUE(track(slopeOf(195, -0.005)).empty());
    EXPECT_TRUE(track(stairs({{80, 0.1}, {115, 1.0}})).empty());
    EXPECT_TRUE(track(stairs({{60, 0.1}, {60, 0.5}, {75, 1.0}})).empty());
    EXPECT_TRUE(track({}).empty());
    EXPECT_TRUE(track({1.0}).empty());
    EXPECT_TRUE(track({1.0, 2.0}).empty());
}

TEST(TrackSurface, FollowsAPeakThroughAllScales) {
    std::vector<double> function;
    for (int i = 0; i < 195; ++i) function.push_back(0.1 + std::exp(-0.5 * std::pow((i - 120) / 3.0, 2)));
    const auto tracked = track(function);
    ASSERT_EQ(tracked.size(), 6u) << "five scales and the unsmoothed function";
    EXPECT_EQ(tracked.back(), 120);
    EXPECT_NEAR(tracked[4], 120, 1);
}

TEST(TrackSurface, APeakIsFoundAtAnyDepth) {
    // The surface is also found where a cut kernel's end, or its mirror image's, passes over the peak, and where mirror
    // image and peak are one at the coarse scales.
    for (int position = 3; position < 190; ++position) {
        std::vector<double> function(195, 1e-4);
        function[static_cast<std::size_t>(position)] = 1.0;
        const auto tracked = track(function);
        ASSERT_FALSE(tracked.empty()) << position;
        EXPECT_EQ(tracked.back(), position);
    }
}

TEST(TakeOffFloor, LeavesWhatExceedsTheQuantile) {
    std::vector<double> result;
    takeOffFloor(std::vector<double>{5, 3, 4, 9, 6}, 0.25, result);
    EXPECT_EQ(result, (std::vector<double>{1, 0, 0, 5, 2}));
    takeOffFloor(std::vector<double>{5, 3, 4}, 0.0, result);
    EXPECT_EQ(result, (std::vector<double>{5, 3, 4}));
    takeOffFloor({}, 0.25, result);
    EXPECT_TRUE(result.empty());
}

TEST(TrackSurface, APeakOnAHighFloorOfNoiseIsFoundOnlyWithoutTheFloor) {
    // Log-compressed speckle has the same variance everywhere, and the peak is twice as high.
    std::vector<double> function;
    std::uint32_t state = 77;
    for (int i = 0; i < 195; ++i)
        function.push_back(1.0 + 0.4 * (((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0) +
                           1.2 * std::exp(-0.5 * std::pow((i - 130) / 3.0, 2)));
    EXPECT_NEAR(track(function, {.floorQuantile = 0.25}).back(), 130, 3);
    const auto asSettled = track(function, {.floorQuantile = 0.0});
    EXPECT_TRUE(asSettled.empty() || std::abs(asSettled.back() - 130) > 30);
}

TEST(TrackSurface, ShortTubesBeginAtTheScaleThatHasRoom) {
    std::vector<double> function(40, 0.01);
    for (int i = 0; i < 40; ++i) function[static_cast<std::size_t>(i)] += std::exp(-0.5 * std::pow((i - 22) / 2.0, 2));
    const auto tracked = track(function);
    ASSERT_FALSE(tracked.empty());
    EXPECT_LE(tracked.size(), 6u);
    EXPECT_EQ(tracked.back(), 22);
}

TEST(TrackSurface, PrefersTheFirstOfTwoEqualPeaksApart) {
    std::vector<double> function(300, 0.001);
    function[90] = function[210] = 1.0;
    EXPECT_EQ(track(function).back(), 90);
}

TEST(TrackSurface, TheCoarsestScaleMayBeAskedToHaveAMaximum) {
    // The peak is too near to the front for the coarsest scale: peak and mirror image are one hill at the border.
    std::vector<double> function(195, 1e-4);
    function[12] = 1.0;
    const auto any = track(function, {.coarsestMustHaveMaximum = false});
    ASSERT_FALSE(any.empty());
    EXPECT_LT(any.size(), 6u);
    EXPECT_TRUE(track(function, {.coarsestMustHaveMaximum = true}).empty());
    function[12] = 1e-4;
    function[100] = 1.0;
    EXPECT_EQ(track(function, {.coarsestMustHaveMaximum = true}).size(), 6u);
}

TEST(TrackSurface, ARangeInSigmasIsThatOfTheScaleWhereTheMaximumWasFound) {
    // There is one scale, sigma 4, with its maximum at 100; the unsmoothed function has single peaks beside it.
    const auto ruleOf = [](double sigmas) {
        return VarianceRule{.coarsestScale = 4, .finestScale = 4, .floorQuantile = 0, .trackingRangeSigmas = sigmas};
    };
    std::vector<double> function(200, 0.0);
    for (int i = 0; i < 200; ++i)
        function[static_cast<std::size_t>(i)] = std::exp(-0.5 * std::pow((i - 100) / 20.0, 2));
    function[100] += 0.01;
    function[91] += 0.2;
    function[109] += 0.2;
    EXPECT_EQ(track(function, ruleOf(2.0)), (std::vector<int>{100, 100})) << "92 to 108";
    EXPECT_EQ(track(function, ruleOf(2.25)), (std::vector<int>{100, 91})) << "91 to 109";
}

TEST(TrackSurface, PassesOverABumpBelowTheThreshold) {
    std::vector<double> function(300, 0.001);
    for (int i = 0; i < 300; ++i)
        function[static_cast<std::size_t>(i)] +=
            0.05 * std::exp(-0.5 * std::pow((i - 60) / 4.0, 2)) + std::exp(-0.5 * std::pow((i - 220) / 4.0, 2));
    EXPECT_EQ(track(function).back(), 220);
    EXPECT_EQ(track(function, {.significance = 0.0}).back(), 60);
}

}  // namespace
}  // namespace echolucent
