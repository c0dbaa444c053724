// Where the planes lie in the grid, which way up they are, and what turning and stepping them moves.
#include "processing/scene/planes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/processing/scene/places.h"

namespace echolucent {
namespace {

constexpr BeamAxis everyBeam[] = {BeamAxis::plusX,  BeamAxis::minusX, BeamAxis::plusY,
                                  BeamAxis::minusY, BeamAxis::plusZ,  BeamAxis::minusZ};

TEST(Planes, TheBeamRunsDownInAAndBAndIntoC) {
    for (const BeamAxis beam : everyBeam) {
        const ViewFrame probe = frameOf(Viewpoint{.beamAxis = beam});
        EXPECT_EQ(apart(frameOf(PlaneName::a, {}, beam).down, probe.forward), 0);
        EXPECT_EQ(apart(frameOf(PlaneName::b, {}, beam).down, probe.forward), 0);
        EXPECT_EQ(apart(frameOf(PlaneName::c, {}, beam).forward, probe.forward), 0);
        // C under A shows the same columns; B is what a viewer to the left of A sees.
        EXPECT_EQ(apart(frameOf(PlaneName::a, {}, beam).right, frameOf(PlaneName::c, {}, beam).right), 0);
        EXPECT_EQ(apart(frameOf(PlaneName::b, {}, beam).forward, frameOf(PlaneName::a, {}, beam).right), 0);
        EXPECT_EQ(apart(frameOf(PlaneName::b, {}, beam).right, frameOf(PlaneName::c, {}, beam).down), 0);
    }
}

TEST(Planes, EveryFrameIsRightHanded) {
    for (const BeamAxis beam : everyBeam)
        for (const PlaneName plane : allPlaneNames)
            EXPECT_EQ(problemOf(frameOf(plane, unusualPlanes(), beam)), "") << nameOf(plane) << " " << nameOf(beam);
}

TEST(Planes, TurningOneKeepsItsVoxelsAndTheReferencePointsPlaceInAll) {
    for (const BeamAxis beam : everyBeam)
        for (const PlaneName plane : allPlaneNames) {
            const Planes before = unusualPlanes(), after = turned(before, plane, 30, beam);
            const ViewFrame from = frameOf(plane, before, beam), to = frameOf(plane, after, beam);
            EXPECT_LT(apart(from.forward, to.forward), 1e-12);
            EXPECT_LT(apart(referencePointOf(before, dataOfPlaces), referencePointOf(after, dataOfPlaces)), 1e-12);
            // The picture turns clockwise: what was to the right is now to the right and 30 degrees below.
            EXPECT_NEAR(to.right.dot(from.right), std::cos(30 * M_PI / 180), 1e-12);
            EXPECT_NEAR(to.down.dot(from.right), 0.5, 1e-12);
            for (const PlaneName each : allPlaneNames) {
                const PlaneView a = planeViewOf(before, each, beam, dataOfPlaces, 1.5),
                                b = planeViewOf(after, each, beam, dataOfPlaces, 1.5);
                const Vec3 at = referencePointOf(before, dataOfPlaces);
                EXPECT_NEAR(a.frame.right.dot(at - a.centreMm), b.frame.right.dot(at - b.centreMm), 1e-9);
                EXPECT_NEAR(a.frame.down.dot(at - a.centreMm), b.frame.down.dot(at - b.centreMm), 1e-9);
                EXPECT_NEAR(b.frame.forward.dot(at - b.centreMm), 0, 1e-9) << "it lies in the plane";
            }
        }
}

TEST(Planes, TurnsThereAndBackAddUp) {
    Planes planes = unusualPlanes();
    for (int i = 0; i < 36; ++i) planes = turned(planes, PlaneName::b, 10, BeamAxis::minusY);
    for (const PlaneName plane : allPlaneNames)
        EXPECT_LT(apart(frameOf(plane, planes, BeamAxis::minusY).right,
                        frameOf(plane, unusualPlanes(), BeamAxis::minusY).right),
                  1e-9);
}

TEST(Planes, APoseTurnsAlongAsIfHeldByThePlanes) {
    for (const BeamAxis beam : everyBeam)
        for (const PlaneName plane : allPlaneNames) {
            const Pose pose{{-50, plane == PlaneName::b ? 90.0 : 12.0, 8}, {2, 9, -4}, 1.7};
            const Planes before = unusualPlanes(), after = turned(before, plane, 40, beam);
            const Pose along = turnedAlong(pose, before, after, beam);
            EXPECT_EQ(along.magnification, pose.magnification);
            EXPECT_LE(std::abs(along.direction.elevation), 90);
            // Seen from each plane, the camera stands and looks as before.
            const ViewFrame from = frameOf(viewpointOf(beam, pose.direction)),
                            to = frameOf(viewpointOf(beam, along.direction));
            const ViewFrame held = frameOf(plane, before, beam), holds = frameOf(plane, after, beam);
            const Vec3 arm = pose.offsetMm - before.offsetMm, armAlong = along.offsetMm - after.offsetMm;
            for (const auto axis : {&ViewFrame::right, &ViewFrame::down, &ViewFrame::forward}) {
                EXPECT_NEAR((held.*axis).dot(from.forward), (holds.*axis).dot(to.forward), 1e-12);
                EXPECT_NEAR((held.*axis).dot(from.down), (holds.*axis).dot(to.down), 1e-12);
                EXPECT_NEAR((held.*axis).dot(arm), (holds.*axis).dot(armAlong), 1e-12);
            }
            // The plane's own picture turned clockwise by 40 degrees, its axis stayed.
            EXPECT_NEAR(held.forward.dot(from.forward), held.forward.dot(to.forward), 1e-12);
        }
    Planes stepped = unusualPlanes();
    stepped.offsetMm += Vec3(1, 2, 3);
    const Pose pose{{-50, 12, 8}, {2, 9, -4}, 1.7};
    EXPECT_TRUE(turnedAlong(pose, unusualPlanes(), stepped, BeamAxis::plusY) == pose) << "no turn";
}

TEST(Planes, AStepMovesAlongTheWayOfLookingAndEndsAtTheData) {
    const Planes planes;
    for (const PlaneName plane : allPlaneNames) {
        const Vec3 forward = frameOf(plane, planes, BeamAxis::plusX).forward;
        const Planes near = stepped(planes, plane, 2.5, BeamAxis::plusX, dataOfPlaces);
        EXPECT_LT(apart(near.offsetMm, forward * 2.5), 1e-12);
        const Planes far = stepped(planes, plane, 1e6, BeamAxis::plusX, dataOfPlaces);
        EXPECT_NEAR(forward.dot(far.offsetMm), std::abs(forward.dot(dataOfPlaces.sizeMm())) / 2, 1e-9);
        EXPECT_TRUE(stepped(far, plane, 1, BeamAxis::plusX, dataOfPlaces) == far);
    }
    const Planes oblique = stepped(unusualPlanes(), PlaneName::a, 1e6, BeamAxis::plusZ, dataOfPlaces);
    const Vec3 moved = oblique.offsetMm - unusualPlanes().offsetMm;
    EXPECT_LT(length(moved.cross(frameOf(PlaneName::a, unusualPlanes(), BeamAxis::plusZ).forward)), 1e-9)
        << "a step that ends at the border does not slide along it";
}

TEST(Planes, TheReferencePointStaysInTheData) {
    EXPECT_LT(apart(referencePointOf(withReferencePoint({}, {1, 6, 11}, dataOfPlaces), dataOfPlaces), {1, 6, 11}),
              1e-12);
    // From (17, 20, 50) towards (-23, 20, 130) the way leaves the box half way, at a face and an edge of it.
    EXPECT_LT(apart(referencePointOf(withReferencePoint({}, {-23, 20, 130}, dataOfPlaces), dataOfPlaces), {-3, 20, 90}),
              1e-12);
    EXPECT_LT(apart(referencePointOf(withReferencePoint({}, {17, 20, 1e9}, dataOfPlaces), dataOfPlaces), {17, 20, 90}),
              1e-6);
}

TEST(Planes, AtMagnification1AllOfTheDataFitsIntoEachAtOneScale) {
    for (const BeamAxis beam : everyBeam)
        for (const double aspect : {0.4, 1.0, 2.5}) {
            const double height = planeViewOf({}, PlaneName::a, beam, dataOfPlaces, aspect).heightMm;
            double filled = 0;
            for (const PlaneName plane : allPlaneNames) {
                const PlaneView view = planeViewOf({}, plane, beam, dataOfPlaces, aspect);
                EXPECT_EQ(view.heightMm, height);
                EXPECT_LT(apart(view.centreMm, dataOfPlaces.centreMm()), 1e-12);
                filled = std::max({filled, std::abs(view.frame.down.dot(dataOfPlaces.sizeMm())) / height,
                                   std::abs(view.frame.right.dot(dataOfPlaces.sizeMm())) / height / aspect});
            }
            EXPECT_GT(filled, 0.9);
            EXPECT_LE(filled, 1.0);
        }
    Planes near;
    near.crops[indexOf(PlaneName::b)] = {3, -4, 2};
    const PlaneView whole = planeViewOf({}, PlaneName::b, BeamAxis::plusY, dataOfPlaces, 1),
                    part = planeViewOf(near, PlaneName::b, BeamAxis::plusY, dataOfPlaces, 1);
    EXPECT_EQ(part.heightMm, whole.heightMm / 2);
    EXPECT_LT(apart(part.centreMm, whole.centreMm + whole.frame.right * 3 - whole.frame.down * 4), 1e-12);
}

}  // namespace
}  // namespace echolucent
