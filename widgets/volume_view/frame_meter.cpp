#include "widgets/volume_view/frame_meter.h"

#include <QEvent>
#include <QOpenGLWindow>
#include <utility>

namespace echolucent {

namespace {
constexpr double nanosecondsPerMillisecond = 1e6;
constexpr double longestInterval = 250.0;    // ms; after a longer one the hand had rested
constexpr double newestIntervalShare = 0.2;  // small, so that a person can read the number

double millisecondsSince(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) / nanosecondsPerMillisecond;
}
}  // namespace

FrameMeter::FrameMeter(QOpenGLWindow* window, QObject* parent) : QObject(parent), m_window(window) {
    window->installEventFilter(this);
    connect(window, &QOpenGLWindow::frameSwapped, this, &FrameMeter::swapped);
}

bool FrameMeter::eventFilter(QObject* watched, QEvent* event) {
    const bool draws = event->type() == QEvent::UpdateRequest || event->type() == QEvent::Expose;
    if (watched == m_window && draws) m_sinceUpdate.start();
    return false;
}

void FrameMeter::rendered(double milliseconds, bool followsHand) {
    m_rendered = milliseconds;
    m_followsHand = followsHand;
}

void FrameMeter::swapped() {
    const auto rendered = std::exchange(m_rendered, std::nullopt);
    if (!rendered || !m_sinceUpdate.isValid()) return;
    m_drawing = *rendered + millisecondsSince(m_sinceUpdate);
    learnInterval();
    emit pictureDrawn(m_drawing);
}

void FrameMeter::learnInterval() {
    if (!m_followsHand) return m_sincePicture.invalidate();
    const double interval = m_sincePicture.isValid() ? millisecondsSince(m_sincePicture) : longestInterval;
    m_sincePicture.start();
    if (interval >= longestInterval) {
        m_intervals = 0;
    } else {
        ++m_intervals;
        m_interval = m_intervals > 1 ? m_interval + newestIntervalShare * (interval - m_interval) : interval;
    }
}

std::optional<double> FrameMeter::framesPerSecond() const {
    if (m_interval > 0.0) return 1000.0 / m_interval;
    return std::nullopt;
}

}  // namespace echolucent
