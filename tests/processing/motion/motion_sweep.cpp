#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "app/measuring/measures/picture_difference.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/motion/flicker.h"
#include "processing/motion/otf_sweep.h"
#include "processing/phantom/phantom.h"

namespace echolucent {
namespace {

using Phases = std::vector<std::shared_ptr<const Volume>>;

Phases phantomPhases(int count) {
    Phases phases;
    for (int i = 0; i < count; ++i) {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {72, 68, 76};
        config.seed = static_cast<std::uint64_t>(i + 1);  // so that every phase has an OTF of its own
        phases.push_back(std::make_shared<const Volume>(*makePhantom(config)));
    }
    return phases;
}

AdaptiveOtfConfig fewTubes() {
    AdaptiveOtfConfig config;
    config.grid.columns = config.grid.rows = 7;
    return config;
}

TEST(Sweep, TurnsAboutTheViewsAxesLikeTheWindow) {
    const Viewpoint start = withFrontAcross(
        {.beamAxis = BeamAxis::plusY, .azimuthDegrees = 5, .elevationDegrees = -3, .rollDegrees = 2}, 7);
    Viewpoint expected = start;
    expected.elevationDegrees = 7;
    EXPECT_EQ(turned(start, MotionAxis::x, 10), expected);
    expected = start;
    expected.azimuthDegrees = 15;
    EXPECT_EQ(turned(start, MotionAxis::y, 10), expected);
    expected = start;
    expected.rollDegrees = -8;
    EXPECT_EQ(turned(start, MotionAxis::z, -10), expected);
}

TEST(Sweep, TurnsAboutTheScreensAxesOfTheViewInWhichItBegan) {
    for (const double elevation : {0.0, -35.0, 90.0, -90.0})
        for (const double roll : {0.0, 25.0, 180.0}) {
            const Viewpoint start = withFrontAcross({BeamAxis::plusX, 50, elevation, roll}, 2);
            const ViewFrame from = frameOf(start);
            for (const double degrees : {-45.0, -1.0, 30.0, 45.0}) {
                const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
                const ViewFrame upright = frameOf(turned(start, MotionAxis::screenVertical, degrees));
                EXPECT_LT(length(upright.down - from.down), 1e-12);
                EXPECT_LT(length(upright.forward - (from.forward * c + from.right * s)), 1e-12);
                const ViewFrame across = frameOf(turned(start, MotionAxis::screenHorizontal, degrees));
                EXPECT_LT(length(across.right - from.right), 1e-12);
                EXPECT_LT(length(across.forward - (from.forward * c - from.down * s)), 1e-12);
                const ViewFrame wheel = frameOf(turned(start, MotionAxis::picturePlane, degrees));
                EXPECT_LT(length(wheel.forward - from.forward), 1e-12);
                EXPECT_LT(length(wheel.right - (from.right * c + from.down * s)), 1e-12);
            }
        }
}

TEST(Sweep, TheScreensAxesHaveTheBitsOfTheViewsWhereTheyAreTheSame) {
    for (double degrees = -45; degrees <= 45; degrees += 0.7) {
        Viewpoint start = withFrontAcross({.beamAxis = BeamAxis::minusY, .azimuthDegrees = 12.3}, 4);
        EXPECT_EQ(turned(start, MotionAxis::screenVertical, degrees), turned(start, MotionAxis::y, degrees));
        start.elevationDegrees = -71.7;
        EXPECT_EQ(turned(start, MotionAxis::screenHorizontal, degrees), turned(start, MotionAxis::x, degrees));
        start.rollDegrees = 33.3;
        EXPECT_EQ(turned(start, MotionAxis::picturePlane, degrees), turned(start, MotionAxis::z, degrees));
    }
    EXPECT_EQ(screenAxisOf(MotionAxis::x), MotionAxis::screenHorizontal);
    EXPECT_EQ(screenAxisOf(MotionAxis::y), MotionAxis::screenVertical);
    EXPECT_EQ(screenAxisOf(MotionAxis::z), MotionAxis::picturePlane);
    for (const MotionAxis axis : screenAxes) EXPECT_EQ(screenAxisOf(axis), axis);
}

TEST(Sweep, FramesAreThePapersNinetyOne) {
    const auto frames = sweepFrames({}, MotionAxis::y, -45, 45, 1, 1);
    ASSERT_EQ(frames.size(), 91u);
    for (std::size_t i = 0; i < 91; ++i) {
        EXPECT_EQ(frames[i].time, static_cast<double>(i));
        EXPECT_EQ(frames[i].degrees, static_cast<double>(i) - 45);
        EXPECT_EQ(frames[i].view.azimuthDegrees, frames[i].degrees);
        EXPECT_EQ(frames[i].phase, 0);
    }
}

TEST(Sweep, FramesEndWhereTheRangeDoes) {
    const auto fine = sweepFrames({}, MotionAxis::x, 0, 1, 0.1, 1);
    ASSERT_EQ(fine.size(), 11u);
    EXPECT_DOUBLE_EQ(fine.back().degrees, 1.0);
    EXPECT_EQ(sweepFrames({}, MotionAxis::x, 0, 10, 4, 1).back().degrees, 8);
    const auto backwards = sweepFrames({}, MotionAxis::x, 3, -3, 2, 3);
    ASSERT_EQ(backwards.size(), 4u);
    EXPECT_EQ(backwards.back().degrees, -3);
    EXPECT_EQ(backwards[2].phase, 2);
    EXPECT_EQ(backwards[3].phase, 0) << "over and over";
    EXPECT_EQ(sweepFrames({}, MotionAxis::x, 4, 4, 1, 1).size(), 1u);
    EXPECT_THROW((void)sweepFrames({}, MotionAxis::x, 0, 1, 0, 1), std::invalid_argument);
    EXPECT_THROW((void)sweepFrames({}, MotionAxis::x, 0, 1, 1, 0), std::invalid_argument);
    EXPECT_THROW((void)sweepFrames({}, MotionAxis::x, 0, INFINITY, 1, 1), std::invalid_argument);
    EXPECT_THROW((void)sweepFrames({}, MotionAxis::x, 0, 1e9, 1, 1), std::invalid_argument);
}

TEST(Sweep, ThePapersThreeScenarios) {
    Motion motion{.axis = MotionAxis::x, .from = -2, .to = 2, .step = 1, .firstPhase = 2};
    const Viewpoint start{.elevationDegrees = 10};
    const auto probe = motionFrames(start, motion, 3);
    motion.objectMoves = true;
    const auto both = motionFrames(start, motion, 3);
    motion.probeMoves = false;
    const auto object = motionFrames(start, motion, 3);
    for (std::size_t i = 0; i < 5; ++i) {
        const double degrees = static_cast<double>(i) - 2;
        EXPECT_EQ(probe[i].view.elevationDegrees, 10 + degrees);
        EXPECT_EQ(probe[i].phase, 2);
        EXPECT_EQ(both[i].view, probe[i].view);
        EXPECT_EQ(both[i].phase, static_cast<int>(2 + i) % 3);
        EXPECT_EQ(object[i].view, start);
        EXPECT_EQ(object[i].degrees, 0.0);
        EXPECT_EQ(object[i].phase, both[i].phase);
    }
    EXPECT_THROW((void)motionFrames(start, motion, 2), std::invalid_argument);
}

TEST(Sweep, EveryFrameHasTheOtfOfItsViewAndPhase) {
    const Phases phases = phantomPhases(2);
    const auto frames = sweepFrames({}, MotionAxis::y, -20, 20, 5, 2);
    const auto swept = sweepOtfs(phases, frames, fewTubes(), OtfSmoothing::mean);
    ASSERT_TRUE(swept);
    ASSERT_EQ(swept->size(), frames.size());
    OtfHistory history(OtfSmoothing::mean);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const SweptOtf& got = (*swept)[i];
        const auto alone = adaptOpacity(*phases[i % 2], frames[i].view, fewTubes());
        double sumOfD = 0;
        for (const TubeCore& tube : alone->tubes) sumOfD += tube.d;
        EXPECT_EQ(got.unsmoothed, alone->curve);
        EXPECT_EQ(got.sumOfD, sumOfD);
        EXPECT_EQ(got.tubesWithWeight, alone->tubesWithWeight);
        EXPECT_EQ(got.frame.degrees, frames[i].degrees);
        EXPECT_EQ(got.shown, history.add(static_cast<double>(i), alone->curve));
    }
}

TEST(Sweep, IsTheSameOnAnyNumberOfThreads) {
    const Phases phases = phantomPhases(3);
    const auto frames = sweepFrames({}, MotionAxis::x, -45, 45, 3, 3);
    std::vector<SweptOtf> expected;
    for (const std::size_t threads : {1, 2, 7}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const auto swept = sweepOtfs(phases, frames, fewTubes(), OtfSmoothing::leastFlicker);
        ASSERT_TRUE(swept);
        if (expected.empty()) expected = *swept;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            EXPECT_EQ((*swept)[i].shown, expected[i].shown);
            EXPECT_EQ((*swept)[i].sumOfD, expected[i].sumOfD);
        }
    }
}

