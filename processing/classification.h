// How voxels get their opacity: from the intensity alone, or from the intensity and the gradient magnitude.
#pragma once

#include <concepts>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "processing/opacity_curve.h"

namespace echolucent {

/// A two-dimensional OTF (Levoy 1988; Kindlmann and Durkin 1998). It gives opacity per reference step over the
/// normalised intensity f in [0,1] and the gradient magnitude g (processing/sampling/gradient_magnitude.h). Its nodes
/// are equidistant, and opacity is bilinear between them.
struct TwoDimensionalOtf {
    int intensities = 2;           ///< nodes along f, from 0 to 1; 2 to 1024
    int gradients = 2;             ///< nodes along g, from 0 to largestGradient; 2 to 1024
    double largestGradient = 1.0;  ///< normalised intensity per unit, above 0; larger gradients count as this one
    std::vector<float> opacities{0, 0, 0, 0};  ///< [0,1]; f runs fastest: index = node of g * intensities + node of f
    friend bool operator==(const TwoDimensionalOtf&, const TwoDimensionalOtf&) = default;
};

/// Opacity at a normalised intensity and a gradient magnitude, both clamped into the nodes' range (NaN counts as 0).
[[nodiscard]] double opacityAt(const TwoDimensionalOtf& otf, double intensity, double gradient);

/// The two-dimensional OTF whose nodes are opacity(f, g), clamped into [0,1] (NaN counts as 0). Throws
/// std::invalid_argument if the number of nodes or the largest gradient is out of range.
template <typename Opacity>
[[nodiscard]] TwoDimensionalOtf tabulated(int intensities, int gradients, double largestGradient,
                                          const Opacity& opacity);

/// A curve or a two-dimensional OTF, as one value. Copies share the two-dimensional OTF. A curve converts to a
/// Classification implicitly.
class Classification {
public:
    /// Opacity 0 everywhere.
    Classification() = default;
    template <typename Curve>
    requires std::constructible_from<OpacityCurve, Curve> Classification(Curve curve) : m_curve(std::move(curve)) {}
    /// Throws std::invalid_argument if a member is out of its range, or if there is not exactly one opacity a node.
    explicit Classification(TwoDimensionalOtf otf);

    [[nodiscard]] bool isTwoDimensional() const { return m_twoDimensional != nullptr; }
    /// The curve. If this is a two-dimensional OTF, the curve has no node and must not be used.
    [[nodiscard]] const OpacityCurve& curve() const { return m_curve; }
    /// Null if this is a curve.
    [[nodiscard]] const std::shared_ptr<const TwoDimensionalOtf>& twoDimensional() const { return m_twoDimensional; }

    friend bool operator==(const Classification& one, const Classification& other);

private:
    OpacityCurve m_curve = ManualCurve{};
    std::shared_ptr<const TwoDimensionalOtf> m_twoDimensional;
};

/// Opacity at a normalised intensity and a gradient magnitude. A curve looks at the intensity only.
[[nodiscard]] double opacityAt(const Classification& classification, double intensity, double gradient);

/// The largest opacity of each intensity at any gradient; a curve stays as it is. An editor with one axis shows this
/// curve.
[[nodiscard]] OpacityCurve upperCurveOf(const Classification& classification);

namespace classification_detail {
void check(int intensities, int gradients, double largestGradient);
float clampedOpacity(double opacity);
}  // namespace classification_detail

template <typename Opacity>
TwoDimensionalOtf tabulated(int intensities, int gradients, double largestGradient, const Opacity& opacity) {
    classification_detail::check(intensities, gradients, largestGradient);
    TwoDimensionalOtf otf{intensities, gradients, largestGradient, {}};
    otf.opacities.reserve(static_cast<std::size_t>(intensities) * static_cast<std::size_t>(gradients));
    for (int j = 0; j < gradients; ++j)
        for (int i = 0; i < intensities; ++i)
            otf.opacities.push_back(classification_detail::clampedOpacity(
                opacity(static_cast<double>(i) / (intensities - 1), largestGradient * j / (gradients - 1))));
    return otf;
}

}  // namespace echolucent
