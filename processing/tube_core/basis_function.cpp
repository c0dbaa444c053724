#include "processing/tube_core/basis_function.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace echolucent {

double basisFunction(double intensity, double low, double high) {
    const double u = ((intensity - low) + (intensity - high)) / (high - low);
    // A gap of a few ulps makes u overflow: far from it the function is 0.
    if (!(std::abs(u) < 1e6)) return 0.0;
    return u * std::exp((1.0 - u * u) / 2.0);
}

void CompensatedSum::add(double term) {
    const double sum = m_sum + term;
    m_lost += std::abs(m_sum) >= std::abs(term) ? (m_sum - sum) + term : (term - sum) + m_sum;
    m_sum = sum;
}

std::vector<double> adaptedLogOpacity(const OpacityCurve& initial, std::span<const TubeCore> tubes, int count) {
    struct Factor {
        double logRange, low, high;
    };
    std::vector<Factor> factors;
    for (const TubeCore& tube : tubes)
        if (tube.d > 0.0) factors.push_back({std::log1p(tube.d), *tube.lowIntensity, *tube.highIntensity});

    std::vector<double> logOpacity(static_cast<std::size_t>(count));
    tbb::parallel_for(tbb::blocked_range<int>(0, count, 32), [&](const tbb::blocked_range<int>& samples) {
        for (int i = samples.begin(); i < samples.end(); ++i) {
            const double x = static_cast<double>(i) / (count - 1);
            const double initialLog = logOpacityAt(initial, x);
            CompensatedSum sum;
            if (std::isfinite(initialLog)) {
                sum.add(initialLog);
                for (const Factor& factor : factors)
                    sum.add(factor.logRange * basisFunction(x, factor.low, factor.high));
            }
            logOpacity[static_cast<std::size_t>(i)] = std::isfinite(initialLog) ? sum.value() : initialLog;
        }
    });
    return logOpacity;
}

SampledCurve curveFromLogOpacity(std::span<const double> logOpacity) {
    SampledCurve curve;
    curve.opacities.resize(logOpacity.size());
    std::transform(logOpacity.begin(), logOpacity.end(), curve.opacities.begin(),
                   [](double value) { return value < 0.0 ? std::exp(value) : 1.0; });
    return curve;
}

}  // namespace echolucent
