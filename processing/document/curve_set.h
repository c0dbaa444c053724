// The opacity curves that a person edits, and the names of all curves that can be rendered.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "processing/designers/fetal_preset.h"
#include "processing/document/curve_adjustment.h"
#include "processing/opacity_curve.h"

namespace echolucent {

/// The five curves a view can be rendered with.
enum class CurveKind { adaptive, manual, linear, parabolic, quartic };

/// All kinds in the order of the legend and of the shortcuts 1 to 5.
inline constexpr std::array<CurveKind, 5> allCurveKinds{CurveKind::adaptive, CurveKind::manual, CurveKind::linear,
                                                        CurveKind::parabolic, CurveKind::quartic};

[[nodiscard]] constexpr std::size_t indexOf(CurveKind kind) { return static_cast<std::size_t>(kind); }

/// "adaptive", "manual", "linear", "parabolic", "quartic".
[[nodiscard]] std::string_view nameOf(CurveKind kind);
[[nodiscard]] std::optional<CurveKind> curveKindFromName(std::string_view name);

/// The curves that a person edits. The adaptive curve is not one of them: it is computed from the volume.
struct CurveSet {
    ManualCurve manual{{fetalPresetNodes.begin(), fetalPresetNodes.end()}};  ///< users of 3D Slicer know it
    LinearCurve linear;
    PowerCurve parabolic{2, 1.0};  ///< the exponent stays 2
    PowerCurve quartic{4, 1.0};    ///< the exponent stays 4
    CurveAdjustment adjustment{};  ///< for every curve that is rendered, the adaptive one too
    friend bool operator==(const CurveSet&, const CurveSet&) = default;
};

/// The curve of one kind. `adaptive`: what the method computed for the volume shown, empty before that.
[[nodiscard]] OpacityCurve curveOf(const CurveSet& curves, CurveKind kind, const SampledCurve& adaptive);

/// The same, adjusted, as it is rendered.
[[nodiscard]] OpacityCurve renderedCurve(const CurveSet& curves, CurveKind kind, const SampledCurve& adaptive);

}  // namespace echolucent
