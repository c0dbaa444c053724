#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "processing/motion/flicker.h"
#include "processing/motion/otf_smoothing.h"

namespace echolucent {
namespace {

constexpr std::array allSmoothings{OtfSmoothing::none, OtfSmoothing::mean, OtfSmoothing::movingLeastSquares,
                                   OtfSmoothing::leastFlicker};

std::vector<double> evenTimes(std::size_t count) {
    std::vector<double> times(count);
    std::iota(times.begin(), times.end(), 0.0);
    return times;
}

std::vector<double> fullWeights(OtfSmoothing smoothing) {
    return smoothingWeights(smoothing, evenTimes(framesUsed(smoothing)));
}

void expectWeights(const std::vector<double>& weights, const std::vector<double>& expected, double tolerance = 1e-14) {
    ASSERT_EQ(weights.size(), expected.size());
    for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(weights[i], expected[i], tolerance) << i;
}

TEST(OtfSmoothing, NamesAreReadBack) {
    for (const OtfSmoothing smoothing : allSmoothings) EXPECT_EQ(otfSmoothingFromName(nameOf(smoothing)), smoothing);
    EXPECT_EQ(nameOf(OtfSmoothing::leastFlicker), "least-flicker");
    EXPECT_EQ(nameOf(OtfSmoothing::movingLeastSquares), "mls");
    EXPECT_FALSE(otfSmoothingFromName("median"));
}

TEST(OtfSmoothing, GainsAreThoseOfTheNote) {
    struct Row {
        OtfSmoothing smoothing;
        double delay, noise, flicker;
    };
    for (const Row& row :
         {Row{OtfSmoothing::none, 0, 1, 1}, Row{OtfSmoothing::mean, 2, 0.447, 0.163},
          Row{OtfSmoothing::movingLeastSquares, 0, 0.941, 0.756}, Row{OtfSmoothing::leastFlicker, 2, 0.456, 0.081}}) {
        const SmoothingGains gains = gainsOf(row.smoothing);
        EXPECT_NEAR(gains.delay, row.delay, 1e-12) << nameOf(row.smoothing);
        EXPECT_NEAR(gains.noise, row.noise, 1e-3) << nameOf(row.smoothing);
        EXPECT_NEAR(gains.flicker, row.flicker, 1e-3) << nameOf(row.smoothing);
        EXPECT_EQ(gains.leastWeight < 0, row.smoothing == OtfSmoothing::movingLeastSquares);
    }
}

TEST(OtfSmoothing, NoiseAndFlickerOfACourseFallByTheGains) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0.5, 0.05);
    constexpr std::size_t samples = 256;
    for (const OtfSmoothing smoothing : allSmoothings) {
        OtfHistory history(smoothing);
        std::vector<SampledCurve> unsmoothed, shown;
        for (int frame = 0; frame < 400; ++frame) {
            SampledCurve curve{std::vector<double>(samples)};
            for (double& opacity : curve.opacities) opacity = noise(random);
            const SampledCurve smoothed = history.add(frame, curve);
            if (frame < 10) continue;
            unsmoothed.push_back(curve);
            shown.push_back(smoothed);
        }
        EXPECT_NEAR(otfFlicker(shown) / otfFlicker(unsmoothed), gainsOf(smoothing).flicker, 0.01) << nameOf(smoothing);
    }
}

TEST(OtfSmoothing, LagIsTheMeanAgeOfTheWeights) {
    for (const OtfSmoothing smoothing : allSmoothings)
        EXPECT_NEAR(lagOf(smoothing).ramp, gainsOf(smoothing).delay, 1e-10) << nameOf(smoothing);
    EXPECT_EQ(lagOf(OtfSmoothing::none).stepToNineTenths, 0);
    EXPECT_EQ(lagOf(OtfSmoothing::mean).stepToNineTenths, 4);
    // The sum 63 + 114 + 124 + 96 = 397 of 462 is 0.86; with 51 more it is 0.97.
    EXPECT_EQ(lagOf(OtfSmoothing::leastFlicker).stepToNineTenths, 4);
    EXPECT_NEAR(lagOf(OtfSmoothing::leastFlicker).overshoot, 0.0, 1e-15);
    // Behind a step the newest two weights add up to 31 + 9 of 35.
    EXPECT_NEAR(lagOf(OtfSmoothing::movingLeastSquares).overshoot, 5.0 / 35, 1e-12);
}

