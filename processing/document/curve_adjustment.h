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

/// The curve as it is rendered. If nothing is adjusted, it is the same one, to the bit. Else it is sampled at the
/// intensities of the ray caster's table.
///
/// The rise is where the curve first reaches half of its largest opacity. Below and above it intensities are stretched
/// linearly, so that 0 and 1 stay where they are.
[[nodiscard]] OpacityCurve adjusted(const OpacityCurve& curve, const CurveAdjustment& adjustment);
/// The same for a curve or an OTF. The rise of a two-dimensional OTF is that of its upper curve. Its intensities are
/// stretched alike at every gradient, and it keeps its number of nodes.
[[nodiscard]] Classification adjustedClassification(const Classification& classification,
                                                    const CurveAdjustment& adjustment);

}  // namespace echolucent
