// Extinction and intensity of a segment of a ray from all intensities between its ends.
#pragma once

#include <array>
#include <vector>

#include "processing/opacity_curve.h"

namespace echolucent::plain_casting {

/// Extinction per unit, and the intensity whose colour goes with it.
struct Extinction {
    double mean = 0.0;
    double intensity = 0.0;
};

/// The pre-integration that castRaysPlainly() defines, by Gauss-Legendre quadrature between the points at which curve
/// or colour map have a corner or a step.
class SegmentIntegral {
public:
    explicit SegmentIntegral(const OpacityCurve& curve);

    /// Both intensities in [0,1], in either order.
    [[nodiscard]] Extinction between(double first, double second) const;

private:
    /// tau, and tau times the intensity; of a point, or integrated.
    using Sums = std::array<double, 2>;
    [[nodiscard]] Sums at(double intensity) const;
    [[nodiscard]] Sums integrated(double low, double high) const;

    OpacityCurve m_curve;
    std::vector<double> m_ends;  ///< ascending from 0 to 1: corners and steps, and many between
    std::vector<Sums> m_before;  ///< integrals from 0 to each of them
};

}  // namespace echolucent::plain_casting
