// Reduces a densely sampled curve to few nodes, and lists the curves that the editor offers as starting points.
#pragma once

#include <QString>
#include <vector>

#include "processing/opacity_curve.h"

namespace echolucent {

/// Largest difference in opacity if a sampled curve is copied into nodes, anywhere in [0,1].
inline constexpr double copiedCurveMaxError = 0.003;

/// The nodes of a manual curve that differs from `curve` by at most `maxError` in opacity at every intensity.
/// `maxError` must be above 0, else std::invalid_argument is thrown. Douglas and Peucker's subdivision, with the
/// distance along the opacity axis: so the bound holds for opacity. The first and last samples are always kept. Fewer
/// than two samples give a constant curve of one node.
[[nodiscard]] ManualCurve reducedToNodes(const SampledCurve& curve, double maxError);

/// A named manual curve to start from.
struct CurvePreset {
    QString key;   ///< part of the object name
    QString name;  ///< as people read it
    ManualCurve curve;
};

/// 3D Slicer's fetal preset, x^2 as nodes, and the ramp from (0,0) to (1,1).
[[nodiscard]] const std::vector<CurvePreset>& curvePresets();

}  // namespace echolucent
