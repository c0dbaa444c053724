// Opacity transfer functions (OTFs) as values. They map normalised intensity in [0,1] to opacity in [0,1] per reference
// step. The reference step is one unit, the volume's smallest spacing. The ray caster corrects for its own step.
#pragma once

#include <variant>
#include <vector>

namespace echolucent {

/// One point of a manual curve.
struct CurveNode {
    double intensity = 0.0;  ///< normalised intensity, [0,1]
    double opacity = 0.0;    ///< opacity per reference step, [0,1]
    friend bool operator==(const CurveNode&, const CurveNode&) = default;
};

/// Linear between its nodes, constant outside the first and last. Nodes ascend in intensity. Two nodes may share an
/// intensity (a step): the later one holds there. Without a node, opacity is 0 everywhere.
struct ManualCurve {
    std::vector<CurveNode> nodes;
    friend bool operator==(const ManualCurve&, const ManualCurve&) = default;
};

/// Petersch 2005, eq. 1, on normalised intensity: 0 below lower, slope (x - lower) up to upper, constant beyond.
struct LinearCurve {
    double lower = 20.0 / 255.0;  ///< L_L, [0,1]
    double slope = 0.5;           ///< a, opacity per unit of normalised intensity, >= 0
    double upper = 1.0;           ///< L_H, [lower,1]
    friend bool operator==(const LinearCurve&, const LinearCurve&) = default;
};

/// scale * x^exponent: the parabolic (2) and quartic (4) functions of Petersch 2005, section 4.
struct PowerCurve {
    int exponent = 2;    ///< 1 and above
    double scale = 1.0;  ///< a, opacity at full intensity before the clamp, >= 0
    friend bool operator==(const PowerCurve&, const PowerCurve&) = default;
};

/// Opacities at equidistant intensities from 0 to 1, linear between them. The adaptive method gives such a curve.
struct SampledCurve {
    std::vector<double> opacities;  ///< two or more values in [0,1]; if empty, opacity is 0 everywhere
    friend bool operator==(const SampledCurve&, const SampledCurve&) = default;
};

using OpacityCurve = std::variant<ManualCurve, LinearCurve, PowerCurve, SampledCurve>;

/// Opacity at a normalised intensity (clamped into [0,1]; NaN counts as 0), clamped into [0,1].
[[nodiscard]] double opacityAt(const OpacityCurve& curve, double intensity);

/// Opacity at `count` equidistant intensities 0, 1/(count-1), ..., 1. Throws std::invalid_argument if `count` is
/// below 2.
[[nodiscard]] std::vector<double> sampledOpacities(const OpacityCurve& curve, int count);

/// Natural logarithm of the curve before its clamp to 1; -infinity if the curve is 0 there.
[[nodiscard]] double logOpacityAt(const OpacityCurve& curve, double intensity);

/// The opacity for `stepRatio` reference steps that gives the same transmittance: 1 - (1-opacity)^stepRatio. It is
/// computed as -expm1(stepRatio * log1p(-opacity)), exact for opacities near 0 and 1 (docs/stability.md, "Numbers").
[[nodiscard]] double opacityForStep(double opacity, double stepRatio);

}  // namespace echolucent
