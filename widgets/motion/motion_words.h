// What a motion's axis and speed are called.
#pragma once

#include <QString>

#include "processing/motion/motion_choice.h"

namespace echolucent {

/// An axis in a sentence: "Screen's vertical".
[[nodiscard]] QString axisText(MotionAxis axis);
/// An axis in a narrow list, whose tool tip says what it means: "Upright".
[[nodiscard]] QString shortAxisText(MotionAxis axis);
/// "¼×", "1×", "0.7×".
[[nodiscard]] QString speedText(double speed);
/// How many frames a second the speed of a motion means, and what 1× is for it.
[[nodiscard]] QString speedTip(const MotionChoice& motion, const PhaseTimes& times);

}  // namespace echolucent
