// What the OTF editor edits, as a value.
#pragma once

#include <array>
#include <cstddef>

#include "processing/opacity_curve.h"

namespace echolucent {

/// The five curves that the editor overlays.
enum class CurveKind { adaptive, manual, linear, parabolic, quartic };

/// All kinds in the order of the legend and of the shortcuts 1 to 5.
inline constexpr std::array<CurveKind, 5> allCurveKinds{CurveKind::adaptive, CurveKind::manual, CurveKind::linear,
                                                        CurveKind::parabolic, CurveKind::quartic};

/// Position of a kind in allCurveKinds and in OtfEditorState::visible.
[[nodiscard]] constexpr std::size_t indexOf(CurveKind kind) { return static_cast<std::size_t>(kind); }

/// The five curves, which of them is rendered and which are drawn.
struct OtfEditorState {
    ManualCurve manual{{{60.0 / 255.0, 0.0}, {120.0 / 255.0, 0.6}, {1.0, 0.8}}};  ///< 3D Slicer's fetal preset
    LinearCurve linear;
    PowerCurve parabolic{2, 1.0};
    PowerCurve quartic{4, 1.0};
    SampledCurve adaptive;                                      ///< empty: not computed yet
    CurveKind active = CurveKind::adaptive;                     ///< the curve that is rendered
    std::array<bool, 5> visible{true, true, true, true, true};  ///< drawn in the plot, by indexOf(kind)
    friend bool operator==(const OtfEditorState&, const OtfEditorState&) = default;
};

/// The curve of one kind; an adaptive curve not computed yet is an empty SampledCurve (opacity 0 everywhere).
[[nodiscard]] OpacityCurve curveOf(const OtfEditorState& state, CurveKind kind);

/// True where both hold the same manual, linear, parabolic and quartic curve: what undo and redo restore.
[[nodiscard]] bool sameEditableCurves(const OtfEditorState& left, const OtfEditorState& right);

}  // namespace echolucent
