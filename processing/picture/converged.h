// The settings of the converged picture: a view at rest shows it, and files get it.
#pragma once

#include "processing/picture/ray_cast_settings.h"

namespace echolucent {

/// A factor on the step of the picture's look (Look::step).
inline constexpr double convergedStep = 0.25;
inline constexpr double convergedTransmittance = 1.0 / 2048;  ///< as RayCastSettings::terminationTransmittance

/// The settings of the converged picture. `asked` are the settings of the look, with the look's own step.
[[nodiscard]] inline RayCastSettings converged(RayCastSettings asked) {
    asked.step *= convergedStep;
    asked.terminationTransmittance = convergedTransmittance;
    return asked;
}

}  // namespace echolucent
