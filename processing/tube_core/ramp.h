// The curve as the mean of one ramp per tube core. Each ramp says which intensities are fluid and which are surface.
// This is the alternative to the paper's product of basis functions.
#pragma once

#include <span>
#include <vector>

#include "processing/tube_core/rules/curve_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// The ramp of one tube core. It is 0 up to I_L + max(begin (I_H - I_L), clearSpreads times the fluid's spread), which
/// hides the fluid's haze and speckle. From I_L + end (I_H - I_L) on, or from leastRampWidth (I_H - I_L) behind its
/// beginning on if that is later, it is 1. It is linear between. I_L and I_H of `tube` must be set.
[[nodiscard]] double rampAt(double intensity, const TubeCore& tube, const RampRule& rule);
/// The intensities at which that ramp begins and is full.
struct RampEnds {
    double begin = 0.0, full = 0.0;
};
[[nodiscard]] RampEnds rampEnds(const TubeCore& tube, const RampRule& rule);
inline constexpr double leastRampWidth = 0.3;

/// The mean of the tubes' ramps, weighted by d, at `count` equidistant intensities 0 ... 1: how surely each intensity
/// is surface, [0,1]. Empty if no tube has a weight. The bits do not depend on the order of the tubes.
[[nodiscard]] std::vector<double> meanRamp(std::span<const TubeCore> tubes, const RampRule& rule, int count);

}  // namespace echolucent
