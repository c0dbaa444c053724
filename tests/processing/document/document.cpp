#include "processing/document/document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "processing/light/rendered_part.h"
#include "processing/motion/otf_sweep.h"
#include "processing/picture/view_limits.h"

namespace echolucent {
namespace {

TEST(Document, TheDefaultIsWhatTheProgramShowsUntouched) {
    const Document document;
    EXPECT_EQ(problemOf(document), "");
    EXPECT_TRUE(viewpointOf(document) == Viewpoint{});
    EXPECT_TRUE(otfViewpointOf(document, firstPane) == Viewpoint{});
    EXPECT_TRUE(configOf(document) == AdaptiveOtfConfig{});
    EXPECT_EQ(document.panes.at(firstPane).curve, CurveKind::adaptive);
    const SampledCurve adaptive{{0.0, 0.5, 1.0}};
    EXPECT_TRUE(curveOf(document, firstPane, adaptive) == OpacityCurve(adaptive));
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

/// Three panes with a curve each.
Document threePanes() {
    Document document;
    document.panes = {{.curve = CurveKind::adaptive}, {.curve = CurveKind::linear}, {.curve = CurveKind::manual}};
    return document;
}

TEST(Document, PanesShareTheSceneAndHaveACurveEach) {
    Document document = threePanes();
    document.scene.pose = Pose{{10, 20, 30}, {1, 2, 3}, 1.5};
    document.scene.front = frontAcross({10, 20, -5}, 4);
    EXPECT_TRUE(viewpointOf(document) == (withFrontAcross(Viewpoint{BeamAxis::plusZ, 10, 20, 30}, 4)));
    EXPECT_FALSE(curveOf(document, 1, {}) == curveOf(document, 2, {}));
    EXPECT_THROW((void)curveOf(document, 3, {}), std::out_of_range);
}

TEST(Document, TheMotionTurnsWhatIsShownAndNotThePose) {
    Document document;
    document.beam.axis = BeamAxis::minusY;
    document.scene.pose = Pose{{5, 6, 7}, {0, 0, 0}, 2};
    document.scene.front = frontAcross({5, 6, 7}, 3);
    const Pose before = document.scene.pose;
    document.scene.motionAngle = 12;
    const Viewpoint start = withFrontAcross({BeamAxis::minusY, 5, 6, 7}, 3);
    for (const MotionAxis axis : {MotionAxis::x, MotionAxis::y, MotionAxis::z, MotionAxis::screenVertical,
                                  MotionAxis::screenHorizontal, MotionAxis::picturePlane}) {
        document.motion.axis = axis;
        EXPECT_TRUE(viewpointOf(document) == turned(start, axis, 12));
        EXPECT_TRUE(shownPose(document).direction == directionOf(turned(start, axis, 12)));
        EXPECT_TRUE(document.scene.pose == before);
        Viewpoint fromSide{BeamAxis::minusY};
        fromSide.frontPlane = start.frontPlane;
        EXPECT_TRUE(otfViewpointOf(document, firstPane) == fromSide);
    }
}

TEST(Pose, AMotionOverAPoleShowsADirectionThatAFileMayHold) {
    for (const double elevation : {-100.0, -90.0, 0.0, 90.0, 91.0, 135.0, 180.0, 269.0}) {
        const Viewpoint view{BeamAxis::plusY, 170, elevation, -30};
        const ViewDirection direction = directionOf(view);
        EXPECT_LE(std::abs(direction.elevation), 90.0) << elevation;
        const ViewFrame seen = frameOf(view), said = frameOf(viewpointOf(BeamAxis::plusY, direction));
        EXPECT_NEAR(length(seen.forward - said.forward) + length(seen.down - said.down), 0.0, 1e-12) << elevation;
        if (std::abs(elevation) <= 90.0) {
            EXPECT_TRUE(direction == (ViewDirection{170, elevation, -30})) << "to the bit";
        }
    }
    Document document;  // looked into from above, and tilted by the motion
    document.scene.pose.direction.elevation = 90;
    document.motion.axis = MotionAxis::x;
    document.scene.motionAngle = 1;
    document.scene.pose = shownPose(document);
    EXPECT_EQ(problemOf(document), "");
    EXPECT_NEAR(document.scene.pose.direction.elevation, 89.0, 1e-12);
}

TEST(Pose, AnOffsetTurnsWithTheCameraAboutTheCentre) {
    const BeamAxis beam = BeamAxis::plusX;
    const Pose pose{{10, -20, 30}, {4, 5, 6}, 1.25};
    const Pose turned = turnedTo(pose, beam, {70, 35, -15});
    const ViewFrame before = frameOf(viewpointOf(beam, pose.direction));
    const ViewFrame after = frameOf(viewpointOf(beam, turned.direction));
    EXPECT_NEAR(turned.offsetMm.dot(after.right), pose.offsetMm.dot(before.right), 1e-12);
    EXPECT_NEAR(turned.offsetMm.dot(after.down), pose.offsetMm.dot(before.down), 1e-12);
    EXPECT_NEAR(turned.offsetMm.dot(after.forward), pose.offsetMm.dot(before.forward), 1e-12);
    EXPECT_EQ(turned.magnification, pose.magnification);
    EXPECT_GT(length(turned.offsetMm - pose.offsetMm), 1.0);
}

TEST(Document, ShowingAnotherPhaseOrFrameIsApartFromTheRest) {
    Document edited = threePanes();
    edited.curves.linear.slope = 0.9;
    Document shown;
    shown.scene.phase = 5;
    shown.scene.motionAngle = 30;
    const Document both = withShown(edited, shown);
    EXPECT_EQ(phaseOf(both, 2), 5);
    EXPECT_EQ(both.scene.motionAngle, 30);
    EXPECT_TRUE(withShown(both, edited) == edited);
}

TEST(Document, AnotherStudyKeepsWhatIsNoMatterOfTheStudy) {
    Document before = threePanes();
    before.beam = {BeamAxis::plusX, BeamSource::person};
    before.scene.pose.magnification = 3;
    before.scene.front.depthMm = 9;
    before.scene.phase = 2;
    before.scene.motionAngle = 10;
    before.curves.manual.nodes = {{0.5, 0.5}};
    before.method.config.cells.size = 7;
    before.scene.side.azimuth = 33;
    before.method.config.grid.withoutTubes = {3, 4};
    before.motion = {.axis = MotionAxis::x, .otf = MotionOtf::mean};  // of an older document
    before.scene.box = {.on = true, .sizeMm = {3, 4, 5}};
    before.scene.planes = {
        .direction = {1, 2, 3}, .offsetMm = {4, 5, 6}, .window = 0.5, .linesIn3d = true, .turnsView = true};
    before.scene.strokes = {ScalpelStroke{.tool = ScalpelTool::eraser, .places = {{0, 0}}, .radius = 1}};
    Document expected = threePanes();
    expected.scene.planes = {.window = 0.5, .linesIn3d = true, .turnsView = true};
    expected.study = SimulatedScan{};
    expected.curves = before.curves;
    before.curves.adjustment = {.threshold = 0.2, .transparency = 0.3};
    expected.method.config.cells.size = 7;
    expected.motion = {.axis = MotionAxis::screenHorizontal, .otf = MotionOtf::mean};
    EXPECT_TRUE(openedDocument(before, SimulatedScan{}) == expected);
}

/// What a scene cuts away of a volume, by place; `scene` has no box.
bool cutsAway(const Scene& scene, BeamAxis beam, const VolumeGeometry& geometry, const Vec3& place) {
    if (scene.front.surface && scene.front.surface->cutsAway(place)) return true;
    if (scene.front.depthMm == 0.0) return false;
    const Viewpoint view = viewpointOf(beam, scene.front.direction);
    return frameOf(view).forward.dot(place) < nearPlaneDepthMm(view, geometry) + scene.front.depthMm;
}

/// The voxels that a picture of the document leaves, or light, or tube cores.
std::vector<bool> leftIn(const Viewpoint& view, const VolumeGeometry& geometry) {
    const RayCastSettings settings = limitedTo(view, geometry, {});
    const RenderedShares left({settings.front, settings.box, settings.clippingPlanes, settings.cutSurface}, {1, 1, 1});
    std::vector<bool> voxels;
    for (int z = 0; z < geometry.size[2]; ++z)
        for (int y = 0; y < geometry.size[1]; ++y)
            for (int x = 0; x < geometry.size[0]; ++x)
                voxels.push_back(left.contains(geometry.gridMmFromVoxel(
                    {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)})));
    return voxels;
}

/// A surface over a cube of 40 voxels, bowed along its columns.
CutSurface bowedSurface();

// The front of 0.1 turned with the camera, so that a wall which was cut away came back as the hand moved.
TEST(Scene, AFrontCutsTheSameVoxelsFromWhereverOneLooks) {
    VolumeGeometry geometry;
    geometry.size = {21, 19, 17};
    geometry.spacing = Vec3(1.4, 1.8, 2.2);
    for (const bool bowed : {false, true}) {
        Document document;
        document.beam.axis = BeamAxis::plusY;
        document.scene.pose.direction = document.scene.side = {12, -7, 3};
        document.scene.front = bowed ? Front{.surface = bowedSurface()} : frontAcross({12, -7, 3}, 11.3);
        const std::vector<bool> first = leftIn(viewpointOf(document), geometry);
        EXPECT_GT(std::ranges::count(first, true), 1000);
        EXPECT_GT(std::ranges::count(first, false), 1000);
        // Forty directions over the whole sphere, the poles among them, and the frames of a motion from each.
        for (int i = 0; i < 40; ++i) {
            const double elevation = i < 2 ? (i == 0 ? 90.0 : -90.0) : std::asin(2.0 * (i + 0.5) / 40 - 1) * 57.29578;
            document.scene.pose.direction = {137.507764 * i - 180.0 * std::floor(137.507764 * i / 180.0), elevation,
                                             9.0 * i};
            for (const double angle : {-45.0, 0.0, 17.0, 45.0}) {
                document.scene.motionAngle = angle;
                EXPECT_EQ(leftIn(viewpointOf(document), geometry), first) << i << ' ' << angle;
                EXPECT_EQ(leftIn(otfViewpointOf(document, firstPane), geometry), first) << i << ' ' << angle;
            }
        }
    }
}

TEST(Scene, TheDepthOfAFrontIsCountedAlongItsOwnForward) {
    VolumeGeometry geometry;
    geometry.size = {40, 40, 40};
    EXPECT_EQ(depthOf(Front{}, geometry), 0.0);
    EXPECT_EQ(depthOf(frontAcross({30, 0, 0}, 7.5), geometry), 7.5);
    EXPECT_EQ(movedTo(frontAcross({30, 0, 0}, 7.5, FrontSource::found), 9, geometry), frontAcross({30, 0, 0}, 9));
    EXPECT_EQ(movedTo(frontAcross({30, 0, 0}, 7.5), 0, geometry), Front{});
    const Front bowed{.surface = bowedSurface(), .source = FrontSource::found};
    // The node over the centre, 19.5 mm from the origin, is the 21st; the box begins half a voxel before the origin.
    EXPECT_NEAR(depthOf(bowed, geometry), 21 / 3.0 + 0.5, 1e-5);
    const Front moved = movedTo(bowed, 12.5, geometry);
    EXPECT_NEAR(depthOf(moved, geometry), 12.5, 1e-5);
    EXPECT_EQ(moved.source, FrontSource::person);
    for (const int node : {0, 17, 41})
        EXPECT_NEAR(moved.surface->depthMm[static_cast<std::size_t>(node)] -
                        bowed.surface->depthMm[static_cast<std::size_t>(node)],
                    5.0, 1e-5);
}

TEST(Scene, AFrontFromHereKeepsItsDepthInTheMiddleOfThePicture) {
    VolumeGeometry geometry;
    geometry.size = {60, 60, 60};
    const Vec3 middle = geometry.centreMm();
    const Front front = frontAcross({}, 20);  // at z = 19.5
    for (const double azimuth : {0.0, 15.0, 40.0, 70.0}) {
        const Viewpoint view{.azimuthDegrees = azimuth};
        const Front tilted = acrossView(front, view, middle, geometry);
        EXPECT_EQ(tilted.direction, directionOf(view));
        const Vec3 forward = frameOf(view).forward;
        const double depth = geometry.depthsAlong(forward).nearest + tilted.depthMm;
        // The middle line passes through (29.5, y, 29.5), and met the front at z = 19.5.
        const double expected = forward.dot(middle) - 10.0 / std::cos(azimuth / 57.29577951);
        EXPECT_NEAR(depth, std::max(expected, geometry.depthsAlong(forward).nearest + 0.1), 0.05 + 1e-9) << azimuth;
    }
    // Seen from behind, the front lies where it lay: 20 mm from one side are 40 mm from the other.
    EXPECT_NEAR(acrossView(front, {.azimuthDegrees = 180}, middle, geometry).depthMm, 40.0, 0.05);
    // Something of the volume is left, however far the point lies.
    const Front far = acrossView(front, {.azimuthDegrees = 90}, {1e4, 0, 0}, geometry);
    EXPECT_LT(far.depthMm, 60.0);
}

CutSurface bowedSurface() {
    CutSurface surface{.frame = frameOf(Viewpoint{}), .columns = 42, .rows = 42};
    surface.firstRightMm = surface.firstDownMm = -1;
    for (int i = 0; i < 42 * 42; ++i) surface.depthMm.push_back(static_cast<float>(i % 42) / 3.0f);
    return surface;
}

TEST(Scene, OfAFrontThatIsBowedAndFlatBothCut) {
    VolumeGeometry geometry;
    geometry.size = {40, 40, 40};
    Scene scene;
    scene.front = {.depthMm = 12, .direction = ViewDirection{25, -15, 40}, .surface = bowedSurface()};
    EXPECT_EQ(problemOf(scene), "");
    const std::vector<bool> left = leftIn(behindFront(Viewpoint{}, scene.front), geometry);
    std::size_t at = 0;
    int ofPlane = 0, ofSurface = 0;
    for (int z = 0; z < 40; ++z)
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                const Vec3 place(x, y, z);
                EXPECT_EQ(left[at++], !cutsAway(scene, BeamAxis::plusZ, geometry, place));
                const bool bySurface = scene.front.surface->cutsAway(place);
                (bySurface ? ofSurface : ofPlane) += cutsAway(scene, BeamAxis::plusZ, geometry, place) ? 1 : 0;
            }
    EXPECT_GT(ofPlane, 1000);
    EXPECT_GT(ofSurface, 1000);
    const Front moved = movedTo(scene.front, depthOf(scene.front, geometry) + 3, geometry);
    EXPECT_NEAR(moved.depthMm, 15, 1e-5);
    EXPECT_NEAR(moved.surface->depthMm[100] - scene.front.surface->depthMm[100], 3, 1e-5);
}

TEST(Scene, AFrontBehindTheVolumeLeavesNothingAndStaysFinite) {
    VolumeGeometry geometry;
    geometry.size = {20, 20, 20};
    const Front flat = frontAcross({20, 0, 0}, 1e300);
    const std::vector<bool> left = leftIn(behindFront(Viewpoint{}, flat), geometry);
    EXPECT_EQ(std::ranges::count(left, true), 0);
}

TEST(Document, NamesOfChoicesGoBothWays) {
    for (const CurveKind kind : allCurveKinds) EXPECT_EQ(curveKindFromName(nameOf(kind)), kind);
    for (const MotionOtf otf : allMotionOtfs) EXPECT_EQ(motionOtfFromName(nameOf(otf)), otf);
    for (const InitialKind kind :
         {InitialKind::parabolic, InitialKind::quartic, InitialKind::linear, InitialKind::manual})
        EXPECT_EQ(initialKindFromName(nameOf(kind)), kind);
    for (const BeamSource source : {BeamSource::assumed, BeamSource::sectorShape, BeamSource::echo, BeamSource::person})
        EXPECT_EQ(beamSourceFromName(nameOf(source)), source);
    for (const MotionAxis axis : {MotionAxis::x, MotionAxis::y, MotionAxis::z, MotionAxis::screenVertical,
                                  MotionAxis::screenHorizontal, MotionAxis::picturePlane})
        EXPECT_EQ(motionAxisFromName(nameOf(axis)), axis);
    for (const MotionScenario scenario : {MotionScenario::probe, MotionScenario::object, MotionScenario::both})
        EXPECT_EQ(motionScenarioFromName(nameOf(scenario)), scenario);
    EXPECT_FALSE(curveKindFromName("sigmoid"));
    EXPECT_FALSE(motionOtfFromName(""));
}

}  // namespace
}  // namespace echolucent
