// The choices of the motion mode, shared by its panel, its player and what is drawn of its OTFs.
#pragma once

#include <array>

#include "processing/motion/otf_sweep.h"

namespace echolucent {

using MotionAxis = SweepAxis;

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
    oneOtf,              ///< the one that was computed before the motion, for every frame
    eachView,            ///< computed anew for each frame, not smoothed
    mean,                ///< ... and smoothed over time: OtfSmoothing::mean
    movingLeastSquares,  ///< OtfSmoothing::movingLeastSquares
    leastFlicker,        ///< OtfSmoothing::leastFlicker
};
inline constexpr std::array allMotionOtfs{MotionOtf::oneOtf, MotionOtf::eachView, MotionOtf::mean,
                                          MotionOtf::movingLeastSquares, MotionOtf::leastFlicker};

/// The range of the motion, whole degrees from the view in which it was started.
inline constexpr int firstMotionAngle = -45;
inline constexpr int lastMotionAngle = 45;

}  // namespace echolucent
