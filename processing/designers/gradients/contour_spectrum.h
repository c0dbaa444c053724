// The OTF designer "contour-spectrum": an opacity ramp at the isovalue whose isosurfaces are steepest (Bajaj, Pascucci,
// Schikore 1997; docs/designers/contour-spectrum.md).
#pragma once

#include <cstddef>
#include <optional>

#include "processing/designers/design.h"
#include "processing/designers/gradients/contour_spectrum_config.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

[[nodiscard]] const ParameterTable<ContourSpectrumConfig>& parametersOf(const ContourSpectrumConfig&);

/// The curve is a ramp: opacity 0 at threshold - halfWidth, `opacity` at threshold + halfWidth. Only its part within
/// [0,1] is kept. If no threshold is given and no isovalue is the steepest, the curve is opacity * x², there are no
/// facts, and the message says why.
/// The plots are "area", "volume", "gradient_integral" and "mean_gradient". The facts are "threshold", then "area",
/// "volume_above" and "mean_gradient" at the ramp, and "maximum_1", "maximum_2", ...: the isovalues of maximaOf(),
/// steepest first, at most mostMaximumFacts. Areas and volumes are in mm² and mm³ if the spacing is known, else in
/// units² and units³.
/// Throws std::invalid_argument if a value is out of its range or the shown voxels have another grid.
[[nodiscard]] std::optional<Design> design(const ContourSpectrumConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});
inline constexpr std::size_t mostMaximumFacts = 6;

}  // namespace echolucent
