// The routes and borders of the scale space against each other and against the convolution written out.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "processing/detection/scale_space.h"
#include "tests/processing/tube_core/signals.h"

namespace echolucent {
namespace {

constexpr std::array<TubeBorder, 2> borders{TubeBorder::mirrorThenZero, TubeBorder::circular};
constexpr std::array<std::size_t, 8> tubeLengths{1, 2, 7, 39, 64, 195, 199, 256};

VarianceRule with(SmoothingRoute route, TubeBorder border) {
    VarianceRule config;
    config.smoothing = route;
    config.border = border;
    return config;
}

/// All scales, coarsest first.
std::vector<std::vector<double>> scalesOf(const std::vector<double>& function, const VarianceRule& config) {
    const ScaleSpace space(config);
    ScaleSmoother smoother(space);
    smoother.begin(function);
    std::vector<std::vector<double>> scales(space.scales());
    for (std::size_t index = 0; index < scales.size(); ++index) smoother.smooth(index, scales[index]);
    return scales;
}

/// Speckle's variance along a tube: exponential noise with a bright part.
std::vector<double> speckleVariance(std::size_t length, unsigned seed) {
    std::mt19937 random(seed);
    std::exponential_distribution<double> value(1.0);
    std::vector<double> function(length);
    for (std::size_t i = 0; i < length; ++i) function[i] = value(random) * (2 * i > length ? 1.0 : 0.1);
    return function;
}

double largestOf(const std::vector<double>& function) { return *std::max_element(function.begin(), function.end()); }

TEST(ScaleSpaceRoutes, FourierEqualsDirectToRounding) {
    for (const TubeBorder border : borders)
        for (const std::size_t length : tubeLengths)
            for (const bool endsAtZero : {true, false}) {
                const auto function = speckleVariance(length, static_cast<unsigned>(length));
                auto direct = with(SmoothingRoute::direct, border), fourier = with(SmoothingRoute::fourier, border);
                direct.kernelEndsAtZero = fourier.kernelEndsAtZero = endsAtZero;
                const auto expected = scalesOf(function, direct), got = scalesOf(function, fourier);
                ASSERT_EQ(expected.size(), got.size());
                for (std::size_t index = 0; index < expected.size(); ++index)
                    EXPECT_LE(largestDifference(expected[index], got[index]), 1e-12 * largestOf(function)) << length;
            }
}

TEST(ScaleSpaceRoutes, OneSmootherServesFunctionsOfAnyLengthOneAfterTheOther) {
    for (const SmoothingRoute route : {SmoothingRoute::direct, SmoothingRoute::fourier}) {
        const VarianceRule config = with(route, TubeBorder::mirrorThenZero);
        const ScaleSpace space(config);
        ScaleSmoother smoother(space);
        std::vector<double> result;
        for (const std::size_t length : {195u, 40u, 300u, 195u}) {
            const auto function = speckleVariance(length, 3);
            smoother.begin(function);
            smoother.smooth(1, result);
            EXPECT_EQ(result, scalesOf(function, config)[1]) << "the same bits as a fresh one";
        }
        smoother.begin({});
        smoother.smooth(0, result);
        EXPECT_TRUE(result.empty());
    }
}

TEST(ScaleSpaceRoutes, CircularIsTheConvolutionOnARing) {
    const auto function = speckleVariance(37, 11);
    const auto config = with(SmoothingRoute::direct, TubeBorder::circular);
    const ScaleSpace space(config);
    const auto scales = scalesOf(function, config);
    for (std::size_t index = 0; index < scales.size(); ++index)
        for (int i = 0; i < 37; ++i) {
            long double expected = 0;
            for (int j = -space.kernel(index).radius(); j <= space.kernel(index).radius(); ++j)
                expected += static_cast<long double>(space.kernel(index).weight(std::abs(j))) *
                            function[static_cast<std::size_t>((i + j + 37 * 37) % 37)];
            EXPECT_NEAR(scales[index][static_cast<std::size_t>(i)], static_cast<double>(expected), 1e-14);
        }
}

TEST(ScaleSpaceRoutes, ConstantsStayConstantAwayFromTheZeroBehind) {
    for (const SmoothingRoute route : {SmoothingRoute::direct, SmoothingRoute::fourier})
        for (const TubeBorder border : borders)
            for (const double value : {1.0, 0.1, 6.0221e-7}) {
                const auto config = with(route, border);
                const auto scales = scalesOf(std::vector<double>(800, value), config);
                const double sigmas[] = {32, 16, 8, 4, 2};
                for (std::size_t index = 0; index < scales.size(); ++index) {
                    const double reach = border == TubeBorder::circular ? 0 : 4 * sigmas[index];
                    for (std::size_t i = 0; i + static_cast<std::size_t>(reach) < 800; ++i)
                        EXPECT_NEAR(scales[index][i], value, 1e-12 * value);
                }
            }
}

}  // namespace
}  // namespace echolucent
