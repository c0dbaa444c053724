#include "processing/document/document.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "processing/motion/otf_sweep.h"

namespace echolucent {
namespace {

TEST(Document, TheDefaultIsWhatTheProgramShowsUntouched) {
    const Document document;
    EXPECT_EQ(problemOf(document), "");
    EXPECT_TRUE(viewpointOf(document, 1) == Viewpoint{});
    EXPECT_TRUE(otfViewpointOf(document, 1) == Viewpoint{});
    EXPECT_TRUE(configOf(document) == AdaptiveOtfConfig{});
    EXPECT_EQ(viewOf(document, 1).curve, CurveKind::adaptive);
    const SampledCurve adaptive{{0.0, 0.5, 1.0}};
    EXPECT_TRUE(curveOf(document, 1, adaptive) == OpacityCurve(adaptive));
}

TEST(Document, TheInitialCurveIsTheDocumentsOwn) {
    Document document;
    document.curves.linear.slope = 0.7;
    document.curves.manual.nodes = {{0.25, 0.5}};
    document.method.initialScale = 0.3;
    document.method.config.initial = PowerCurve{3, 9.0};  // plays no part
    EXPECT_TRUE(configOf(document).initial == OpacityCurve(PowerCurve{2, 0.3}));
    document.method.initial = InitialKind::quartic;
    EXPECT_TRUE(configOf(document).initial == OpacityCurve(PowerCurve{4, 0.3}));
    document.method.initial = InitialKind::linear;
    EXPECT_TRUE(configOf(document).initial == OpacityCurve(document.curves.linear));
    document.method.initial = InitialKind::manual;
    EXPECT_TRUE(configOf(document).initial == OpacityCurve(document.curves.manual));
}

/// Two views of one pose and one cut each their own look and curve, and a third alone.
Document threeViews() {
    Document document;
    document.poses = {{1, {}}, {2, {}}};
    document.cuts = {{1, {}}, {2, {}}};
    document.views = {
        {1, 1, 1, 1, 1, CurveKind::adaptive}, {2, 1, 1, 1, 1, CurveKind::linear}, {3, 2, 2, 1, 1, CurveKind::manual}};
    return document;
}

TEST(Document, ViewsThatShareAnIdAreLinked) {
    Document document = threeViews();
    poseOf(document, 2) = Pose{{10, 20, 30}, {1, 2, 3}, 1.5};
    cutOf(document, 1).nearCutMm = 4;
    EXPECT_TRUE(poseOf(document, 1) == poseOf(document, 2));
    EXPECT_TRUE(viewpointOf(document, 1) == (Viewpoint{BeamAxis::plusZ, 10, 20, 30, 4}));
    EXPECT_TRUE(viewpointOf(document, 3) == Viewpoint{});
    EXPECT_FALSE(curveOf(document, 1, {}) == curveOf(document, 2, {}));
    EXPECT_THROW((void)poseOf(document, 4), std::out_of_range);
}

TEST(Document, RulesBetweenPartsAreNamed) {
    Document document = threeViews();
    EXPECT_EQ(problemOf(document), "");
    document.views[1].cut = 7;
    EXPECT_EQ(problemOf(document), "views[1].cut names no cut");
    document.poses[1].id = 1;
    EXPECT_EQ(problemOf(document), "poses must have an id of its own each");
    document.views.clear();
    EXPECT_EQ(problemOf(document), "views must hold at least one view");
}

TEST(Document, TheMotionTurnsWhatIsShownAndNotThePose) {
    Document document;
    document.beam.axis = BeamAxis::minusY;
    poseOf(document, 1) = Pose{{5, 6, 7}, {0, 0, 0}, 2};
    cutOf(document, 1).nearCutMm = 3;
    const Pose before = poseOf(document, 1);
    document.motionAngle = 12;
    const Viewpoint start{BeamAxis::minusY, 5, 6, 7, 3};
    for (const MotionAxis axis : {MotionAxis::x, MotionAxis::y, MotionAxis::z}) {
        document.motion.axis = axis;
        EXPECT_TRUE(viewpointOf(document, 1) == turned(start, axis, 12));
        EXPECT_TRUE(shownPose(document, 1).direction == directionOf(turned(start, axis, 12)));
        EXPECT_TRUE(poseOf(document, 1) == before);
        EXPECT_TRUE(otfViewpointOf(document, 1) == (Viewpoint{BeamAxis::minusY, 0, 0, 0, 3}));
    }
}

TEST(Pose, AnOffsetTurnsWithTheCameraAboutTheCentre) {
    const BeamAxis beam = BeamAxis::plusX;
    const Pose pose{{10, -20, 30}, {4, 5, 6}, 1.25};
    const Pose turned = turnedTo(pose, beam, {70, 35, -15});
    const ViewFrame before = frameOf(viewpointOf(beam, pose.direction, 0));
    const ViewFrame after = frameOf(viewpointOf(beam, turned.direction, 0));
    EXPECT_NEAR(turned.offsetMm.dot(after.right), pose.offsetMm.dot(before.right), 1e-12);
    EXPECT_NEAR(turned.offsetMm.dot(after.down), pose.offsetMm.dot(before.down), 1e-12);
    EXPECT_NEAR(turned.offsetMm.dot(after.forward), pose.offsetMm.dot(before.forward), 1e-12);
    EXPECT_EQ(turned.magnification, pose.magnification);
    EXPECT_GT(length(turned.offsetMm - pose.offsetMm), 1.0);
}

TEST(Document, ShowingAnotherPhaseOrFrameIsApartFromTheRest) {
    Document edited = threeViews();
    edited.curves.linear.slope = 0.9;
    Document shown;
    shown.phases = {{1, 5}};
    shown.motionAngle = 30;
    const Document both = withShown(edited, shown);
    EXPECT_EQ(phaseOf(both, 3), 5);
    EXPECT_EQ(both.motionAngle, 30);
    EXPECT_TRUE(withShown(both, edited) == edited);
}

TEST(Document, AnotherStudyKeepsWhatIsNoMatterOfTheStudy) {
    Document before = threeViews();
    before.beam = {BeamAxis::plusX, BeamSource::person};
    before.poses[1].value.magnification = 3;
    before.cuts[0].value.nearCutMm = 9;
    before.phases[0].value = 2;
    before.motionAngle = 10;
    before.curves.manual.nodes = {{0.5, 0.5}};
    before.method.config.cells.size = 7;
    before.method.direction.azimuth = 33;
    before.method.config.grid.withoutTubes = {3, 4};
    before.motion.otf = MotionOtf::mean;
    before.boxes[0].value = {.on = true, .sizeMm = {3, 4, 5}, .front = BoxSide::left};
    before.planes[0].value = {.direction = {1, 2, 3}, .offsetMm = {4, 5, 6}, .window = 0.5, .linesIn3d = true};
    before.strokes[0].value.list = {ScalpelStroke{.tool = ScalpelTool::eraser, .places = {{0, 0}}, .radius = 1}};
    Document expected = threeViews();
    expected.planes[0].value = {.window = 0.5, .linesIn3d = true};
    expected.study = SimulatedScan{};
    expected.curves = before.curves;
    before.curves.adjustment = {.threshold = 0.2, .transparency = 0.3};
    expected.method.config.cells.size = 7;
    expected.motion = before.motion;
    EXPECT_TRUE(openedDocument(before, SimulatedScan{}) == expected);
}

TEST(Document, NamesOfChoicesGoBothWays) {
    for (const CurveKind kind : allCurveKinds) EXPECT_EQ(curveKindFromName(nameOf(kind)), kind);
    for (const MotionOtf otf : allMotionOtfs) EXPECT_EQ(motionOtfFromName(nameOf(otf)), otf);
    for (const InitialKind kind :
         {InitialKind::parabolic, InitialKind::quartic, InitialKind::linear, InitialKind::manual})
        EXPECT_EQ(initialKindFromName(nameOf(kind)), kind);
    for (const BeamSource source : {BeamSource::assumed, BeamSource::sectorShape, BeamSource::echo, BeamSource::person})
        EXPECT_EQ(beamSourceFromName(nameOf(source)), source);
    for (const MotionAxis axis : {MotionAxis::x, MotionAxis::y, MotionAxis::z})
        EXPECT_EQ(motionAxisFromName(nameOf(axis)), axis);
    for (const MotionScenario scenario : {MotionScenario::probe, MotionScenario::object, MotionScenario::both})
        EXPECT_EQ(motionScenarioFromName(nameOf(scenario)), scenario);
    EXPECT_FALSE(curveKindFromName("sigmoid"));
    EXPECT_FALSE(motionOtfFromName(""));
}

}  // namespace
}  // namespace echolucent
