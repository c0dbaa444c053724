#include "processing/opacity_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace echolucent {
namespace {

TEST(OpacityCurve, LinearIsEquation1) {
    const OpacityCurve curve = LinearCurve{0.2, 0.5, 0.8};
    EXPECT_EQ(opacityAt(curve, 0.0), 0.0);
    EXPECT_EQ(opacityAt(curve, 0.1999), 0.0);
    EXPECT_NEAR(opacityAt(curve, 0.5), 0.15, 1e-15);
    EXPECT_NEAR(opacityAt(curve, 0.8), 0.3, 1e-15);
    EXPECT_NEAR(opacityAt(curve, 1.0), 0.3, 1e-15) << "constant beyond L_H";
}

TEST(OpacityCurve, PowersAreClampedAtOne) {
    EXPECT_DOUBLE_EQ(opacityAt(PowerCurve{2, 0.5}, 0.6), 0.18);
    EXPECT_DOUBLE_EQ(opacityAt(PowerCurve{4, 1.0}, 0.5), 0.0625);
    EXPECT_EQ(opacityAt(PowerCurve{2, 9.0}, 0.5), 1.0);
    EXPECT_EQ(opacityAt(PowerCurve{2, 0.0}, 1.0), 0.0);
}

TEST(OpacityCurve, ManualIsLinearBetweenNodesAndConstantOutside) {
    const OpacityCurve curve = ManualCurve{{{0.2, 0.1}, {0.4, 0.5}, {0.4, 0.9}, {0.8, 0.3}}};
    EXPECT_EQ(opacityAt(curve, 0.0), 0.1);
    EXPECT_EQ(opacityAt(curve, 0.2), 0.1);
    EXPECT_NEAR(opacityAt(curve, 0.3), 0.3, 1e-15);
    EXPECT_NEAR(opacityAt(curve, std::nextafter(0.4, 0.0)), 0.5, 1e-12);
    EXPECT_EQ(opacityAt(curve, 0.4), 0.9) << "of two nodes at one intensity the later holds";
    EXPECT_NEAR(opacityAt(curve, 0.6), 0.6, 1e-15);
    EXPECT_EQ(opacityAt(curve, 1.0), 0.3);
    EXPECT_EQ(opacityAt(ManualCurve{}, 0.5), 0.0);
    EXPECT_EQ(opacityAt(ManualCurve{{{0.5, 0.4}}}, 0.1), 0.4);
    EXPECT_EQ(opacityAt(ManualCurve{{{0.5, 0.4}}}, 0.9), 0.4);
    EXPECT_EQ(opacityAt(ManualCurve{{{0.5, 0.1}, {0.5, 0.2}, {0.5, 0.7}}}, 0.5), 0.7);
}

TEST(OpacityCurve, SampledIsLinearBetweenItsValues) {
    const OpacityCurve curve = SampledCurve{{0.0, 1.0, 0.5}};
    EXPECT_NEAR(opacityAt(curve, 0.25), 0.5, 1e-15);
    EXPECT_EQ(opacityAt(curve, 0.5), 1.0);
    EXPECT_NEAR(opacityAt(curve, 0.75), 0.75, 1e-15);
    EXPECT_EQ(opacityAt(curve, 1.0), 0.5);
    EXPECT_EQ(opacityAt(SampledCurve{}, 0.5), 0.0);
    EXPECT_EQ(opacityAt(SampledCurve{{0.3}}, 0.9), 0.3);
}

TEST(OpacityCurve, EveryCurveStaysInItsRangeForAnyIntensity) {
    const double infinity = std::numeric_limits<double>::infinity();
    const OpacityCurve curves[] = {ManualCurve{{{0.0, 0.2}, {1.0, 5.0}}}, LinearCurve{0.1, 7.0, 0.9},
                                   PowerCurve{2, 3.0}, SampledCurve{{-0.5, 2.0}}, LinearCurve{0.0, -1.0, 1.0}};
    for (const OpacityCurve& curve : curves) {
        for (const double x : {-infinity, -1.0, -0.0, 0.0, 1e-300, 0.3, 1.0, 1.5, infinity, std::nan("")}) {
            EXPECT_GE(opacityAt(curve, x), 0.0);
            EXPECT_LE(opacityAt(curve, x), 1.0);
        }
        EXPECT_EQ(opacityAt(curve, -3.0), opacityAt(curve, 0.0));
        EXPECT_EQ(opacityAt(curve, infinity), opacityAt(curve, 1.0));
        EXPECT_EQ(opacityAt(curve, std::nan("")), opacityAt(curve, 0.0)) << "NaN counts as 0";
    }
}

TEST(OpacityCurve, SamplesBeginAt0AndEndAt1) {
    const auto samples = sampledOpacities(PowerCurve{1, 1.0}, 5);
    EXPECT_EQ(samples, (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
    EXPECT_THROW((void)sampledOpacities(PowerCurve{}, 1), std::invalid_argument);
    // A curve of its own samples is itself.
    const OpacityCurve curve = PowerCurve{2, 0.8};
    const OpacityCurve copy = SampledCurve{sampledOpacities(curve, 256)};
    for (int i = 0; i < 256; ++i) EXPECT_NEAR(opacityAt(copy, i / 255.0), opacityAt(curve, i / 255.0), 1e-15);
}

TEST(OpacityCurve, LogOpacityIsBeforeTheClampAndExactWhereTheCurveVanishes) {
    EXPECT_NEAR(logOpacityAt(PowerCurve{2, 9.0}, 0.5), std::log(2.25), 1e-15) << "not clamped to 1";
    EXPECT_NEAR(logOpacityAt(PowerCurve{4, 1.0}, 1e-100), -400 * std::log(10.0), 1e-10) << "x^4 alone would be 0";
    EXPECT_EQ(logOpacityAt(PowerCurve{2, 1.0}, 0.0), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(logOpacityAt(PowerCurve{2, 0.0}, 0.5), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(logOpacityAt(LinearCurve{0.2, 0.5, 1.0}, 0.1), -std::numeric_limits<double>::infinity());
    EXPECT_NEAR(logOpacityAt(LinearCurve{0.0, 4.0, 1.0}, 0.5), std::log(2.0), 1e-15);
    EXPECT_NEAR(logOpacityAt(ManualCurve{{{0, 0.5}}}, 0.7), std::log(0.5), 1e-15);
}

TEST(OpacityCurve, StepCorrectionKeepsTransmittance) {
    // Petersch's eq. 2 over n small steps lets through what it does over one.
    for (const double opacity : {0.0, 1e-12, 1e-6, 0.01, 0.5, 0.999, 1.0 - 1e-7})
        for (const int parts : {1, 2, 10, 1000}) {
            const double part = opacityForStep(opacity, 1.0 / parts);
            EXPECT_NEAR(-std::expm1(parts * std::log1p(-part)), opacity, 1e-12 * std::max(opacity, 1e-6));
        }
    // Where pow in float errs by 19 %, first order is exact to 1e-6.
    EXPECT_NEAR(opacityForStep(1e-6, 0.1) / 1e-7, 1.0, 1e-6);
    EXPECT_DOUBLE_EQ(opacityForStep(0.75, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(opacityForStep(0.5, 2.0), 0.75);
    EXPECT_EQ(opacityForStep(1.0, 1e-3), 1.0);
    EXPECT_EQ(opacityForStep(1.0, 0.0), 0.0);
    EXPECT_EQ(opacityForStep(0.0, 4.0), 0.0);
    EXPECT_EQ(opacityForStep(std::nan(""), 1.0), 0.0);
}

}  // namespace
}  // namespace echolucent
