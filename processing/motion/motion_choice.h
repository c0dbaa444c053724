// What a person chooses of the motion mode and of the cine of a 4D study, and which frame follows which.
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

/// The choices of the motion mode.
struct MotionChoice {
    MotionAxis axis = MotionAxis::y;
    MotionScenario scenario = MotionScenario::probe;
    MotionOtf otf = MotionOtf::oneOtf;
    bool pingPong = true;         ///< whether the probe turns at its ends; else it starts from the first angle again
    bool phasesPingPong = false;  ///< the same of the phases
    std::optional<PhaseRange> phaseRange = {};  ///< the phases that play; all where there is no value
    int otfPhase = 0;    ///< the phase whose OTF every frame shows where the choice is MotionOtf::oneOtf, from 0
    double speed = 1.0;  ///< how many times as fast as scanned, or as motionDegreesPerSecond, frames follow each other
    friend bool operator==(const MotionChoice&, const MotionChoice&) = default;
};

inline constexpr double leastMotionSpeed = 1.0 / 16.0, largestMotionSpeed = 16.0;

/// A probe that moves turns by so many degrees in a second, at speed 1.
inline constexpr double motionDegreesPerSecond = 30.0;
/// At speed 1, so many phases are shown in a second where the time between phases is not known.
inline constexpr double assumedPhasesPerSecond = 20.0;

/// The phases that play of a study of `phases` phases (>= 1): a range that reaches beyond it ends with it.
[[nodiscard]] PhaseRange playedPhases(const MotionChoice& motion, int phases);

/// Seconds between frames that follow each other, above 0: where the object moves, phaseSeconds over the speed, or,
/// where the time between phases is not known, that of assumedPhasesPerSecond; else one degree of
/// motionDegreesPerSecond.
[[nodiscard]] double frameSeconds(const MotionChoice& motion, std::optional<double> phaseSeconds);

/// A frame of a motion that plays.
struct MotionPosition {
    int angle = 0;                              ///< whole degrees from the view in which the motion began
    int phase = 0;                              ///< counted from 0
    bool angleBack = false, phaseBack = false;  ///< whether it goes backwards; back and forth only
    friend bool operator==(const MotionPosition&, const MotionPosition&) = default;
};

/// The frame after another one in a study of `phases` phases (>= 1). Back and forth, the frames at the ends are shown
/// once each. A phase that lies outside the range goes on with the range's first one.
[[nodiscard]] MotionPosition nextFrame(const MotionPosition& position, const MotionChoice& motion, int phases);

/// The frames of one turn of a motion, from its first angle and its first phase on, each as often as it is shown until
/// the first of them comes again; a still probe stands at the angle of `at`, and a still object shows its phase. Where
/// probe and object move, a turn is one of the probe.
[[nodiscard]] std::vector<MotionPosition> framesOfTurn(const MotionChoice& motion, int phases,
                                                       const MotionPosition& at);

/// What is wrong with choices that were read from a file, lower case, no full stop; an empty text where nothing is.
[[nodiscard]] std::string problemOf(const MotionChoice& motion);

}  // namespace echolucent
