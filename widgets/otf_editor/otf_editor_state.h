// What the OTF editor shows, as a value.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "processing/document/curve_set.h"

namespace echolucent {

/// The five curves: which one is rendered, and which are drawn.
struct OtfEditorState : CurveSet {
    SampledCurve adaptive;                                      ///< empty if it is not computed yet
    CurveKind active = CurveKind::adaptive;                     ///< the curve that is rendered
    std::array<bool, 5> visible{true, true, true, true, true};  ///< drawn in the plot, by indexOf(kind)
    bool designed = false;                 ///< a designer's OTF is rendered instead of the active curve
    std::string designer{};                ///< the designer's name, as a person reads it
    std::optional<OpacityCurve> design{};  ///< upperCurveOf() the designer's OTF; none if it is not computed yet
    bool designVisible = true;             ///< drawn in the plot
    friend bool operator==(const OtfEditorState&, const OtfEditorState&) = default;
};

/// The curve of one kind. An adaptive curve not computed yet is an empty SampledCurve (opacity 0 everywhere).
[[nodiscard]] inline OpacityCurve curveOf(const OtfEditorState& state, CurveKind kind) {
    return curveOf(state, kind, state.adaptive);
}

/// The rendered curve, adjusted. For a designer's OTF the upper curve; transparent if it is not computed yet.
[[nodiscard]] inline OpacityCurve renderedCurve(const OtfEditorState& state) {
    if (state.designed) return adjusted(state.design.value_or(ManualCurve{}), state.adjustment);
    return renderedCurve(state, state.active, state.adaptive);
}

}  // namespace echolucent
