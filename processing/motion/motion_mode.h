// What moves in the motion mode, and which OTF its frames show.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "processing/motion/otf_smoothing.h"

namespace echolucent {

/// The axis of the view's frame about which the view turns: x changes the elevation, y the azimuth, z the roll.
enum class MotionAxis { x, y, z };

/// The range of the motion, in whole degrees from the view in which it began.
inline constexpr int firstMotionAngle = -45;
inline constexpr int lastMotionAngle = 45;

/// What moves from frame to frame (Petersch 2005, section 5).
enum class MotionScenario {
    probe,   ///< the view turns, the volume stays
    object,  ///< the view stays, the phases of a 4D study follow each other
    both,
};
[[nodiscard]] constexpr bool movesProbe(MotionScenario scenario) { return scenario != MotionScenario::object; }
[[nodiscard]] constexpr bool movesObject(MotionScenario scenario) { return scenario != MotionScenario::probe; }

/// Which OTF the frames of a motion show.
enum class MotionOtf {
    oneOtf,              ///< one for every frame, of the phase MotionChoice::otfPhase
    eachView,            ///< computed anew for each frame, not smoothed
    mean,                ///< computed for each frame and smoothed over time by OtfSmoothing::mean
    movingLeastSquares,  ///< computed for each frame and smoothed by OtfSmoothing::movingLeastSquares
    leastFlicker,        ///< computed for each frame and smoothed by OtfSmoothing::leastFlicker
};
inline constexpr std::array allMotionOtfs{MotionOtf::oneOtf, MotionOtf::eachView, MotionOtf::mean,
                                          MotionOtf::movingLeastSquares, MotionOtf::leastFlicker};

/// How the OTFs of a motion are smoothed; empty for oneOtf.
[[nodiscard]] std::optional<OtfSmoothing> smoothingOf(MotionOtf otf);

/// "x", "y", "z".
[[nodiscard]] std::string_view nameOf(MotionAxis axis);
[[nodiscard]] std::optional<MotionAxis> motionAxisFromName(std::string_view name);
/// "probe", "object", "both".
[[nodiscard]] std::string_view nameOf(MotionScenario scenario);
[[nodiscard]] std::optional<MotionScenario> motionScenarioFromName(std::string_view name);
/// "one_otf", "each_view", "mean", "moving_least_squares", "least_flicker".
[[nodiscard]] std::string_view nameOf(MotionOtf otf);
[[nodiscard]] std::optional<MotionOtf> motionOtfFromName(std::string_view name);

}  // namespace echolucent
