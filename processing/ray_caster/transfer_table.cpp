#include "processing/ray_caster/transfer_table.h"

#include <algorithm>
#include <cmath>

namespace echolucent::ray_casting {

TransferTable::TransferTable(const OpacityCurve& curve, ColourMap colourMap, double stepRatio)
    : m_entries(intervals + 2), m_opaqueBefore(intervals + 3) {
    const std::vector<double> opacities = sampledOpacities(curve, intervals + 1);
    for (int i = 0; i <= intervals; ++i) {
        const double opacity = opacityForStep(opacities[static_cast<std::size_t>(i)], stepRatio);
        const Vec3 colour = colourOf(colourMap, static_cast<double>(i) / intervals) * opacity;
        m_entries[static_cast<std::size_t>(i)] = Float4{static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                                                        static_cast<float>(colour[2]), static_cast<float>(opacity)};
    }
    m_entries.back() = m_entries[intervals];
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        m_opaqueBefore[i + 1] = m_opaqueBefore[i] + (m_entries[i][3] > 0.0f ? 1 : 0);
}

bool TransferTable::transparentBetween(float lowest, float highest) const {
    const auto first = static_cast<std::size_t>(lowest);
    const auto last = static_cast<std::size_t>(std::ceil(highest));
    return m_opaqueBefore[last + 1] == m_opaqueBefore[first];
}

}  // namespace echolucent::ray_casting
