// Two sliders that move whichever curve is rendered.
#pragma once

#include "processing/classification.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

/// How a curve is changed before it is rendered. Opacities 0 and 1 stay with any transparency. The opacities at
/// intensities 0 and 1 stay with any threshold: lifting a curve never fills black fluid.
struct CurveAdjustment {
    double threshold = 0.0;     ///< [-0.5, 0.5]: the curve's rise moves by this much to larger intensities
    double transparency = 0.0;  ///< [-1, 1]: light passes through 4^transparency times as much depth
    friend bool operator==(const CurveAdjustment&, const CurveAdjustment&) = default;
};

[[nodiscard]] const ParameterTable<CurveAdjustment>& adjustmentParameters();

/// The curve as it is rendered. If nothing is adjusted or the curve is 0 everywhere, it stays the same, to the bit.
/// Else it is sampled at the intensities of the ray caster's table.
///
/// The rise is the intensity at which the curve first reaches half of its largest opacity. Intensities below and above
/// the rise are stretched linearly, so that 0 and 1 stay where they are. Before and after it moves, the rise counts as
/// at least 0.02 and at most 0.98.
[[nodiscard]] OpacityCurve adjusted(const OpacityCurve& curve, const CurveAdjustment& adjustment);
/// The same for a curve or an OTF. The rise of a two-dimensional OTF is that of its upper curve. The OTF's intensities
/// are stretched alike at every gradient, and it keeps its number of nodes.
[[nodiscard]] Classification adjustedClassification(const Classification& classification,
                                                    const CurveAdjustment& adjustment);

}  // namespace echolucent
