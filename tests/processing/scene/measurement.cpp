#include "processing/scene/measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace echolucent {
namespace {

VolumeGeometry turnedGrid() {
    VolumeGeometry geometry{.size = {30, 40, 50}, .spacing = {0.3, 0.7, 1.9}, .origin = {-10, 20, 5}};
    const double angle = 0.6;  // an oblique grid
    geometry.direction = Mat3(std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1);
    return geometry;
}

TEST(Measurement, DistancesAreThoseBetweenPatientPositions) {
    const VolumeGeometry geometry = turnedGrid();
    const Vec3 from{3, 7, 11}, to{21, 30, 4};  // voxels
    const Measurement measurement{.placesMm = {geometry.gridMmFromVoxel(from), geometry.gridMmFromVoxel(to)}};
    const double expected = cv::norm(geometry.patientFromVoxel(to) - geometry.patientFromVoxel(from));
    EXPECT_NEAR(measuredValue(measurement, geometry).value(), expected, 1e-12 * expected);
}

TEST(Measurement, AnglesKeepTheirDigitsNearTheirEnds) {
    const VolumeGeometry geometry = turnedGrid();
    for (const double degrees : {1e-6, 0.5, 30.0, 90.0, 179.5, 180.0 - 1e-6}) {
        const double radians = degrees * std::numbers::pi / 180.0;
        const Measurement measurement{
            .kind = MeasurementKind::angle,
            .placesMm = {{15, 5, 5}, {5, 5, 5}, {5 + 3 * std::cos(radians), 5, 5 + 3 * std::sin(radians)}}};
        EXPECT_NEAR(measuredValue(measurement, geometry).value(), degrees, 1e-9);
    }
}

TEST(Measurement, IsRefusedWhereTheSpacingIsUnknownOrItsPlacesCoincide) {
    VolumeGeometry geometry = turnedGrid();
    const Measurement angle{.kind = MeasurementKind::angle, .placesMm = {{1, 1, 1}, {1, 1, 1}, {2, 2, 2}}};
    EXPECT_EQ(measuredValue(angle, geometry).error().sentence(),
              "an angle needs a vertex that lies apart from its other places. Mark three places that lie apart.");
    EXPECT_EQ(measuredValue(Measurement{.placesMm = {{1, 1, 1}, {1, 1, 1}}}, geometry).error().sentence(),
              "a distance needs two places that lie apart. Mark another place.");
    geometry.spacingKnown = false;
    const Measurement distance{.placesMm = {{1, 1, 1}, {2, 2, 2}}};
    EXPECT_EQ(measuredValue(distance, geometry).error().kind, FailureKind::wrongUsage);
}

TEST(Measurement, WhatAFileMayNotHoldIsNamed) {
    EXPECT_EQ(problemOf(Measurement{.placesMm = {{1, 1, 1}, {2, 2, 2}}}), "");
    EXPECT_EQ(problemOf(Measurement{.placesMm = {{1, 1, 1}}}), "places_mm must hold 2 places");
    EXPECT_EQ(problemOf(Measurement{.kind = MeasurementKind::angle, .placesMm = {{1, 1, 1}, {2, 2, 2}}}),
              "places_mm must hold 3 places");
    EXPECT_EQ(problemOf(Measurement{.id = 0, .placesMm = {{1, 1, 1}, {2, 2, 2}}}), "id must be at least 1");
    const double nowhere = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(problemOf(Measurement{.placesMm = {{1, 1, 1}, {nowhere, 2, 2}}}), "places_mm must hold finite numbers");
}

}  // namespace
}  // namespace echolucent
