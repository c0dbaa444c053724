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

Measurement worded(const std::string& name, const std::string& comment) {
    return {.placesMm = {{1, 1, 1}, {2, 2, 2}}, .name = name, .comment = comment};
}

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

TEST(Measurement, NameAndCommentAreBoundedInLettersAndPlain) {
    EXPECT_EQ(problemOf(worded("Länge 心", "first line\nsecond")), "");
    EXPECT_EQ(problemOf(worded(repeated("ü", 80), repeated("心", 500))), "");
    EXPECT_EQ(problemOf(worded(repeated("ü", 81), "")), "name must have at most 80 letters");
    EXPECT_EQ(problemOf(worded("", repeated("a", 501))), "comment must have at most 500 letters");
    for (const char* wrong : {"two\nlines", "a\tb", "\x7f", "\xff", "\u202e"})
        EXPECT_EQ(problemOf(worded(wrong, "")), "name must be one line of UTF-8 without control characters") << wrong;
    for (const char* wrong : {"a\tb", "a\rb", "\xff", "\u202e"})
        EXPECT_EQ(problemOf(worded("", wrong)),
                  "comment must be UTF-8 without control characters other than the ends of lines")
            << wrong;
}

TEST(Measurement, WhatIsTypedBecomesWhatAFileMayHold) {
    EXPECT_EQ(measurementNameOf(""), "");
    EXPECT_EQ(measurementNameOf("   "), "");
    EXPECT_EQ(measurementNameOf("  left ventricle \n"), "left ventricle");
    EXPECT_EQ(measurementNameOf(repeated("ü", 90)), repeated("ü", 80));
    EXPECT_EQ(measurementNameOf(repeated("a", 79) + " b"), repeated("a", 79))
        << "no blank at the end that the cut made";
    EXPECT_EQ(measurementCommentOf("a\tb\r\nc\n"), "a b \nc\n");
    EXPECT_EQ(measurementCommentOf(repeated("心\n", 300)), repeated("心\n", 250));
    for (const char* typed : {"a\x01\xff\u202e", "\n\n", "a\n b"}) {
        EXPECT_EQ(problemOf(worded(measurementNameOf(typed), measurementCommentOf(typed))), "") << typed;
    }
}

TEST(Measurement, OnlyPlacesWithDataMayBeMarked) {
    VolumeGeometry geometry{.size = {8, 6, 4}, .spacing = {0.5, 1, 2}};
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(geometry.voxelCount()), 1);
    for (std::int64_t z = 0; z < 4; ++z)
        for (std::int64_t y = 0; y < 6; ++y) mask[static_cast<std::size_t>(geometry.offset(3, y, z))] = 0;
    const Volume whole(geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()), 9));
    const Volume masked = whole.withDataMask(DataMask(std::move(mask)));
    const auto at = [&](double x, double y, double z) { return geometry.gridMmFromVoxel({x, y, z}); };
    EXPECT_TRUE(holdsData(whole, at(3, 2, 2)));
    EXPECT_FALSE(holdsData(masked, at(3, 2, 2)));
    EXPECT_FALSE(holdsData(masked, at(3.4, 2, 2)));
    EXPECT_TRUE(holdsData(masked, at(3.6, 2, 2)));
    EXPECT_TRUE(holdsData(masked, at(-0.4, 5.4, 3.4)));
    for (const Vec3& beside : {at(-0.6, 2, 2), at(7.6, 2, 2), at(5, -0.6, 2), at(5, 2, 3.6)})
        EXPECT_FALSE(holdsData(whole, beside));
}

}  // namespace
}  // namespace echolucent
