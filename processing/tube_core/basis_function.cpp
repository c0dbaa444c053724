#include "processing/tube_core/basis_function.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "processing/parallel.h"
#include "processing/tube_core/basis_factor.h"

namespace echolucent {

double basisFunction(double intensity, double low, double high) {
    const BasisFactor factor(low, high, 1.0);
    double value = 0.0, lost = 0.0;
    addFactors({&factor, 1}, {&intensity, 1}, {&value, 1}, {&lost, 1});
    return value;
}

void CompensatedSum::add(double term) {
    const double sum = m_sum + term;
    m_lost += std::abs(m_sum) >= std::abs(term) ? (m_sum - sum) + term : (term - sum) + m_sum;
    m_sum = sum;
}

namespace {

/// The factors of the tubes with a weight, in an order that does not depend on the order of the tubes.
std::vector<BasisFactor> factorsOf(std::span<const TubeCore> tubes) {
    std::vector<std::tuple<double, double, double>> keys;
    for (const TubeCore& tube : tubes)
        if (tube.d > 0.0) keys.emplace_back(*tube.lowIntensity, *tube.highIntensity, tube.d);
    std::sort(keys.begin(), keys.end());
    std::vector<BasisFactor> factors;
    factors.reserve(keys.size());
    for (const auto& [low, high, d] : keys) factors.emplace_back(low, high, std::log1p(d));
    return factors;
}

}  // namespace

std::vector<double> adaptedLogOpacity(const OpacityCurve& initial, std::span<const TubeCore> tubes, int count) {
    const std::vector<BasisFactor> factors = factorsOf(tubes);
    const auto size = static_cast<std::size_t>(count);
    std::vector<double> intensities(size), sums(size, 0.0), lost(size, 0.0);
    for (std::size_t i = 0; i < size; ++i) {
        intensities[i] = static_cast<double>(i) / (count - 1);
        if (const double first = logOpacityAt(initial, intensities[i]); std::isfinite(first)) sums[i] = first;
    }
    const auto partOf = [](auto& values, const LoopRange<std::size_t>& range) {
        return std::span(values).subspan(range.begin(), range.size());
    };
    constexpr std::size_t grain = 32;
    parallelFor(LoopRange<std::size_t>(0, size, grain), [&](const LoopRange<std::size_t>& range) {
        addFactors(factors, partOf(intensities, range), partOf(sums, range), partOf(lost, range));
    });
    for (std::size_t i = 0; i < size; ++i) {
        const double first = logOpacityAt(initial, intensities[i]);
        sums[i] = std::isfinite(first) ? sums[i] + lost[i] : first;
    }
    return sums;
}

SampledCurve curveFromLogOpacity(std::span<const double> logOpacity) {
    SampledCurve curve;
    curve.opacities.resize(logOpacity.size());
    std::transform(logOpacity.begin(), logOpacity.end(), curve.opacities.begin(),
                   [](double value) { return value < 0.0 ? std::exp(value) : 1.0; });
    return curve;
}

}  // namespace echolucent
