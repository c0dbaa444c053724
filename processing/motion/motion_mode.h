// What moves in the motion mode, and which OTF its frames show.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "processing/motion/otf_smoothing.h"

namespace echolucent {

/// The axis about which the view turns, as it lay when the motion began.
enum class MotionAxis {
    x,                 ///< adds to the elevation: in documents of older programs
    y,                 ///< adds to the azimuth: in documents of older programs
    z,                 ///< adds to the roll, as picturePlane: in documents of older programs
    screenVertical,    ///< of the picture
    screenHorizontal,  ///< of the picture
    picturePlane,      ///< the direction of looking: the picture turns in its own plane
};
/// What a person may choose, in the order of the choices.
inline constexpr std::array screenAxes{MotionAxis::screenVertical, MotionAxis::screenHorizontal,
                                       MotionAxis::picturePlane};
/// The axis for a view that begins anew: the screen's for one of the older programs, which it is if the view has
/// neither elevation nor roll; any other as it is.
[[nodiscard]] MotionAxis screenAxisOf(MotionAxis axis);

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

/// "x", "y", "z", "screen_vertical", "screen_horizontal", "picture_plane".
[[nodiscard]] std::string_view nameOf(MotionAxis axis);
[[nodiscard]] std::optional<MotionAxis> motionAxisFromName(std::string_view name);
/// "probe", "object", "both".
[[nodiscard]] std::string_view nameOf(MotionScenario scenario);
[[nodiscard]] std::optional<MotionScenario> motionScenarioFromName(std::string_view name);
/// "one_otf", "each_view", "mean", "moving_least_squares", "least_flicker".
[[nodiscard]] std::string_view nameOf(MotionOtf otf);
[[nodiscard]] std::optional<MotionOtf> motionOtfFromName(std::string_view name);

}  // namespace echolucent
