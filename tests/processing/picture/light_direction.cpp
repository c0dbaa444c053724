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

TEST(LightDirection, TheDefaultIsUpperLeftInFrontOfTheViewer) {
    const Vec3 documented = normalized(Vec3(-0.45, -0.55, -0.7));
    EXPECT_LT(length(towardsLight(LightDirection{}) - documented), 1e-12);
    EXPECT_LT(length(normalized(Shading{}.towardsLight) - documented), 1e-12);
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
