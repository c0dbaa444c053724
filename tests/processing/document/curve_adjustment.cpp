// What threshold and transparency make of a curve.
#include "processing/document/curve_adjustment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "processing/document/document.h"

namespace echolucent {
namespace {

const OpacityCurve ramp = ManualCurve{{{0.3, 0.0}, {0.5, 0.8}, {1.0, 0.9}}};

TEST(CurveAdjustment, WithoutOneTheCurveIsTheSameToTheBit) { EXPECT_TRUE(adjusted(ramp, {}) == ramp); }

TEST(CurveAdjustment, BlackStaysClearAndOpaqueStaysOpaque) {
    for (const double threshold : {-0.5, -0.2, 0.0, 0.3, 0.5})
        for (const double transparency : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
            const CurveAdjustment adjustment{threshold, transparency};
            EXPECT_EQ(opacityAt(adjusted(ramp, adjustment), 0.0), 0.0) << threshold << " " << transparency;
            EXPECT_EQ(opacityAt(adjusted(PowerCurve{2, 1.0}, adjustment), 1.0), 1.0);
        }
}

TEST(CurveAdjustment, TheThresholdMovesTheRiseAndKeepsTheOrder) {
    // The ramp reaches half of its largest opacity, 0.45, at 0.4125.
    const OpacityCurve moved = adjusted(ramp, {.threshold = 0.2});
    EXPECT_NEAR(opacityAt(moved, 0.6125), 0.45, 0.002);
    const OpacityCurve lowered = adjusted(ramp, {.threshold = -0.2});
    EXPECT_NEAR(opacityAt(lowered, 0.2125), 0.45, 0.002);
    double before = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const double opacity = opacityAt(moved, i / 100.0);
        EXPECT_GE(opacity, before) << "a rising curve goes on rising";
        before = opacity;
        EXPECT_LE(opacity, opacityAt(ramp, i / 100.0) + 1e-12);
    }
}

TEST(CurveAdjustment, TransparencyIsDepth) {
    // A quarter of the depth: four steps through the adjusted curve are one through the curve itself.
    const OpacityCurve clear = adjusted(ramp, {.transparency = 1.0});
    for (const double intensity : {0.35, 0.45, 0.7})
        EXPECT_NEAR(1.0 - std::pow(1.0 - opacityAt(clear, intensity), 4.0), opacityAt(ramp, intensity), 1e-3);
}

TEST(CurveAdjustment, IsRenderedWithWhicheverCurveIsActive) {
    Document document;
    document.curves.adjustment = {.threshold = 0.1, .transparency = 0.5};
    const SampledCurve adaptive{{0.0, 0.2, 1.0}};
    for (const CurveKind kind : allCurveKinds) {
        document.panes.at(firstPane).curve = kind;
        EXPECT_TRUE(curveOf(document, firstPane, adaptive) ==
                    adjusted(curveOf(document.curves, kind, adaptive), document.curves.adjustment));
    }
    EXPECT_TRUE(configOf(document).initial == configOf(Document{}).initial) << "the method's own function stays";
    EXPECT_TRUE(adjusted(SampledCurve{}, document.curves.adjustment) == OpacityCurve(SampledCurve{}));
}

TEST(CurveAdjustment, ATwoDimensionalOtfIsAdjustedAsTheCurveOfEachGradient) {
    // Half of the largest opacity, that of gradient 0.4, is reached at 0.4125 as in the ramp.
    const TwoDimensionalOtf otf =
        tabulated(1021, 5, 0.4, [](double f, double g) { return opacityAt(ramp, f) * g / 0.4; });
    const CurveAdjustment adjustment{.threshold = 0.2, .transparency = -0.5};
    const Classification moved = adjustedClassification(Classification(otf), adjustment);
    ASSERT_TRUE(moved.isTwoDimensional());
    const OpacityCurve upper = adjusted(ramp, adjustment);
    for (int i = 0; i <= 50; ++i) EXPECT_NEAR(opacityAt(moved, i / 50.0, 0.4), opacityAt(upper, i / 50.0), 0.005);
    EXPECT_NEAR(opacityAt(moved, 0.6125, 0.2), 1.0 - std::pow(1.0 - 0.225, 2.0), 0.005);
    EXPECT_EQ(opacityAt(moved, 0.9, 0.0), 0.0);
    EXPECT_EQ(adjustedClassification(Classification(otf), {}), Classification(otf));
    EXPECT_EQ(adjustedClassification(ramp, adjustment), Classification(upper));
    EXPECT_EQ(adjustedClassification(Classification(), adjustment), Classification());
}

}  // namespace
}  // namespace echolucent
