// The config of the designer by the contour spectrum (docs/designers/contour-spectrum.md).
#pragma once

#include "processing/choice_names.h"
#include "processing/designers/designer_words.h"

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
    double opacity = 0.6;     ///< behind the ramp, per unit, [0,1]
    friend bool operator==(const ContourSpectrumConfig&, const ContourSpectrumConfig&) = default;
};

}  // namespace echolucent
