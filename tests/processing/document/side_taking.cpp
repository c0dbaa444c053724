// What a document becomes if a side is taken.
#include "processing/document/side_taking.h"

#include <gtest/gtest.h>

#include "processing/document/opening_finds.h"
#include "tests/processing/sides/hill.h"

namespace echolucent {
namespace {

TEST(SideTaking, SetsViewTubeCoresFrontAndExposureAndNothingElse) {
    const Volume volume = hillSeenAlong({0, 1, 0});
    const SidesFinding found = *findSides(volume, {}, true, CutShapes::flatAndCurved);
    Document before;
    before.scene.look.projection = Projection::perspective;
    before.scene.box = {.on = true, .centreMm = {3, 4, 5}, .sizeMm = {6, 7, 8}};
    before.scene.motionAngle = 12;
    before.scene.front = frontAcross({}, 9);
    before.scene.exposure = 0.7;
    for (const JudgedSide& judged : found.sides) {
        const Document taken = withSideTaken(before, judged, volume.dataBox(), 1.5);
        const Vec3 forward = frameOf(judged.side.view).forward;
        EXPECT_LT(length(frameOf(viewpointOf(taken)).forward - forward), 1e-12) << judged.side.name;
        EXPECT_LT(length(frameOf(otfViewpointOf(taken, firstPane)).forward - forward), 1e-12);
        EXPECT_EQ(cuts(taken.scene.front), makesFront(judged.front)) << "the front before is gone";
        EXPECT_EQ(taken.scene.exposure, judged.exposure);
        EXPECT_EQ(taken.scene.motionAngle, 0.0);
        Viewpoint onto = judged.side.view;
        onto.box = orientedBoxOf(before.scene.box, BeamAxis::plusZ);
        EXPECT_EQ(taken.scene.pose, wholeVolumePose(volume.dataBox(), onto, Projection::perspective, 1.5))
            << "the box fills the picture";
        EXPECT_EQ(sideAlong(found, taken.beam.axis, taken.scene.side),
                  static_cast<std::size_t>(judged.side.number - 1));
        Document rest = taken;
        rest.scene.pose = before.scene.pose;
        rest.scene.side = before.scene.side;
        rest.scene.front = before.scene.front;
        rest.scene.exposure = before.scene.exposure;
        rest.scene.motionAngle = before.scene.motionAngle;
        EXPECT_TRUE(rest == before);
    }
}

TEST(SideTaking, AFlatFrontIsRoundedAsPeopleSetItAndABowedOneIsKept) {
    const Viewpoint view{.azimuthDegrees = 90};
    NearCutFinding finding{.answer = NearCutAnswer::wallBeforeFluid, .nearCutMm = 10.6499, .sure = true};
    EXPECT_EQ(frontOf(view, finding),
              (Front{.depthMm = 10.6, .direction = {.azimuth = 90}, .source = FrontSource::found}));
    EXPECT_NEAR(frontDepthMm(behindFound(view, finding)), 10.6499, 1e-12);
    finding.surface = CutSurface{.columns = 2, .rows = 2, .depthMm = {1.F, 2.F, 3.F, 4.F}};
    EXPECT_EQ(frontOf(view, finding), (Front{.surface = finding.surface, .source = FrontSource::found}));
    EXPECT_TRUE(behindFound(view, finding).cutSurface == finding.surface);
    EXPECT_FALSE(behindFound(view, finding).frontPlane);
    finding.sure = false;
    EXPECT_EQ(frontOf(view, finding), Front{});
    EXPECT_TRUE(behindFound(view, finding) == view);
}

TEST(SideTaking, ADirectionLooksAlongASideToADegreeHoweverItRolls) {
    const SidesFinding found = *findSides(hillSeenAlong({0, 1, 0}), {}, true);
    EXPECT_EQ(sideAlong(found, BeamAxis::plusZ, {.azimuth = 0.9}), probeSide);
    EXPECT_EQ(sideAlong(found, BeamAxis::plusZ, {.azimuth = 0.5, .roll = 70}), probeSide);
    EXPECT_FALSE(sideAlong(found, BeamAxis::plusZ, {.azimuth = 1.5}));
}

}  // namespace
}  // namespace echolucent
