// What opening makes of its finds: sure ones are taken, all others leave the document as it is.
#include "processing/document/opening_finds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "processing/document/side_taking.h"
#include "processing/volume/coarse_grid.h"
#include "tests/processing/sides/hill.h"

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
    EXPECT_EQ(withFinds({}, unsure).beam, Beam{});
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
    EXPECT_EQ(found->place, probeSide) << "no side shows anything";
    EXPECT_EQ(found->sides->sides[probeSide].side.name, "Side 1") << "nobody knows where the probe was";
    EXPECT_EQ(withFinds({}, *found), Document{});
}

TEST(OpeningFinds, WhatAPersonSaidIsTakenAndNotLookedFor) {
    VolumeGeometry geometry;
    geometry.size = {20, 21, 22};
    const Volume even(geometry, Voxels(std::vector<std::uint8_t>(20 * 21 * 22, 90)));
    const ViewDirection side{.azimuth = 12};
    const auto found = findOnOpening(even, {}, {.beam = BeamAxis::minusX, .direction = side});
    EXPECT_FALSE(found->sides);
    EXPECT_EQ(found->source, SideSource::person);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->cut) << "along the side";
    const Document document = withFinds({}, *found);
    EXPECT_EQ(document.beam, (Beam{BeamAxis::minusX, BeamSource::person}));
    EXPECT_EQ(document.scene.side, side);
    EXPECT_FALSE(findOnOpening(even, {}, {.beam = BeamAxis::minusX, .front = true})->cut);
    // A side alone: the beam stays the assumed one.
    const Document turned = withFinds({}, *findOnOpening(even, {}, {.direction = side}));
    EXPECT_EQ(turned.beam, Beam{});
    EXPECT_EQ(turned.scene.side, side);
}

/// A hill that only the side from the right shows, along x against its axis.
const Volume& hill() {
    static const Volume volume = hillSeenAlong({-1, 0, 0});
    return volume;
}

TEST(OpeningFinds, TheSideThatShowsMostComesWithItsFront) {
    const auto found = findOnOpening(hill());
    ASSERT_TRUE(found && found->place);
    EXPECT_EQ(*found->place, found->sides->best);
    EXPECT_EQ(found->source, SideSource::found);
    const JudgedSide& judged = found->sides->sides[*found->place];
    const Document document = withFinds({}, *found);
    EXPECT_EQ(frameOf(otfViewpointOf(document, firstPane)).forward, Vec3(-1, 0, 0));
    EXPECT_EQ(document.scene.front.source, FrontSource::found);
    EXPECT_TRUE(document.scene.front == frontOf(judged.side.view, judged.front));
    EXPECT_TRUE(cuts(document.scene.front));
    const OpenedDocuments opened =
        openedDocuments({}, {.reference = SimulatedScan{}, .box = hill().dataBox(), .finds = found}, 1.0);
    EXPECT_EQ(frameOf(viewpointOf(opened.found)).forward, Vec3(-1, 0, 0)) << "it is seen from there too";
    Document taken = withSideTaken(opened.plain, judged, hill().dataBox(), 1.0);
    taken.beam = opened.found.beam;
    EXPECT_TRUE(taken == opened.found) << "a person who takes this side gets the same";
}

TEST(OpeningFinds, ASideThatAPersonSaidOrTookLastIsTaken) {
    for (const char* word : {"5", "side-5"}) {
        const auto said = findOnOpening(hill(), {}, {.side = word});
        EXPECT_EQ(said->place, std::size_t{4}) << word;
        EXPECT_EQ(said->source, SideSource::person);
        EXPECT_EQ(said->side, directionOf(said->sides->sides[4].side.view));
        EXPECT_EQ(said->cut->message, said->sides->sides[4].front.message) << "with its own front";
    }
    const auto unknown = findOnOpening(hill(), {}, {.side = "top"});
    EXPECT_FALSE(unknown->place);
    const auto remembered = findOnOpening(hill(), {}, {.sideOfKind = "side-2"});
    EXPECT_EQ(remembered->place, std::size_t{1});
    EXPECT_EQ(remembered->source, SideSource::remembered);
    const auto other = findOnOpening(hill(), {}, {.sideOfKind = "onto"});
    EXPECT_EQ(other->place, other->sides->best) << "this scan has no side of that name";
    EXPECT_EQ(other->source, SideSource::found);
    const auto both = findOnOpening(hill(), {}, {.side = "3", .front = true});
    EXPECT_EQ(both->place, std::size_t{2});
    EXPECT_FALSE(both->cut) << "the person chose the front too";
    // A front or a beam that a person said belongs to the view from the probe.
    EXPECT_FALSE(findOnOpening(hill(), {}, {.front = true})->sides);
    const auto along = findOnOpening(hill(), {}, {.beam = BeamAxis::minusY});
    EXPECT_FALSE(along->sides);
    EXPECT_EQ(along->side, ViewDirection{});
}

TEST(OpeningFinds, TheCoarseVolumeOfALargeOneSaysTheSide) {
    // Planes lie far apart along x, so that all voxels tell the planes, and those of the coarse grid, nearly cubes, do
    // not: its sides stand in another order. The hill is as large as with its own voxels.
    VolumeGeometry geometry = gridOf({110, 560, 560}, {48.0 / 110, 48.0 / 560, 48.0 / 560});
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    const auto near = [](std::int64_t at, std::int64_t size) { return at * voxelsOfEdge / size; };
    std::vector<std::uint8_t> rows;  // of 110 voxels, of each y and z of the hill; most are taken several times
    for (std::int64_t z = 0; z < voxelsOfEdge; ++z)
        for (std::int64_t y = 0; y < voxelsOfEdge; ++y)
            for (std::int64_t x = 0; x < 110; ++x)
                rows.push_back(
                    static_cast<std::uint8_t>(hill().storedValue(hill().geometry().offset(near(x, 110), y, z))));
    for (std::int64_t z = 0; z < 560; ++z)
        for (std::int64_t y = 0; y < 560; ++y)
            std::copy_n(rows.begin() + 110 * (near(z, 560) * voxelsOfEdge + near(y, 560)), 110,
                        voxels.begin() + geometry.offset(0, y, z));
    const Volume large(geometry, std::move(voxels));
    const auto coarse = coarseVolumeOf(large);
    ASSERT_TRUE(coarse);
    const auto seenFirst = findOnOpening(*coarse->voxels), found = findOnOpening(large);
    EXPECT_TRUE(found->sides->planes.sure);
    EXPECT_FALSE(seenFirst->sides->planes.sure);
    const auto looksAlong = [](const OpeningFinds& finds) {
        return frameOf(finds.sides->sides[*finds.place].side.view).forward;
    };
    EXPECT_LT(length(looksAlong(*found) - looksAlong(*seenFirst)), 1e-12);
    EXPECT_EQ(found->place, found->sides->best);
    const SidesFinding other = withFirst(*found->sides, 1);
    EXPECT_EQ(other.best, 1U);
    EXPECT_TRUE(other.sentence.starts_with("\"Side 2\" comes first")) << other.sentence;
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
    all.lean = all.side = {.azimuth = 10};
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
