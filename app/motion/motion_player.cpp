#include "app/motion/motion_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace echolucent {

MotionPlayer::MotionPlayer(QObject* parent) : QObject(parent) {
    m_clock.start();
    m_interval.setSingleShot(true);
    m_interval.setTimerType(Qt::PreciseTimer);
    connect(&m_interval, &QTimer::timeout, this, &MotionPlayer::advanceIfReady);
}

void MotionPlayer::setMinimumFrameInterval(std::optional<int> milliseconds) {
    m_minimumInterval = milliseconds;
    if (m_interval.isActive()) waitForInterval();
}

FramePacing::Time MotionPlayer::interval() const {
    if (m_minimumInterval) return std::chrono::milliseconds(*m_minimumInterval);
    const int next = nextFrame(m_position, m_choice, m_phases).phase;
    return std::chrono::round<FramePacing::Time>(
        std::chrono::duration<double>(frameSeconds(m_choice, m_times, m_position.phase, next)));
}

void MotionPlayer::waitForInterval() {
    m_interval.start(std::chrono::round<std::chrono::milliseconds>(m_pacing.wait(now(), interval())));
}

bool MotionPlayer::stepNow() {
    if (!m_playing || !m_frameShown) return false;
    m_pacing.begin(now(), interval());
    m_position = nextFrame(m_position, m_choice, m_phases);
    waitForInterval();
    moveTo(m_position);
    return true;
}

void MotionPlayer::play() {
    if (m_playing) return;
    m_playing = true;
    m_pacing.resume(now(), interval());
    emit playingChanged(true);
    advanceIfReady();
}

void MotionPlayer::pause() {
    if (!m_playing) return;
    m_playing = false;
    emit playingChanged(false);
}

void MotionPlayer::togglePlaying() { m_playing ? pause() : play(); }

void MotionPlayer::setAngle(double degrees) {
    if (!std::isfinite(degrees)) return;
    MotionPosition next = m_position;
    next.angle = static_cast<int>(std::lround(std::clamp<double>(degrees, firstMotionAngle, lastMotionAngle)));
    if (next != m_position) moveTo(next);
}

void MotionPlayer::stepBy(int degrees) { setAngle(m_position.angle + static_cast<double>(degrees)); }

void MotionPlayer::setChoice(const MotionChoice& choice) {
    const MotionChoice before = std::exchange(m_choice, choice);
    if (m_interval.isActive()) waitForInterval();
    if (choice.axis != before.axis) setAngle(0);
}

void MotionPlayer::setStudy(int phases, const PhaseTimes& times) {
    Q_ASSERT(phases >= 1);
    m_phases = phases;
    m_times = times;
    m_position.phase = 0;
    m_position.phaseBack = false;
}

void MotionPlayer::setPhase(int phase) {
    Q_ASSERT(phase >= 0 && phase < m_phases);
    if (phase == m_position.phase) return;
    m_position.phase = phase;
    m_frameShown = false;
}

void MotionPlayer::frameShown() {
    m_frameShown = true;
    advanceIfReady();
}

void MotionPlayer::advanceIfReady() {
    if (!m_interval.isActive()) stepNow();
}

void MotionPlayer::moveTo(const MotionPosition& position) {
    m_position = position;
    m_frameShown = false;
    emit frameChanged(position.angle, position.phase);
}

}  // namespace echolucent
