// One tube core's factor of the curve, prepared for many intensities.
#pragma once

#include <cstddef>
#include <span>

namespace echolucent {

/// (1 + d)^g(x) of one tube core, by its logarithm range * g(x). What eq. 5 takes from I_L and I_H alone is computed
/// once, together with what rounding drops there: I_L + I_H = centre2 + centre2Lost, I_H - I_L = gapHigh + gapLow.
struct BasisFactor {
    /// `range` is ln(1 + d). high > low is needed, both in [0,1].
    BasisFactor(double low, double high, double range);

    double range;
    double twice;                 ///< times the intensity: 2, or more where the gap is next to nothing (see inverseGap)
    double centre2, centre2Lost;  ///< twice the midpoint
    double gapHigh, gapLow;       ///< gapHigh holds half of a double's digits: its product with another half is exact
    double inverseGap;            ///< finite: gaps too small for that are scaled up with everything else
};

/// sums[i] + lost[i] += range * g(intensities[i]) of every factor in turn, compensated. `intensities`, `sums` and
/// `lost` are equally long. g as in basisFunction(), error below 3e-16. The same bits on every machine.
void addFactors(std::span<const BasisFactor> factors, std::span<const double> intensities, std::span<double> sums,
                std::span<double> lost);

}  // namespace echolucent
