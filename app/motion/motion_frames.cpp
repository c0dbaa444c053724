#include "app/motion/motion_frames.h"

#include <QSignalBlocker>

#include "widgets/motion/otf_course_panel.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

MotionFrames::MotionFrames(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connectPanel();
    MotionPlayer& player = m_parts.player;
    connect(&player, &MotionPlayer::frameChanged, this, &MotionFrames::showFrame);
    connect(&player, &MotionPlayer::playingChanged, this, [this](bool playing) {
        m_parts.panel.setPlaying(playing);
        m_parts.picture.setPlaying(playing);
        m_frameClock.invalidate();
        m_frameSeconds = 0;
        if (!playing) m_parts.panel.setFrameRate(std::nullopt);
    });
    connect(&m_parts.view, &DocumentView::cameraMoved, this, &MotionFrames::endByHand);
    connect(&m_parts.model, &DocumentModel::motionChanged, this, &MotionFrames::takeChoices);
    connect(&m_parts.model, &DocumentModel::motionAngleChanged, this, &MotionFrames::takeAngle);
    // Along another beam the motion is begun anew.
    connect(&m_parts.model, &DocumentModel::beamChanged, &player, &MotionPlayer::pause);
    // After the OTF has followed what else the same step changed: the view of the frame is asked for last.
    connect(&m_parts.model, &DocumentModel::changed, this, &MotionFrames::takeMode);
    takeChoices();
}

void MotionFrames::connectPanel() {
    const MotionPanel* panel = &m_parts.panel;
    connect(panel, &MotionPanel::playRequested, this,
            [this](bool play) { play ? m_parts.player.play() : m_parts.player.pause(); });
    connect(panel, &MotionPanel::angleChanged, &m_parts.player, &MotionPlayer::setAngle);
    connect(panel, &MotionPanel::axisChanged, this, [this](MotionAxis axis) {
        editMotion(tr("axis of the motion"), [axis](Document& next) { next.motion.axis = axis; });
    });
    connect(panel, &MotionPanel::scenarioChanged, this, [this](MotionScenario scenario) {
        editMotion(tr("what moves"), [scenario](Document& next) { next.motion.scenario = scenario; });
    });
    connect(panel, &MotionPanel::pingPongChanged, this, [this](bool pingPong) {
        editMotion(tr("order of the motion"), [pingPong](Document& next) { next.motion.pingPong = pingPong; });
    });
    connect(panel, &MotionPanel::otfChanged, this, [this](MotionOtf otf) {
        editMotion(tr("OTF of the motion"), [this, otf](Document& next) {
            next.motion.otf = otf;
            // Back to one OTF: the one of the view in which the motion began.
            if (otf == MotionOtf::oneOtf) next.method.direction = poseOf(next, m_parts.view.view()).direction;
        });
    });
}

void MotionFrames::editMotion(const QString& what, const std::function<void(Document&)>& change) {
    Document next = m_parts.model.document();
    change(next);
    m_parts.model.edit(next, what);
}

void MotionFrames::takeChoices() {
    const MotionChoice motion = m_parts.model.document().motion;
    m_parts.panel.setAxis(motion.axis);
    m_parts.panel.setScenario(motion.scenario);
    m_parts.panel.setPingPong(motion.pingPong);
    m_parts.panel.setOtf(motion.otf);
    m_parts.player.setScenario(motion.scenario);
    m_parts.player.setPingPong(motion.pingPong);
    m_parts.player.setAxis(motion.axis);
    m_parts.coursePanel.setMode(motion.otf);
}

void MotionFrames::takeMode() {
    if (std::exchange(m_mode, mode()) == mode()) return;
    const bool oneOtf = mode() == MotionOtf::oneOtf;
    m_parts.computing.computeFor(oneOtf ? otfViewpointOf(m_parts.model.document(), m_parts.view.view()) : frameView());
}

void MotionFrames::takeAngle() {
    const double angle = m_parts.model.document().motionAngle;
    m_parts.panel.setAngle(angle);
    if (angle == m_parts.player.angle()) return;
    const QSignalBlocker quiet(m_parts.player);
    m_parts.player.setAngle(angle);
}

void MotionFrames::beginAtRest(int phases) {
    m_parts.player.pause();
    m_parts.player.setPhaseCount(phases);
    m_parts.panel.setPhaseCount(phases);
    m_otf.reset();
    m_courseKey.reset();
    m_frameWaits = false;
    takeAngle();
    takeChoices();
}

Viewpoint MotionFrames::frameView() const { return viewpointOf(m_parts.model.document(), m_parts.view.view()); }

void MotionFrames::rewind() {
    m_parts.player.pause();
    m_parts.player.setAngle(0);
}

