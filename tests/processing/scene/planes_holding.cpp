// Planes that are turned to hold places: that they do, and turn no more than they must.
#include "processing/scene/planes_holding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/processing/scene/places.h"

namespace echolucent {
namespace {

double farthestFrom(const Planes& planes, PlaneName plane, const std::vector<Vec3>& places) {
    double farthest = 0.0;
    for (const Vec3& place : places)
        farthest = std::max(
            farthest,
            std::abs(
                frameOf(plane, planes, BeamAxis::plusZ).forward.dot(place - referencePointOf(planes, dataOfPlaces))));
    return farthest;
}

TEST(PlanesHolding, OneOfThemTurnsAsLittleAsNeededToHoldPlaces) {
    const std::vector<std::vector<Vec3>> measured{{{10, 20, 30}, {20, 11, 55}},               // oblique to all
                                                  {{-2, 6, 12}, {36, 34, 88}},                // from corner to corner
                                                  {{10, 20, 30}, {20, 11, 55}, {1, 30, 60}},  // an angle
                                                  {{0, 10, 20}, {5, 15, 30}, {10, 20, 40}},   // on one straight line
                                                  {{10, 20, 30}, {10, 20, 30}}};              // one place
    for (const Planes& before : {Planes{}, unusualPlanes()})
        for (const std::vector<Vec3>& places : measured) {
            const Planes after = planesHolding(before, places, BeamAxis::plusZ, dataOfPlaces);
            const auto held = std::ranges::find_if(
                allPlaneNames, [&](PlaneName plane) { return farthestFrom(after, plane, places) < 1e-9; });
            ASSERT_NE(held, allPlaneNames.end());
            // A plane must lean by the angle between the line and its present self, and no plane leans less.
            double least = 90.0;
            const Vec3 along = places[1] - places[0];
            for (const PlaneName plane : allPlaneNames)
                if (length(along) > 0 && farthestFrom(after, *held, places) < 1e-9)
                    least = std::min(
                        least,
                        std::asin(std::abs(normalized(along).dot(frameOf(plane, before, BeamAxis::plusZ).forward))));
            const double turn = std::acos(std::clamp(
                frameOf(*held, before, BeamAxis::plusZ).forward.dot(frameOf(*held, after, BeamAxis::plusZ).forward),
                -1.0, 1.0));
            if (places.size() == 2 && length(along) > 0) {
                EXPECT_NEAR(turn, least, 1e-7);
            }
            if (length(along) == 0) {
                EXPECT_EQ(after.direction, before.direction);
            }
            // Once there, it stays.
            EXPECT_EQ(planesHolding(after, places, BeamAxis::plusZ, dataOfPlaces), after);
        }
}

TEST(PlanesHolding, ThePlaneThatHoldsPlacesAlreadyIsTaken) {
    const Planes before = unusualPlanes();
    for (const PlaneName plane : allPlaneNames) {
        const ViewFrame frame = frameOf(plane, before, BeamAxis::plusZ);
        const Vec3 at = referencePointOf(before, dataOfPlaces);
        const std::vector<Vec3> places{at + frame.right * 5, at + frame.down * 4 - frame.right};
        const Planes after = planesHolding(before, places, BeamAxis::plusZ, dataOfPlaces);
        EXPECT_EQ(after.direction, before.direction);
        EXPECT_EQ(after.offsetMm, before.offsetMm);
    }
}

TEST(PlanesHolding, AMagnifiedPictureHasThePlacesInItsMiddle) {
    Planes before;
    for (PlaneCrop& crop : before.crops) crop.magnification = 8.0;
    const std::vector<Vec3> places{{0, 10, 20}, {4, 30, 25}};
    const Planes after = planesHolding(before, places, BeamAxis::plusZ, dataOfPlaces);
    bool centred = false;
    for (const PlaneName plane : allPlaneNames)
        centred = centred || apart(planeViewOf(after, plane, BeamAxis::plusZ, dataOfPlaces, 1.4).centreMm,
                                   (places[0] + places[1]) * 0.5) < 1e-9;
    EXPECT_TRUE(centred);
}

}  // namespace
}  // namespace echolucent
