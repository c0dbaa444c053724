#include "processing/ray_caster/packed/transfer_table.h"

#include <algorithm>
#include <cmath>

namespace echolucent::ray_casting {

namespace {

ColourRanges rangesOf(ColourMap map) {
    ColourRanges ranges{};
    constexpr double width = static_cast<double>(TransferTable::intervals) / ColourRanges::count;
    for (std::size_t range = 0; range < ColourRanges::count; ++range) {
        const Vec3 first = colourOf(map, static_cast<double>(range) / ColourRanges::count);
        const Vec3 last = colourOf(map, static_cast<double>(range + 1) / ColourRanges::count);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int c = static_cast<int>(channel);
            const double slope = (last[c] - first[c]) / width;
            ranges.slope[channel][range] = static_cast<float>(slope);
            ranges.base[channel][range] = static_cast<float>(first[c] - slope * width * static_cast<double>(range));
        }
    }
    return ranges;
}

}  // namespace

ColourBends::ColourBends(ColourMap colourMap) {
    const auto channelAt = [&](std::size_t channel, int range) {
        return colourOf(colourMap, static_cast<double>(range) / ColourRanges::count)[static_cast<int>(channel)];
    };
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto slopeOf = [&](int range) {
            return (channelAt(channel, range + 1) - channelAt(channel, range)) * ColourRanges::count;
        };
        for (int bend = 0; bend < count; ++bend) {
            const double by = slopeOf(bend + 1) - slopeOf(bend);
            change[channel][static_cast<std::size_t>(bend)] = static_cast<float>(by);
            any = any || std::abs(by) > 1e-9;
        }
        base[channel] = static_cast<float>(channelAt(channel, 0));
        slope[channel] = static_cast<float>(slopeOf(0));
    }
}

TransferTable::TransferTable(const OpacityCurve& curve, ColourMap colourMap, double stepRatio)
    : m_opacities(intervals + 2),
      m_extinctions(intervals + 2),
      m_visibleBefore(intervals + 2),
      m_colours(rangesOf(colourMap)) {
    const std::vector<double> opacities = sampledOpacities(curve, intervals + 1);
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        const double opacity = stepRatio == 1.0 ? opacities[i] : opacityForStep(opacities[i], stepRatio);
        m_opacities[i] = static_cast<float>(opacity);
        m_extinctions[i] = static_cast<float>(std::min(-stepRatio * std::log1p(-opacities[i]), mostExtinction));
        m_visibleBefore[i + 1] = m_visibleBefore[i] + (opacities[i] > negligible ? 1 : 0);
    }
    const auto visible =
        std::find_if(m_opacities.begin(), m_opacities.end(), [](float opacity) { return opacity > 0.0f; });
    m_firstVisible = static_cast<float>(visible - m_opacities.begin()) - 1.0f;
    m_opacities.back() = m_opacities[intervals];
    m_extinctions.back() = m_extinctions[intervals];
}

bool TransferTable::transparentBetween(float lowest, float highest) const {
    const auto first = static_cast<std::size_t>(lowest);
    const auto last = static_cast<std::size_t>(std::ceil(highest));
    return m_visibleBefore[last + 1] == m_visibleBefore[first];
}

ByteOpacities::ByteOpacities(const TransferTable& table, double toTable) : m_opacities(255 * perLevel + 1) {
    for (std::size_t i = 0; i < m_opacities.size(); ++i) {
        const double position =
            std::min(static_cast<double>(i) / perLevel * toTable, static_cast<double>(TransferTable::intervals));
        const auto left = static_cast<std::size_t>(position);
        const auto share = static_cast<float>(position - static_cast<double>(left));
        const float* const entry = table.opacities() + left;
        m_opacities[i] = entry[0] + (entry[1] - entry[0]) * share;
    }
    const auto visible =
        std::find_if(m_opacities.begin(), m_opacities.end(), [](float opacity) { return opacity > 0.0f; });
    // The nearest entry counts.
    m_firstVisible = static_cast<float>(visible - m_opacities.begin()) - 0.51f;
}

}  // namespace echolucent::ray_casting
