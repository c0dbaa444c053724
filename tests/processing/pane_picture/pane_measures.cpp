// The measures of a document's panes: with which surfaces, and what they do not depend on.
#include "processing/pane_picture/pane_measures.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <stdexcept>

#include "processing/adaptive/method_reading.h"
#include "processing/phantom/phantom.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent {
namespace {

const SimulatedScan scan{.scene = PhantomScene::shapes, .size = {56, 54, 58}, .seed = 4};

std::shared_ptr<const Volume> volumeOf(const SimulatedScan& simulated) {
    PhantomConfig config = defaultPhantom(simulated.scene);
    config.size = simulated.size;
    config.seed = simulated.seed;
    return std::make_shared<const Volume>(*makePhantom(config));
}

/// Panes of curves under a turned view behind a front, of a study whose truth nobody knows.
Document documentOf(const std::vector<CurveKind>& curves) {
    Document document;
    StudyFile file;
    file.path = "scan.mha";
    document.study = file;
    document.scene.pose.direction = {.azimuth = 15, .elevation = -6};
    document.scene.front.depthMm = 2;
    document.scene.look.reduction = SpeckleReduction::light;
    document.panes.clear();
    for (const CurveKind curve : curves) document.panes.push_back({.curve = curve});
    return document;
}

std::vector<PaneMeasures> measured(const Document& document, const StudyPhases& phases) {
    std::vector<PaneMeasures> all;
    const auto measures = measuresOfPanes(document, phases);
    for (const auto& one : *measures) all.push_back(one.value());
    return all;
}

void expectSame(const PaneMeasures& one, const PaneMeasures& other) {
    EXPECT_EQ(one.from, other.from);
    EXPECT_EQ(one.measures.depth, other.measures.depth);
    EXPECT_EQ(one.measures.contrast.contrastToNoise(), other.measures.contrast.contrastToNoise());
    EXPECT_EQ(one.measures.light.meanShare, other.measures.light.meanShare);
    EXPECT_EQ(one.measures.light.meanIntensity, other.measures.light.meanIntensity);
}

TEST(PaneMeasures, OfOneOtfAreTheSameInEveryPaneAndForEveryReading) {
    const StudyPhases phases{.scans = {volumeOf(scan)}};
    const Document document =
        documentOf({CurveKind::adaptive, CurveKind::linear, CurveKind::parabolic, CurveKind::linear});
    const auto all = measured(document, phases);
    EXPECT_EQ(all[1].from, SurfacesFrom::tubeCores);
    EXPECT_GT(all[1].measures.depth.rays(), 20);
    expectSame(all[1], all[3]);
    EXPECT_NE(all[1].measures.light.meanShare, all[2].measures.light.meanShare) << "another OTF has other numbers";
    for (const MethodReading reading : {MethodReading::asPublished, MethodReading::settled}) {
        Document other = document;
        other.method.config = configOf(reading);
        other.method.config.grid = {.columns = 7, .rows = 6, .withoutTubes = {3, 4}};
        other.panes[1].withoutTubes = {11};
        const auto read = measured(other, phases);
        for (const std::size_t fixed : {1u, 2u, 3u}) expectSame(read[fixed], all[fixed]);
        EXPECT_NE(read[0].measures.light.meanShare, all[0].measures.light.meanShare) << "the adaptive OTF is another";
    }
}

TEST(PaneMeasures, AreTakenInTheViewThatIsShownWithTheVoxelsThatAreShown) {
    const auto raw = volumeOf(scan);
    Document document = documentOf({CurveKind::parabolic, CurveKind::linear});
    document.motion.axis = MotionAxis::y;
    document.scene.motionAngle = 20;
    document.scene.side = {.azimuth = -40};
    const auto all = measured(document, {.scans = {raw}});
    const Viewpoint view = viewpointOf(document);
    ASSERT_NE(view, otfViewpointOf(document, firstPane));
    const Classification linear = classificationOf(document, 1, {});
    const auto expected =
        *measuresOf(*quietVolume(*raw, SpeckleReduction::light), view, *foundSurfaces(*raw, view), std::vector{linear});
    EXPECT_EQ(all[1].measures.depth, expected[0].depth);
    EXPECT_EQ(all[1].measures.light.meanShare, expected[0].light.meanShare);
}

TEST(PaneMeasures, OfASimulatedScanTakeTheTruthUnlessTheScalpelCut) {
    const auto raw = volumeOf(scan);
    Document document = documentOf({CurveKind::parabolic, CurveKind::linear});
    document.study = scan;
    const auto known = *measuredSurfacesOf(surfaceSourceOf(document), *raw);
    EXPECT_EQ(known.from, SurfacesFrom::truth);
    PhantomConfig config = defaultPhantom(scan.scene);
    config.size = scan.size;
    config.seed = scan.seed;
    EXPECT_EQ(known.rays, trueSurfaces(raw->geometry(), PhantomTruth(config), viewpointOf(document),
                                       InterfaceInto::objectOrTissue, measuredRaySpacing));
    for (const PaneMeasures& one : measured(document, {.scans = {raw}})) {
        EXPECT_EQ(one.from, SurfacesFrom::truth);
        EXPECT_EQ(one.measures.depth.rays(), static_cast<int>(known.rays.size()));
    }
    document.scene.strokes.push_back({.tool = ScalpelTool::eraser, .places = {{0.0, 0.0}}, .radius = 0.05});
    const auto cut = *measuredSurfacesOf(surfaceSourceOf(document), *raw);
    EXPECT_EQ(cut.from, SurfacesFrom::tubeCores);
    EXPECT_EQ(cut.rays, *foundSurfaces(*raw, viewpointOf(document)));
}

TEST(PaneMeasures, OfAPaneAreThoseOfItsOwnPhase) {
    SimulatedScan later = scan;
    later.seed = 9;
    const auto first = volumeOf(scan), second = volumeOf(later);
    Document document = documentOf({CurveKind::parabolic, CurveKind::linear});
    document.panes[1].phase = 1;
    const auto both = measured(document, {.scans = {first, second}});
    Document alone = documentOf({CurveKind::parabolic, CurveKind::linear});
    expectSame(both[0], measured(alone, {.scans = {first}})[0]);
    expectSame(both[1], measured(alone, {.scans = {second}})[1]);
    EXPECT_THROW((void)measuresOfPanes(document, {.scans = {first}}), std::out_of_range);
}

TEST(PaneMeasures, AreMissingWithoutASurfaceAndEndWhereCancelled) {
    VolumeGeometry geometry;
    geometry.size = {20, 20, 20};
    const auto nothing = std::make_shared<const Volume>(geometry, std::vector<std::uint8_t>(8000, 7));
    const Document document = documentOf({CurveKind::parabolic, CurveKind::linear});
    const auto none = *measuresOfPanes(document, {.scans = {nothing}});
    ASSERT_EQ(none.size(), 2u);
    EXPECT_FALSE(none[0] || none[1]);
    const std::atomic<bool> raised = true;
    EXPECT_FALSE(measuresOfPanes(document, {.scans = {nothing}}, {{}, &raised}));
}

}  // namespace
}  // namespace echolucent
