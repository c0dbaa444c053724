// What each tube core of a run does to the curve (Fig. 5 of Petersch et al. 2005), and how the curve grows with them.
#pragma once

#include <cstddef>
#include <vector>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/opacity_curve.h"
#include "processing/tube_core/rules/curve_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// The factor of one tube core at AdaptiveOtf::sampleCount intensities (Fig. 5). With ProductRule f_t(x) = (1 + d)^g(x)
/// of eq. 7. With RampRule its ramp, [0,1], as it is for the voxels for which the curve is meant.
struct TubeFactor {
    int number = 0;
    double d = 0.0;
    std::vector<double> values;
};

/// The tube cores with a weight, heaviest d first, ties by number; their numbers. Empty if surfacesWhereDataBegin,
/// because no tube core moves the curve then.
[[nodiscard]] std::vector<int> heaviestFirst(const AdaptiveOtf& otf);

/// The factors of all tube cores with a weight, in the order of heaviestFirst(), at most `most` of them (Fig. 5). The
/// product of all factors and the initial function is the run's curve before its clamp; the mean of all ramps, weighted
/// by d, is the share of the curve that the tube cores' ramps have.
[[nodiscard]] std::vector<TubeFactor> allFactors(const AdaptiveOtf& otf, std::size_t most = 4096);

/// The run's curve as it grows tube core by tube core: made of the first `count` of heaviestFirst(), clamped into [0,
/// their number]. Each has its d of the full run. 0 is exactly the initial function, all are the run's curve to the
/// bit.
///
/// With RampRule trust grows with the count: it is the share of RampRule::trustedShare that these tube cores reach. The
/// ramp for every wall stays that of the whole run, from the first tube core on: it belongs to no single one.
[[nodiscard]] SampledCurve grownCurve(const AdaptiveOtf& otf, std::size_t count);

/// A tube core of a run as its curve was made of it: status, d, I_L, I_H and the fluid's spread, in the voxels for
/// which the curve is meant. Other fields are not set.
[[nodiscard]] TubeCore curveTubeOf(const AdaptiveOtf& otf, std::size_t number);
/// The rule that made a run's curve: for quiet voxels quieterRule().
[[nodiscard]] CurveRule curveRuleOf(const AdaptiveOtf& otf);
/// The factor of such a tube core, with d > 0.
[[nodiscard]] TubeFactor factorOf(const TubeCore& curveTube, int number, const CurveRule& rule);

}  // namespace echolucent
