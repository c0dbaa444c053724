#include "processing/ray_caster/pre_integration.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace echolucent::ray_casting {

PreIntegration::PreIntegration(const OpacityCurve& curve, ColourMap colourMap, double stepRatio)
    : m_integrals(static_cast<std::size_t>(intervals + 2) * 4) {
    const std::vector<double> opacities = sampledOpacities(curve, intervals + 1);
    std::array<double, 4> sum{}, before{};
    for (std::size_t i = 0; i <= intervals; ++i) {
        const double extinction = stepRatio * std::min(-std::log1p(-opacities[i]), largestExtinction);
        const Vec3 colour = colourOf(colourMap, static_cast<double>(i) / intervals);
        const std::array<double, 4> here{extinction * colour[0], extinction * colour[1], extinction * colour[2],
                                         extinction};
        for (std::size_t c = 0; c < 4; ++c) {
            if (i > 0) sum[c] += 0.5 * (before[c] + here[c]);
            m_integrals[i * 4 + c] = static_cast<float>(sum[c]);
        }
        before = here;
    }
    std::copy_n(m_integrals.end() - 8, 4, m_integrals.end() - 4);
}

}  // namespace echolucent::ray_casting
