#include "tests/benchmarks_window/heartbeat.h"

#include <algorithm>
#include <ctime>

namespace echolucent::bench {

namespace {

double processorMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace

Heartbeat::Heartbeat(std::function<QStringList()> underWay) : m_underWay(std::move(underWay)) {
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Heartbeat::beat);
}

void Heartbeat::begin(const QString& action) {
    m_action = action;
    m_before = m_underWay();
    m_last = Clock::now();
    m_processor = processorMilliseconds();
    m_timer.start(1);
}

void Heartbeat::end() {
    beat();
    m_timer.stop();
}

void Heartbeat::beat() {
    const std::chrono::duration<double, std::milli> wall = Clock::now() - m_last;
    const double processor = processorMilliseconds() - m_processor;
    const QStringList now = m_underWay();
    QStringList meanwhile = m_before + now;
    meanwhile.removeDuplicates();
    if (meanwhile.isEmpty()) meanwhile << QStringLiteral("nothing");
    for (const QString& each : meanwhile) count(each, wall.count(), processor);
    m_before = now;
    m_processor = processorMilliseconds();
    m_last = Clock::now();
}

void Heartbeat::count(const QString& underWay, double milliseconds, double processorMilliseconds) {
    auto stall = std::ranges::find_if(
        m_stalls, [&](const Stall& each) { return each.action == m_action && each.underWay == underWay; });
    if (stall == m_stalls.end()) stall = m_stalls.insert(m_stalls.end(), Stall{m_action, underWay});
    if (milliseconds > stallLimit) ++stall->overLimit;
    if (milliseconds <= stall->milliseconds) return;
    stall->milliseconds = milliseconds;
    stall->processorMilliseconds = processorMilliseconds;
}

}  // namespace echolucent::bench
