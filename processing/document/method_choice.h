// How the adaptive method is run for a document.
#pragma once

#include <optional>
#include <string_view>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/document/curve_set.h"
#include "processing/parameters/parameter.h"

namespace echolucent {

/// The kind of initial function that the adaptive method begins with.
enum class InitialKind {
    parabolic,  ///< a x^2
    quartic,    ///< a x^4
    linear,     ///< the piecewise linear curve of the document
    manual,     ///< the manual curve of the document
};
/// "parabolic", "quartic", "linear", "manual".
[[nodiscard]] std::string_view nameOf(InitialKind kind);
[[nodiscard]] std::optional<InitialKind> initialKindFromName(std::string_view name);

/// A config whose initial function is a name, so that a curve of the document stands in one place only.
struct MethodChoice {
    AdaptiveOtfConfig config;  ///< without `initial`, which is not used and keeps its default
    InitialKind initial = InitialKind::parabolic;
    double initialScale = defaultOpacityScale;  ///< a of the parabolic and quartic initial function, >= 0
    friend bool operator==(const MethodChoice&, const MethodChoice&) = default;
};

/// The rows of the initial function and its scale. The rows of the config are methodParameters().
[[nodiscard]] const ParameterTable<MethodChoice>& initialFunctionParameters();

[[nodiscard]] OpacityCurve initialCurve(const MethodChoice& method, const CurveSet& curves);
/// The config for adaptOpacity().
[[nodiscard]] AdaptiveOtfConfig configOf(const MethodChoice& method, const CurveSet& curves);

}  // namespace echolucent
