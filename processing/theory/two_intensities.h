// The two-intensity model of Petersch 2005, section 4: fluid before tissue, seen along one ray by eqs. 2 and 3.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "processing/opacity_curve.h"

namespace echolucent {

/// Fluid of one intensity, and behind it tissue of another one up to the end of the ray. A ray takes one sample a unit.
/// White is intensity 1 (linear greys).
struct TwoIntensities {
    static constexpr std::int64_t mostUnits = 1'000'000;
    double tissue = 85.0 / 255.0;   ///< c1, [0,1]: the phantoms' tissue
    double fluid = 14.0 / 255.0;    ///< c2, [0,1]: the phantoms' fluid
    std::int64_t fluidUnits = 30;   ///< thickness of the fluid, [0, mostUnits]: the tissue's surface lies behind it
    std::int64_t tissueUnits = 40;  ///< thickness of the tissue, [0, mostUnits]
    double background = 0.0;        ///< c(r,0) of eq. 3, [0,1]: opaque
    friend bool operator==(const TwoIntensities&, const TwoIntensities&) = default;
};
/// What is out of range: "c1 must be from 0 to 1". Empty if nothing is. A value that is no number is out of range.
[[nodiscard]] std::string problemOf(const TwoIntensities& model);

/// A part of a ray that is the same everywhere.
struct RayLayer {
    double intensity = 0.0;  ///< c of eq. 2, [0,1]
    double opacity = 0.0;    ///< alpha of eq. 2, one sample, [0,1]
    std::int64_t units = 0;  ///< samples, >= 0
};

/// A model has rays of two kinds, both of the same length.
enum class ModelRay {
    throughFluid,  ///< fluid all the way: beside the tissue
    intoTissue,    ///< fluid, then tissue
};
/// The layers of a ray in the order in which it meets them from the eye. Throws std::invalid_argument if problemOf()
/// is not empty.
[[nodiscard]] std::array<RayLayer, 2> layersOf(const TwoIntensities& model, const OpacityCurve& curve, ModelRay ray);

/// C(r) by eq. 2, sample by sample from the background to the eye. Sums are kept in long double: 1 - alpha of a small
/// alpha would else round in each of a million samples.
[[nodiscard]] double byEquation2(std::span<const RayLayer> layers, double background);
/// C(r) by eq. 3, term by term, k = K at the eye. Sums are kept in long double.
[[nodiscard]] double byEquation3(std::span<const RayLayer> layers, double background);
/// C(r) in closed form. The sum of eq. 3 over n samples of one layer is geometric: c (1 - (1 - alpha)^n), times what
/// the layers before it let through.
[[nodiscard]] double inClosedForm(std::span<const RayLayer> layers, double background);

/// The pixels of both rays, as shares of white.
struct ModelPixels {
    double fluid = 0.0, tissue = 0.0;
};
/// In closed form. Throws as layersOf() does.
[[nodiscard]] ModelPixels pixelsOf(const TwoIntensities& model, const OpacityCurve& curve);

/// How two pixels are set against each other.
enum class ContrastKind {
    difference,  ///< tissue - fluid: a share of white, negative if the fluid is brighter
    michelson,   ///< (tissue - fluid) / (tissue + fluid), [-1,1]
    weber,       ///< (tissue - fluid) / fluid, >= -1
};
inline constexpr std::array<ContrastKind, 3> allContrastKinds{ContrastKind::difference, ContrastKind::michelson,
                                                              ContrastKind::weber};
/// "difference", "michelson", "weber".
[[nodiscard]] std::string_view nameOf(ContrastKind kind);
/// Empty if the divisor is 0: black has no relative contrast.
[[nodiscard]] std::optional<double> contrastOf(const ModelPixels& pixels, ContrastKind kind);

/// From how many units of fluid on the contrast (difference) with `better` is that with `other` or more. It is D =
/// (1 - alpha2)^n ((c1 - c0) A1 - (c2 - c0) A2), n units of fluid, c0 the background, A1 and A2 the opacities of the
/// tissue and of as much fluid. So the quotient of two curves' contrasts is a power of n, and there is one such
/// thickness. Both curves' contrasts must be above 0, and `better` must let more light through fluid. Else the result
/// is empty. Not below 0. The model's own fluidUnits has no say. Throws as layersOf() does.
[[nodiscard]] std::optional<double> unitsToBeat(const TwoIntensities& model, const OpacityCurve& better,
                                                const OpacityCurve& other);

}  // namespace echolucent
