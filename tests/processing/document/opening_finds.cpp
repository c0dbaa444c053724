// What opening makes of its finds: sure ones are taken, all others leave the document as it is.
#include "processing/document/opening_finds.h"

#include <gtest/gtest.h>

namespace echolucent {
namespace {

OpeningFinds finds() {
    OpeningFinds all;
    all.beam = {.axis = BeamAxis::minusY, .evidence = BeamEvidence::sectorShape, .confidence = 0.8, .sure = true};
    all.cut = NearCutFinding{.answer = NearCutAnswer::wallBeforeFluid, .nearCutMm = 10.6499, .sure = true};
    return all;
}

TEST(OpeningFinds, SureOnesAreTaken) {
    const Document taken = withFinds({}, finds());
    EXPECT_EQ(taken.beam, (Beam{BeamAxis::minusY, BeamSource::sectorShape}));
    EXPECT_EQ(taken.scene.front, (Front{.depthMm = 10.6, .source = FrontSource::found}));
    Document rest = taken;
    rest.beam = {};
    rest.scene.front = {};
    EXPECT_EQ(rest, Document{}) << "nothing else changes";
}

TEST(OpeningFinds, WhatIsNotSureStaysAsItIs) {
    OpeningFinds unsure = finds();
    unsure.beam.sure = false;
    EXPECT_EQ(withFinds({}, unsure), Document{}) << "without a sure beam nobody knows along what to cut";
    unsure = finds();
    unsure.cut->sure = false;
    EXPECT_EQ(withFinds({}, unsure).scene.front, Front{});
    EXPECT_EQ(withFinds({}, unsure).beam.axis, BeamAxis::minusY);
    unsure = finds();
    unsure.cut->answer = NearCutAnswer::fluidAtFront;
    EXPECT_EQ(withFinds({}, unsure).scene.front, Front{});
}

TEST(OpeningFinds, AVolumeOfOneValueHasNone) {
    VolumeGeometry geometry;
    geometry.size = {20, 21, 22};
    const Volume even(geometry, Voxels(std::vector<std::uint8_t>(20 * 21 * 22, 90)));
    const auto found = findOnOpening(even);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->cut) << "without a sure beam nothing is looked for";
    EXPECT_EQ(withFinds({}, *found), Document{});
}

TEST(OpeningFinds, WhatAPersonSaidIsTakenAndNotLookedFor) {
    VolumeGeometry geometry;
    geometry.size = {20, 21, 22};
    const Volume even(geometry, Voxels(std::vector<std::uint8_t>(20 * 21 * 22, 90)));
    const ViewDirection side{.azimuth = 12};
    const auto found = findOnOpening(even, {}, {.beam = BeamAxis::minusX, .side = side});
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->cut) << "along the side";
    const Document document = withFinds({}, *found);
    EXPECT_EQ(document.beam, (Beam{BeamAxis::minusX, BeamSource::person}));
    EXPECT_EQ(document.scene.side, side);
    EXPECT_FALSE(findOnOpening(even, {}, {.beam = BeamAxis::minusX, .front = true})->cut);
    // A side alone: the beam stays the assumed one.
    const Document turned = withFinds({}, *findOnOpening(even, {}, {.side = side}));
    EXPECT_EQ(turned.beam, Beam{});
    EXPECT_EQ(turned.scene.side, side);
}

TEST(OpenedDocuments, AreSeenWholeFromTheirSideWithAndWithoutTheFinds) {
    VolumeGeometry geometry;
    geometry.size = {30, 20, 50};
    const Volume volume(geometry, Voxels(std::vector<std::uint8_t>(30 * 20 * 50, 90)));
    const double aspect = 1.5;
    Document before;
    before.scene.look.projection = Projection::perspective;
    before.scene.front.depthMm = 4;
    OpeningFinds all = finds();
    all.lean = {.azimuth = 10};
    const OpenedStudy study{.reference = SimulatedScan{}, .box = volume.dataBox(), .finds = all};
    const OpenedDocuments opened = openedDocuments(before, study, aspect);
    EXPECT_EQ(opened.plain.study, StudyReference(SimulatedScan{}));
    EXPECT_EQ(opened.plain.scene.front, Front{});
    EXPECT_EQ(opened.plain.scene.pose, wholeVolumePose(volume.dataBox(), Viewpoint{}, Projection::perspective, aspect));
    EXPECT_EQ(opened.found.scene.pose,
              wholeVolumePose(volume.dataBox(), viewAlongBeam(opened.found.beam), Projection::perspective, aspect));
    Document expected = withFinds(opened.plain, all);
    expected.scene.pose = opened.found.scene.pose;
    EXPECT_TRUE(opened.found == expected);
    OpenedStudy simulated = study;
    simulated.finds.reset();
    const OpenedDocuments same = openedDocuments(before, simulated, aspect);
    EXPECT_TRUE(same.plain == same.found) << "nothing is found of a scan whose beam is known";
}

TEST(OpenedDocuments, TheObjectOfA4DStudyMovesUnlessSomethingElseWasChosenInOne) {
    Document before;
    before.motion.scenario = MotionScenario::both;
    const auto scenario = [&](int phases, int phasesBefore) {
        OpenedStudy study;
        study.box = {{0, 0, 0}, {9, 9, 9}};
        study.phases = phases;
        study.phasesBefore = phasesBefore;
        return openedDocuments(before, study, 1.0).found.motion.scenario;
    };
    EXPECT_EQ(scenario(1, 4), MotionScenario::probe);
    EXPECT_EQ(scenario(4, 1), MotionScenario::object);
    EXPECT_EQ(scenario(4, 4), MotionScenario::both);
}

}  // namespace
}  // namespace echolucent
