// What a stroke of the scalpel cuts, by its plain definition.
#include "processing/scalpel/scalpel_stroke.h"

#include <gtest/gtest.h>

#include "processing/picture/picture_place.h"

namespace echolucent {
namespace {

Camera camera(Projection projection) {
    return {{10, 20, 30}, frameOf(Viewpoint{.azimuthDegrees = 30, .elevationDegrees = -20}), projection, 40, 30, 100};
}

TEST(PicturePlace, IsTheOtherWayOfTheGridPlace) {
    for (const Projection projection : {Projection::parallel, Projection::perspective})
        for (const double depth : {5.0, 25.0, 60.0}) {
            const Vec3 place = gridPlaceAt(camera(projection), {0.2, -0.4}, depth);
            EXPECT_NEAR(camera(projection).frame.forward.dot(place), depth, 1e-9);
            const auto seen = placeInPicture(camera(projection), place);
            ASSERT_TRUE(seen);
            EXPECT_NEAR((*seen)[0], 0.2, 1e-12);
            EXPECT_NEAR((*seen)[1], -0.4, 1e-12);
        }
    const Camera perspective = camera(Projection::perspective);
    EXPECT_FALSE(placeInPicture(perspective, perspective.focalPoint - perspective.frame.forward * 101));
}

/// A place that the camera sees at (right, down), `behind` mm behind its focal point.
Vec3 at(const Camera& camera, double right, double down, double behind) {
    return gridPlaceAt(camera, {right, down}, camera.frame.forward.dot(camera.focalPoint) + behind);
}

TEST(ScalpelStroke, AnOutlineCutsInsideOrOutsideThroughEverythingOrDownToADepth) {
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        const Camera seen = camera(projection);
        ScalpelStroke stroke{.tool = ScalpelTool::polygon, .camera = seen, .places = {{0, 0}, {0.3, 0}, {0, 0.3}}};
        EXPECT_EQ(problemOf(stroke), "");
        for (const double behind : {-30.0, 0.0, 50.0}) {
            EXPECT_TRUE(cutsAway(stroke, at(seen, 0.1, 0.1, behind)));
            EXPECT_FALSE(cutsAway(stroke, at(seen, 0.2, 0.2, behind)));
            EXPECT_FALSE(cutsAway(stroke, at(seen, -0.1, 0.1, behind)));
        }
        stroke.depthMm = seen.frame.forward.dot(seen.focalPoint) + 10;
        EXPECT_TRUE(cutsAway(stroke, at(seen, 0.1, 0.1, 9)));
        EXPECT_FALSE(cutsAway(stroke, at(seen, 0.1, 0.1, 11)));
        stroke.side = ScalpelSide::outside;
        EXPECT_FALSE(cutsAway(stroke, at(seen, 0.1, 0.1, 9)));
        EXPECT_TRUE(cutsAway(stroke, at(seen, 0.2, 0.2, 9)));
        EXPECT_FALSE(cutsAway(stroke, at(seen, 0.2, 0.2, 11)));
    }
}

TEST(ScalpelStroke, WhatAnOutlineWindsAroundTwiceIsOutside) {
    const Camera seen = camera(Projection::parallel);
    // A five-pointed star, drawn in one go: its middle is wound around twice.
    const ScalpelStroke star{.camera = seen,
                             .places = {{0, -0.4}, {0.235, 0.324}, {-0.38, -0.124}, {0.38, -0.124}, {-0.235, 0.324}}};
    EXPECT_FALSE(cutsAway(star, at(seen, 0, 0, 0)));
    EXPECT_TRUE(cutsAway(star, at(seen, 0, -0.3, 0)));
}

TEST(ScalpelStroke, AnEraserCutsAlongItsLineAndRoundAtItsEnds) {
    const Camera seen = camera(Projection::parallel);
    ScalpelStroke eraser{.tool = ScalpelTool::eraser, .camera = seen, .places = {{0.1, 0}}, .radius = 0.05};
    EXPECT_EQ(problemOf(eraser), "");
    EXPECT_TRUE(cutsAway(eraser, at(seen, 0.149, 0, 3)));
    EXPECT_FALSE(cutsAway(eraser, at(seen, 0.151, 0, 3)));
    eraser.places = {{0.1, 0}, {0.1, 0.2}, {0.3, 0.2}};
    EXPECT_TRUE(cutsAway(eraser, at(seen, 0.06, 0.1, 3)));
    EXPECT_TRUE(cutsAway(eraser, at(seen, 0.2, 0.249, 3)));
    EXPECT_FALSE(cutsAway(eraser, at(seen, 0.2, 0.1, 3))) << "it encloses nothing";
}

TEST(ScalpelStroke, InPerspectiveNothingBehindTheEyeIsCut) {
    const Camera seen = camera(Projection::perspective);
    ScalpelStroke stroke{.camera = seen, .places = {{-9, -9}, {9, -9}, {0, 9}}};
    EXPECT_FALSE(cutsAway(stroke, seen.focalPoint - seen.frame.forward * 150));
    EXPECT_TRUE(cutsAway(stroke, seen.focalPoint - seen.frame.forward * 50));
}

}  // namespace
}  // namespace echolucent
