// Which pixels stand for which ray: closed forms for both projections.
#include "processing/comparison/surface_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/picture/picture_place.h"

namespace echolucent {
namespace {

constexpr int columns = 5, rows = 3;
constexpr double apartMm = 2.0;

/// Rays in rows around the middle of the picture; their surfaces at one depth.
SurfaceRectangles lattice(const ViewFrame& frame, double depthMm) {
    SurfaceRectangles rectangles{.frame = frame, .sidesMm = {apartMm, apartMm}};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            rectangles.rays.push_back({.pointMm = frame.right * ((column - (columns - 1) / 2.0) * apartMm) +
                                                  frame.down * ((row - (rows - 1) / 2.0) * apartMm),
                                       .surfaceDepthMm = depthMm});
    return rectangles;
}

std::ptrdiff_t pixelsOf(const std::vector<std::int32_t>& picture, std::int32_t ray) {
    return std::ranges::count(picture, ray);
}

TEST(SurfacePicture, GivesEachRayTheSamePixelsInAParallelView) {
    const Camera camera{.heightMm = 12.0};  // 4 pixels a mm
    const auto picture = raysInPicture(camera, 64, 48, lattice(camera.frame, 7.0));
    ASSERT_EQ(picture.size(), 64U * 48U);
    for (std::int32_t ray = 0; ray < columns * rows; ++ray) EXPECT_EQ(pixelsOf(picture, ray), 64) << ray;
    EXPECT_EQ(pixelsOf(picture, noRay), 64 * 48 - 64 * columns * rows);
    const auto at = [&](int column, int row) { return picture[static_cast<std::size_t>(row * 64 + column)]; };
    EXPECT_EQ(at(32, 24), 7) << "the middle";
    EXPECT_EQ(at(12, 12), 0) << "five of 8 pixels before the middle begin at 12, three at 12";
    EXPECT_EQ(at(11, 12), noRay);
    EXPECT_EQ(at(12, 11), noRay);
    EXPECT_EQ(at(51, 35), columns * rows - 1);
    EXPECT_EQ(at(52, 35), noRay);
}

TEST(SurfacePicture, TurnsWithTheRowsOfTheRays) {
    const double angle = 0.4;
    const Camera camera{.heightMm = 12.0};
    const ViewFrame rolled{{std::cos(angle), std::sin(angle), 0}, {-std::sin(angle), std::cos(angle), 0}, {0, 0, 1}};
    const SurfaceRectangles rectangles = lattice(rolled, 7.0);
    const auto picture = raysInPicture(camera, 640, 480, rectangles);  // 40 pixels a mm
    for (std::int32_t ray = 0; ray < columns * rows; ++ray) {
        EXPECT_NEAR(static_cast<double>(pixelsOf(picture, ray)), 80.0 * 80.0, 80.0) << ray;
        const auto place = *placeInPicture(camera, rectangles.rays[static_cast<std::size_t>(ray)].pointMm);
        const auto column = static_cast<int>(320 + place[0] * 480), row = static_cast<int>(240 + place[1] * 480);
        EXPECT_EQ(picture[static_cast<std::size_t>(row * 640 + column)], ray);
    }
}

TEST(SurfacePicture, ShowsFartherRaysSmallerAndTheNearerBefore) {
    const Camera camera{.projection = Projection::perspective, .viewAngleDegrees = 40, .distanceMm = 20};
    const double perMm = 480 / (2.0 * std::tan(20.0 * std::numbers::pi / 180.0));  // pixels of a mm at 1 mm
    for (const double depth : {-5.0, 0.0, 10.0}) {
        const auto picture = raysInPicture(camera, 640, 480, lattice(camera.frame, depth));
        const double side = apartMm * perMm / (20.0 + depth);
        EXPECT_NEAR(static_cast<double>(pixelsOf(picture, 7)), side * side, 2.0 * side) << depth;
    }
    SurfaceRectangles two{.frame = camera.frame, .sidesMm = {apartMm, apartMm}};
    two.rays = {{.surfaceDepthMm = -5.0}, {.surfaceDepthMm = 10.0}};
    EXPECT_EQ(pixelsOf(raysInPicture(camera, 640, 480, two), 1), 0) << "the nearer one hides the farther one";
    std::swap(two.rays[0], two.rays[1]);
    EXPECT_EQ(pixelsOf(raysInPicture(camera, 640, 480, two), 0), 0) << "whatever their order";
    two.rays[0].surfaceDepthMm = -30.0;
    EXPECT_EQ(pixelsOf(raysInPicture(camera, 640, 480, two), 0), 0) << "behind the eye";
}

TEST(SurfacePicture, LeavesWhatThePictureCutsOff) {
    const Camera camera{.focalPoint = {4.0, 0, 0}, .heightMm = 4.0};  // 10 pixels a mm, from 2 to 6 mm to the right
    const auto picture = raysInPicture(camera, 40, 40, lattice(camera.frame, 0.0));
    EXPECT_EQ(pixelsOf(picture, 7), 0);
    EXPECT_EQ(pixelsOf(picture, 8), 10 * 20) << "half of it is left of the picture";
    EXPECT_EQ(pixelsOf(picture, 9), 20 * 20);
    EXPECT_TRUE(raysInPicture(camera, 0, 0, lattice(camera.frame, 0.0)).empty());
}

}  // namespace
}  // namespace echolucent
