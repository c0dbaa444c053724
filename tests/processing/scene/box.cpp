// Where the render box stands, and the way each of its sides looks in.
#include "processing/scene/box.h"

#include <gtest/gtest.h>

#include "processing/document/document.h"
#include "tests/processing/scene/places.h"

namespace echolucent {
namespace {

TEST(Box, SidesOfAnUnturnedBoxAreThoseOfThePlanes) {
    for (const BeamAxis beam : {BeamAxis::plusX, BeamAxis::minusY, BeamAxis::plusZ}) {
        const OrientedBox box = orientedBoxOf({}, beam);
        const auto seenFrom = [&](BoxSide side) { return frameFrom(side, box.axes); };
        EXPECT_TRUE(seenFrom(BoxSide::top) == frameOf(PlaneName::c, {}, beam));
        EXPECT_TRUE(seenFrom(BoxSide::near) == frameOf(PlaneName::a, {}, beam)) << "A's viewer stands before near";
        EXPECT_TRUE(seenFrom(BoxSide::left) == frameOf(PlaneName::b, {}, beam)) << "B's viewer stands to the left";
        EXPECT_EQ(apart(seenFrom(BoxSide::bottom).forward, -seenFrom(BoxSide::top).forward), 0);
        EXPECT_EQ(apart(seenFrom(BoxSide::far).forward, -seenFrom(BoxSide::near).forward), 0);
        EXPECT_EQ(apart(seenFrom(BoxSide::right).forward, -seenFrom(BoxSide::left).forward), 0);
    }
}

TEST(Box, EachFrontGivesItsDirection) {
    const Box box{.on = true, .direction = {25, -35, 15}, .centreMm = {1, 2, 3}, .sizeMm = {4, 5, 6}};
    for (const BeamAxis beam : {BeamAxis::minusX, BeamAxis::plusY, BeamAxis::minusZ})
        for (const BoxSide side : allBoxSides) {
            const ViewFrame wanted = frameFrom(side, orientedBoxOf(box, beam).axes);
            EXPECT_EQ(problemOf(wanted), "") << nameOf(side);
            const ViewFrame frame = frameOf(viewpointOf(beam, directionFrom(side, box, beam)));
            EXPECT_LT(apart(frame.forward, wanted.forward), 1e-12) << nameOf(side);
            EXPECT_LT(apart(frame.down, wanted.down), 1e-12) << nameOf(side);
        }
}

TEST(Box, TheWholeBoxHoldsAllDataAndNoMore) {
    const Box turned{.direction = {25, -35, 15}, .side = BoxSide::left};
    const Box whole = wholeBox(turned, BeamAxis::plusX, dataOfPlaces);
    EXPECT_TRUE(whole.on);
    EXPECT_EQ(whole.side, BoxSide::left);
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