TEST(Sweep, AStillProbeComputesEachPhaseOnce) {
    const Phases phases = phantomPhases(2);
    std::vector<SweepFrame> frames = sweepFrames({}, MotionAxis::y, 0, 99, 1, 2);
    for (SweepFrame& frame : frames) frame.view = Viewpoint{};
    // Reports come from the calling thread, one a computed frame at most.
    int reports = 0;
    const auto swept = sweepOtfs(phases, frames, fewTubes(), OtfSmoothing::none, {[&](double) { ++reports; }, nullptr});
    ASSERT_TRUE(swept);
    EXPECT_LE(reports, 2);
    for (std::size_t i = 2; i < frames.size(); ++i) EXPECT_EQ((*swept)[i].unsmoothed, (*swept)[i % 2].unsmoothed);
    EXPECT_NE((*swept)[0].unsmoothed, (*swept)[1].unsmoothed);
}

TEST(Sweep, EndsWhereItIsCancelled) {
    const Phases phases = phantomPhases(1);
    std::atomic<bool> cancel = false;
    const auto frames = sweepFrames({}, MotionAxis::y, -45, 45, 1, 1);
    const Progress afterSome{[&](double share) { cancel = share > 0; }, &cancel};
    EXPECT_FALSE(sweepOtfs(phases, frames, fewTubes(), OtfSmoothing::none, afterSome));
    EXPECT_FALSE(sweepOtfs(phases, frames, fewTubes(), OtfSmoothing::none, {{}, &cancel}));
}

