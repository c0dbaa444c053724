// The curve that the tube cores make of the initial function (Petersch 2005, eqs. 4 to 7; docs/method.md, "7. Curve").
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "processing/adaptive/found_ramp.h"
#include "processing/opacity_curve.h"
#include "processing/tube_core/rules/curve_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

struct AdaptedCurve {
    std::vector<double> logOpacity;  ///< ln of the curve before the clamp to 1, at equidistant intensities 0 ... 1
    SampledCurve curve;              ///< min(1, exp(logOpacity))
    double trust = 1.0;  ///< with RampRule: the tubes' share of the curve, [0,1]; the rest is the initial function's. 1
                         ///< with ProductRule
};

/// The curve at `count` (>= 2) intensities. If no tube core has a weight, the curve is the initial function, clamped to
/// [0,1]. With RampRule and some trust, the initial function is clamped before it is mixed in. `everyWall` is the
/// ramp of rampForEveryWall(), which RampRule::aim mixes in; empty if the rule asks for none
/// (asksForEveryWall()).
[[nodiscard]] AdaptedCurve adaptedCurve(const CurveRule& rule, const OpacityCurve& initial,
                                        std::span<const TubeCore> tubes, int count,
                                        const std::optional<FoundRamp>& everyWall = {});
/// Whether the rule mixes in the ramp of rampForEveryWall().
[[nodiscard]] bool asksForEveryWall(const CurveRule& rule);
/// The rule with RampRule::aim 0. If nobody reads the curve of a run, this rule saves the search for that ramp.
/// Surfaces and weights stay the same.
[[nodiscard]] CurveRule withoutEveryWall(CurveRule rule);

}  // namespace echolucent
