#include "app/motion/motion_player.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

MotionPlayer::MotionPlayer(QObject* parent) : QObject(parent) {
    m_interval.setSingleShot(true);
    m_interval.setTimerType(Qt::PreciseTimer);
    m_interval.setInterval(33);
    connect(&m_interval, &QTimer::timeout, this, &MotionPlayer::advanceIfReady);
}

void MotionPlayer::setMinimumFrameInterval(int milliseconds) { m_interval.setInterval(milliseconds); }

bool MotionPlayer::stepNow() {
    if (!m_playing || !m_frameShown) return false;
    m_interval.start();
    moveTo(movesProbe(m_scenario) ? nextAngle() : m_angle,
           movesObject(m_scenario) ? (m_phase + 1) % m_phaseCount : m_phase);
    return true;
}

void MotionPlayer::play() {
    if (m_playing) return;
    m_playing = true;
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
    const double inRange = std::clamp<double>(degrees, firstMotionAngle, lastMotionAngle);
    const int angle = static_cast<int>(std::lround(inRange));
    if (angle != m_angle) moveTo(angle, m_phase);
}

void MotionPlayer::stepBy(int degrees) { setAngle(m_angle + static_cast<double>(degrees)); }

void MotionPlayer::setScenario(MotionScenario scenario) { m_scenario = scenario; }

void MotionPlayer::setPhaseCount(int count) {
    Q_ASSERT(count >= 1);
    m_phaseCount = count;
    m_phase = 0;
}

void MotionPlayer::setPhase(int phase) {
    Q_ASSERT(phase >= 0 && phase < m_phaseCount);
    if (phase == m_phase) return;
    m_phase = phase;
    m_frameShown = false;
}

void MotionPlayer::setAxis(MotionAxis axis) {
    if (axis == m_axis) return;
    m_axis = axis;
    setAngle(0);
}

void MotionPlayer::setPingPong(bool pingPong) {
    m_pingPong = pingPong;
    if (!pingPong) m_direction = 1;
}

void MotionPlayer::frameShown() {
    m_frameShown = true;
    advanceIfReady();
}

void MotionPlayer::advanceIfReady() {
    if (!m_interval.isActive()) stepNow();
}

void MotionPlayer::moveTo(int angle, int phase) {
    m_angle = angle;
    m_phase = phase;
    m_frameShown = false;
    emit frameChanged(angle, phase);
}

int MotionPlayer::nextAngle() {
    if (m_pingPong) {
        if (m_angle >= lastMotionAngle) m_direction = -1;
        if (m_angle <= firstMotionAngle) m_direction = 1;
        return m_angle + m_direction;
    }
    return m_angle >= lastMotionAngle ? firstMotionAngle : m_angle + 1;
}

}  // namespace echolucent
