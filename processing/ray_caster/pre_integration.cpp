#include "processing/ray_caster/pre_integration.h"

#include <algorithm>
#include <cmath>

namespace echolucent::ray_casting {

namespace {

/// `sums` rise.
PreIntegration::Integral inFixedPoint(const std::vector<double>& sums) {
    const double unit = std::max(sums.back() * 0x1p-30, 1e-30);
    PreIntegration::Integral integral{std::vector<std::int32_t>(sums.size() + 1), static_cast<float>(unit)};
    std::transform(sums.begin(), sums.end(), integral.entries.begin(),
                   [&](double sum) { return static_cast<std::int32_t>(std::lround(sum / unit)); });
    integral.entries.back() = integral.entries[sums.size() - 1];
    return integral;
}

}  // namespace

PreIntegration::PreIntegration(const OpacityCurve& curve, double stepRatio) {
    const std::vector<double> opacities = sampledOpacities(curve, intervals + 1);
    std::vector<double> sums(opacities.size()), weighted(opacities.size());
    double before = 0.0;
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        const double extinction = stepRatio * std::min(-std::log1p(-opacities[i]), largestExtinction);
        if (i > 0) {
            const double position = static_cast<double>(i);
            sums[i] = sums[i - 1] + 0.5 * (before + extinction);
            weighted[i] = weighted[i - 1] + 0.5 * (before * (position - 1.0) + extinction * position);
        }
        before = extinction;
    }
    m_extinction = inFixedPoint(sums);
    m_weighted = inFixedPoint(weighted);
}

}  // namespace echolucent::ray_casting
