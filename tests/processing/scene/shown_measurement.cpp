// The words of measurements, and where planes and cameras see them.
#include "processing/scene/shown_measurement.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <numbers>
#include <random>

namespace echolucent {
namespace {

const VolumeGeometry measuredGrid{.size = {60, 60, 60}, .spacing = {0.5, 0.8, 1.3}};

std::string distanceText(double mm) {
    return measurementText({.placesMm = {{1, 2, 3}, {1, 2, 3 + mm}}}, measuredGrid).value();
}

TEST(ShownMeasurement, SaysMillimetresWithEnoughDigits) {
    EXPECT_EQ(distanceText(123.44), "123.4 mm");
    EXPECT_EQ(distanceText(12.34), "12.3 mm");
    EXPECT_EQ(distanceText(1.0), "1.0 mm");
    EXPECT_EQ(distanceText(0.474), "0.47 mm");
    EXPECT_EQ(distanceText(0.0474), "0.047 mm");
    EXPECT_EQ(distanceText(0.0002), "0.000 mm");
    const double radians = 47.13 * std::numbers::pi / 180.0;
    const Measurement angle{.kind = MeasurementKind::angle,
                            .placesMm = {{6, 2, 3}, {2, 2, 3}, {2 + std::cos(radians), 2 + std::sin(radians), 3}}};
    EXPECT_EQ(measurementText(angle, measuredGrid).value(), "47.1°");
}

TEST(ShownMeasurement, TheNameStandsBeforeTheValue) {
    Measurement measurement{.placesMm = {{1, 2, 3}, {1, 2, 15.34}}, .name = "BPD"};
    EXPECT_EQ(measurementText(measurement, measuredGrid).value(), "12.3 mm");
    EXPECT_EQ(measurementLabel(measurement, measuredGrid).value(), "BPD 12.3 mm");
    EXPECT_EQ(shownMeasurement(measurement, measuredGrid)->text, "BPD 12.3 mm");
    EXPECT_EQ(measurementNumber(measurement, measuredGrid)->digits, "12.3");
    EXPECT_EQ(measurementNumber(measurement, measuredGrid)->unit, "mm");
    measurement.name = "";
    EXPECT_EQ(measurementLabel(measurement, measuredGrid).value(), "12.3 mm");
    measurement.name = "twenty-four letters long";
    EXPECT_EQ(measurementLabel(measurement, measuredGrid).value(), "twenty-four letters long 12.3 mm");
    measurement.name = "twenty-five letters longü";
    EXPECT_EQ(measurementLabel(measurement, measuredGrid).value(), "twenty-five letters lon… 12.3 mm");
    measurement.placesMm[1] = measurement.placesMm[0];
    EXPECT_FALSE(measurementLabel(measurement, measuredGrid));
}

TEST(ShownMeasurement, SaysAPointWhateverTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
        std::setlocale(LC_ALL, locale);
        EXPECT_EQ(distanceText(12.34), "12.3 mm");
    }
    std::setlocale(LC_ALL, before.c_str());
}

TEST(ShownMeasurement, AreThoseOfThePhaseThatHaveAValue) {
    const std::vector<Measurement> all{
        {.id = 1, .placesMm = {{0, 0, 0}, {3, 4, 0}}},
        {.id = 2, .placesMm = {{0, 0, 0}, {0, 0, 2}}, .phase = 3},
        {.id = 5, .kind = MeasurementKind::angle, .placesMm = {{1, 1, 1}, {1, 1, 1}, {2, 2, 2}}},
        {.id = 7, .placesMm = {{0, 0, 0}, {0, 0, 7}}}};
    const auto shown = shownMeasurements(all, 0, measuredGrid);
    ASSERT_EQ(shown.size(), 2u);
    EXPECT_EQ(shown[0].id, 1);
    EXPECT_EQ(shown[0].text, "5.0 mm");
    EXPECT_EQ(shown[1].id, 7);
    VolumeGeometry unknown = measuredGrid;
    unknown.spacingKnown = false;
    EXPECT_TRUE(shownMeasurements(all, 0, unknown).empty());
    EXPECT_EQ(measurementText(all[0], unknown).error().kind, FailureKind::wrongUsage);
    // One that is being made has no value yet.
    const auto begun =
        shownMeasurement({.kind = MeasurementKind::angle, .placesMm = {{1, 2, 3}, {4, 5, 6}}}, measuredGrid);
    ASSERT_TRUE(begun.has_value());
    EXPECT_EQ(begun->text, "");
    EXPECT_TRUE(begun->arcMm.empty());
}

TEST(ShownMeasurement, A3dPictureSaysInWhichPlaneItWasMade) {
    const Volume volume(measuredGrid, Voxels(std::vector<std::uint8_t>(60 * 60 * 60, 100)), 255.0);
    const BeamAxis beam = BeamAxis::plusZ;
    Planes planes;
    planes.direction = {33.3, -21.7, 71.1};
    const Vec3 centre = referencePointOf(planes, volume.dataBox());
    const ViewFrame b = frameOf(PlaneName::b, planes, beam);
    const Vec3 beside = b.forward * (2.0 * measuredGrid.unit());
    const std::vector<Vec3> inB{centre + b.right * 3 + b.down * 2, centre - b.right * 4 + b.down};
    const std::vector<Measurement> all{{.id = 1, .placesMm = inB},
                                       {.id = 2, .placesMm = {inB[0] + beside, inB[1] + beside}, .name = "LV"},
                                       {.id = 3, .ground = MeasurementGround::surface, .placesMm = inB}};
    const auto shown = shownMeasurementsIn3d(all, 0, volume, planes, beam);
    ASSERT_EQ(shown.size(), 3u);
    const std::string value = measurementText(all[0], measuredGrid).value();
    EXPECT_EQ(shown[0].text, value + " (in plane B)");
    EXPECT_EQ(shown[1].text, "LV " + value + " (in a plane)");
    EXPECT_EQ(shown[2].text, value) << "a surface is where the picture shows it";
    EXPECT_TRUE(shown[0].dashed && shown[1].dashed && !shown[2].dashed);
    Camera camera;
    camera.focalPoint = centre;
    EXPECT_TRUE(placedInPicture(shown, camera)[0].dashed);
    EXPECT_FALSE(placedInPicture(shown, camera)[2].dashed);
    for (const ShownMeasurement& each : shownMeasurements(all, 0, measuredGrid)) EXPECT_FALSE(each.dashed);
}

TEST(ShownMeasurement, AnArcRunsAboutTheVertexFromSideToSide) {
    const Vec3 vertex{5, 6, 7};
    const auto shown = shownMeasurement(
        {.kind = MeasurementKind::angle, .placesMm = {vertex + Vec3(10, 0, 0), vertex, vertex + Vec3(0, 0, 4)}},
        measuredGrid);
    ASSERT_TRUE(shown.has_value());
    ASSERT_GE(shown->arcMm.size(), 3u);
    const double radius = length(shown->arcMm.front() - vertex);
    EXPECT_GT(radius, 0.0);
    EXPECT_LT(radius, 4.0) << "it is shorter than the shorter side";
    for (const Vec3& place : shown->arcMm) {
        EXPECT_NEAR(length(place - vertex), radius, 1e-12);
        EXPECT_NEAR(place[1], vertex[1], 1e-12) << "it lies in the plane of the sides";
    }
    EXPECT_LT(length(shown->arcMm.front() - (vertex + Vec3(radius, 0, 0))), 1e-12);
    EXPECT_LT(length(shown->arcMm.back() - (vertex + Vec3(0, 0, radius))), 1e-12);
}

TEST(ShownMeasurement, IsSeenInThePlanesThatHoldIt) {
    // A plane across z at 10 mm, seen from below z, 40 mm high.
    const PlaneView view{.centreMm = {15, 24, 10}, .frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .heightMm = 40.0};
    const double reach = planeReachUnits * measuredGrid.unit();
    const std::vector<ShownMeasurement> shown{
        {.id = 1, .placesMm = {{15, 24, 10}, {25, 14, 10 + 0.99 * reach}}, .text = "a"},
        {.id = 2, .placesMm = {{15, 24, 10}, {25, 14, 10 + 1.01 * reach}}, .text = "b"},
        {.id = 3, .placesMm = {{15, 24, 10 - 0.99 * reach}, {16, 24, 10}}, .text = "c"}};
    const auto placed = placedInPlane(shown, view, measuredGrid.unit());
    ASSERT_EQ(placed.size(), 2u);
    EXPECT_EQ(placed[0].id, 1);
    EXPECT_EQ(placed[0].text, "a");
    EXPECT_EQ(placed[0].places[0], (PicturePlace{0.0, 0.0}));
    EXPECT_NEAR(placed[0].places[1][0], 0.25, 1e-15);
    EXPECT_NEAR(placed[0].places[1][1], -0.25, 1e-15);
    EXPECT_EQ(placed[1].id, 3);
}

TEST(ShownMeasurement, IsSeenByACameraWhereThatSeesItsPlaces) {
    Camera camera{.focalPoint = {10, 10, 50}, .heightMm = 80.0, .viewAngleDegrees = 40.0, .distanceMm = 100.0};
    const std::vector<ShownMeasurement> shown{
        {.id = 4, .placesMm = {{10, 10, 50}, {30, 10, 20}}, .arcMm = {{10, 30, 50}}}};
    const auto parallel = placedInPicture(shown, camera);
    ASSERT_EQ(parallel.size(), 1u);
    EXPECT_NEAR(parallel[0].places[1][0], 20.0 / 80.0, 1e-15);
    EXPECT_NEAR(parallel[0].arc[0][1], 20.0 / 80.0, 1e-15);
    camera.projection = Projection::perspective;
    const auto perspective = placedInPicture(shown, camera);
    ASSERT_EQ(perspective.size(), 1u);
    const double height = 2.0 * std::tan(20.0 * std::numbers::pi / 180.0) * 70.0;  // of the picture, 70 mm from the eye
    EXPECT_NEAR(perspective[0].places[1][0], 20.0 / height, 1e-12);
    camera.distanceMm = 20.0;  // the second place lies behind the eye
    EXPECT_TRUE(placedInPicture(shown, camera).empty());
}

TEST(ShownMeasurement, WordsStandBesideTheLinesAndWithinThePicture) {
    const std::vector<PicturePlace> places{{0.1, 0.2}, {-0.3, 0.0}, {0.4, -0.1}};
    const auto label = [](const std::vector<PicturePlace>& beside, double width) {
        return labelsOf({{beside, width, 0.05}}, 1.5).at(0);
    };
    EXPECT_TRUE(label(places, 0.2).toTheRight);
    EXPECT_EQ(label(places, 0.2).at, (PicturePlace{0.4, -0.1}));
    EXPECT_FALSE(label(places, 0.36).toTheRight);
    EXPECT_EQ(label(places, 0.36).at, (PicturePlace{-0.3, 0.0}));
    // Without room on either side they stay whole, and stand clear of the place.
    EXPECT_TRUE(label(places, 0.6).toTheRight);
    EXPECT_DOUBLE_EQ(label(places, 0.6).at[0] + 0.6, 0.75);
    EXPECT_DOUBLE_EQ(label(places, 0.6).at[1], -0.05);
    EXPECT_DOUBLE_EQ(label({{0.1, 0.46}}, 1.0).at[1], 0.41);
    EXPECT_FALSE(label({{0.8, 0.1}}, 1.6).toTheRight);  // its place is not seen
    EXPECT_DOUBLE_EQ(label({{0.0, 0.49}}, 0.2).at[1], 0.475);
    EXPECT_DOUBLE_EQ(label({{0.0, -0.5}}, 0.2).at[1], -0.475);
    EXPECT_DOUBLE_EQ(label({{0.0, 0.7}}, 0.2).at[1], 0.7);  // beside the picture, as its place is
}

TEST(ShownMeasurement, WordsOfMeasurementsThatLieCloseTogetherAvoidEachOther) {
    constexpr double width = 0.2, height = 0.05, aspect = 1.5;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> nearly(-0.04, 0.04);
    for (const double middle : {0.0, 0.47, -0.47, 0.7}) {
        std::vector<MeasurementWords> words;
        for (int i = 0; i < 8; ++i)
            words.push_back({{{middle + nearly(random), std::clamp(middle, -0.47, 0.47) + nearly(random) / 2.0}},
                             width + nearly(random),
                             height});
        const auto labels = labelsOf(words, aspect);
        ASSERT_EQ(labels.size(), words.size());
        EXPECT_EQ(labels[0].at[1], std::clamp(words[0].places[0][1], -0.475, 0.475));  // the first stays
        const auto left = [&](std::size_t i) {
            return labels[i].at[0] - (labels[i].toTheRight ? 0.0 : words[i].width);
        };
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_EQ(labels[i].at[0], words[i].places[0][0]);
            EXPECT_LE(std::abs(labels[i].at[1]), 0.5 - height / 2.0 + 1e-12);
            for (std::size_t other = 0; other < i; ++other) {
                const bool beside = left(i) >= left(other) + words[other].width - 1e-9 ||
                                    left(other) >= left(i) + words[i].width - 1e-9;
                EXPECT_TRUE(beside || std::abs(labels[i].at[1] - labels[other].at[1]) >= height - 1e-8)
                    << middle << ": " << i << " over " << other;
            }
        }
    }
    // Words with nothing in their way stand where they would alone.
    const std::vector<MeasurementWords> apart{{{{0.0, 0.0}}, width, height}, {{{0.0, 0.06}}, width, height}};
    EXPECT_EQ(labelsOf(apart, aspect)[1].at, (PicturePlace{0.0, 0.06}));
}

}  // namespace
}  // namespace echolucent
