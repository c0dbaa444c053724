#include "processing/volume/geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace echolucent {
namespace {

double largestDifference(const Mat3& a, const Mat3& b) { return cv::norm(a - b, cv::NORM_INF); }

TEST(Geometry, RotationsAreRightHandedTurnsOfTheAxes) {
    EXPECT_EQ(rotationX(90) * Vec3(0, 1, 0), Vec3(0, 0, 1));
    EXPECT_EQ(rotationY(90) * Vec3(0, 0, 1), Vec3(1, 0, 0));
    EXPECT_EQ(rotationZ(90) * Vec3(1, 0, 0), Vec3(0, 1, 0));
    EXPECT_EQ(rotationX(37) * Vec3(1, 0, 0), Vec3(1, 0, 0));
    EXPECT_EQ(rotationY(37) * Vec3(0, 1, 0), Vec3(0, 1, 0));
    EXPECT_EQ(rotationZ(37) * Vec3(0, 0, 1), Vec3(0, 0, 1));
    const double third = std::sqrt(3.0) / 2;
    EXPECT_NEAR(cv::norm(rotationZ(60) * Vec3(1, 0, 0) - Vec3(0.5, third, 0)), 0, 1e-15);
}

TEST(Geometry, QuarterTurnsAreExact) {
    for (const auto rotation : {rotationX, rotationY, rotationZ})
        for (const double degrees : {-810.0, -270.0, -180.0, -90.0, 0.0, 90.0, 180.0, 270.0, 360.0, 450.0, 36090.0})
            for (const double element : rotation(degrees).val)
                EXPECT_TRUE(element == 0.0 || element == 1.0 || element == -1.0) << degrees << ": " << element;
}

TEST(Geometry, RotationsComposeAndKeepLengths) {
    for (const auto rotation : {rotationX, rotationY, rotationZ})
        for (double degrees = -400; degrees < 400; degrees += 23.7) {
            const Mat3 turn = rotation(degrees);
            EXPECT_LT(largestDifference(turn * turn.t(), Mat3::eye()), 1e-15);
            EXPECT_NEAR(cv::determinant(turn), 1.0, 1e-15);
            EXPECT_LT(largestDifference(turn * rotation(11.0), rotation(degrees + 11.0)), 1e-14);
            EXPECT_LT(largestDifference(turn.t(), rotation(-degrees)), 1e-15);
        }
}

TEST(Geometry, NormalizedKeepsTheDirectionAndRefusesZero) {
    const Vec3 vector{3, -4, 12};
    EXPECT_DOUBLE_EQ(length(vector), 13.0);
    EXPECT_NEAR(length(normalized(vector)), 1.0, 1e-15);
    EXPECT_NEAR(normalized(vector).dot(vector), 13.0, 1e-14);
    EXPECT_THROW((void)normalized(Vec3(0, 0, 0)), std::invalid_argument);
    EXPECT_THROW((void)normalized(Vec3(std::nan(""), 0, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
