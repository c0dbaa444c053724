// From a densely sampled curve to few nodes, and the curves that the editor offers as starting points.
#pragma once

#include <QString>
#include <vector>

#include "processing/opacity_curve.h"

namespace echolucent {

/// Largest difference in opacity that copying a sampled curve into nodes may cause, anywhere in [0,1].
inline constexpr double copiedCurveMaxError = 0.003;

/// The nodes of a manual curve that differs from `curve` by at most `maxError` (> 0) in opacity at every intensity.
/// Douglas and Peucker's subdivision with the distance taken along the opacity axis, so that the bound is one on
/// opacity. First and last sample are always kept; fewer than two samples give a constant curve of one node.
[[nodiscard]] ManualCurve reducedToNodes(const SampledCurve& curve, double maxError);

/// A named manual curve to begin from.
struct CurvePreset {
    QString key;   ///< part of the object name
    QString name;  ///< as people read it
    ManualCurve curve;
};

/// 3D Slicer's fetal preset, x^2 as nodes, and the ramp from (0,0) to (1,1).
[[nodiscard]] const std::vector<CurvePreset>& curvePresets();

}  // namespace echolucent