TEST(Sweep, RefusesWhatMakesNoSense) {
    const Phases phases = phantomPhases(1);
    const auto frames = sweepFrames({}, MotionAxis::y, 0, 3, 1, 2);
    EXPECT_THROW((void)sweepOtfs(phases, frames, fewTubes(), OtfSmoothing::none), std::invalid_argument);
    AdaptiveOtfConfig wrong = fewTubes();
    wrong.cells.size = 0;
    EXPECT_THROW((void)sweepOtfs(phases, std::span(frames).first(1), wrong, OtfSmoothing::none), std::invalid_argument);
    EXPECT_TRUE(sweepOtfs(phases, {}, fewTubes(), OtfSmoothing::none)->empty());
}

SampledCurve flat(double opacity) { return SampledCurve{std::vector<double>(256, opacity)}; }

TEST(Flicker, OfOtfsIsTheSecondDifference) {
    // A steady change counts for nothing, an alternation counts four times its amplitude.
    EXPECT_NEAR(otfFlicker(std::vector{flat(0.1), flat(0.2), flat(0.3), flat(0.4)}), 0.0, 1e-15);
    EXPECT_NEAR(otfFlicker(std::vector{flat(0.5), flat(0.6), flat(0.5), flat(0.6)}), 0.2, 1e-14);
    EXPECT_EQ(otfFlicker(std::vector{flat(0.5), flat(0.6)}), 0.0);
    SampledCurve half = flat(0.5);
    for (std::size_t i = 0; i < 64; ++i) half.opacities[i] = 0.6;
    EXPECT_NEAR(otfFlicker(std::vector{flat(0.5), half, flat(0.5)}), 0.2 * std::sqrt(64.0 / 256), 1e-14);
    EXPECT_THROW((void)otfFlicker(std::vector{flat(0.5), flat(0.5), SampledCurve{{0.0, 0.0}}}), std::invalid_argument);
}

