#include "tests/benchmarks_window/measures.h"

#include <QThread>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace echolucent::bench {

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    const auto place = std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

void Stopwatch::start() {
    m_wall.start();
    m_processor = std::clock();
}

double Stopwatch::milliseconds() const { return static_cast<double>(m_wall.nsecsElapsed()) * 1e-6; }

double Stopwatch::processorShare() const {
    const double seconds = static_cast<double>(std::clock() - m_processor) / CLOCKS_PER_SEC;
    return seconds / (milliseconds() * 1e-3 * QThread::idealThreadCount());
}

void FrameRecord::begin() {
    m_reports.clear();
    m_drawn.clear();
    m_clock.start();
}

void FrameRecord::summarise(Row& row) const {
    row.processorShare = m_clock.processorShare();
    row.frames = drawnFrames();
    const double seconds = m_clock.milliseconds() * 1e-3;
    row.deliveredPerSecond = static_cast<double>(m_reports.size()) / seconds;
    row.framesPerSecond = row.frames / seconds;
    std::vector<double> intervals, casts, draws;
    for (std::size_t i = 1; i < m_drawn.size(); ++i) intervals.push_back(m_drawn[i] - m_drawn[i - 1]);
    std::map<std::tuple<int, int, double>, int> pictures;
    for (const PictureReport& report : m_reports) {
        casts.push_back(report.castMilliseconds);
        draws.push_back(report.drawMilliseconds);
        ++pictures[{report.rays.width(), report.rays.height(), report.step}];
    }
    row.medianInterval = quantile(intervals, 0.5);
    row.interval95 = quantile(intervals, 0.95);
    row.castMilliseconds = quantile(casts, 0.5);
    row.drawMilliseconds = quantile(draws, 0.5);
    const auto most = std::max_element(pictures.begin(), pictures.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == pictures.end()) return;
    const auto& [width, height, step] = most->first;
    row.rays = {width, height};
    row.step = step;
    row.qualityShare = static_cast<double>(most->second) / static_cast<double>(m_reports.size());
    for (const PictureReport& report : m_reports)
        if (report.rays == row.rays && report.step == step) row.quality = report.quality;
}

}  // namespace echolucent::bench