TEST(MovingLeastSquares, EqualTimesGiveTheClosedForm) {
    const double n = 35;
    expectWeights(fullWeights(OtfSmoothing::movingLeastSquares), {3 / n, -5 / n, -3 / n, 9 / n, 31 / n});
}

TEST(MovingLeastSquares, FewFramesLowerTheOrder) {
    const auto weights = [](std::vector<double> times) {
        return smoothingWeights(OtfSmoothing::movingLeastSquares, times);
    };
    expectWeights(weights({3}), {1});
    expectWeights(weights({3, 9}), {0, 1});         // order 1 through two
    expectWeights(weights({3, 9, 10}), {0, 0, 1});  // order 2 through three
    // With four equal steps and order 2 this is the newest row of the projection, [19 3 -3 1]/20.
    expectWeights(weights({0, 1, 2, 3}), {1 / 20., -3 / 20., 3 / 20., 19 / 20.});
}

TEST(MovingLeastSquares, TimesThatCannotBeToldApartLowerTheOrder) {
    // There are two clusters, so no parabola can be told from a line. The newest cluster's mean is what a line gives.
    const double close = 1e-14;
    const auto weights =
        smoothingWeights(OtfSmoothing::movingLeastSquares, std::vector<double>{0, close, 2 * close, 1, 1 + 4 * close});
    expectWeights(weights, {0, 0, 0, 0.5, 0.5}, 1e-9);
}

TEST(MovingLeastSquares, UnevenTimesReproduceEveryParabola) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int trial = 0; trial < 1000; ++trial) {
        std::vector<double> times(5);
        double time = 10 * uniform(random);
        for (double& t : times) t = time += 0.05 + uniform(random);
        const double a = uniform(random), b = uniform(random), c = uniform(random);
        const auto parabola = [&](double t) { return a + b * (t - times[0]) + c * (t - times[0]) * (t - times[0]); };
        const auto weights = smoothingWeights(OtfSmoothing::movingLeastSquares, times);
        double shown = 0;
        for (std::size_t i = 0; i < 5; ++i) shown += weights[i] * parabola(times[i]);
        EXPECT_NEAR(shown, parabola(times.back()), 1e-9);
    }
}

/// Half the gradient of the squared second differences of w, where w is padded with zeros.
std::vector<double> flickerGradient(const std::vector<double>& w) {
    const auto count = static_cast<std::ptrdiff_t>(w.size());
    const auto at = [&](std::ptrdiff_t i) { return i >= 0 && i < count ? w[static_cast<std::size_t>(i)] : 0.0; };
    std::vector<double> gradient;
    for (std::ptrdiff_t i = 0; i < count; ++i)
        gradient.push_back(at(i - 2) - 4 * at(i - 1) + 6 * at(i) - 4 * at(i + 1) + at(i + 2));
    return gradient;
}

