#include "app/main_window.h"
#include "widgets/motion/otf_course_panel.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

void MainWindow::connectMotion() {
    connectMotionPanel();
    connect(&m_motionPlayer, &MotionPlayer::playingChanged, this, [this](bool playing) {
        m_motionPanel->setPlaying(playing);
        m_frameClock.invalidate();
        m_frameSeconds = 0;
        if (!playing) m_motionPanel->setFrameRate(std::nullopt);
        updateIdle();
    });
    connect(&m_motionPlayer, &MotionPlayer::frameChanged, this, &MainWindow::showMotionFrame);
}

void MainWindow::connectMotionPanel() {
    connect(m_motionPanel, &MotionPanel::playRequested, this,
            [this](bool play) { play ? m_motionPlayer.play() : m_motionPlayer.pause(); });
    connect(m_motionPanel, &MotionPanel::angleChanged, &m_motionPlayer, &MotionPlayer::setAngle);
    connect(m_motionPanel, &MotionPanel::axisChanged, &m_motionPlayer, &MotionPlayer::setAxis);
    connect(m_motionPanel, &MotionPanel::scenarioChanged, &m_motionPlayer, &MotionPlayer::setScenario);
    connect(m_motionPanel, &MotionPanel::pingPongChanged, &m_motionPlayer, &MotionPlayer::setPingPong);
    connect(m_motionPanel, &MotionPanel::otfChanged, this, [this](MotionOtf otf) {
        m_coursePanel->setMode(otf);
        // Back to one OTF: the one of the view in which the motion began.
        computeFor(otf == MotionOtf::oneOtf ? m_motionStart : motionView());
    });
}

void MainWindow::beginMotionAtRest() {
    const int phases = static_cast<int>(m_session.study()->phases.size());
    m_motionPlayer.pause();
    m_motionPlayer.setPhaseCount(phases);
    m_motionPanel->setPhaseCount(phases);
    m_motionPlayer.setScenario(m_motionPanel->scenario());
    m_motionStart = m_otfView;
    m_frameWaits = false;
    m_motionPanel->setAngle(0);
    const QSignalBlocker quiet(m_motionPlayer);
    m_motionPlayer.setAngle(0);
}

Viewpoint MainWindow::motionView() const {
    return turned(m_motionStart, m_motionPlayer.axis(), m_motionPlayer.angle());
}

void MainWindow::showMotionFrame(double angle, int phase) {
    m_motionPanel->setAngle(angle);
    m_viewPanel->setPhase(phase);
    showFrameRate();
    if (!m_session.volume()) return;
    const bool sameVolume = phase == m_session.phase();
    if (!sameVolume) m_session.setPhase(phase);
    if (m_motionPanel->otf() == MotionOtf::oneOtf) {
        // Before the first OTF of a study nothing of it is shown: the frame comes with that OTF.
        m_frameWaits = true;
        if (m_shownOtf)
            showFrameWithItsOtf();
        else if (!sameVolume)
            computeFor(m_otfView);
    } else {
        // Under the hand the picture follows at once and its OTF after it; played, a frame is shown as a whole.
        if (!m_motionPlayer.isPlaying() && sameVolume) m_volumeView->setView(motionView());
        m_frameWaits = true;
        computeFor(motionView());
    }
    updateIdle();
}

/// A frame of a motion with one OTF, which is there already.
void MainWindow::showFrameWithItsOtf() {
    m_frameWaits = false;
    m_volumeView->setVolume(m_session.volume());
    m_volumeView->setView(motionView());
    keepCourseOf(m_shownOtf->config);
    m_course.addOneOtf(courseFrame(), m_shownOtf->curve);
    m_coursePanel->showCourse();
}

/// The player goes on once the picture of the present frame, made with the frame's OTF, is on the screen.
void MainWindow::announceShownFrame() {
    if (m_frameWaits || m_session.computingOtf() || !m_volumeView->pictureIsCurrent()) return;
    m_motionPlayer.frameShown();
}

CourseFrame MainWindow::courseFrame() const {
    return {.angle = static_cast<int>(m_motionPlayer.angle()),
            .phase = m_motionPlayer.phase(),
            .phases = static_cast<int>(m_session.study()->phases.size())};
}

void MainWindow::keepCourseOf(const AdaptiveOtfConfig& config) {
    const CourseFrame frame = courseFrame();
    const MotionScenario scenario = m_motionPanel->scenario();
    const auto rows = movesProbe(scenario) ? OtfCourse::Rows::angles : OtfCourse::Rows::phases;
    const int fixed = scenario == MotionScenario::both ? 0 : movesProbe(scenario) ? frame.phase : frame.angle;
    const CourseKey key{m_session.study(), m_motionStart, m_motionPlayer.axis(), config, rows, fixed};
    if (m_courseKey == key) return;
    m_courseKey = key;
    m_course.begin(rows, frame.phases);
}

SampledCurve MainWindow::curveToShow(const AdaptiveOtf& otf) {
    const MotionOtf mode = m_motionPanel->otf();
    keepCourseOf(otf.config);
    // An OTF of another view than the frame's (one OTF for a motion that has gone on) is no frame of the course.
    const bool ofFrame = otf.view == motionView();
    if (ofFrame) m_course.add(courseFrame(), otf.curve);
    if (mode == MotionOtf::oneOtf) m_course.addOneOtf(courseFrame(), otf.curve);
    m_coursePanel->showCourse();
    return ofFrame && mode != MotionOtf::oneOtf ? m_course.newest(mode) : otf.curve;
}

void MainWindow::cameraMovedByPerson() {
    // The motion starts from where the person left the camera.
    if (m_motionPlayer.isPlaying()) m_motionPlayer.pause();
    m_motionStart = m_volumeView->view();
    m_frameWaits = false;
    m_motionPanel->setAngle(0);
    const QSignalBlocker quiet(m_motionPlayer);
    m_motionPlayer.setAngle(0);
}

void MainWindow::showFrameRate() {
    if (!m_motionPlayer.isPlaying()) return;
    const double seconds = static_cast<double>(m_frameClock.isValid() ? m_frameClock.restart() : 0) * 1e-3;
    if (!m_frameClock.isValid()) m_frameClock.start();
    if (!(seconds > 0)) return;
    // A running mean over about ten frames, so that the number can be read.
    m_frameSeconds = m_frameSeconds > 0 ? 0.9 * m_frameSeconds + 0.1 * seconds : seconds;
    m_motionPanel->setFrameRate(1.0 / m_frameSeconds);
}

}  // namespace echolucent
