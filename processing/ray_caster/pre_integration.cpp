#include "processing/ray_caster/pre_integration.h"

#include <algorithm>
#include <cmath>

namespace echolucent::ray_casting {

PreIntegration::PreIntegration(const OpacityCurve& curve, double stepRatio)
    : m_extinction(intervals + 2), m_weighted(intervals + 2) {
    const std::vector<double> opacities = sampledOpacities(curve, intervals + 1);
    double sum = 0.0, weightedSum = 0.0, before = 0.0;
    for (std::size_t i = 0; i <= intervals; ++i) {
        const double extinction = stepRatio * std::min(-std::log1p(-opacities[i]), largestExtinction);
        if (i > 0) {
            const double position = static_cast<double>(i);
            sum += 0.5 * (before + extinction);
            weightedSum += 0.5 * (before * (position - 1.0) + extinction * position);
        }
        m_extinction[i] = static_cast<float>(sum);
        m_weighted[i] = static_cast<float>(weightedSum);
        before = extinction;
    }
    m_extinction.back() = m_extinction[intervals];
    m_weighted.back() = m_weighted[intervals];
}

}  // namespace echolucent::ray_casting
