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
    EXPECT_DOUBLE_EQ(frameSeconds(motion, 0.04), 0.08);
    EXPECT_DOUBLE_EQ(frameSeconds(motion, std::nullopt), 2.0 / assumedPhasesPerSecond);
    motion.scenario = MotionScenario::probe;
    EXPECT_DOUBLE_EQ(frameSeconds(motion, 0.04), 2.0 / motionDegreesPerSecond);
}

TEST(MotionChoice, WhatMakesNoSenseIsNamed) {
    EXPECT_EQ(problemOf(MotionChoice{}), "");
    EXPECT_EQ(problemOf(MotionChoice{.speed = 0}), "speed must be 1/16 to 16");
    EXPECT_EQ(problemOf(MotionChoice{.otfPhase = -1}), "otf_phase must not be negative");
    EXPECT_NE(problemOf(MotionChoice{.phaseRange = PhaseRange{3, 2}}), "");
}

}  // namespace
}  // namespace echolucent
