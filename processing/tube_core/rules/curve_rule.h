// The two ways in which tube cores can bend the initial function. A method uses one.
#pragma once

#include <variant>

namespace echolucent {

/// T * d_max of the paper: 0.03 at its 15 x 15 tube cores (docs/method.md, "Readings").
inline constexpr double paperStrength = 0.03 * 225;

/// The initial function times one basis function per tube core (Petersch 2005, eq. 4).
struct ProductRule {
    double strength = paperStrength;  ///< T * d_max: one rule for any number of tube cores
    friend bool operator==(const ProductRule&, const ProductRule&) = default;
};

/// The mean, weighted by d, of one ramp per tube core. A ramp begins between the intensity before its surface (I_L) and
/// that at it (I_H), and is full beyond I_H: at I_H these ends give half of it, and more in quiet voxels
/// (quieterRule()). Only the ratios of the weights count, so the paper's strength is taken for d_max.
struct RampRule {
    double begin = 0.4;          ///< an intensity is clear up to this share of the way from I_L to I_H
    double clearSpreads = 2.5;   ///< an intensity is clear, too, up to this many standard deviations of the fluid's
                                 ///< voxels above I_L
    double end = 1.6;            ///< the ramp is full from this share of the way from I_L to I_H on; above `begin`
    double opacity = 1.0;        ///< opacity per unit length if all tube cores say surface
    double aim = 0.5;            ///< [0,1]: 0 shows bright surfaces, by the mean of the ramps; 1 shows every wall, by
                                 ///< the ramp that holds half of the light back at each surface (FoundRamp); between
                                 ///< them both curves are mixed
    double trustedShare = 0.05;  ///< if at least this share of the tube cores has a weight, the initial function has no
                                 ///< say in the curve; below this share, ramp and initial function are mixed
    friend bool operator==(const RampRule&, const RampRule&) = default;
};

using CurveRule = std::variant<ProductRule, RampRule>;

/// T * d_max under a rule.
[[nodiscard]] inline double strengthOf(const CurveRule& rule) {
    const auto* product = std::get_if<ProductRule>(&rule);
    return product != nullptr ? product->strength : paperStrength;
}

}  // namespace echolucent
