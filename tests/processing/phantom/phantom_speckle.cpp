// Speckle has the statistics of a Rayleigh field, the correlation of its smoothing, and the same bits wherever it is
// made.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "processing/phantom/speckle.h"

namespace echolucent {
namespace {

/// The whole field without row padding, x fastest.
std::vector<float> fieldOf(const SpeckleConfig& config) {
    std::vector<float> field;
    makeSpeckle(config, 0, config.size[2], [&](std::int64_t, const float* values, std::int64_t stride) {
        for (std::int64_t y = 0; y < config.size[1]; ++y)
            field.insert(field.end(), values + y * stride, values + y * stride + config.size[0]);
    });
    return field;
}

struct Moments {
    double mean = 0, deviation = 0;
};

Moments momentsOf(const std::vector<float>& values) {
    double sum = 0, squares = 0;
    for (const double value : values) sum += value, squares += value * value;
    const double n = static_cast<double>(values.size()), mean = sum / n;
    return {mean, std::sqrt(squares / n - mean * mean)};
}

/// Correlation of R^2 between voxels `lag` apart along an axis.
double intensityCorrelation(const std::vector<float>& field, const std::array<std::int64_t, 3>& size, int axis,
                            int lag) {
    const std::array<std::int64_t, 3> stride{1, size[0], size[0] * size[1]};
    double a = 0, b = 0, ab = 0, aa = 0, bb = 0, n = 0;
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x) {
                const std::array<std::int64_t, 3> at{x, y, z};
                if (at[axis] + lag >= size[axis]) continue;
                const auto offset = static_cast<std::size_t>(x + stride[1] * y + stride[2] * z);
                const double u = field[offset] * field[offset];
                const double other = field[offset + static_cast<std::size_t>(lag * stride[axis])], v = other * other;
                a += u, b += v, ab += u * v, aa += u * u, bb += v * v, n += 1;
            }
    return (ab / n - a / n * (b / n)) / std::sqrt((aa / n - a / n * (a / n)) * (bb / n - b / n * (b / n)));
}

TEST(Speckle, UncorrelatedFieldIsRayleighOfUnitMean) {
    const auto field = fieldOf({7, {101, 97, 83}, 0});
    const Moments moments = momentsOf(field);
    EXPECT_NEAR(moments.mean, 1.0, 0.003);
    EXPECT_NEAR(moments.deviation, std::sqrt(4 / std::numbers::pi - 1), 0.003);
    // The share above r is exp(-pi r^2 / 4), also far in the tail.
    for (const double r : {0.1, 0.5, 1.0, 2.0, 3.0}) {
        double above = 0;
        for (const float value : field) above += value > r;
        const double share = std::exp(-std::numbers::pi * r * r / 4), n = static_cast<double>(field.size());
        EXPECT_NEAR(above / n, share, 5 * std::sqrt(share * (1 - share) / n)) << r;
    }
}

TEST(Speckle, SmoothingKeepsTheDistribution) {
    for (const double smoothing : {1.0, 2.0, 3.5}) {
        const Moments moments = momentsOf(fieldOf({11, {120, 110, 100}, smoothing}));
        EXPECT_NEAR(moments.mean, 1.0, 0.02) << smoothing;
        EXPECT_NEAR(moments.deviation, 0.5227, 0.02) << smoothing;
    }
}

TEST(Speckle, CorrelationFollowsFromTheSmoothing) {
    // Gaussian smoothing of deviation sigma correlates the noise by exp(-k^2 / (4 sigma^2)), its squared modulus by the
    // square of that. It is checked here at whole lags along every axis.
    for (const double smoothing : {2.0, 4.0}) {
        const std::array<std::int64_t, 3> size{110, 100, 90};
        const auto field = fieldOf({5, size, smoothing});
        const double sigma = smoothing / 2.354820045;
        for (int axis = 0; axis < 3; ++axis)
            for (const int lag : {1, 2, 3, 6})
                EXPECT_NEAR(intensityCorrelation(field, size, axis, lag), std::exp(-lag * lag / (2 * sigma * sigma)),
                            0.035)
                    << smoothing << " axis " << axis << " lag " << lag;
    }
}

TEST(Speckle, UncorrelatedNeighboursShareNothing) {
    const std::array<std::int64_t, 3> size{110, 100, 90};
    const auto field = fieldOf({5, size, 0});
    for (int axis = 0; axis < 3; ++axis)
        for (const int lag : {1, 2, 8}) EXPECT_NEAR(intensityCorrelation(field, size, axis, lag), 0.0, 0.006);
}

TEST(Speckle, PiecesAndTheWholeAgreeToTheBit) {
    for (const double smoothing : {0.0, 2.0}) {
        const SpeckleConfig config{3, {37, 21, 30}, smoothing};
        const auto whole = fieldOf(config);
        std::int64_t compared = 0;
        makeSpeckle(config, 11, 17, [&](std::int64_t z, const float* values, std::int64_t stride) {
            for (std::int64_t y = 0; y < 21; ++y)
                for (std::int64_t x = 0; x < 37; ++x, ++compared)
                    ASSERT_EQ(values[y * stride + x], whole[static_cast<std::size_t>(x + 37 * (y + 21 * z))]);
        });
        EXPECT_EQ(compared, 37 * 21 * 6);
    }
}

TEST(Speckle, AVoxelDoesNotDependOnTheVolumesSize) {
    const auto small = fieldOf({9, {20, 20, 20}, 2}), large = fieldOf({9, {45, 33, 25}, 2});
    for (std::size_t z = 0; z < 20; ++z)
        for (std::size_t y = 0; y < 20; ++y)
            for (std::size_t x = 0; x < 20; ++x) ASSERT_EQ(small[x + 20 * (y + 20 * z)], large[x + 45 * (y + 33 * z)]);
}

TEST(Speckle, SeedsDiffer) {
    const std::array<std::int64_t, 3> size{60, 60, 30};
    const auto one = fieldOf({1, size, 0}), two = fieldOf({2, size, 0});
    std::size_t equal = 0;
    double product = 0;
    for (std::size_t i = 0; i < one.size(); ++i) equal += one[i] == two[i], product += (one[i] - 1) * (two[i] - 1);
    EXPECT_LT(equal, one.size() / 1000);
    EXPECT_NEAR(product / static_cast<double>(one.size()), 0.0, 0.004);
}

TEST(Speckle, TapsHaveUnitPowerAndTheStatedWidth) {
    for (const double smoothing : {1.5, 2.0, 6.0}) {
        const auto taps = speckleTaps(smoothing);
        ASSERT_EQ(taps.size() % 2, 1U);
        double power = 0;
        for (const double tap : taps) power += tap * tap;
        EXPECT_NEAR(power, 1.0, 1e-6);
        // The Gaussian has half its height at FWHM / 2.
        const auto middle = taps.size() / 2;
        const double perVoxel = std::log2(static_cast<double>(taps[middle]) / taps[middle + 1]);
        EXPECT_NEAR(2 / std::sqrt(perVoxel), smoothing, 1e-4);
    }
    EXPECT_EQ(speckleTaps(0), std::vector<float>{1.0F});
}

TEST(EchoFinish, MultipliesCompressesAndRounds) {
    constexpr std::size_t count = 32;
    std::vector<float> echo(count), rayleigh(count);
    for (std::size_t i = 0; i < count; ++i) {
        echo[i] = static_cast<float>(i * 9);
        rayleigh[i] = 0.25F + 0.05F * static_cast<float>(i);
    }
    for (const EchoFinish finish : {EchoFinish{0.5F, 0, 255}, EchoFinish{1, 0, 4095}, EchoFinish{0.3F, 50, 65535}}) {
        std::vector<std::uint16_t> stored(count);
        finishRow(echo.data(), rayleigh.data(), count, finish, stored.data());
        for (std::size_t i = 0; i < count; ++i) {
            double expected = echo[i] * (1 + finish.speckle * (static_cast<double>(rayleigh[i]) - 1));
            if (finish.decibel > 0) expected = 255 * (1 + 20 * std::log10(expected / 255) / finish.decibel);
            expected = std::clamp(expected / 255, 0.0, 1.0) * finish.whiteLevel;
            EXPECT_NEAR(stored[i], expected, 0.51 + 1e-6 * finish.whiteLevel) << i;
        }
    }
}

}  // namespace
}  // namespace echolucent
