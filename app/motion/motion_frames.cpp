#include "app/motion/motion_frames.h"

#include <QSignalBlocker>
#include <utility>

#include "widgets/motion/otf_course_panel.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

MotionFrames::MotionFrames(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_plays(parts.works, {}) {
    connectPanel();
    MotionPlayer& player = m_parts.player;
    connect(&player, &MotionPlayer::frameChanged, this, &MotionFrames::showFrame);
    connect(&player, &MotionPlayer::playingChanged, this, [this](bool playing) {
        m_plays.set(playing);
        m_parts.panel.setPlaying(playing);
        m_parts.picture.setPlaying(playing);
        m_parts.panes.setPlaying(playing);
        m_frameClock.invalidate();
        m_frameSeconds = 0;
        if (!playing) m_parts.panel.setFrameRate(std::nullopt);
    });
    connect(&m_parts.view, &DocumentView::cameraMoved, this, &MotionFrames::endByHand);
    connect(&m_parts.model, &DocumentModel::motionChanged, this, &MotionFrames::takeChoices);
    connect(&m_parts.model, &DocumentModel::motionAngleChanged, this, &MotionFrames::takeAngle);
    connect(&m_parts.model, &DocumentModel::phaseChanged, this, &MotionFrames::takePhase);
    connect(&m_parts.panes, &ShownPanes::courseChanged, &m_parts.coursePanel, &OtfCoursePanel::showCourse);
    // Another beam pauses the motion.
    connect(&m_parts.model, &DocumentModel::beamChanged, &player, &MotionPlayer::pause);
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
    // If the choice goes back to one OTF, that is the OTF of the view in which the motion began.
    if (choice.otf == MotionOtf::oneOtf && before != MotionOtf::oneOtf) next.scene.side = next.scene.pose.direction;
    m_parts.model.edit(next, what);
}

void MotionFrames::takeChoices() {
    const MotionChoice motion = m_parts.model.document().motion;
    m_parts.panel.setChoice(motion);
    if (const double angle = m_parts.model.document().scene.motionAngle; angle != m_parts.player.angle()) {
        // A step has set the frame too: another axis does not begin the motion anew.
        const QSignalBlocker quiet(m_parts.player);
        m_parts.player.setChoice(motion);
        m_parts.player.setAngle(angle);
    } else {
        m_parts.player.setChoice(motion);
    }
    m_parts.coursePanel.setMode(motion.otf);
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
    m_parts.player.setStudy(phases, study.phaseTimes);
    m_parts.panel.setStudy(phases, study.phaseTimes);
}

void MotionFrames::takePhase() {
    const int phase = phaseOf(m_parts.model.document(), firstPane);
    m_parts.panel.setPhase(phase);
    const Study* study = m_parts.openStudy.study();
    if (study != nullptr && phase < static_cast<int>(study->phases.size())) m_parts.player.setPhase(phase);
}

void MotionFrames::beginAtRest() {
    takeAngle();
    takeChoices();
    takePhase();
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

void MotionFrames::rewind() {
    m_parts.player.pause();
    m_parts.player.setAngle(0);
}

void MotionFrames::showFrame(double angle, int phase) {
    showFrameRate();
    m_parts.model.showFrame(angle, phase);
}

void MotionFrames::announceShownFrame() {
    if (m_parts.otfs.busy() || !m_parts.view.isCurrent()) return;
    // If another pane has the whole room, there is no 3D picture, and the motion goes on in that pane.
    const VolumeViewWidget& picture = m_parts.picture;
    if (picture.isVisible() && !(picture.pictureIsCurrent() && picture.pictureIsOnScreen())) return;
    m_parts.player.frameShown();
}

void MotionFrames::endByHand() { m_parts.player.pause(); }

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
        m_parts.panel.setFrameRate(1.0 / m_frameSeconds, {.frames = m_parts.picture.keptFrames(),
                                                          .quietPhases = m_parts.openStudy.quietPhases().madeCount(),
                                                          .otfs = static_cast<int>(m_parts.otfs.kept().count()),
                                                          .frameBytes = m_parts.picture.keptFrameBytes(),
                                                          .quietBytes = m_parts.openStudy.quietPhases().bytes(),
                                                          .otfBytes = m_parts.otfs.kept().bytes()});
}

}  // namespace echolucent
