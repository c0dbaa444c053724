#include "processing/picture/light_direction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "processing/picture/shading.h"

namespace echolucent {
namespace {

TEST(LightDirection, GoesRightUpAndBehindAsItSays) {
    EXPECT_LT(length(towardsLight({0, 0}) - Vec3(0, 0, -1)), 1e-15) << "the viewer's own place";
    EXPECT_LT(length(towardsLight({90, 0}) - Vec3(1, 0, 0)), 1e-15) << "right";
    EXPECT_LT(length(towardsLight({0, 90}) - Vec3(0, -1, 0)), 1e-15) << "above: down is positive";
    EXPECT_LT(length(towardsLight({180, 0}) - Vec3(0, 0, 1)), 1e-15) << "behind";
    const Vec3 slanted = towardsLight({-30, 45});
    EXPECT_NEAR(slanted[0], -0.5 * std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(slanted[1], -std::sqrt(0.5), 1e-15);
}

TEST(LightDirection, ComesBackFromItsVector) {
    for (const double azimuth : {-179.0, -90.0, -32.5, 0.0, 45.0, 180.0})
        for (const double elevation : {-80.0, 0.0, 33.25, 89.0}) {
            const LightDirection back = lightDirectionOf(towardsLight({azimuth, elevation}) * 3.0);
            EXPECT_NEAR(back.azimuthDegrees, azimuth, 1e-9);
            EXPECT_NEAR(back.elevationDegrees, elevation, 1e-9);
        }
    EXPECT_EQ(lightDirectionOf({0, -2, 0}), (LightDirection{0, 90}));
    EXPECT_EQ(lightDirectionOf({0, 2, 0}), (LightDirection{0, -90}));
}

TEST(LightDirection, TheDefaultIsTheLightOfShadingToTheDegree) {
    const LightDirection usual = lightDirectionOf(Shading{}.towardsLight);
    EXPECT_NEAR(usual.azimuthDegrees, LightDirection{}.azimuthDegrees, 0.5);
    EXPECT_NEAR(usual.elevationDegrees, LightDirection{}.elevationDegrees, 0.5);
}

TEST(LightDirection, FollowsTheHand) {
    const LightDirection start{170, 80};
    EXPECT_EQ(moved(start, 0.0, 0.0), start);
    EXPECT_NEAR(moved(start, 0.25, 0.0).azimuthDegrees, -145.0, 1e-9) << "wraps";
    EXPECT_NEAR(moved(start, 0.0, 0.5).elevationDegrees, -10.0, 1e-9) << "down is down";
    EXPECT_EQ(moved(start, 0.0, -5.0).elevationDegrees, 90.0) << "stops above";
}

}  // namespace
}  // namespace echolucent
