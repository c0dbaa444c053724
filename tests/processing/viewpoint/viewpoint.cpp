#include "processing/viewpoint/viewpoint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace echolucent {
namespace {

constexpr BeamAxis allAxes[] = {BeamAxis::plusX,  BeamAxis::minusX, BeamAxis::plusY,
                                BeamAxis::minusY, BeamAxis::plusZ,  BeamAxis::minusZ};

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

TEST(Viewpoint, NamesOfBeamAxes) {
    for (const BeamAxis axis : allAxes) EXPECT_EQ(beamAxisFromName(nameOf(axis)), axis);
    EXPECT_EQ(nameOf(BeamAxis::minusY), "-y");
    for (const char* name : {"", "z", "+w", "+Z", "--z", "+z "})
        EXPECT_FALSE(beamAxisFromName(name).has_value()) << name;
}

TEST(Viewpoint, TheBeamAxisIsTheDefaultDirectionExactly) {
    const Vec3 directions[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::size_t i = 0; i < 6; ++i) {
        Viewpoint view;
        view.beamAxis = allAxes[i];
        EXPECT_EQ(frameOf(view).forward, directions[i]) << nameOf(allAxes[i]);
    }
    const ViewFrame frame = frameOf(Viewpoint{});
    EXPECT_EQ(frame.right, Vec3(1, 0, 0));
    EXPECT_EQ(frame.down, Vec3(0, 1, 0));
}

// The product R_y(azimuth) R_x(elevation) (0,0,1) is multiplied out by hand.
TEST(Viewpoint, AnglesTurnTheDirectionAsDefined) {
    for (double azimuth = -170; azimuth <= 180; azimuth += 35)
        for (double elevation = -85; elevation <= 85; elevation += 17) {
            Viewpoint view;
            view.azimuthDegrees = azimuth;
            view.elevationDegrees = elevation;
            view.rollDegrees = 3 * azimuth;
            const double a = radians(azimuth), e = radians(elevation);
            const Vec3 expected{std::sin(a) * std::cos(e), -std::sin(e), std::cos(a) * std::cos(e)};
            EXPECT_LT(length(frameOf(view).forward - expected), 1e-14);
        }
    Viewpoint right;
    right.azimuthDegrees = 90;
    EXPECT_EQ(frameOf(right).forward, Vec3(1, 0, 0)) << "azimuth turns +z towards +x";
    Viewpoint up;
    up.elevationDegrees = 90;
    EXPECT_EQ(frameOf(up).forward, Vec3(0, -1, 0)) << "elevation turns +z towards -y";
}

TEST(Viewpoint, TurnsAboutAnAxisOfItsOwnFrame) {
    for (const BeamAxis beam : allAxes)
        for (const double elevation : {0.0, 35.0, 90.0, -90.0})
            for (const double roll : {0.0, 90.0, 180.0, -40.0})
                for (const Vec3& axis :
                     {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(0.6, 0, 0.8)}) {
                    const Viewpoint before = withFrontAcross({beam, 20, elevation, roll}, 3);
                    const Viewpoint after = turnedAbout(before, axis, 50);
                    const ViewFrame from = frameOf(before), to = frameOf(after);
                    const Vec3 about = from.right * axis[0] + from.down * axis[1] + from.forward * axis[2];
                    EXPECT_EQ(after.frontPlane, before.frontPlane);
                    // About its axis every direction goes by 50 degrees, right-handed.
                    for (const auto direction : {&ViewFrame::right, &ViewFrame::down, &ViewFrame::forward}) {
                        const Vec3 across = from.*direction - about * about.dot(from.*direction);
                        const Vec3 expected = about * about.dot(from.*direction) + across * std::cos(radians(50)) +
                                              about.cross(across) * std::sin(radians(50));
                        EXPECT_LT(length(to.*direction - expected), 1e-12) << nameOf(beam) << elevation << ' ' << roll;
                    }
                }
    const Viewpoint turned = turnedAbout({BeamAxis::plusZ, 0.1, 0, 0}, {0, 1, 0}, 0.2);
    EXPECT_EQ(turned.azimuthDegrees, 0.1 + 0.2) << "the angles are added";
    EXPECT_EQ(turned.elevationDegrees, 0);
    EXPECT_EQ(turned.rollDegrees, 0);
}

TEST(Viewpoint, AnotherBeamAxisTurnsTheWholeFrame) {
    // With beam +y the frame is that of +z with y where z was and -z where y was.
    Viewpoint z, y;
    y.beamAxis = BeamAxis::plusY;
    z.azimuthDegrees = y.azimuthDegrees = 25;
    z.elevationDegrees = y.elevationDegrees = -40;
    z.rollDegrees = y.rollDegrees = 15;
    const auto turned = [](const Vec3& v) { return Vec3(v[0], v[2], -v[1]); };
    EXPECT_LT(length(frameOf(y).right - turned(frameOf(z).right)), 1e-14);
    EXPECT_LT(length(frameOf(y).down - turned(frameOf(z).down)), 1e-14);
    EXPECT_LT(length(frameOf(y).forward - turned(frameOf(z).forward)), 1e-14);
}

TEST(Viewpoint, FramesAreOrthonormalAndRightHanded) {
    for (const BeamAxis axis : allAxes)
        for (double angle = -179; angle < 180; angle += 29.3) {
            const Viewpoint view{axis, angle, angle / 2, -angle};
            const ViewFrame frame = frameOf(view);
            EXPECT_NEAR(length(frame.right), 1, 1e-14);
            EXPECT_NEAR(length(frame.down), 1, 1e-14);
            EXPECT_LT(length(frame.right.cross(frame.down) - frame.forward), 1e-14);
            Viewpoint rolled = view;
            rolled.rollDegrees += 77;
            EXPECT_LT(length(frameOf(rolled).forward - frame.forward), 1e-14) << "roll moves no tube core";
        }
}

TEST(Viewpoint, ViewAlongFindsTheViewOfAFrame) {
    for (const BeamAxis seenFrom : allAxes)
        for (const BeamAxis beam : allAxes)
            for (double angle = -171; angle < 180; angle += 38.6) {
                const ViewFrame frame = frameOf(Viewpoint{seenFrom, angle, angle / 2.3, angle * 0.7});
                const Viewpoint found = viewAlong(frame.forward * 3.0, frame.down * 0.2 + frame.forward, beam);
                EXPECT_EQ(found.beamAxis, beam);
                EXPECT_FALSE(found.frontPlane);
                EXPECT_LT(length(frameOf(found).forward - frame.forward), 1e-7);
                EXPECT_LT(length(frameOf(found).down - frame.down), 1e-7);
                EXPECT_TRUE(found.elevationDegrees >= -90 && found.elevationDegrees <= 90);
                EXPECT_TRUE(found.azimuthDegrees > -180.0000001 && found.azimuthDegrees <= 180);
            }
}

TEST(Viewpoint, ViewAlongGivesBackTheAngles) {
    const Viewpoint view = withFrontAcross({BeamAxis::minusX, -33, 21, 58}, 7);
    const ViewFrame frame = frameOf(view);
    const Viewpoint found = viewAlong(frame.forward, frame.down, BeamAxis::minusX);
    EXPECT_NEAR(found.azimuthDegrees, view.azimuthDegrees, 1e-9);
    EXPECT_NEAR(found.elevationDegrees, view.elevationDegrees, 1e-9);
    EXPECT_NEAR(found.rollDegrees, view.rollDegrees, 1e-9);
}

// Straight up, asin is badly conditioned: half the digits are all there is unless it is taken with care.
TEST(Viewpoint, ViewAlongThePolesKeepsItsDigits) {
    for (const double elevation : {90.0, -90.0, 89.9999999, 89.99})
        for (const double azimuth : {0.0, 40.0, -120.0}) {
            const ViewFrame frame = frameOf(Viewpoint{BeamAxis::plusZ, azimuth, elevation, 10});
            const ViewFrame found = frameOf(viewAlong(frame.forward, frame.down, BeamAxis::plusZ));
            EXPECT_LT(length(found.forward - frame.forward), 1e-12) << elevation;
            EXPECT_LT(length(found.down - frame.down), 1e-9) << elevation << " " << azimuth;
        }
}

TEST(Viewpoint, DirectionsInVoxelsHonourSpacing) {
    VolumeGeometry geometry;
    geometry.size = {10, 10, 10};
    geometry.spacing = {1, 2, 4};
    Viewpoint view;
    view.azimuthDegrees = 45;  // (1, 0, 1) in mm is (1, 0, 1/4) in voxels
    EXPECT_LT(length(directionInVoxels(view, geometry) - normalized(Vec3(1, 0, 0.25))), 1e-14);
    EXPECT_EQ(directionInVoxels(Viewpoint{}, geometry), Vec3(0, 0, 1));
}

TEST(Viewpoint, AFrontAcrossTheViewIsCountedFromTheForemostCorner) {
    VolumeGeometry geometry;
    geometry.size = {10, 20, 30};
    geometry.spacing = {1, 0.5, 2};
    Viewpoint view;
    EXPECT_DOUBLE_EQ(nearPlaneDepthMm(view, geometry), -1.0) << "half a voxel before the first centres";
    view = withFrontAcross(view, 7);
    EXPECT_DOUBLE_EQ(nearPlaneDepthMm(view, geometry), 6.0);
    EXPECT_DOUBLE_EQ(frontDepthMm(view), 7);
    view.beamAxis = BeamAxis::minusX;
    EXPECT_DOUBLE_EQ(nearPlaneDepthMm(view, geometry), -9.5) << "the front stays where it was";
    view = withFrontAcross(view, 7);
    EXPECT_DOUBLE_EQ(nearPlaneDepthMm(view, geometry), -9.5 + 7);
    view.frontPlane->depthMm = -3;
    EXPECT_DOUBLE_EQ(nearPlaneDepthMm(view, geometry), -9.5) << "never before the volume";
    EXPECT_FALSE(withFrontAcross(view, -3).frontPlane);
    view = Viewpoint{};
    view.azimuthDegrees = 45;
    EXPECT_NEAR(nearPlaneDepthMm(view, geometry), (-0.5 - 1.0) * std::sqrt(0.5), 1e-14);
}

TEST(Viewpoint, AnglesThatAreWholeButForRoundingAreWhole) {
    const Viewpoint view = withoutRounding({BeamAxis::plusY, 90.0 - 1e-14, -1e-13, -180.0 + 1e-13});
    EXPECT_EQ(view, (Viewpoint{BeamAxis::plusY, 90, 0, 180}));
    EXPECT_FALSE(std::signbit(view.elevationDegrees));
    EXPECT_EQ(withoutRounding({BeamAxis::plusY, 12.5, 1e-5, 3}), (Viewpoint{BeamAxis::plusY, 12.5, 1e-5, 3}));
}

}  // namespace
}  // namespace echolucent
