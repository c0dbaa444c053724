#include "processing/explanation/tube_factors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "processing/adaptive/found_ramp.h"
#include "tests/processing/explanation/explained_scan.h"

namespace echolucent {
namespace {

TEST(GrownCurve, IsTheInitialFunctionAtFirstAndTheRunsCurveInTheEnd) {
    AdaptiveOtfConfig distrusted;
    std::get<RampRule>(distrusted.curve).trustedShare = 1.0;
    const ExplainedRun half(distrusted, explainedQuiet());
    ASSERT_LT(half.otf.trust, 1.0);
    for (const ExplainedRun* run : {&publishedRun(), &defaultRun(), &half}) {
        const std::size_t all = heaviestFirst(run->otf).size();
        ASSERT_EQ(all, static_cast<std::size_t>(run->otf.tubesWithWeight));
        EXPECT_EQ(grownCurve(run->otf, 0).opacities,
                  sampledOpacities(run->otf.config.initial, AdaptiveOtf::sampleCount));
        EXPECT_EQ(grownCurve(run->otf, all), run->otf.curve);
        EXPECT_EQ(grownCurve(run->otf, all + 9), run->otf.curve);
        EXPECT_NE(grownCurve(run->otf, all - 1), run->otf.curve);
    }
}

TEST(GrownCurve, TakesTheHeaviestFirst) {
    const AdaptiveOtf& otf = publishedRun().otf;
    const std::vector<int> order = heaviestFirst(otf);
    for (std::size_t i = 1; i < order.size(); ++i) {
        const double before = otf.tubes[static_cast<std::size_t>(order[i - 1])].d;
        const double here = otf.tubes[static_cast<std::size_t>(order[i])].d;
        EXPECT_TRUE(before > here || (before == here && order[i - 1] < order[i])) << i;
    }
    const auto factors = allFactors(otf);
    const SampledCurve two = grownCurve(otf, 2);
    for (std::size_t i = 0; i < two.opacities.size(); ++i) {
        const double initial = opacityAt(otf.config.initial, AdaptiveOtf::intensityOf(i));
        ASSERT_NEAR(two.opacities[i], std::min(1.0, initial * factors[0].values[i] * factors[1].values[i]), 1e-12);
    }
}

TEST(AllFactors, TimesTheInitialFunctionAreTheCurve) {
    const AdaptiveOtf& otf = publishedRun().otf;
    const auto factors = allFactors(otf);
    ASSERT_EQ(factors.size(), static_cast<std::size_t>(otf.tubesWithWeight));
    EXPECT_EQ(allFactors(otf, 5).size(), 5u);
    for (std::size_t i = 0; i < otf.curve.opacities.size(); ++i) {
        double product = opacityAt(otf.config.initial, AdaptiveOtf::intensityOf(i));
        for (const TubeFactor& factor : factors) product *= factor.values[i];
        ASSERT_NEAR(std::min(1.0, product), otf.curve.opacities[i], 1e-12) << i;
    }
}

TEST(AllFactors, AsRampsHaveTheCurvesMean) {
    const AdaptiveOtf& otf = defaultRun().otf;
    const auto& rule = std::get<RampRule>(otf.config.curve);
    const auto factors = allFactors(otf);
    ASSERT_TRUE(otf.everyWall);
    for (std::size_t i = 0; i < otf.curve.opacities.size(); ++i) {
        const double x = AdaptiveOtf::intensityOf(i);
        double sum = 0.0, weight = 0.0;
        for (const TubeFactor& factor : factors) {
            sum += factor.d * factor.values[i];
            weight += factor.d;
        }
        const double ramps = (1.0 - rule.aim) * sum / weight + rule.aim * opacityAt(*otf.everyWall, x);
        const double initial = opacityAt(otf.config.initial, x);
        ASSERT_NEAR(otf.trust * rule.opacity * ramps + (1.0 - otf.trust) * initial, otf.curve.opacities[i], 1e-12) << i;
    }
}

}  // namespace
}  // namespace echolucent
