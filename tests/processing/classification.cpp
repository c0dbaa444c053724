// Two-dimensional OTFs between their nodes, and what a classification holds.
#include "processing/classification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace echolucent {
namespace {

TEST(Classification, BetweenNodesATwoDimensionalOtfIsBilinear) {
    // Opacity 0.1 + 0.3 f + 0.2 g / 4 + 0.4 f g / 4 is bilinear, so that any nodes give it everywhere.
    const auto exact = [](double f, double g) { return 0.1 + 0.3 * f + 0.05 * g + 0.1 * f * g; };
    for (const int intensities : {2, 3, 17})
        for (const int gradients : {2, 5, 64}) {
            const TwoDimensionalOtf otf = tabulated(intensities, gradients, 4.0, exact);
            for (double f = 0.0; f <= 1.0; f += 0.07)
                for (double g = 0.0; g <= 4.0; g += 0.23) EXPECT_NEAR(opacityAt(otf, f, g), exact(f, g), 1e-7);
        }
}

TEST(Classification, PlacesOutsideCountAsTheNearestOneInside) {
    const TwoDimensionalOtf otf = tabulated(3, 3, 0.5, [](double f, double g) { return f + g * 0.5; });
    EXPECT_EQ(opacityAt(otf, -1.0, 0.2), opacityAt(otf, 0.0, 0.2));
    EXPECT_EQ(opacityAt(otf, 7.0, 0.2), opacityAt(otf, 1.0, 0.2));
    EXPECT_EQ(opacityAt(otf, 0.3, 9.0), opacityAt(otf, 0.3, 0.5));
    EXPECT_EQ(opacityAt(otf, 0.3, -9.0), opacityAt(otf, 0.3, 0.0));
    EXPECT_EQ(opacityAt(otf, std::nan(""), std::nan("")), opacityAt(otf, 0.0, 0.0));
    EXPECT_EQ(opacityAt(otf, INFINITY, INFINITY), opacityAt(otf, 1.0, 0.5));
}

TEST(Classification, OpacitiesAreClampedWhereATableIsMade) {
    const TwoDimensionalOtf otf = tabulated(2, 2, 1.0, [](double f, double g) {
        return f > 0 ? 3.0 : g > 0 ? -1 : NAN;
    });
    EXPECT_EQ(otf.opacities, (std::vector<float>{0, 1, 0, 1}));
}

TEST(Classification, BrokenTablesAreRefused) {
    const auto zero = [](double, double) { return 0.0; };
    EXPECT_THROW((void)tabulated(1, 2, 1.0, zero), std::invalid_argument);
    EXPECT_THROW((void)tabulated(2, 1025, 1.0, zero), std::invalid_argument);
    EXPECT_THROW((void)tabulated(2, 2, 0.0, zero), std::invalid_argument);
    EXPECT_THROW((void)tabulated(2, 2, std::numeric_limits<double>::infinity(), zero), std::invalid_argument);
    EXPECT_THROW(Classification(TwoDimensionalOtf{2, 2, 1.0, {0, 0, 0}}), std::invalid_argument);
    EXPECT_THROW(Classification(TwoDimensionalOtf{2, 2, 1.0, {0, 0, 0, 1.5f}}), std::invalid_argument);
    EXPECT_THROW(Classification(TwoDimensionalOtf{2, 2, 1.0, {0, 0, 0, NAN}}), std::invalid_argument);
}

TEST(Classification, EqualityIsThatOfWhatItHolds) {
    const auto rising = [](double f, double) { return f; };
    const Classification curve = PowerCurve{2, 1.0}, table{tabulated(3, 3, 1.0, rising)};
    EXPECT_EQ(curve, Classification(PowerCurve{2, 1.0}));
    EXPECT_NE(curve, Classification(PowerCurve{2, 0.9}));
    EXPECT_NE(curve, table);
    EXPECT_EQ(table, Classification(tabulated(3, 3, 1.0, rising)));
    EXPECT_NE(table, Classification(tabulated(3, 3, 0.9, rising)));
    EXPECT_EQ(opacityAt(curve, 0.5, 123.0), 0.25);
}

TEST(Classification, TheUpperCurveHasTheLargestOpacityOfEachIntensity) {
    const Classification table(
        tabulated(3, 4, 1.0, [](double f, double g) { return f * (1 - std::abs(g - 1.0 / 3)); }));
    const OpacityCurve upper = upperCurveOf(table);
    for (const double f : {0.0, 0.25, 0.5, 1.0}) EXPECT_NEAR(opacityAt(upper, f), f, 1e-6);
    EXPECT_EQ(upperCurveOf(PowerCurve{4, 1.0}), OpacityCurve(PowerCurve{4, 1.0}));
}

}  // namespace
}  // namespace echolucent