TEST(LeastFlicker, WeightsAreTheOptimumOverAnyLength) {
    // The Karush-Kuhn-Tucker conditions: the gradient is linear in age where a weight is above 0, and not below that
    // line where it is 0. The problem is convex, so they prove the least flicker of all weights of that delay.
    std::vector<double> w = fullWeights(OtfSmoothing::leastFlicker);
    std::reverse(w.begin(), w.end());
    const std::size_t taps = w.size();
    w.resize(taps + 30, 0.0);
    const std::vector<double> gradient = flickerGradient(w);
    const double offset = gradient[0], slope = gradient[1] - gradient[0];
    for (std::size_t age = 0; age < w.size(); ++age) {
        const double excess = gradient[age] - (offset + slope * static_cast<double>(age));
        if (age < taps) {
            EXPECT_GT(w[age], 0.0);
            EXPECT_NEAR(excess, 0.0, 1e-14) << age;
        } else {
            EXPECT_GE(excess, -1e-14) << age;
        }
    }
    double sum = 0, delay = 0;
    for (std::size_t age = 0; age < w.size(); ++age) {
        sum += w[age];
        delay += w[age] * static_cast<double>(age);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_NEAR(delay, 2, 1e-14);
}

TEST(LeastFlicker, FewerFramesAreTheNewestTapsOverTheirSum) {
    expectWeights(smoothingWeights(OtfSmoothing::leastFlicker, evenTimes(1)), {1});
    expectWeights(smoothingWeights(OtfSmoothing::leastFlicker, evenTimes(3)), {124 / 301., 114 / 301., 63 / 301.});
}

TEST(LeastFlicker, AFrameAfterALongPauseStandsForItself) {
    const auto weights = smoothingWeights(OtfSmoothing::leastFlicker, std::vector<double>{0, 1, 2, 3, 4, 1000});
    EXPECT_GT(weights.back(), 0.6);
    for (const double weight : weights) EXPECT_GT(weight, 0.0);
    // Frames in a burst share the weight of the time they stand for.
    const auto burst = smoothingWeights(OtfSmoothing::leastFlicker, std::vector<double>{0, 1, 2, 2.9, 2.95, 3});
    EXPECT_LT(burst[5], 0.5 * burst[2]);
}

TEST(OtfSmoothing, TheTimesOriginAndUnitDoNotMatter) {
    // The times are epoch milliseconds; frames lie 33 ms apart, jittered by whole milliseconds.
    const std::vector<double> jitter{0, 1, -2, 0, 3, -1};
    for (const OtfSmoothing smoothing : allSmoothings) {
        std::vector<double> plain, epoch, tiny, huge;
        for (std::size_t i = 0; i < framesUsed(smoothing); ++i) {
            plain.push_back(33.0 * static_cast<double>(i) + jitter[i]);
            epoch.push_back(1.7e12 + plain.back());
            tiny.push_back(std::ldexp(plain.back(), -600));
            huge.push_back(std::ldexp(plain.back(), 900));
        }
        const auto expected = smoothingWeights(smoothing, plain);
        for (const auto& times : {epoch, tiny, huge})
            expectWeights(smoothingWeights(smoothing, times), expected, 1e-15);
    }
    const double largest = std::numeric_limits<double>::max();
    for (const double weight :
         smoothingWeights(OtfSmoothing::movingLeastSquares, std::vector<double>{-largest, 0, 5e-324, 1, largest}))
        EXPECT_LE(std::abs(weight), 1.0 + 1e-12);
}

/// Times of any awkward kind, ascending.
double nextTime(double time, std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    switch (random() % 5) {
        case 0: return time + 1;
        case 1: return std::nextafter(time, std::numeric_limits<double>::infinity());
        case 2: return time + std::pow(10.0, 30 * uniform(random) - 15);
        case 3: return time + uniform(random);
        default: return time;
    }
}

TEST(OtfSmoothing, FiftyThousandRandomInputsStayOpacities) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    const std::array<double, 8> extremes{
        0, 1, -0.0, 5e-324, std::nextafter(1.0, 0.0), -3, 7, std::numeric_limits<double>::quiet_NaN()};
    int below = 0;
    for (const OtfSmoothing smoothing : allSmoothings) {
        OtfHistory history(smoothing);
        double time = -1e3;
        for (int frame = 0; frame < 12500; ++frame) {
            if (random() % 97 == 0) history.clear(), time = 1.7e12 * (2 * uniform(random) - 1);
            time = nextTime(time, random);
            SampledCurve curve;
            for (int i = 0; i < 4; ++i)
                curve.opacities.push_back(random() % 2 ? extremes[random() % extremes.size()] : uniform(random));
            const SampledCurve shown = history.add(time, curve);
            ASSERT_EQ(shown.opacities.size(), 4u);
            for (const double opacity : shown.opacities) below += opacity >= 0.0 && opacity <= 1.0 ? 0 : 1;
        }
    }
    EXPECT_EQ(below, 0);
}

