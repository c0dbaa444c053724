#include "widgets/volume_view/preview_quality.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace echolucent {

namespace {

struct Level {
    double reduction;  // of width and height
    double step;       // times the fine step
};
constexpr std::array<Level, 8> levels{{{1, 1}, {1, 1.5}, {1.5, 1.5}, {2, 2}, {3, 2}, {4, 2.5}, {6, 3}, {8, 4}}};
constexpr double newestShare = 0.5;    // of the newest measure in the learnt cost
constexpr double shareToRefine = 0.7;  // of the budget that the next finer level must keep within

double samplesOf(const RayCastSettings& settings) {
    return static_cast<double>(settings.width) * settings.height / settings.step;
}

double samplesAt(const Level& level, const RayCastSettings& fine) {
    return samplesOf(fine) / (level.reduction * level.reduction * level.step);
}

}  // namespace

void PreviewQuality::measured(const RayCastSettings& settings, double milliseconds) {
    const double cost = milliseconds / samplesOf(settings);
    m_costPerSample = m_costPerSample > 0.0 ? m_costPerSample + newestShare * (cost - m_costPerSample) : cost;
}

RayCastSettings PreviewQuality::coarse(const RayCastSettings& fine) {
    if (m_costPerSample > 0.0) {
        const auto cost = [&](std::size_t level) { return m_costPerSample * samplesAt(levels[level], fine); };
        while (m_level + 1 < levels.size() && cost(m_level) > m_budget) ++m_level;
        while (m_level > 0 && cost(m_level - 1) <= shareToRefine * m_budget) --m_level;
    }
    const Level& level = levels[m_level];
    RayCastSettings coarse = fine;
    coarse.width = std::max(1, static_cast<int>(std::lround(fine.width / level.reduction)));
    coarse.height = std::max(1, static_cast<int>(std::lround(fine.height / level.reduction)));
    coarse.step = fine.step * level.step;
    return coarse;
}

}  // namespace echolucent