TEST(Flicker, OfPicturesLeavesTheRotationsOwnChangeOut) {
    const Phases phases = phantomPhases(1);
    const auto frames = sweepFrames({}, MotionAxis::y, 0, 40, 10, 1);
    RayCastSettings settings;
    settings.width = settings.height = 24;
    const FrameRenderer render = frameRenderer(phases, frames, settings);
    const auto ofSame = pictureFlicker(frames, std::vector(5, flat(0.3)), render);
    ASSERT_TRUE(ofSame);
    EXPECT_EQ(ofSame->change, 0.0);
    EXPECT_EQ(ofSame->flicker, 0.0);
    EXPECT_GT(differenceOf(*render(frames[0], flat(0.3)), *render(frames[1], flat(0.3))).rms, 1e-3);
    EXPECT_THROW((void)pictureFlicker(frames, std::vector(4, flat(0.3)), render), std::invalid_argument);
}

TEST(Flicker, EveryFrameIsRenderedAtOneScale) {
    // A rod along the axis of rotation looks the same from all sides: so it does in the pictures, at one scale.
    VolumeGeometry geometry{.size = {40, 40, 24}};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 0);
    for (std::int64_t y = 0; y < 40; ++y)
        for (std::int64_t z = 10; z < 14; ++z)
            for (std::int64_t x = 18; x < 22; ++x) voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] = 255;
    const Phases phases{std::make_shared<const Volume>(geometry, voxels)};
    RayCastSettings settings;
    settings.width = settings.height = 120;
    const auto frames = sweepFrames({}, MotionAxis::y, 0, 90, 90, 1);
    const FrameRenderer render = frameRenderer(phases, frames, settings);
    const auto lit = [&](const SweepFrame& frame) {
        const Picture picture = *render(frame, SampledCurve{{0.0, 0.0, 1.0, 1.0}});
        int pixels = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) pixels += picture.rgba[i] > 0.5f ? 1 : 0;
        return pixels;
    };
    EXPECT_GT(lit(frames[0]), 100);
    EXPECT_EQ(lit(frames[0]), lit(frames[1]));
}

TEST(Flicker, OfPicturesComparesEachViewWithTheOtfBefore) {
    // A renderer whose pixels are the first opacity times a factor of the view: everything is known.
    const FrameRenderer render = [](const SweepFrame& frame, const SampledCurve& otf) -> std::optional<Picture> {
        const auto level = static_cast<float>(otf.opacities[0] * (1 + frame.degrees));
        return Picture{1, 1, {level, level, level, 1.0f}};
    };
    const auto frames = sweepFrames({}, MotionAxis::y, 0, 3, 1, 1);
    const auto flicker = pictureFlicker(frames, std::vector{flat(0.1), flat(0.2), flat(0.2), flat(0.1)}, render);
    ASSERT_TRUE(flicker);
    // 2 x 0.1, 3 x 0, 4 x -0.1; then 3 x -0.1, 4 x -0.1.
    EXPECT_NEAR(flicker->change, std::sqrt((0.04 + 0 + 0.16) / 3), 1e-7);
    EXPECT_NEAR(flicker->flicker, std::sqrt((0.09 + 0.16) / 2), 1e-7);
}

TEST(Flicker, DifferenceOfPicturesLeavesAlphaOut) {
    const Picture left{1, 1, {0.5f, 0.5f, 0.5f, 1.0f}}, right{1, 1, {0.5f, 0.25f, 0.5f, 0.0f}};
    EXPECT_NEAR(differenceOf(left, right).rms, 0.25 / std::sqrt(3.0), 1e-12);
    EXPECT_EQ(differenceOf(left, right).largest, 0.25);
    EXPECT_THROW((void)differenceOf(left, Picture{2, 1, std::vector<float>(8)}), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
