// The curve from the tubes: basis functions, multiplied as a sum of logarithms (Petersch 2005, eqs. 4 to 7).
#pragma once

#include <span>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// A sum of finite terms that keeps its rounding errors (Neumaier). Its error does not grow with the number of terms.
class CompensatedSum {
public:
    void add(double term);
    [[nodiscard]] double value() const { return m_sum + m_lost; }

private:
    double m_sum = 0.0, m_lost = 0.0;
};

/// g_t(x) of Petersch 2005, eq. 5, with its erratum, scaled: u = ((x - low) + (x - high)) / (high - low),
/// g = u exp((1 - u^2) / 2). It is -1 at low and +1 at high. Needs high > low.
[[nodiscard]] double basisFunction(double intensity, double low, double high);

/// ln initial(x) + sum over tubes of ln(1 + d) g(x) at `count` (>= 2) equidistant intensities 0 ... 1, before any
/// clamp; -infinity if the initial function is 0. Tubes without a weight do not count. The sum is compensated and goes
/// in the order of I_L, I_H, d. So its bits depend neither on the order of the tubes nor on threads or instruction set.
[[nodiscard]] std::vector<double> adaptedLogOpacity(const OpacityCurve& initial, std::span<const TubeCore> tubes,
                                                    int count);

/// min(1, exp(log opacity)).
[[nodiscard]] SampledCurve curveFromLogOpacity(std::span<const double> logOpacity);

}  // namespace echolucent
