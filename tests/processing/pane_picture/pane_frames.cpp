// The frames of a motion: each is the picture of the document that shows it, to the bit.
#include "processing/pane_picture/pane_frames.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "processing/motion/otf_sweep.h"
#include "processing/pane_picture/pane_picture.h"
#include "processing/phantom/phantom.h"
#include "processing/scalpel/scalpel_stroke.h"

namespace echolucent {
namespace {

constexpr int pictureWidth = 40, pictureHeight = 36;

StudyPhases phasesOf(int count) {
    StudyPhases phases;
    for (int i = 0; i < count; ++i) {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {40, 38, 36};
        config.spacing = Vec3(2, 2, 2);
        config.seed = static_cast<std::uint64_t>(3 + i);
        config.phase = 0.25 * i;
        phases.scans.push_back(std::make_shared<const Volume>(*makePhantom(config)));
    }
    return phases;
}

/// A view with a cut, a stroke and light that is seen from aside.
Document documentOf(MotionScenario scenario, MotionOtf otf) {
    Document document;
    document.scene.pose.direction = {.azimuth = 12, .elevation = -7};
    document.scene.front.depthMm = 5;
    document.scene.look.reduction = SpeckleReduction::light;
    document.scene.look.step = 4;
    ScalpelStroke stroke{.tool = ScalpelTool::eraser, .places = {{-0.2, 0.1}, {0.2, -0.1}}, .radius = 0.06};
    stroke.camera = {{40, 38, 36}, frameOf(Viewpoint{.azimuthDegrees = 10}), Projection::parallel, 60, 30, 100};
    document.scene.strokes.push_back(stroke);
    document.motion.scenario = scenario;
    document.motion.otf = otf;
    return document;
}

std::vector<float> pixels(const std::optional<PanePicture>& picture) {
    return picture ? picture->picture.rgba : std::vector<float>{};
}

TEST(PaneFrames, AFrameIsThePictureOfItsDocument) {
    const StudyPhases phases = phasesOf(4);
    for (const MotionScenario scenario : {MotionScenario::probe, MotionScenario::object, MotionScenario::both})
        for (const MotionOtf otf : {MotionOtf::eachView, MotionOtf::oneOtf}) {
            Document document = documentOf(scenario, otf);
            document.motion.phasesPingPong = true;
            document.motion.otfPhase = 2;
            PaneFrames frames(document, firstPane, phases);
            ASSERT_EQ(frames.count(), scenario == MotionScenario::object ? 6 : 180);
            for (const int frame : {0, 1, 5}) {
                Document alone = document;
                alone.scene.motionAngle = frames.position(frame).angle;
                alone.scene.phase = frames.position(frame).phase;
                if (otf == MotionOtf::eachView) alone.scene.side = shownPose(alone).direction;
                EXPECT_EQ(frames.documentOf(frame), alone);
                const auto expected = panePicture(alone, firstPane, phases.scans, pictureWidth, pictureHeight);
                const auto made = frames.picture(frame, pictureWidth, pictureHeight);
                EXPECT_TRUE(pixels(made) == pixels(expected)) << nameOf(scenario) << ' ' << nameOf(otf) << ' ' << frame;
                EXPECT_TRUE(made->cast == expected->cast && made->classification == expected->classification);
            }
            EXPECT_THROW((void)frames.position(frames.count()), std::out_of_range);
        }
}

TEST(PaneFrames, AStillProbeStaysAsTheHandTurnedIt) {
    const StudyPhases phases = phasesOf(2);
    Document document = documentOf(MotionScenario::object, MotionOtf::oneOtf);
    document.scene.motionAngle = 30;
    PaneFrames frames(document, firstPane, phases);
    Document alone = document;
    alone.scene.phase = 1;
    EXPECT_EQ(frames.documentOf(1), alone);
    EXPECT_TRUE(pixels(frames.picture(1, pictureWidth, pictureHeight)) ==
                pixels(panePicture(alone, firstPane, phases.scans, pictureWidth, pictureHeight)));
}

TEST(PaneFrames, PhasesComeBackWithTheSameBits) {
    const StudyPhases phases = phasesOf(3);
    Document document = documentOf(MotionScenario::object, MotionOtf::eachView);
    document.motion.phasesPingPong = true;
    PaneFrames frames(document, firstPane, phases);
    ASSERT_EQ(frames.count(), 4);
    const auto second = pixels(frames.picture(1, pictureWidth, pictureHeight));
    EXPECT_TRUE(pixels(frames.picture(1, pictureWidth, pictureHeight)) == second) << "asked for twice";
    EXPECT_TRUE(pixels(frames.picture(2, pictureWidth, pictureHeight)) != second);
    EXPECT_TRUE(pixels(frames.picture(3, pictureWidth, pictureHeight)) == second) << "the way back";
    for (const auto& [frame, first] : {std::pair(0, 0), {1, 1}, {2, 2}, {3, 1}})
        EXPECT_EQ(frames.firstLike(frame), first) << frame;
    document.motion.otf = MotionOtf::mean;
    const PaneFrames smoothed(document, firstPane, phases);
    EXPECT_EQ(smoothed.firstLike(3), 3) << "its OTF is smoothed over other frames";
}

TEST(PaneFrames, OneOtfIsThatOfItsPhase) {
    const StudyPhases phases = phasesOf(3);
    Document document = documentOf(MotionScenario::object, MotionOtf::oneOtf);
    const auto curveOfPhase = [&](int phase) {
        document.motion.otfPhase = phase;
        PaneFrames frames(document, firstPane, phases);
        return frames.picture(1, pictureWidth, pictureHeight)->classification;
    };
    Document each = document;
    each.motion.otf = MotionOtf::eachView;
    each.scene.side = each.scene.pose.direction;
    each.scene.phase = 2;
    document.scene.side = each.scene.side;
    const Classification last = panePicture(each, firstPane, phases.scans, pictureWidth, pictureHeight)->classification;
    EXPECT_TRUE(curveOfPhase(2) == last);
    EXPECT_TRUE(curveOfPhase(9) == last) << "a phase beyond the last one is the last one";
    EXPECT_FALSE(curveOfPhase(0) == last);
    // A study of one phase has one OTF, whatever phase is chosen.
    EXPECT_EQ(otfPhaseOf(document, firstPane, 1), 0);
}

TEST(PaneFrames, SmoothedOtfsFollowTheTurnRoundAndRound) {
    const StudyPhases phases = phasesOf(3);
    Document document = documentOf(MotionScenario::object, MotionOtf::mean);
    PaneFrames frames(document, firstPane, phases);
    // Three turns one after the other: the last is what is shown, whose history is full.
    OtfHistory history(OtfSmoothing::mean);
    std::vector<SampledCurve> shown;
    for (int frame = 0; frame < 3 * frames.count(); ++frame) {
        Document alone = frames.documentOf(frame % frames.count());
        alone.motion.otf = MotionOtf::eachView;
        const OpacityCurve own = panePicture(alone, firstPane, phases.scans, 2, 2)->classification.curve();
        shown.push_back(history.add(frame, std::get<SampledCurve>(own)));
    }
    for (int frame = 0; frame < frames.count(); ++frame) {
        const auto made = frames.picture(frame, pictureWidth, pictureHeight);
        const auto& curve = std::get<SampledCurve>(made->classification.curve());
        const auto& expected = shown[static_cast<std::size_t>(2 * frames.count() + frame)];
        for (std::size_t i = 0; i < curve.opacities.size(); ++i)
            EXPECT_NEAR(curve.opacities[i], expected.opacities[i], 1e-14);
        EXPECT_FALSE(made->classification == frames.picture((frame + 1) % 3, 2, 2)->classification);
    }
}

TEST(PaneFrames, QuietVoxelsAtHandChangeNoBit) {
    StudyPhases phases = phasesOf(2);
    const Document document = documentOf(MotionScenario::object, MotionOtf::eachView);
    PaneFrames plain(document, firstPane, phases);
    for (const auto& scan : phases.scans)
        phases.quiet.push_back(
            std::make_shared<const Volume>(quietVolume(*scan, SpeckleReduction::light)->withDataBox(scan->dataBox())));
    phases.reduction = SpeckleReduction::light;
    PaneFrames withQuiet(document, firstPane, phases);
    EXPECT_TRUE(pixels(plain.picture(1, pictureWidth, pictureHeight)) ==
                pixels(withQuiet.picture(1, pictureWidth, pictureHeight)));
    EXPECT_TRUE(withQuiet.picture(1, pictureWidth, pictureHeight)->voxels->isSameScanAs(*phases.quiet[1]));
    // Those of another reduction are not taken.
    phases.reduction = SpeckleReduction::strong;
    PaneFrames ofAnother(document, firstPane, phases);
    EXPECT_TRUE(pixels(plain.picture(0, pictureWidth, pictureHeight)) ==
                pixels(ofAnother.picture(0, pictureWidth, pictureHeight)));
}

TEST(PaneFrames, IsCancelled) {
    PaneFrames frames(documentOf(MotionScenario::object, MotionOtf::eachView), firstPane, phasesOf(2));
    std::atomic<bool> cancel = true;
    EXPECT_FALSE(frames.picture(0, pictureWidth, pictureHeight, {{}, &cancel}));
    cancel = false;
    EXPECT_TRUE(frames.picture(0, pictureWidth, pictureHeight, {{}, &cancel}));
}

TEST(PaneFrames, AStudyWithoutPhasesIsABrokenContract) {
    EXPECT_THROW(PaneFrames(Document{}, firstPane, StudyPhases{}), std::invalid_argument);
}

TEST(PaneFrames, ADesignIsThatOfTheOnePhaseOrOfEach) {
    const StudyPhases phases = phasesOf(3);
    for (const MotionOtf otf : {MotionOtf::oneOtf, MotionOtf::eachView, MotionOtf::mean}) {
        Document document = withDesigner(documentOf(MotionScenario::object, otf), firstPane, OtsuConfig{});
        document.motion.otfPhase = 1;
        PaneFrames frames(document, firstPane, phases);
        for (const int frame : {0, 2}) {
            Document alone = frames.documentOf(frame);
            const int phase = otf == MotionOtf::oneOtf ? 1 : frames.position(frame).phase;
            alone.scene.phase = phase;
            alone.motion.otf = MotionOtf::eachView;
            const auto expected = panePicture(alone, firstPane, phases.scans, 2, 2);
            EXPECT_EQ(frames.picture(frame, 2, 2)->classification, expected->classification) << nameOf(otf);
        }
    }
}

}  // namespace
}  // namespace echolucent
