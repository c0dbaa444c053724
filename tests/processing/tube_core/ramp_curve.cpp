// The ramp form of the curve: closed forms, and the whole method's curve recomputed from its tubes.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/phantom/phantom.h"
#include "processing/tube_core/ramp.h"

namespace echolucent {
namespace {

TubeCore tubeOf(double low, double high, double fluidSpread, double d) {
    TubeCore tube;
    tube.status = TubeStatus::surface;
    tube.lowIntensity = low;
    tube.highIntensity = high;
    tube.fluidSpread = fluidSpread;
    tube.d = d;
    return tube;
}

/// The rule begins at 0.4, ends at 1.6 of the way and is clear up to 2.5 spreads of the fluid, whatever the program's
/// own settings are.
constexpr RampRule usualRamp{.begin = 0.4, .clearSpreads = 2.5, .end = 1.6};

TEST(Ramp, OfOneTubeIsLinearBetweenFluidAndSurface) {
    struct Row {
        double fluidSpread, from, to;
    };
    // I_L is 0.1 and I_H is 0.5. The spread decides where 2.5 of it exceed 0.16; the ramp keeps 0.3 of the way.
    for (const Row& row : {Row{0.02, 0.26, 0.74}, Row{0.1, 0.35, 0.74}, Row{0.3, 0.85, 0.97}}) {
        const TubeCore tube = tubeOf(0.1, 0.5, row.fluidSpread, 0.3);
        for (int i = 0; i <= 1000; ++i) {
            const double x = i / 1000.0;
            EXPECT_NEAR(rampAt(x, tube, usualRamp), std::clamp((x - row.from) / (row.to - row.from), 0.0, 1.0), 1e-14)
                << x;
        }
        EXPECT_EQ(rampAt(row.from - 1e-9, tube, usualRamp), 0.0);
        EXPECT_GT(rampAt(row.from + 1e-9, tube, usualRamp), 0.0);
        EXPECT_EQ(rampAt(row.to + 1e-9, tube, usualRamp), 1.0);
    }
    // There is next to no rise at all: the ramp is a step, and no NaN.
    const TubeCore flat = tubeOf(0.1, std::nextafter(0.1, 1.0), 0.0, 0.3);
    EXPECT_EQ(rampAt(0.1, flat, usualRamp), 0.0);
    EXPECT_EQ(rampAt(0.2, flat, usualRamp), 1.0);
}

TEST(Ramp, TheMeanIsWeightedByD) {
    const TubeCore dark = tubeOf(0.1, 0.3, 0.0, 0.3), bright = tubeOf(0.3, 0.5, 0.0, 0.1);
    TubeCore weightless = tubeOf(0.9, 0.95, 0.0, 0.0);
    const std::vector<TubeCore> tubes{dark, weightless, bright};
    const auto mean = meanRamp(tubes, usualRamp, 256);
    ASSERT_EQ(mean.size(), 256u);
    for (int i = 0; i < 256; ++i) {
        const double x = i / 255.0;
        // The ramps run from 0.18 to 0.42 and from 0.38 to 0.62.
        const double expected =
            0.75 * std::clamp((x - 0.18) / 0.24, 0.0, 1.0) + 0.25 * std::clamp((x - 0.38) / 0.24, 0.0, 1.0);
        EXPECT_NEAR(mean[static_cast<std::size_t>(i)], expected, 1e-14) << i;
    }
    EXPECT_TRUE(meanRamp(std::vector<TubeCore>{weightless}, usualRamp, 256).empty());
    EXPECT_TRUE(meanRamp({}, usualRamp, 256).empty());
}

const Volume& shapes() {
    static const Volume volume = [] {
        PhantomConfig config = defaultPhantom(PhantomScene::shapes);
        config.size = {128, 128, 128};
        config.seed = 17;
        return *makePhantom(config);
    }();
    return volume;
}

TEST(Ramp, TheOrderOfTheTubesChangesNoBit) {
    AdaptiveOtf otf = *adaptOpacity(shapes(), {}, {});
    const RampRule& rule = std::get<RampRule>(otf.config.curve);
    const auto mean = meanRamp(otf.tubes, rule, 256);
    std::reverse(otf.tubes.begin(), otf.tubes.end());
    EXPECT_EQ(meanRamp(otf.tubes, rule, 256), mean);
    std::rotate(otf.tubes.begin(), otf.tubes.begin() + 71, otf.tubes.end());
    EXPECT_EQ(meanRamp(otf.tubes, rule, 256), mean);
}

TEST(RampCurve, HasTheSameBitsOnAnyNumberOfThreads) {
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 23, .elevationDegrees = -14}}) {
        const AdaptiveOtf otf = *adaptOpacity(shapes(), view, {});
        ASSERT_GT(otf.tubesWithWeight, 50);
        for (const std::size_t threads : {1u, 2u, 7u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const AdaptiveOtf again = *adaptOpacity(shapes(), view, {});
            EXPECT_EQ(again.logOpacity, otf.logOpacity);
            EXPECT_EQ(again.curve, otf.curve);
            EXPECT_EQ(again.leastContrast, otf.leastContrast);
            EXPECT_EQ(again.fluidIntensity, otf.fluidIntensity);
            for (std::size_t t = 0; t < otf.tubes.size(); ++t) {
                EXPECT_EQ(again.tubes[t].d, otf.tubes[t].d);
                EXPECT_EQ(again.tubes[t].surfaceCell, otf.tubes[t].surfaceCell);
                EXPECT_EQ(again.tubes[t].cellMeans, otf.tubes[t].cellMeans);
            }
        }
    }
}

