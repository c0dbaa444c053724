// How many digits tell values apart.
#pragma once

#include <algorithm>
#include <cmath>

#include "processing/volume/value_scale.h"

namespace echolucent {

/// How many significant digits tell values of a window apart: `least`, or more if it lies far from 0 for its width, but
/// no more than a double has.
[[nodiscard]] inline int digitsToTell(const ValueWindow& window, int least) {
    constexpr double farthestTold = 1e13;
    const double farthest = std::max(std::abs(window.black), std::abs(window.white));
    const double times = std::min(farthest / (window.white - window.black), farthestTold);
    constexpr int most = 17;
    return times > 1.0 ? std::min(most, least + static_cast<int>(std::ceil(std::log10(times) - 1e-9))) : least;
}

}  // namespace echolucent