TEST(OtfSmoothing, RandomTimesGiveBoundedWeightsThatSumToOne) {
    std::mt19937_64 random(12);
    for (const OtfSmoothing smoothing : allSmoothings)
        for (int trial = 0; trial < 12500; ++trial) {
            std::vector<double> times{nextTime(static_cast<double>(random() % 1000), random)};
            while (times.size() < framesUsed(smoothing)) {
                const double next = nextTime(times.back(), random);
                if (next > times.back()) times.push_back(next);
            }
            const auto weights = smoothingWeights(smoothing, times);
            double sum = 0;
            for (const double weight : weights) {
                sum += weight;
                // A row of a projection is no longer than 1; the other smoothings weigh nothing negatively.
                ASSERT_LE(std::abs(weight), 1.0 + 1e-12);
                if (smoothing != OtfSmoothing::movingLeastSquares) {
                    ASSERT_GE(weight, 0.0);
                }
            }
            ASSERT_NEAR(sum, 1.0, 1e-12);
        }
}

TEST(OtfHistory, EqualFramesAreShownToTheBit) {
    for (const OtfSmoothing smoothing : allSmoothings) {
        OtfHistory history(smoothing);
        const SampledCurve curve{{0.1, 1.0 / 3, 0.7, 1.0, 0.0}};
        for (int frame = 0; frame < 10; ++frame) EXPECT_EQ(history.add(0.1 * frame * frame, curve), curve);
    }
}

TEST(OtfHistory, ThePastEntersUnsmoothed) {
    OtfHistory history(OtfSmoothing::mean);
    const auto shown = [&](double time, double opacity) {
        return history.add(time, SampledCurve{{opacity, opacity}}).opacities.front();
    };
    EXPECT_DOUBLE_EQ(shown(0, 0.2), 0.2);
    EXPECT_DOUBLE_EQ(shown(1, 0.4), 0.3);
    EXPECT_DOUBLE_EQ(shown(2, 0.9), 0.5);
    EXPECT_DOUBLE_EQ(shown(3, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(shown(4, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(shown(5, 0.7), 0.6) << "the first frame is forgotten";
}

TEST(OtfHistory, AFrameAtTheNewestTimeReplacesIt) {
    OtfHistory history(OtfSmoothing::mean);
    (void)history.add(0, SampledCurve{{0.0, 0.0}});
    (void)history.add(1, SampledCurve{{1.0, 1.0}});
    EXPECT_DOUBLE_EQ(history.add(1, SampledCurve{{0.5, 0.5}}).opacities[0], 0.25);
    history.clear();
    EXPECT_EQ(history.add(-5, SampledCurve{{0.75}}).opacities, std::vector<double>{0.75});
}

TEST(OtfHistory, RefusesWhatMakesNoSense) {
    OtfHistory history;
    (void)history.add(1, SampledCurve{{0.5, 0.5}});
    EXPECT_THROW((void)history.add(0.5, SampledCurve{{0.5, 0.5}}), std::invalid_argument);
    EXPECT_THROW((void)history.add(std::nan(""), SampledCurve{{0.5, 0.5}}), std::invalid_argument);
    EXPECT_THROW((void)history.add(2, SampledCurve{{0.5}}), std::invalid_argument);
    EXPECT_EQ(history.add(2, SampledCurve{{0.5, 0.5}}).opacities.size(), 2u) << "a refused frame leaves no trace";
    EXPECT_THROW((void)smoothingWeights(OtfSmoothing::mean, {}), std::invalid_argument);
    EXPECT_THROW((void)smoothingWeights(OtfSmoothing::mean, std::vector<double>{1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
