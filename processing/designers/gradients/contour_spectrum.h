// The OTF designer "contour-spectrum": an opacity ramp at the isovalue whose isosurfaces are steepest (Bajaj, Pascucci,
// Schikore 1997; docs/designers/contour-spectrum.md).
#pragma once

#include <cstddef>
#include <optional>

#include "processing/choice_names.h"
#include "processing/designers/designer_declarations.h"

namespace echolucent {

/// Where the middle of the ramp comes from.
enum class IsovalueChoice {
    steepest,  ///< the steepest of maximaOf() the spectrum
    given,     ///< a person's choice
};
inline constexpr ChoiceNames<2> isovalueChoiceNames{"steepest", "given"};

/// parametersOf() has the ranges too.
struct ContourSpectrumConfig {
    static constexpr DesignerWords words{"contour-spectrum", "Contour spectrum"};
    IsovalueChoice choice = IsovalueChoice::steepest;
    double threshold = 0.2;   ///< normalised intensity, [0,1]; only for IsovalueChoice::given
    double leastArea = 0.1;   ///< share of the largest area, [0,1]: smaller isosurfaces are noise
    double halfWidth = 0.08;  ///< of the ramp, normalised intensity, [0,1]
    double opacity = 0.6;     ///< beyond the ramp, per unit, [0,1]
    friend bool operator==(const ContourSpectrumConfig&, const ContourSpectrumConfig&) = default;
};
[[nodiscard]] const ParameterTable<ContourSpectrumConfig>& parametersOf(const ContourSpectrumConfig&);

/// The curve is a ramp: opacity 0 at threshold - halfWidth, `opacity` at threshold + halfWidth. Only its part within
/// [0,1] is kept. If no threshold is given and no isovalue is the steepest, the curve is opacity * x², there are no
/// facts, and the message says why. If a threshold is given but the volume has no isosurface, the ramp stands there all
/// the same, and the message says so.
///
/// The plots are "area", "volume", "gradient_integral" and "mean_gradient". The facts are "threshold", then "area",
/// "volume_above" and "mean_gradient" at the threshold, and "maximum_1", "maximum_2", ...: the isovalues of maximaOf(),
/// steepest first, at most mostMaximumFacts. Areas and volumes are in mm² and mm³ if the spacing is known, else in
/// units² and units³.
[[nodiscard]] std::optional<Design> design(const ContourSpectrumConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});
inline constexpr std::size_t mostMaximumFacts = 6;

}  // namespace echolucent
