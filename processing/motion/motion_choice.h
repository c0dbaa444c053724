// What a person chooses for the motion mode and for the cine of a 4D study, and which frame follows which.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "processing/motion/motion_mode.h"
#include "processing/motion/phase_times.h"

namespace echolucent {

/// The phases that play, from `first` to `last`, both included, counted from 0.
struct PhaseRange {
    int first = 0, last = 0;
    friend bool operator==(const PhaseRange&, const PhaseRange&) = default;
};

struct MotionChoice {
    MotionAxis axis = MotionAxis::screenVertical;
    MotionScenario scenario = MotionScenario::probe;
    MotionOtf otf = MotionOtf::oneOtf;
    bool pingPong = true;         ///< true: the probe turns back at its ends; false: it starts again at the first angle
    bool phasesPingPong = false;  ///< as pingPong, for the phases
    std::optional<PhaseRange> phaseRange = {};  ///< the phases that play; empty: all
    int otfPhase = 0;                           ///< for MotionOtf::oneOtf: the phase, from 0, whose OTF all frames show
    double speed = 1.0;                         ///< a factor on the rate of frames, see frameSeconds()
    friend bool operator==(const MotionChoice&, const MotionChoice&) = default;
};

inline constexpr double leastMotionSpeed = 1.0 / 16.0, largestMotionSpeed = 16.0;

/// Degrees by which a moving probe turns in a second at speed 1 if the object stays. If the object moves too, the probe
/// turns by one degree a phase.
inline constexpr double motionDegreesPerSecond = 30.0;
/// Phases that are shown in a second at speed 1 if the study does not know the time between phases.
inline constexpr double assumedPhasesPerSecond = 20.0;

/// The phases that play in a study of `phases` phases (>= 1). An end of the range that lies beyond the study becomes
/// the study's last phase.
[[nodiscard]] PhaseRange playedPhases(const MotionChoice& motion, int phases);

/// Mean seconds from one frame to the next. If the object moves: from phase to phase, or 1 / assumedPhasesPerSecond if
/// that is unknown. Otherwise 1 / motionDegreesPerSecond. Either is divided by MotionChoice::speed (> 0).
[[nodiscard]] double frameSeconds(const MotionChoice& motion, const PhaseTimes& times);
/// The same from a frame that shows phase `from` to one that shows phase `to`: uneven phases are played as they are.
[[nodiscard]] double frameSeconds(const MotionChoice& motion, const PhaseTimes& times, int from, int to);
/// How many pictures of a movie show each of its frames, and how long each picture lasts. `phases` are the phases of
/// the frames in order; the movie begins again after its last. If all frames last equally long, each has one picture.
/// Otherwise a picture lasts as long as the shortest frame, but no less than `leastPictureSeconds` (>= 0) and than a
/// hundredth of the longest frame. Each frame has as many pictures as it lasts, at least one, rounded so that errors do
/// not add up.
struct HeldFrames {
    std::vector<int> pictures;
    double pictureSeconds = 0;
};
[[nodiscard]] HeldFrames heldFrames(const MotionChoice& motion, const PhaseTimes& times, std::span<const int> phases,
                                    double leastPictureSeconds);

struct MotionPosition {
    int angle = 0;  ///< whole degrees from the view in which the motion began
    int phase = 0;  ///< counted from 0
    /// Whether angle or phase goes backwards. True only in a motion that goes back and forth.
    bool angleBack = false, phaseBack = false;
    friend bool operator==(const MotionPosition&, const MotionPosition&) = default;
};

/// The next frame in a study of `phases` phases (>= 1). If a motion goes back and forth, its ends are not shown twice
/// in a row. After an angle or a phase outside its range comes the first one of the range. What does not move stays.
[[nodiscard]] MotionPosition nextFrame(const MotionPosition& position, const MotionChoice& motion, int phases);

/// The frames of one turn of a motion. A turn begins at the first angle and the first phase. If the probe moves, it
/// ends before the first angle comes again, else before the first phase does. A still probe stays at the angle of `at`,
/// a still object at the phase of `at`.
[[nodiscard]] std::vector<MotionPosition> framesOfTurn(const MotionChoice& motion, int phases,
                                                       const MotionPosition& at);

/// What is wrong with choices from a file: lower case, no full stop; empty if nothing is.
[[nodiscard]] std::string problemOf(const MotionChoice& motion);

}  // namespace echolucent
