// The opacity curves that section 4 compares, and two ways to make them comparable.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/opacity_curve.h"
#include "processing/theory/two_intensities.h"

namespace echolucent {

struct TheoryCurve {
    std::string name;  ///< "linear, x": it begins with the name of the editor's curve, so that a plot has its colour
    OpacityCurve curve;
};

/// How the opacity scale a makes curves comparable.
enum class OpacityScaling {
    sameScale,    ///< a multiplies every curve: the paper's a x, a x^2, a x^4, and 0.5 a of eq. 1
    sameAtTissue  ///< every curve is multiplied so that its opacity at c1 is a c1, that of the line
};
/// "same scale", "same at tissue".
[[nodiscard]] std::string_view nameOf(OpacityScaling scaling);
[[nodiscard]] std::optional<OpacityScaling> opacityScalingFromName(std::string_view name);

/// The adaptive curve of a model, as one tube core makes it that has found the surface: I_L is c2, I_H is c1, and no
/// voxel differs from its layer's intensity. The rule's *every wall* reads the model's own ray. If c1 is not above c2,
/// no tube core has a weight, and the curve is the initial function. Throws as layersOf() does.
[[nodiscard]] SampledCurve adaptiveCurveOf(const TwoIntensities& model, const AdaptiveOtfConfig& config = {});

/// The curves beside the line x. The defaults are the paper's.
struct GivenCurves {
    PowerCurve parabolic{2, 1.0}, quartic{4, 1.0};
    LinearCurve equation1{};                 ///< L_L = 20/255 and a = 0.5, as in Fig. 1b
    std::optional<SampledCurve> adaptive{};  ///< of a study; empty: adaptiveCurveOf() the model
    friend bool operator==(const GivenCurves&, const GivenCurves&) = default;
};
/// x, x^2, x^4, eq. 1 and the adaptive curve, in this order. Throws as adaptiveCurveOf() does.
[[nodiscard]] std::vector<TheoryCurve> theoryCurves(const GivenCurves& given, const TwoIntensities& model);

/// The curve with its opacities multiplied by a factor (>= 0, finite; else std::invalid_argument). Opacities stay at
/// most 1.
[[nodiscard]] OpacityCurve scaledCurve(const OpacityCurve& curve, double factor);

/// The curves with the opacity scale (>= 0). A curve that is clear at c1 cannot be made as opaque as the line and stays
/// as it is.
[[nodiscard]] std::vector<TheoryCurve> scaledCurves(std::vector<TheoryCurve> curves, OpacityScaling scaling,
                                                    double scale, double tissue);

}  // namespace echolucent