void MotionFrames::showFrame(double angle, int phase) {
    m_parts.model.showMotionAngle(angle);
    showFrameRate();
    if (!m_parts.session.volume()) return;
    const bool sameVolume = phase == m_parts.session.phase();
    // Another phase cancels what is being computed, which is then asked for again.
    const bool overtaken = !sameVolume && m_parts.session.computingOtf();
    m_parts.model.showPhase(m_parts.view.view(), phase);
    m_frameWaits = true;
    if (mode() == MotionOtf::oneOtf) {
        // Where there is no OTF the frame comes with the one that is computed, or with the failure to compute it.
        if (m_otf && !overtaken)
            showFrameWithItsOtf();
        else if (!sameVolume || !m_parts.session.computingOtf())
            m_parts.computing.computeAgain();
    } else {
        // Under the hand the picture follows at once and its OTF after it; played, a frame is shown as a whole.
        if (!m_parts.player.isPlaying() && sameVolume) m_parts.view.showPose();
        m_parts.computing.computeFor(frameView());
    }
}

/// A frame of a motion with one OTF, which is there already.
void MotionFrames::showFrameWithItsOtf() {
    m_frameWaits = false;
    m_parts.view.showVolume(m_parts.session.newestVoxels(), m_parts.session.volume());
    keepCourseOf(m_otf->config);
    m_parts.course.addOneOtf(courseFrame(), m_otf->curve);
    m_parts.coursePanel.showCourse();
}

void MotionFrames::showWaitingFrame() {
    if (std::exchange(m_frameWaits, false)) m_parts.view.showPose();
}

void MotionFrames::announceShownFrame() {
    if (m_frameWaits || m_parts.session.computingOtf()) return;
    // Where another pane has the whole room, no picture is made, and the motion goes on in that pane.
    if (m_parts.picture.isVisible() && !m_parts.picture.pictureIsCurrent()) return;
    m_parts.player.frameShown();
}

CourseFrame MotionFrames::courseFrame() const {
    return {.angle = static_cast<int>(m_parts.player.angle()),
            .phase = m_parts.player.phase(),
            .phases = static_cast<int>(m_parts.session.study()->phases.size())};
}

void MotionFrames::keepCourseOf(const AdaptiveOtfConfig& config) {
    const Document& document = m_parts.model.document();
    const int view = m_parts.view.view();
    Viewpoint start =
        viewpointOf(document.beam.axis, poseOf(document, view).direction, cutOf(document, view).nearCutMm);
    start.cutSurface = cutOf(document, view).surface;
    start.box = viewpointOf(document, view).box;
    const CourseFrame frame = courseFrame();
    const MotionScenario scenario = document.motion.scenario;
    const auto rows = movesProbe(scenario) ? OtfCourse::Rows::angles : OtfCourse::Rows::phases;
    const int fixed = scenario == MotionScenario::both ? 0 : movesProbe(scenario) ? frame.phase : frame.angle;
    const CourseKey key{start, strokesOf(document, view), document.motion.axis, config, rows, fixed};
    if (m_courseKey == key) return;
    m_courseKey = key;
    m_parts.session.forgetKeptOtfs();
    m_parts.course.begin(rows, frame.phases);
}

SampledCurve MotionFrames::curveToShow(std::shared_ptr<const AdaptiveOtf> otf) {
    m_otf = std::move(otf);
    keepCourseOf(m_otf->config);
    // An OTF of another view than the frame's (one OTF for a motion that has gone on) is no frame of the course.
    const bool ofFrame = m_otf->view == frameView();
    if (ofFrame) m_parts.course.add(courseFrame(), m_otf->curve);
    if (mode() == MotionOtf::oneOtf) m_parts.course.addOneOtf(courseFrame(), m_otf->curve);
    m_parts.coursePanel.showCourse();
    return ofFrame && mode() != MotionOtf::oneOtf ? m_parts.course.newest(mode()) : m_otf->curve;
}

void MotionFrames::endByHand() {
    m_parts.player.pause();
    m_frameWaits = false;
}

void MotionFrames::showFrameRate() {
    if (!m_parts.player.isPlaying()) return;
    const double seconds = static_cast<double>(m_frameClock.isValid() ? m_frameClock.restart() : 0) * 1e-3;
    if (!m_frameClock.isValid()) m_frameClock.start();
    if (!(seconds > 0)) return;
    // A running mean over about ten frames, so that the number can be read.
    m_frameSeconds = m_frameSeconds > 0 ? 0.9 * m_frameSeconds + 0.1 * seconds : seconds;
    m_frameRate.tell();
}

void MotionFrames::tellFrameRate() {
    if (m_parts.player.isPlaying() && m_frameSeconds > 0)
        m_parts.panel.setFrameRate(1.0 / m_frameSeconds, m_parts.picture.keptFrames());
}

}  // namespace echolucent