/// The curve from nothing but the tubes' own numbers and the config, in long double.
std::vector<long double> curveFromTubes(const AdaptiveOtf& otf) {
    const AdaptiveOtfConfig& config = otf.config;
    const RampRule& rule = std::get<RampRule>(config.curve);
    int meeting = 0, weighted = 0;
    for (const TubeCore& tube : otf.tubes) {
        meeting += tube.status != TubeStatus::outside ? 1 : 0;
        weighted += tube.d > 0 ? 1 : 0;
    }
    const long double needed = static_cast<long double>(rule.trustedShare) * meeting;
    const long double trust = needed > 0 ? std::min(1.0L, weighted / needed) : 1.0L;
    std::vector<long double> curve;
    for (int i = 0; i < AdaptiveOtf::sampleCount; ++i) {
        const long double x = i / static_cast<long double>(AdaptiveOtf::sampleCount - 1);
        long double sum = 0, weight = 0;
        for (const TubeCore& tube : otf.tubes) {
            if (tube.d <= 0) continue;
            const long double low = *tube.lowIntensity, rise = *tube.highIntensity - low;
            const long double clear = std::max<long double>(
                rule.begin * rise, static_cast<long double>(rule.clearSpreads) * *tube.fluidSpread);
            const long double full = std::max<long double>(rule.end * rise, clear + leastRampWidth * rise);
            sum += tube.d * std::clamp((x - low - clear) / (full - clear), 0.0L, 1.0L);
            weight += tube.d;
        }
        const long double initial = opacityAt(config.initial, static_cast<double>(x));
        const long double aim = rule.aim, wall = otf.everyWall ? opacityAt(*otf.everyWall, static_cast<double>(x)) : 0;
        curve.push_back(trust * rule.opacity * ((1 - aim) * (sum / weight) + aim * wall) + (1 - trust) * initial);
    }
    return curve;
}

void expectCurveFollows(const AdaptiveOtf& otf) {
    ASSERT_EQ(otf.message, "");
    const auto expected = curveFromTubes(otf);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        // The ramps are a tenth of the range wide: their slope makes 1e-16 of intensity a few 1e-15 of opacity.
        EXPECT_NEAR(otf.curve.opacities[i], static_cast<double>(expected[i]), 5e-15) << i;
        if (expected[i] > 1e-6L) {
            EXPECT_NEAR(otf.logOpacity[i], static_cast<double>(std::log(expected[i])), 1e-9) << i;
        }
    }
}

TEST(RampCurve, FollowsFromTheTubes) {
    const AdaptiveOtf otf = *adaptOpacity(shapes(), {}, {});
    EXPECT_EQ(otf.trust, 1.0);
    expectCurveFollows(otf);
    AdaptiveOtfConfig other;
    other.grid.columns = 9;
    other.grid.rows = 21;
    other.curve = RampRule{.begin = -0.2, .clearSpreads = 0.7, .end = 0.9, .opacity = 0.35};
    expectCurveFollows(*adaptOpacity(shapes(), {.azimuthDegrees = -31, .elevationDegrees = 12}, other));
}

TEST(RampCurve, IsMixedWithTheInitialFunctionWhereFewTubesSpeak) {
    AdaptiveOtfConfig config;
    config.initial = LinearCurve{};
    config.curve = RampRule{.opacity = 0.8, .trustedShare = 1.0};
    const AdaptiveOtf otf = *adaptOpacity(shapes(), {}, config);
    EXPECT_DOUBLE_EQ(otf.trust, static_cast<double>(otf.tubesWithWeight) / otf.tubesMeetingVolume);
    EXPECT_GT(otf.trust, 0.1);
    EXPECT_LT(otf.trust, 0.99);
    expectCurveFollows(otf);
    config.curve = RampRule{.opacity = 0.8, .trustedShare = 0.0};
    EXPECT_EQ(adaptOpacity(shapes(), {}, config)->trust, 1.0);
}

TEST(RampCurve, DoesNotDependOnTheNumberOfTubes) {
    AdaptiveOtfConfig few, many;
    few.grid.spacing = 8;
    many.grid.columns = many.grid.rows = 50;
    many.grid.spacing = 2.4;
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 19, .elevationDegrees = 7}}) {
        const AdaptiveOtf of225 = *adaptOpacity(shapes(), view, few), of2500 = *adaptOpacity(shapes(), view, many);
        ASSERT_GT(of2500.tubesMeetingVolume, 2000);
        double most = 0, squares = 0;
        for (std::size_t i = 0; i < of225.curve.opacities.size(); ++i) {
            const double differing = std::abs(of225.curve.opacities[i] - of2500.curve.opacities[i]);
            most = std::max(most, differing);
            squares += differing * differing;
        }
        std::printf("T = %d against %d: curves differ by at most %.4f, RMS %.4f\n", of225.tubesMeetingVolume,
                    of2500.tubesMeetingVolume, most, std::sqrt(squares / AdaptiveOtf::sampleCount));
        // The mean of 150 ramps stands within some 0.5 / sqrt(150).
        EXPECT_LE(most, 0.06);
    }
}

}  // namespace
}  // namespace echolucent
