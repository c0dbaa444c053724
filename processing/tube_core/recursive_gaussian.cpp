#include "processing/tube_core/recursive_gaussian.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace echolucent {

namespace {

/// exp(-x^2 / 2) for x >= 0 as the real part of a sum of weight * exp(-decay x): Deriche 1993, fourth order.
struct Term {
    std::complex<double> weight, decay;
};
constexpr std::array<Term, 2> terms{{{{1.6800, 3.7350}, {1.7830, 0.6318}}, {{-0.6803, -0.2598}, {1.7230, 1.9970}}}};

/// In sigmas; the slower oscillation has fallen to 1e-12 there.
constexpr double reachSigmas = 16.0;

}  // namespace

RecursiveGaussian::RecursiveGaussian(double sigma) : m_reach(static_cast<std::size_t>(std::ceil(reachSigmas * sigma))) {
    std::array<std::complex<double>, 2> poles;
    double sum = 0.0;
    for (std::size_t k = 0; k < terms.size(); ++k) {
        poles[k] = std::exp(-terms[k].decay / sigma);
        sum += (terms[k].weight * (1.0 + poles[k]) / (1.0 - poles[k])).real();
    }
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const std::complex<double> weight = terms[k].weight / sum;
        m_oscillations[k] = {{poles[k].real(), poles[k].imag()}, {weight.real(), weight.imag()}};
    }
}

RecursiveGaussian::Complex RecursiveGaussian::Oscillation::next(const Complex& state, double input) const {
    return {pole.re * state.re - pole.im * state.im + input, pole.re * state.im + pole.im * state.re};
}

double RecursiveGaussian::Oscillation::output(const Complex& state) const {
    return weight.re * state.re - weight.im * state.im;
}

RecursiveGaussian::Complex RecursiveGaussian::Oscillation::afterAllPeriods(const Complex& state,
                                                                           std::size_t length) const {
    const std::complex<double> perPeriod = std::pow(std::complex(pole.re, pole.im), static_cast<double>(length));
    const std::complex<double> all = std::complex(state.re, state.im) / (1.0 - perPeriod);
    return {all.real(), all.imag()};
}

RecursiveGaussian::States RecursiveGaussian::statesBefore(std::span<const double> function, TubeBorder border) const {
    States states;
    const std::size_t count = function.size();
    const bool circular = border == TubeBorder::circular;
    for (std::size_t i = circular ? count : std::min(count, m_reach); i-- > 0;)
        for (std::size_t k = 0; k < states.size(); ++k)
            states[k] = m_oscillations[k].next(states[k], circular ? function[count - 1 - i] : function[i]);
    if (circular)
        for (std::size_t k = 0; k < states.size(); ++k) states[k] = m_oscillations[k].afterAllPeriods(states[k], count);
    return states;
}

RecursiveGaussian::States RecursiveGaussian::statesBehind(std::span<const double> function, TubeBorder border) const {
    States states;
    if (border != TubeBorder::circular) return states;
    for (std::size_t i = function.size(); i-- > 0;)
        for (std::size_t k = 0; k < states.size(); ++k) states[k] = m_oscillations[k].next(states[k], function[i]);
    for (std::size_t k = 0; k < states.size(); ++k)
        states[k] = m_oscillations[k].afterAllPeriods(states[k], function.size());
    return states;
}

void RecursiveGaussian::smooth(std::span<const double> function, TubeBorder border, std::vector<double>& result) const {
    const std::size_t count = function.size();
    result.assign(count, 0.0);
    if (count == 0) return;
    States before = statesBefore(function, border), behind = statesBehind(function, border);
    // The states behind hold the samples behind i only: i itself is counted by those before.
    for (std::size_t step = 0; step < count; ++step) {
        const std::size_t i = step, j = count - 1 - step;
        for (std::size_t k = 0; k < before.size(); ++k) {
            before[k] = m_oscillations[k].next(before[k], function[i]);
            result[i] += m_oscillations[k].output(before[k]);
            result[j] += m_oscillations[k].output(m_oscillations[k].next(behind[k], 0.0));
            behind[k] = m_oscillations[k].next(behind[k], function[j]);
        }
    }
}

}  // namespace echolucent
