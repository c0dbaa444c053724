// The width of boundaries and the position in them, from functions in closed form.
#include "processing/designers/gradients/boundary_position.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/processing/designers/gradients/blurred_steps.h"

namespace echolucent {
namespace {

constexpr std::size_t nodes = HistogramVolume::intensityNodes;

double intensityOf(std::size_t node) { return static_cast<double>(node) / (nodes - 1); }

/// g and h of a step where it has an intensity.
DerivativeSums derivativesOf(const BlurredStep& step, double intensity) {
    const double at = step.positionOf(intensity) / step.sigma;
    const double slope =
        (step.high - step.low) / (step.sigma * std::sqrt(2.0 * std::numbers::pi)) * std::exp(-0.5 * at * at);
    return {1.0, intensity, slope, -at / step.sigma * slope};
}

bool isWithin(const BlurredStep& step, double intensity) {
    return intensity > step.low + 1e-6 && intensity < step.high - 1e-6;
}

/// Of a step, `voxels(node)` voxels at each node; none beyond the step.
template <typename Voxels>
HistogramVolume histogramOf(const BlurredStep& step, const Voxels& voxels) {
    HistogramVolume histogram;
    histogram.overIntensity.resize(nodes);
    for (std::size_t node = 0; node < nodes; ++node) {
        if (!isWithin(step, intensityOf(node))) continue;
        const DerivativeSums one = derivativesOf(step, intensityOf(node));
        const double count = voxels(node);
        histogram.overIntensity[node] = {count, count * one.intensities, count * one.gradients, count * one.seconds};
    }
    return histogram;
}

TEST(BoundaryPosition, FunctionsOfAStepGiveItsWidthAndPosition) {
    const BlurredStep step{0.1, 0.9, 2.5};
    const HistogramVolume histogram = histogramOf(step, [](std::size_t) { return 100.0; });
    const MeanDerivatives means = meanDerivatives(histogram, 0.0);
    const BoundaryWidth width = *boundaryWidth(means, 0.0, 100.0);
    EXPECT_NEAR(width.sigma, 2.5, 0.003);
    EXPECT_EQ(width.sigma, width.smoothed);
    EXPECT_NEAR(width.largestGradient, 0.8 / (2.5 * std::sqrt(2.0 * std::numbers::pi)), 1e-5);
    EXPECT_NEAR(width.largestSecond, -width.leastSecond, 1e-4);
    const std::vector<double> positions = boundaryPositions(means, width, 0.0);
    for (std::size_t node = 0; node < nodes; ++node) {
        if (isWithin(step, intensityOf(node)))
            EXPECT_NEAR(positions[node], step.positionOf(intensityOf(node)) / 2.5, 0.01) << node;
        else
            EXPECT_TRUE(std::isnan(positions[node])) << node;
    }
}

TEST(BoundaryPosition, APrefilterAddsItsVarianceWhichIsTakenOff) {
    const BlurredStep smoothed{0.1, 0.9, std::hypot(1.5, 2.0)};
    const MeanDerivatives means = meanDerivatives(histogramOf(smoothed, [](std::size_t) { return 100.0; }), 0.0);
    const BoundaryWidth width = *boundaryWidth(means, 2.0, 100.0);
    EXPECT_NEAR(width.smoothed, 2.5, 0.003);
    EXPECT_NEAR(width.sigma, 1.5, 0.005);
    EXPECT_FALSE(width.isSharperThanBoundaries());
    EXPECT_EQ(boundaryWidth(means, 2.6, 100.0)->sigma, 0.0);
    EXPECT_FALSE(boundaryWidth(means, 2.6, 100.0)->isSharperThanBoundaries());
    EXPECT_TRUE(boundaryWidth(means, 3.0, 100.0)->isSharperThanBoundaries());
    EXPECT_FALSE(boundaryWidth(means, 0.0, 2.4)) << "wider than the volume";
}

TEST(BoundaryPosition, TheThresholdIsTakenOffAGradient) {
    const BlurredStep step{0.1, 0.9, 2.0};
    const MeanDerivatives means = meanDerivatives(histogramOf(step, [](std::size_t) { return 100.0; }), 0.0);
    const BoundaryWidth width = *boundaryWidth(means, 0.0, 100.0);
    const std::vector<double> positions = boundaryPositions(means, width, 0.5);
    for (std::size_t node = 0; node < nodes; ++node) {
        const double floor = 0.5 * width.largestGradient;
        if (means.gradient[node] > floor + 1e-6)
            EXPECT_NEAR(positions[node], -width.sigma * means.second[node] / (means.gradient[node] - floor), 1e-12);
        else
            EXPECT_TRUE(std::isnan(positions[node])) << node;
    }
}

TEST(BoundaryPosition, BetweenKnownMeansTheOthersAreLinearAndBeyondThemUnknown) {
    HistogramVolume histogram;
    histogram.overIntensity.resize(nodes);
    const auto put = [&](std::size_t node, double count, double gradient, double second) {
        histogram.overIntensity[node] = {count, count * intensityOf(node), count * gradient, count * second};
    };
    put(50, 1000, 0.1, 0.02);
    put(70, 15, 9.0, 9.0);  // too few to be known
    put(100, 40, 0.2, -0.03);
    for (const double smoothing : {0.0, 2.0}) {
        const MeanDerivatives means = meanDerivatives(histogram, smoothing);
        for (std::size_t node = 0; node < nodes; ++node) {
            if (node < 50 || node > 100) {
                EXPECT_TRUE(std::isnan(means.gradient[node]) && std::isnan(means.second[node])) << node;
                continue;
            }
            const double share = static_cast<double>(node - 50) / 50.0;
            EXPECT_NEAR(means.gradient[node], 0.1 + 0.1 * share, 1e-9) << node;
            EXPECT_NEAR(means.second[node], 0.02 - 0.05 * share, 1e-9) << node;
        }
    }
}

TEST(BoundaryPosition, SmoothingQuietsMeansAndKeepsThemWhereManyVoxelsStandBesideFew) {
    // Twice a hundred at odd nodes and a thousand times as many in the lower half.
    const auto voxels = [](std::size_t node) { return (node % 2 == 0 ? 100.0 : 200.0) * (node < 128 ? 1000.0 : 1.0); };
    const BlurredStep step{0.0, 1.0, 2.0};
    HistogramVolume histogram = histogramOf(step, voxels);
    for (std::size_t node = 0; node < nodes; ++node)
        histogram.overIntensity[node].seconds += (node % 2 == 0 ? 0.01 : -0.01) * voxels(node);
    const MeanDerivatives means = meanDerivatives(histogram, 2.0);
    for (std::size_t node = 20; node < nodes - 20; ++node) {
        const DerivativeSums exact = derivativesOf(step, intensityOf(node));
        EXPECT_NEAR(means.gradient[node], exact.gradients, 0.002) << node;
        EXPECT_NEAR(means.second[node], exact.seconds, 0.003) << node;
    }
}

TEST(BoundaryPosition, WithoutABoundaryThereIsNoWidth) {
    HistogramVolume histogram;
    histogram.overIntensity.resize(nodes);
    EXPECT_FALSE(boundaryWidth(meanDerivatives(histogram, 2.0), 1.0, 100.0));
    for (std::size_t node = 0; node < nodes; ++node)
        histogram.overIntensity[node] = {100.0, 100.0 * intensityOf(node), 0.0, 0.0};
    EXPECT_FALSE(boundaryWidth(meanDerivatives(histogram, 2.0), 1.0, 100.0)) << "no gradient";
    for (DerivativeSums& here : histogram.overIntensity) here.gradients = 1.0;
    EXPECT_FALSE(boundaryWidth(meanDerivatives(histogram, 2.0), 1.0, 100.0)) << "no second derivative";
}

TEST(BoundaryPosition, OverBothAxesFollowsTheNodeOfTheGradient) {
    // Two boundaries of one width share their intensities: from 0 to 0.5 and from 0 to 1.
    const BlurredStep half{0.0, 0.5, 2.0}, full{0.0, 1.0, 2.0};
    HistogramVolume histogram = histogramOf(full, [](std::size_t) { return 100.0; });
    histogram.gradientNodes = 64;
    histogram.largestGradient = 0.2;
    histogram.overBoth.resize(nodes * 64);
    for (const BlurredStep& step : {half, full})
        for (int i = 1; i < 20000; ++i) {
            const double intensity = step.high * i / 20000.0;
            const DerivativeSums here = derivativesOf(step, intensity);
            const auto row = static_cast<std::size_t>(std::lround(here.gradients / 0.2 * 63.0));
            histogram.overBoth[row * nodes + static_cast<std::size_t>(std::lround(intensity * 255.0))] += here;
        }
    const BoundaryWidth width = *boundaryWidth(meanDerivatives(histogram, 0.0), 0.0, 100.0);
    const std::vector<double> positions = boundaryPositions(histogram, width, 0.0);
    ASSERT_EQ(positions.size(), nodes * 64);
    const auto at = [&](double intensity, double gradient) {
        return positions[static_cast<std::size_t>(std::lround(gradient / 0.2 * 63.0)) * nodes +
                         static_cast<std::size_t>(std::lround(intensity * 255.0))];
    };
    for (const BlurredStep& step : {half, full})
        for (const double share : {0.3, 0.4, 0.5, 0.6, 0.7}) {
            const DerivativeSums here = derivativesOf(step, share * step.high);
            EXPECT_NEAR(at(share * step.high, here.gradients), step.positionOf(share * step.high) / 2.0, 0.1) << share;
        }
    EXPECT_TRUE(std::isnan(at(0.9, 0.19))) << "far from what was seen";
}

}  // namespace
}  // namespace echolucent
