// The OTF designer "template": the curve of a reference volume, carried to another one by a warp of the intensity axis
// (Rezk-Salama and others 2000; docs/designers/template.md).
#pragma once

#include <optional>

#include "processing/designers/designer_declarations.h"
#include "processing/designers/template/template_comparison.h"
#include "processing/designers/template/template_reference.h"

namespace echolucent {

/// parametersOf() has the ranges of the slopes too.
struct TemplateConfig {
    static constexpr DesignerWords words{"template", "Template"};
    SharedTemplate reference = fetusTemplate();  ///< no row of the table
    TemplateComparison comparison = TemplateComparison::logarithm;
    double leastSlope = 0.25;   ///< of the warp, [1/8,1]
    double largestSlope = 4.0;  ///< of the warp, [1,8]
    friend bool operator==(const TemplateConfig&, const TemplateConfig&) = default;
};
/// The table also checks the reference.
[[nodiscard]] const ParameterTable<TemplateConfig>& parametersOf(const TemplateConfig&);

/// The curve alpha(t^-1(v)) at 256 equidistant intensities v. alpha is the reference's curve, and t the warp that
/// findWarp() finds from the reference's histogram to that of the shown voxels. The plots are "warp" (NaN if the volume
/// cuts the reference's intensity off), "reference_histogram" and "histogram". The facts are "largest_shift" (of the
/// warp within [0,1], with its sign), "mean_slope", "distance_before" and "distance".
///
/// If the reference's curve is 0 everywhere, the curve is x². Else, if the volume or the reference holds no data, or
/// intensities of one bin alone, the curve is the reference's unchanged. In both cases the message says so, and there
/// are no facts and no "warp".
[[nodiscard]] std::optional<Design> design(const TemplateConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
