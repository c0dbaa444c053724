// The factor by which one tube core multiplies the curve, prepared for many intensities.
#pragma once

#include <cstddef>
#include <span>

namespace echolucent {

/// (1 + d)^g(x) of one tube core, kept as its logarithm range * g(x). Terms of eq. 5 without the intensity are computed
/// once, with their rounding errors: I_L + I_H = centre2 + centre2Lost, I_H - I_L = gapHigh + gapLow.
struct BasisFactor {
    /// `range` is ln(1 + d). Needs high > low, both in [0,1].
    BasisFactor(double low, double high, double range);

    double range;
    double twice;                 ///< multiplies the intensity: 2, or more if the gap is tiny (see inverseGap)
    double centre2, centre2Lost;  ///< twice the midpoint
    double gapHigh, gapLow;       ///< gapHigh holds half of a double's digits: its product with another half is exact
    double inverseGap;            ///< finite: a gap too small for that is scaled up with everything else
};

/// For each factor in turn, sums[i] + lost[i] += range * g(intensities[i]), compensated. The three spans are equally
/// long. g is basisFunction(), with an error below 3e-16. The bits are the same on every machine.
void addFactors(std::span<const BasisFactor> factors, std::span<const double> intensities, std::span<double> sums,
                std::span<double> lost);

}  // namespace echolucent
