#include "processing/motion/phase_times.h"

#include <limits>

#include <gtest/gtest.h>

namespace echolucent {
namespace {

TEST(PhaseTimes, EvenTimesAreTheirMean) {
    const PhaseTimes times = phaseTimesAt({10.0, 10.04, 10.08, 10.12});
    EXPECT_NEAR(times.meanSeconds.value_or(0), 0.04, 1e-12);
    EXPECT_TRUE(times.starts.empty());
    EXPECT_NEAR(secondsOfPhase(times, 3).value_or(0), 0.12, 1e-12);
    EXPECT_NEAR(secondsBetween(times, 3, 0).value_or(0), 0.04, 1e-12);
    EXPECT_NEAR(gapsOf(times).value().second, 0.04, 1e-12);
}

TEST(PhaseTimes, UnevenTimesAreKeptFromTheFirstOn) {
    const PhaseTimes times = phaseTimesAt({0.5, 0.6, 0.9});
    ASSERT_EQ(times.starts.size(), 3u);
    EXPECT_NEAR(times.meanSeconds.value_or(0), 0.2, 1e-12);
    EXPECT_EQ(secondsOfPhase(times, 0), 0.0);
    EXPECT_NEAR(secondsOfPhase(times, 2).value_or(0), 0.4, 1e-12);
    EXPECT_FALSE(secondsOfPhase(times, 3));
    EXPECT_NEAR(secondsBetween(times, 1, 2).value_or(0), 0.3, 1e-12);
    EXPECT_NEAR(secondsBetween(times, 2, 1).value_or(0), 0.3, 1e-12);
    EXPECT_NEAR(secondsBetween(times, 2, 0).value_or(0), 0.2, 1e-12);
    EXPECT_NEAR(gapsOf(times).value().first, 0.1, 1e-12);
    EXPECT_NEAR(gapsOf(times).value().second, 0.3, 1e-12);
}

TEST(PhaseTimes, TimesThatDoNotRiseAreUnknown) {
    const double never = std::numeric_limits<double>::quiet_NaN(), ever = std::numeric_limits<double>::infinity();
    const double most = std::numeric_limits<double>::max();
    for (const std::vector<double>& seconds : std::vector<std::vector<double>>{
             {}, {1.0}, {1.0, 1.0}, {2.0, 1.0}, {0.0, never, 1.0}, {0.0, ever}, {-most, most}, {1e300, 1e300, 2e300}})
        EXPECT_EQ(phaseTimesAt(seconds), PhaseTimes{});
    for (const double seconds : {0.0, -1.0, never, ever}) EXPECT_EQ(PhaseTimes::every(seconds), PhaseTimes{});
    EXPECT_FALSE(gapsOf({}));
    EXPECT_FALSE(secondsBetween({}, 0, 1));
}

TEST(PhaseTimes, OnlyTimesThatAPhaseCanHaveAreTaken) {
    EXPECT_TRUE(areTimesOf({}, 3));
    EXPECT_TRUE(areTimesOf(PhaseTimes::every(0.1), 1));
    EXPECT_TRUE(areTimesOf(phaseTimesAt({0.0, 0.1, 0.4}), 3));
    EXPECT_FALSE(areTimesOf(phaseTimesAt({0.0, 0.1, 0.4}), 2));
    EXPECT_FALSE(areTimesOf({.meanSeconds = std::nullopt, .starts = {0.0, 0.1}}, 2));
    EXPECT_FALSE(areTimesOf({.meanSeconds = 0.1, .starts = {0.0, 0.3}}, 2));
    EXPECT_FALSE(areTimesOf({.meanSeconds = 0.1, .starts = {0.1, 0.2}}, 2));
    EXPECT_FALSE(areTimesOf({.meanSeconds = -0.1, .starts = {}}, 2));
}

}  // namespace
}  // namespace echolucent
