// The OTF designer "template": the curve of a reference volume, carried to another one by a warp of the intensity axis
// (Rezk-Salama and others 2000; docs/designers/template.md).
#pragma once

#include <optional>

#include "processing/designers/design.h"
#include "processing/designers/template/template_config.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// Its table, which also knows what is wrong with the reference; the argument only selects it.
[[nodiscard]] const ParameterTable<TemplateConfig>& parametersOf(const TemplateConfig&);

/// The curve alpha(t^-1(v)) at 256 equidistant intensities v, alpha the reference's curve and t the warp that
/// findWarp() finds between the reference's histogram and that of the shown voxels. The plots are "warp" (NaN where the
/// volume cuts the reference's intensities off), "reference_histogram" and "histogram"; the facts "largest_shift" (of
/// the warp, with its sign, where it is within [0,1]), "mean_slope", "distance_before" and "distance".
/// Where the volume or the reference holds no data, or one intensity alone, the curve is the reference's as it is, and
/// the message says why. Where that curve is 0 everywhere, the curve is x².
/// It throws std::invalid_argument where a value is out of its range, where the reference's histogram is not one, or
/// where the shown voxels have another grid.
[[nodiscard]] std::optional<Design> design(const TemplateConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
