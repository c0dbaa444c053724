#include "processing/motion/motion_choice.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace echolucent {
namespace {

std::vector<int> phasesOf(const std::vector<MotionPosition>& frames) {
    std::vector<int> phases;
    for (const MotionPosition& frame : frames) phases.push_back(frame.phase);
    return phases;
}

TEST(MotionChoice, PhasesLoopOrGoBackAndForthAndShowTheirEndsOnce) {
    MotionChoice motion{.scenario = MotionScenario::object};
    EXPECT_EQ(phasesOf(framesOfTurn(motion, 4, {.phase = 2})), (std::vector{0, 1, 2, 3}));
    motion.phasesPingPong = true;
    EXPECT_EQ(phasesOf(framesOfTurn(motion, 4, {.phase = 2})), (std::vector{0, 1, 2, 3, 2, 1}));
    motion.phaseRange = PhaseRange{1, 3};
    EXPECT_EQ(phasesOf(framesOfTurn(motion, 4, {.phase = 2})), (std::vector{1, 2, 3, 2}));
    motion.phaseRange = PhaseRange{3, 9};  // as of another study
    EXPECT_EQ(phasesOf(framesOfTurn(motion, 4, {.phase = 2})), (std::vector{3}));
    motion.phaseRange.reset();
    EXPECT_EQ(phasesOf(framesOfTurn(motion, 1, {.phase = 0})), (std::vector{0}));
    EXPECT_EQ(phasesOf(framesOfTurn(motion, 2, {.phase = 0})), (std::vector{0, 1}));
}

TEST(MotionChoice, AProbeTurnsThroughAllAnglesAndAStillObjectStays) {
    MotionChoice motion{.scenario = MotionScenario::probe, .pingPong = false};
    const auto once = framesOfTurn(motion, 4, {.phase = 2});
    ASSERT_EQ(once.size(), 91u);
    EXPECT_EQ(once.front().angle, firstMotionAngle);
    EXPECT_EQ(once.back().angle, lastMotionAngle);
    for (const MotionPosition& frame : once) EXPECT_EQ(frame.phase, 2);
    motion.pingPong = true;
    EXPECT_EQ(framesOfTurn(motion, 4, {.phase = 2}).size(), 180u);
    motion.scenario = MotionScenario::both;
    const auto both = framesOfTurn(motion, 4, {.phase = 2});
    ASSERT_EQ(both.size(), 180u);
    for (std::size_t i = 0; i < both.size(); ++i) EXPECT_EQ(both[i].phase, static_cast<int>(i % 4));
}

TEST(MotionChoice, AStillProbeStaysWhereItStands) {
    const MotionChoice motion{.scenario = MotionScenario::object};
    const auto turn = framesOfTurn(motion, 3, {.angle = 30, .phase = 2});
    ASSERT_EQ(turn.size(), 3u);
    for (const MotionPosition& frame : turn) EXPECT_EQ(frame.angle, 30);
}

TEST(MotionChoice, APhaseOutsideTheRangeGoesOnWithItsFirst) {
    const MotionChoice motion{.scenario = MotionScenario::object, .phaseRange = PhaseRange{2, 3}};
    EXPECT_EQ(nextFrame({.phase = 0}, motion, 6).phase, 2);
    EXPECT_EQ(nextFrame({.phase = 5}, motion, 6).phase, 2);
    EXPECT_EQ(nextFrame({.phase = 3}, motion, 6).phase, 2);
}

TEST(MotionChoice, TimesBetweenFramesFollowTheScanAndTheSpeed) {
    MotionChoice motion{.scenario = MotionScenario::object, .speed = 0.5};
    EXPECT_DOUBLE_EQ(frameSeconds(motion, PhaseTimes::every(0.04)), 0.08);
    EXPECT_DOUBLE_EQ(frameSeconds(motion, {}), 2.0 / assumedPhasesPerSecond);
    motion.scenario = MotionScenario::probe;
    EXPECT_DOUBLE_EQ(frameSeconds(motion, PhaseTimes::every(0.04)), 2.0 / motionDegreesPerSecond);
}

TEST(MotionChoice, AMovieHoldsUnevenPhasesAsLongAsTheyLasted) {
    const PhaseTimes times = phaseTimesAt({0.0, 0.1, 0.35, 0.6, 0.7});  // gaps 1 : 2.5 : 2.5 : 1, then the mean, 1.75
    MotionChoice motion{.scenario = MotionScenario::object, .speed = 2.0};
    const std::vector<int> phases{0, 1, 2, 3, 4};
    const HeldFrames held = heldFrames(motion, times, phases, 0);
    EXPECT_NEAR(held.pictureSeconds, 0.05, 1e-12);
    // The frames end at 1, 3.5, 6, 7 and 8.75 pictures: what is rounded away is not lost.
    EXPECT_EQ(held.pictures, (std::vector<int>{1, 3, 2, 1, 2}));
    EXPECT_EQ(heldFrames(motion, PhaseTimes::every(0.1), phases, 0).pictures, std::vector<int>(5, 1));
    EXPECT_EQ(heldFrames(motion, PhaseTimes::every(0.1), phases, 0).pictureSeconds, 0.05);
    motion.scenario = MotionScenario::probe;
    EXPECT_EQ(heldFrames(motion, times, phases, 0).pictures, std::vector<int>(5, 1));
    EXPECT_TRUE(heldFrames(motion, times, {}, 0).pictures.empty());
}

TEST(MotionChoice, AMovieKeepsItsLengthIfPhasesAreTooShortForAPicture) {
    const MotionChoice motion{.scenario = MotionScenario::object};
    const PhaseTimes times = phaseTimesAt({0.0, 0.001, 0.041, 0.081, 0.121});  // then the mean, 30.25 ms
    const HeldFrames held = heldFrames(motion, times, std::vector<int>{0, 1, 2, 3, 4}, 0.01);
    EXPECT_EQ(held.pictureSeconds, 0.01);
    // The frames end at 0.1, 4.1, 8.1, 12.1 and 15.1 pictures; the first has one all the same.
    EXPECT_EQ(held.pictures, (std::vector<int>{1, 3, 4, 4, 3}));
    // Nor does any phase last longer than a hundred pictures.
    const HeldFrames far = heldFrames(motion, phaseTimesAt({0.0, 1e-9, 1e9}), std::vector<int>{0, 1, 2}, 0);
    EXPECT_EQ(far.pictures, (std::vector<int>{1, 99, 50}));
}

TEST(MotionChoice, WhatMakesNoSenseIsNamed) {
    EXPECT_EQ(problemOf(MotionChoice{}), "");
    EXPECT_EQ(problemOf(MotionChoice{.speed = 0}), "speed must be 1/16 to 16");
    EXPECT_EQ(problemOf(MotionChoice{.otfPhase = -1}), "otf_phase must not be negative");
    EXPECT_NE(problemOf(MotionChoice{.phaseRange = PhaseRange{3, 2}}), "");
}

}  // namespace
}  // namespace echolucent
