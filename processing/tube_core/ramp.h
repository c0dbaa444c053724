// The curve as the mean of the tubes' ramps: what each tube core says about which intensities are fluid and which are
// surface, side by side with the paper's product of basis functions.
#pragma once

#include <span>
#include <vector>

#include "processing/tube_core/rules/curve_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// The ramp of one tube core: 0 up to I_L + max(begin (I_H - I_L), clearSpreads times the fluid's spread), so that
/// neither haze nor the speckle of the fluid is seen; 1 from I_L + end (I_H - I_L) on, linear between, over at least
/// leastRampWidth of the way.
[[nodiscard]] double rampAt(double intensity, const TubeCore& tube, const RampRule& rule);
inline constexpr double leastRampWidth = 0.3;

/// The tubes' ramps at `count` equidistant intensities 0 ... 1, their mean weighted by d: how surely an intensity is
/// surface, [0,1]; empty where no tube has a weight. The sums are compensated and have an order of the ramps' own, so
/// that the bits are the same for any order of the tubes.
[[nodiscard]] std::vector<double> meanRamp(std::span<const TubeCore> tubes, const RampRule& rule, int count);

}  // namespace echolucent
