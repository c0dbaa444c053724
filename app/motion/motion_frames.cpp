#include "app/motion/motion_frames.h"

#include <QSignalBlocker>
#include <utility>

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
    connect(&m_parts.model, &DocumentModel::phaseChanged, this,
            [this] { m_parts.panel.setPhase(phaseOf(m_parts.model.document(), firstPane)); });
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
    connect(panel, &MotionPanel::phaseChanged, this, [this](int phase) { m_parts.model.showPhase(phase); });
    connect(panel, &MotionPanel::choiceChanged, this, &MotionFrames::takeFromPanel);
}

void MotionFrames::takeFromPanel(const MotionChoice& choice, const QString& what) {
    Document next = m_parts.model.document();
    const MotionOtf before = std::exchange(next.motion, choice).otf;
    // Back to one OTF: the one of the view in which the motion began.
    if (choice.otf == MotionOtf::oneOtf && before != MotionOtf::oneOtf) next.scene.side = next.scene.pose.direction;
    m_parts.model.edit(next, what, m_parts.hand.current());
}

void MotionFrames::takeChoices() {
    const MotionChoice motion = m_parts.model.document().motion;
    m_parts.panel.setChoice(motion);
    m_parts.player.setChoice(motion);
    m_parts.coursePanel.setMode(motion.otf);
}

void MotionFrames::takeMode() {
    if (std::exchange(m_mode, mode()) == mode()) return;
    const bool oneOtf = mode() == MotionOtf::oneOtf;
    m_parts.computing.computeFor(oneOtf ? otfViewpointOf(m_parts.model.document(), firstPane) : frameView());
}

void MotionFrames::takeAngle() {
    const double angle = m_parts.model.document().scene.motionAngle;
    m_parts.panel.setAngle(angle);
    if (angle == m_parts.player.angle()) return;
    const QSignalBlocker quiet(m_parts.player);
    m_parts.player.setAngle(angle);
}

void MotionFrames::setStudy(const Study& study) {
    const int phases = static_cast<int>(study.phases.size());
    m_parts.player.pause();
    m_parts.player.setStudy(phases, study.phaseSeconds);
    m_parts.panel.setStudy(phases, study.phaseSeconds);
}

void MotionFrames::beginAtRest() {
    m_otf.reset();
    m_courseKey.reset();
    m_frameWaits = false;
    takeAngle();
    takeChoices();
    m_parts.panel.setPhase(phaseOf(m_parts.model.document(), firstPane));
}

void MotionFrames::stepPhase(int step) {
    const Study* study = m_parts.openStudy.study();
    if (study == nullptr) return;
    m_parts.player.pause();
    const Document& document = m_parts.model.document();
    const PhaseRange played = playedPhases(document.motion, static_cast<int>(study->phases.size()));
    const int phase = phaseOf(document, firstPane), count = played.last - played.first + 1;
    const bool outside = phase < played.first || phase > played.last;
    const int next = !outside   ? played.first + (phase - played.first + step + count) % count
                     : step > 0 ? played.first
                                : played.last;
    m_parts.model.showPhase(next);
}

Viewpoint MotionFrames::frameView() const { return viewpointOf(m_parts.model.document()); }

void MotionFrames::rewind() {
    m_parts.player.pause();
    m_parts.player.setAngle(0);
}

void MotionFrames::showFrame(double angle, int phase) {
    m_parts.model.showMotionAngle(angle);
    showFrameRate();
    if (!m_parts.openStudy.volume()) return;
    const bool sameVolume = phase == m_parts.openStudy.phase();
    m_parts.model.showPhase(phase);
    if (mode() == MotionOtf::oneOtf) {
        showWithOneOtf();
    } else {
        m_frameWaits = true;
        // Under the hand the picture follows at once and its OTF after it; played, a frame is shown as a whole.
        if (!m_parts.player.isPlaying() && sameVolume) m_parts.view.showPose();
        m_parts.computing.computeFor(frameView());
    }
}

void MotionFrames::showWithOneOtf() {
    m_frameWaits = true;
    // Else the frame comes with the OTF that is under way, or with the failure to compute it.
    if (m_parts.openStudy.otfUnderWay()) return;
    m_parts.openStudy.otf() ? showFrameWithItsOtf() : m_parts.computing.computeAgain();
}

/// A frame of a motion with one OTF, which is there already.
void MotionFrames::showFrameWithItsOtf() {
    m_frameWaits = false;
    m_parts.view.showVolume(m_parts.openStudy.newestVoxels(), m_parts.openStudy.volume());
    keepCourseOf(m_otf->config);
    m_parts.course.addOneOtf(courseFrame(), m_otf->curve);
    m_parts.coursePanel.showCourse();
}

void MotionFrames::showWaitingFrame() {
    if (std::exchange(m_frameWaits, false)) m_parts.view.showPose();
}

void MotionFrames::announceShownFrame() {
    if (m_frameWaits || m_parts.openStudy.computingOtf() || m_parts.designs.busy()) return;
    // Where another pane has the whole room, no picture is made, and the motion goes on in that pane.
    const VolumeViewWidget& picture = m_parts.picture;
    if (picture.isVisible() && !(picture.pictureIsCurrent() && picture.pictureIsOnScreen())) return;
    m_parts.player.frameShown();
}

CourseFrame MotionFrames::courseFrame() const {
    return {.angle = static_cast<int>(m_parts.player.angle()),
            .phase = m_parts.player.phase(),
            .phases = static_cast<int>(m_parts.openStudy.study()->phases.size())};
}

void MotionFrames::keepCourseOf(const AdaptiveOtfConfig& config) {
    const CourseFrame frame = courseFrame();
    const CourseKey key = courseKeyOf(m_parts.model.document(), config, frame);
    if (m_courseKey == key) return;
    m_courseKey = key;
    m_parts.openStudy.forgetKeptOtfs();
    m_parts.course.begin(key.rows, frame.phases);
}

SampledCurve MotionFrames::curveToShow(std::shared_ptr<const AdaptiveOtf> otf) {
    m_otf = std::move(otf);
    keepCourseOf(m_otf->config);
    // An OTF of another view or phase than the frame's (one OTF for a motion that has gone on) is no frame of the
    // course.
    const bool ofFrame = m_otf->view == frameView() && m_parts.openStudy.phaseOfOtf() == m_parts.player.phase();
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
        m_parts.panel.setFrameRate(1.0 / m_frameSeconds,
                                   {.frames = m_parts.picture.keptFrames(),
                                    .quietPhases = m_parts.openStudy.quietPhases().madeCount(),
                                    .otfs = static_cast<int>(m_parts.openStudy.keptOtfs().count()),
                                    .frameBytes = m_parts.picture.keptFrameBytes(),
                                    .quietBytes = m_parts.openStudy.quietPhases().bytes(),
                                    .otfBytes = m_parts.openStudy.keptOtfs().bytes()});
}

}  // namespace echolucent
