// What a person chooses for the motion mode and for the cine of a 4D study, and which frame follows which.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/motion/motion_mode.h"

namespace echolucent {

/// The phases that play, from the first to the last, counted from 0.
struct PhaseRange {
    int first = 0, last = 0;
    friend bool operator==(const PhaseRange&, const PhaseRange&) = default;
};

struct MotionChoice {
    MotionAxis axis = MotionAxis::y;
    MotionScenario scenario = MotionScenario::probe;
    MotionOtf otf = MotionOtf::oneOtf;
    bool pingPong = true;         ///< true: the probe turns back at its ends; false: it starts again at the first angle
    bool phasesPingPong = false;  ///< the same for the phases
    std::optional<PhaseRange> phaseRange = {};  ///< the phases that play; empty: all
    int otfPhase = 0;                           ///< the phase, from 0, whose OTF all frames show; for MotionOtf::oneOtf
    double speed = 1.0;                         ///< times the speed of the scan, or of motionDegreesPerSecond
    friend bool operator==(const MotionChoice&, const MotionChoice&) = default;
};

inline constexpr double leastMotionSpeed = 1.0 / 16.0, largestMotionSpeed = 16.0;

/// At speed 1 a moving probe turns by so many degrees in a second.
inline constexpr double motionDegreesPerSecond = 30.0;
/// At speed 1 so many phases are shown in a second if the study does not know the time between phases.
inline constexpr double assumedPhasesPerSecond = 20.0;

/// The phases that play in a study of `phases` phases (>= 1). A range that reaches beyond the study ends with it.
[[nodiscard]] PhaseRange playedPhases(const MotionChoice& motion, int phases);

/// Seconds from one frame to the next, above 0. If the object moves: phaseSeconds, or that of assumedPhasesPerSecond if
/// unknown. Otherwise the time of one degree at motionDegreesPerSecond. Both are divided by the speed.
[[nodiscard]] double frameSeconds(const MotionChoice& motion, std::optional<double> phaseSeconds);

struct MotionPosition {
    int angle = 0;                              ///< whole degrees from the view in which the motion began
    int phase = 0;                              ///< counted from 0
    bool angleBack = false, phaseBack = false;  ///< whether angle or phase goes backwards; only back and forth
    friend bool operator==(const MotionPosition&, const MotionPosition&) = default;
};

/// The next frame in a study of `phases` phases (>= 1). If a motion goes back and forth, its ends are not shown
/// twice in a row. After a phase outside the range comes the range's first one.
[[nodiscard]] MotionPosition nextFrame(const MotionPosition& position, const MotionChoice& motion, int phases);

/// The frames of one turn of a motion: from its first angle and phase until the first comes again. If probe and object
/// move, the probe's turn counts. A still probe stays at the angle of `at`, a still object at its phase.
[[nodiscard]] std::vector<MotionPosition> framesOfTurn(const MotionChoice& motion, int phases,
                                                       const MotionPosition& at);

/// What is wrong with choices from a file: lower case, no full stop; empty if nothing is.
[[nodiscard]] std::string problemOf(const MotionChoice& motion);

}  // namespace echolucent
