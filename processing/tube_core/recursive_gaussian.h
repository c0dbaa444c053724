// A Gaussian as a recursive filter: the cost does not grow with sigma (Deriche 1993, "Recursively implementing the
// Gaussian and its derivatives", INRIA 1893; fourth order).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "processing/adaptive_otf.h"

namespace echolucent {

/// Two damped oscillations forwards and the same backwards, scaled so that a constant stays the same to rounding. Their
/// sum keeps within 4e-4 of an uncut Gaussian's peak for every sigma from 1 on; the Gaussian is neither cut nor
/// lowered.
class RecursiveGaussian {
public:
    /// sigma in samples, above 0.
    explicit RecursiveGaussian(double sigma);

    /// Smooths a function, continued as the border says: mirrored in front (once, as far as the function reaches) and
    /// zero behind, or itself again on both sides. result may not be function.
    void smooth(std::span<const double> function, TubeBorder border, std::vector<double>& result) const;

private:
    struct Complex {
        double re = 0.0, im = 0.0;
    };
    struct Oscillation {
        Complex pole, weight;
        /// pole * state + input
        [[nodiscard]] Complex next(const Complex& state, double input) const;
        /// Re(weight * state)
        [[nodiscard]] double output(const Complex& state) const;
        /// The state after endlessly many periods of which each alone leaves `state`.
        [[nodiscard]] Complex afterAllPeriods(const Complex& state, std::size_t length) const;
    };
    using States = std::array<Complex, 2>;
    [[nodiscard]] States statesBefore(std::span<const double> function, TubeBorder border) const;
    [[nodiscard]] States statesBehind(std::span<const double> function, TubeBorder border) const;
    std::array<Oscillation, 2> m_oscillations;
    std::size_t m_reach;  ///< samples farther away no longer count
};

}  // namespace echolucent
