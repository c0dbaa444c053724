#include "processing/detection/scale_space.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "processing/detection/variance_surface.h"
#include "tests/processing/tube_core/signals.h"

namespace echolucent {
namespace {

VarianceRule cutAt(double sigmas) {
    VarianceRule config;
    config.kernelCut = sigmas;
    return config;
}

constexpr std::array<double, 5> settledSigmas{32, 16, 8, 4, 2};

TEST(ScaleSpace, KernelsAreGaussiansOfTheSettledWidthThatReachZeroAtThreeSigma) {
    const ScaleSpace space{VarianceRule{}};
    ASSERT_EQ(space.scales(), 5u);
    for (std::size_t index = 0; index < space.scales(); ++index) {
        const GaussianKernel& kernel = space.kernel(index);
        const double sigma = settledSigmas[index];
        EXPECT_EQ(space.sigma(index), sigma);
        ASSERT_EQ(kernel.radius(), static_cast<int>(3 * sigma));
        double sum = kernel.weight(0), secondMoment = 0;
        for (int i = 1; i <= kernel.radius(); ++i) {
            sum += 2 * kernel.weight(i);
            secondMoment += 2.0 * i * i * kernel.weight(i);
            const double end = std::exp(-0.5 * std::pow((kernel.radius() + 1) / sigma, 2));
            EXPECT_NEAR(kernel.weight(i) / kernel.weight(0), (std::exp(-i * i / (2 * sigma * sigma)) - end) / (1 - end),
                        1e-14);
        }
        EXPECT_NEAR(sum, 1.0, 1e-14);
        // The kernel is lowered to reach zero behind 3 sigma, and keeps most of a Gaussian's variance.
        EXPECT_NEAR(secondMoment / (sigma * sigma), 0.945, 0.035);
    }
}

TEST(ScaleSpace, EqualsTheConvolutionWrittenOut) {
    std::vector<double> function;
    for (int i = 0; i < 37; ++i) function.push_back(std::fmod(i * i * 0.37 + 0.11 * i, 1.0));
    for (const double sigma : {2.0, 8.0, 32.0}) {
        const GaussianKernel kernel(sigma, 3.0);
        const auto result = smoothed(function, sigma);
        ASSERT_EQ(result.size(), function.size());
        for (int i = 0; i < 37; ++i) {
            long double expected = 0;
            for (int j = -kernel.radius(); j <= kernel.radius(); ++j) {
                int at = i + j;
                if (at < 0) at = -1 - at;  // mirrored in front
                if (at >= 37) continue;    // zero behind
                expected +=
                    static_cast<long double>(kernel.weight(std::abs(j))) * function[static_cast<std::size_t>(at)];
            }
            EXPECT_NEAR(result[static_cast<std::size_t>(i)], static_cast<double>(expected), 1e-15);
        }
    }
}

TEST(ScaleSpace, SmoothingTwiceAddsTheVariances) {
    // Gaussians are a semigroup; the kernels are cut far out, so that only sampling is left as error.
    std::vector<double> impulse(401, 0.0);
    impulse[200] = 1.0;
    const auto twice = smoothed(smoothed(impulse, 6.0, cutAt(8)), 8.0, cutAt(8));
    const auto once = smoothed(impulse, 10.0, cutAt(8));
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(twice[i], once[i], 1e-13);
}

TEST(ScaleSpace, DoesNotShiftAPeak) {
    std::vector<double> impulse(301, 0.0);
    impulse[150] = 1.0;
    for (const double sigma : settledSigmas)
        EXPECT_EQ(firstSignificantMaximum(smoothed(impulse, sigma), {0, 300}, 0.4), 150);
}

TEST(ScaleSpace, CreatesNoMaximumFromAConstantOrAFallingRamp) {
    for (const double value : {1.0, 0.1, 1.0 / 3.0, 6.0221e-7}) {
        std::vector<double> constant(195, value), falling(195);
        for (std::size_t i = 0; i < falling.size(); ++i) falling[i] = value * static_cast<double>(falling.size() - i);
        for (const double sigma : settledSigmas) {
            EXPECT_FALSE(firstSignificantMaximum(smoothed(constant, sigma), {0, 194}, 0.0)) << value;
            EXPECT_FALSE(firstSignificantMaximum(smoothed(falling, sigma), {0, 194}, 0.0)) << value;
        }
    }
}

TEST(ScaleSpace, NeverAddsMaximaAsItGetsCoarser) {
    std::vector<double> noise;
    std::uint32_t state = 12345;
    for (int i = 0; i < 400; ++i) noise.push_back(((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0);
    const auto maxima = [](const std::vector<double>& function) {
        int count = 0;
        for (IndexRange range{0, static_cast<int>(function.size()) - 1};;) {
            const auto next = firstSignificantMaximum(function, range, 0.0);
            if (!next) return count;
            ++count;
            range.first = *next + 1;
        }
    };
    int finer = maxima(noise);
    EXPECT_GT(finer, 100);
    for (const double sigma : {2.0, 4.0, 8.0, 16.0, 32.0}) {
        const int coarser = maxima(smoothed(noise, sigma, cutAt(6)));
        EXPECT_LE(coarser, finer) << sigma;
        finer = coarser;
    }
}

}  // namespace
}  // namespace echolucent
