// Where the render box stands.
#include "processing/scene/box.h"

#include <gtest/gtest.h>

#include "processing/document/document.h"
#include "tests/processing/scene/places.h"

namespace echolucent {
namespace {

TEST(Box, TheWholeBoxHoldsAllDataAndNoMore) {
    const Box turned{.direction = {25, -35, 15}};
    const Box whole = wholeBox(turned, BeamAxis::plusX, dataOfPlaces);
    EXPECT_TRUE(whole.on);
    const OrientedBox box = orientedBoxOf(whole, BeamAxis::plusX);
    Vec3 farthest{0, 0, 0};
    for (const Vec3& corner :
         OrientedBox{dataOfPlaces.centreMm(), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, dataOfPlaces.sizeMm()}.corners())
        for (int axis = 0; axis < 3; ++axis)
            farthest[axis] = std::max(farthest[axis], std::abs(box.inBox(corner)[axis]));
    EXPECT_LT(apart(farthest, box.halfMm()), 1e-9);
}

TEST(Box, PlacesGoThereAndBack) {
    const OrientedBox box =
        orientedBoxOf({.direction = {25, -35, 15}, .centreMm = {1, 2, 3}, .sizeMm = {4, 5, 6}}, BeamAxis::minusY);
    EXPECT_LT(apart(box.inGrid(box.inBox({7, 8, 9})), {7, 8, 9}), 1e-12);
    EXPECT_TRUE(box.contains(box.inGrid({1.99, -2.49, 2.99})));
    EXPECT_FALSE(box.contains(box.inGrid({2.01, 0, 0})));
    EXPECT_FALSE(box.contains(box.inGrid({0, -2.51, 0})));
    EXPECT_FALSE(box.contains(box.inGrid({0, 0, 3.01})));
    EXPECT_LT(apart(box.corners()[5], box.inGrid({2, -2.5, 3})), 1e-12);
}

TEST(Box, LimitsWhatAViewShowsAndWhatItsTubeCoresRead) {
    Document document;
    document.beam.axis = BeamAxis::plusX;
    document.scene.box = {.on = false, .sizeMm = {4, 5, 6}};
    EXPECT_FALSE(viewpointOf(document).box) << "it is not switched on";
    document.scene.box.on = true;
    const OrientedBox box = orientedBoxOf(document.scene.box, BeamAxis::plusX);
    EXPECT_TRUE(viewpointOf(document).box == box);
    EXPECT_TRUE(otfViewpointOf(document, firstPane).box == box);
    document.scene.motionAngle = 10;
    EXPECT_TRUE(viewpointOf(document).box == box) << "it stays with the volume";
}

}  // namespace
}  // namespace echolucent
