// What tube cores are called in the window.
#pragma once

#include <QString>

#include "processing/explanation/tube_explanation.h"

namespace echolucent {

/// nameOf(state).
[[nodiscard]] QString wordsOf(TubeState state);

/// "Tube core 112: column 7, row 7, weighs, d 0.021".
[[nodiscard]] QString lineOf(const AdaptiveOtf& run, int number);

}  // namespace echolucent
