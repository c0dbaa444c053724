// Two sliders that move whichever curve is rendered.
#pragma once

#include "processing/classification.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

/// What is made of a curve before it is rendered. Opacity 0 stays 0 and opacity 1 stays 1 with any transparency, and
/// what a curve gives at intensities 0 and 1 stays with any threshold: lifting a curve never fills black fluid.
struct CurveAdjustment {
    double threshold = 0.0;     ///< [-0.5, 0.5]: by how much the curve's rise moves to larger intensities
    double transparency = 0.0;  ///< [-1, 1]: light passes through 4^transparency times as much depth
    friend bool operator==(const CurveAdjustment&, const CurveAdjustment&) = default;
};

/// A row for each of both.
[[nodiscard]] const ParameterTable<CurveAdjustment>& adjustmentParameters();

/// The curve as it is rendered; the same one, to the bit, where nothing is adjusted. Else it is sampled at the
/// intensities of the ray caster's table.
///
/// The rise is where the curve first reaches half of its largest opacity. Below and above it intensities are stretched
/// linearly, so that 0 and 1 stay where they are.
[[nodiscard]] OpacityCurve adjusted(const OpacityCurve& curve, const CurveAdjustment& adjustment);
/// The same of whatever is rendered. Of a two-dimensional OTF the rise is that of its upper curve, and intensities are
/// stretched at every gradient alike; its nodes stay as many as they are.
[[nodiscard]] Classification adjustedClassification(const Classification& classification,
                                                    const CurveAdjustment& adjustment);

}  // namespace echolucent
