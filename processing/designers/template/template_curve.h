// The OTF designer "template": the curve of a reference volume, carried to another one by a warp of the intensity axis
// (Rezk-Salama and others 2000; docs/designers/template.md).
#pragma once

#include <optional>

#include "processing/designers/design.h"
#include "processing/designers/template/template_config.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// Its table, which also checks the reference; the argument only selects it.
[[nodiscard]] const ParameterTable<TemplateConfig>& parametersOf(const TemplateConfig&);

/// The curve alpha(t^-1(v)) at 256 equidistant intensities v. alpha is the reference's curve, and t the warp that
/// findWarp() finds from the reference's histogram to that of the shown voxels. The plots are "warp" (NaN if the volume
/// cuts the reference's intensity off), "reference_histogram" and "histogram". The facts are "largest_shift" (of the
/// warp within [0,1], with its sign), "mean_slope", "distance_before" and "distance".
/// If the volume or the reference holds no data, or one intensity alone, the curve is the reference's unchanged, and
/// the message says why. If that curve is 0 everywhere, the curve is x².
/// Throws std::invalid_argument if a value is out of its range, the reference's histogram is none, or the shown voxels
/// have another grid.
[[nodiscard]] std::optional<Design> design(const TemplateConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
