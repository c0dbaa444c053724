#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "processing/tube_core/basis_function.h"

namespace echolucent {
namespace {

TEST(BasisFunction, HasItsExtremesAtLowAndHighAndIsZeroBetween) {
    for (const auto& [low, high] : {std::pair{0.1, 0.4}, {14.0 / 255, 85.0 / 255}, {0.0, 1.0}, {0.3, 0.3 + 1e-9}}) {
        EXPECT_EQ(basisFunction(low, low, high), -1.0);
        EXPECT_EQ(basisFunction(high, low, high), 1.0);
        for (int i = 0; i <= 1000; ++i) EXPECT_LE(std::abs(basisFunction(i / 1000.0, low, high)), 1.0);
    }
    EXPECT_EQ(basisFunction(0.25, 0.125, 0.375), 0.0);
    EXPECT_LT(basisFunction(0.15, 0.1, 0.4), 0.0) << "lowers before the surface's intensities";
    EXPECT_GT(basisFunction(0.35, 0.1, 0.4), 0.0) << "raises at the surface's intensities";
}

TEST(BasisFunction, EqualsTheLiteralEquationWithItsErratum) {
    // Eqs. 5 and 6 with (x - c) for the first x, in extended precision.
    const long double low = 0.0588235294117647L, high = 0.6274509803921569L;
    const long double b = 2 / ((high - low) * (high - low));
    const long double c = 1 / std::sqrt(2 * b) + low;
    const long double a = std::sqrt(2 * b * std::exp(1.0L));
    for (int i = 0; i <= 255; ++i) {
        const long double x = i / 255.0L;
        const long double literal = a * (x - c) * std::exp(-b * (x - c) * (x - c));
        EXPECT_NEAR(basisFunction(static_cast<double>(x), static_cast<double>(low), static_cast<double>(high)),
                    static_cast<double>(literal), 1e-15);
    }
}

TEST(BasisFunction, StaysFiniteForAGapOfOneUlp) {
    const double low = 0.5, high = std::nextafter(low, 1.0);
    EXPECT_EQ(basisFunction(low, low, high), -1.0);
    EXPECT_EQ(basisFunction(high, low, high), 1.0);
    EXPECT_EQ(basisFunction(0.0, low, high), 0.0);
    EXPECT_EQ(basisFunction(1.0, 5e-324, 1e-323), 0.0);
    EXPECT_EQ(basisFunction(5e-324, 5e-324, 1e-323), -1.0);
    EXPECT_EQ(basisFunction(1e-323, 5e-324, 1e-323), 1.0);
    for (const double gap : {1.0, 2.0, 3.0, 5.0, 7.0, 1000.0}) {
        // I_L and I_H are a few ulps apart; in between and beside them, u is of small odd numbers over the gap.
        const double end = low + gap * 0x1p-53 * 2;
        for (int i = -3; i <= 2000; i += i < 12 ? 1 : 331) {
            const long double u = (2.0L * i - gap) / gap;
            EXPECT_NEAR(basisFunction(low + i * 0x1p-52, low, end), static_cast<double>(u * std::exp((1 - u * u) / 2)),
                        4e-16)
                << gap << " " << i;
        }
    }
}

TEST(CompensatedSum, KeepsWhatRoundingDrops) {
    CompensatedSum sum;
    sum.add(1e16);
    for (int i = 0; i < 1000; ++i) sum.add(1.0);
    sum.add(-1e16);
    EXPECT_EQ(sum.value(), 1000.0);
}

TubeCore tubeOfWeight(double d, double low, double high) {
    TubeCore tube;
    tube.status = TubeStatus::surface;
    tube.d = d;
    tube.lowIntensity = low;
    tube.highIntensity = high;
    return tube;
}

TEST(AdaptedLogOpacity, RaisesAtHighAndLowersAtLowByTheFactorOnePlusD) {
    const double low = 51.0 / 255, high = 153.0 / 255;
    const std::vector<TubeCore> tubes{tubeOfWeight(0.5, low, high)};
    const auto logOpacity = adaptedLogOpacity(PowerCurve{2, 0.8}, tubes, 256);
    EXPECT_NEAR(logOpacity[51], std::log(0.8 * low * low / 1.5), 1e-14);
    EXPECT_NEAR(logOpacity[153], std::log(0.8 * high * high * 1.5), 1e-14);
    EXPECT_EQ(logOpacity[0], -std::numeric_limits<double>::infinity());
    const SampledCurve curve = curveFromLogOpacity(logOpacity);
    EXPECT_EQ(curve.opacities[0], 0.0);
    EXPECT_NEAR(curve.opacities[51], 0.8 * low * low / 1.5, 1e-15);
}

TEST(AdaptedLogOpacity, IsNotTheOrdinaryProductThatOverflows) {
    const std::vector<TubeCore> tubes(100000, tubeOfWeight(1e6, 0.2, 0.6));
    const auto logOpacity = adaptedLogOpacity(PowerCurve{2, 1.0}, tubes, 256);
    const double expected = 2 * std::log(0.6) + 1e5 * std::log1p(1e6);
    EXPECT_NEAR(logOpacity[153], expected, 1e-14 * expected);
    for (const double opacity : curveFromLogOpacity(logOpacity).opacities) {
        EXPECT_GE(opacity, 0.0);
        EXPECT_LE(opacity, 1.0);
    }
}

}  // namespace
}  // namespace echolucent
