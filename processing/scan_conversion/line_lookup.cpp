#include "processing/scan_conversion/line_lookup.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace echolucent {

namespace {
constexpr std::int64_t entriesPerLine = 16, fewestEntries = 4096, entriesPerPoll = 4096;
}

LineLookup::LineLookup(const PolarAxis& lines, const Progress& progress) {
    const bool angular = lines.spread == PolarSpread::angles;
    const auto [low, high] = std::minmax(lines.values.front(), lines.values.back());
    const double firstKey = angular ? std::tan(low / 2) : low, lastKey = angular ? std::tan(high / 2) : high;
    const auto count = std::max(fewestEntries, entriesPerLine * static_cast<std::int64_t>(lines.values.size()));
    const double step = (lastKey - firstKey) / static_cast<double>(count);
    for (std::int64_t i = 0; i <= count && !(i % entriesPerPoll == 0 && progress.cancelled()); ++i) {
        const double key = firstKey + step * static_cast<double>(i);
        const double value = std::clamp(angular ? 2 * std::atan(key) : key, low, high);
        m_indices.push_back(static_cast<float>(indexOnAxis(lines, value).value_or(0.0)));
    }
    m_indices.push_back(m_indices.empty() ? 0.0F : m_indices.back());
    m_firstKey = static_cast<float>(firstKey);
    m_entriesPerKey = static_cast<float>(1 / step);
    m_lastPlace = static_cast<float>(count);
}

}  // namespace echolucent
