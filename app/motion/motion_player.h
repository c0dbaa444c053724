// Plays the motion of the probe, of the object, or of both: which frame comes next, and when.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "app/motion/frame_pacing.h"
#include "processing/motion/motion_choice.h"

namespace echolucent {

/// Frames follow each other as nextFrame() says, frameSeconds() apart (see FramePacing). A step is taken only when the
/// frame before has been shown, so playing never outruns the renderer and skips no frame: where frames take longer than
/// their time, the motion is slower than asked for.
///
///                 play()                        step: frameChanged(a, p)
///   [Paused] ---------------> [Frame shown, interval over] --------> [Waiting for frameShown() and the interval]
///       ^                                ^                                              |
///       |  pause() in any state          +----------- both have happened ---------------+
///
/// Scrubbing (setAngle, stepBy, setPhase) is possible in any state; playing goes on from there.
class MotionPlayer : public QObject {
    Q_OBJECT

public:
    explicit MotionPlayer(QObject* parent = nullptr);

    [[nodiscard]] bool isPlaying() const { return m_playing; }
    /// The angle in whole degrees from the view in which the motion began.
    [[nodiscard]] double angle() const { return m_position.angle; }
    /// The phase of the 4D study, counted from 0.
    [[nodiscard]] int phase() const { return m_position.phase; }
    [[nodiscard]] const MotionChoice& choice() const { return m_choice; }
    /// Steps follow each other this many milliseconds apart instead of frameSeconds(), which comes back where there is
    /// no value. At 0 they follow each other as fast as frames are shown.
    void setMinimumFrameInterval(std::optional<int> milliseconds);

    /// Takes the next step at once, without waiting for the interval. Returns false and takes none while paused, or
    /// while the present frame has not been shown.
    bool stepNow();

public slots:
    void play();
    void pause();
    void togglePlaying();
    /// Sets the angle, rounded to whole degrees and clamped into the range. Emits frameChanged where it differs.
    void setAngle(double degrees);
    /// Moves the angle on by this many degrees, clamped into the range.
    void stepBy(int degrees);
    /// What moves, in which order and how fast. Where another axis is chosen while the angle is not 0, the motion
    /// starts from its view again: emits frameChanged with angle 0.
    void setChoice(const echolucent::MotionChoice& choice);
    /// A study of `phases` phases (>= 1), phaseSeconds apart where that is known (above 0), is shown from its first
    /// phase on; emits nothing.
    void setStudy(int phases, std::optional<double> phaseSeconds);
    /// Another phase is shown, by hand; emits nothing. Needs a phase of the study.
    void setPhase(int phase);
    /// The present frame is on the screen. To be called for every frame, played or scrubbed.
    void frameShown();

signals:
    /// Another frame is to be shown.
    void frameChanged(double degrees, int phase);
    void playingChanged(bool playing);

private:
    [[nodiscard]] FramePacing::Time now() const { return FramePacing::Time(m_clock.nsecsElapsed()); }
    [[nodiscard]] FramePacing::Time interval() const;
    void waitForInterval();
    void advanceIfReady();
    void moveTo(const MotionPosition& position);

    QElapsedTimer m_clock;
    FramePacing m_pacing;
    QTimer m_interval;                     // runs while the interval is not over
    std::optional<int> m_minimumInterval;  // ms
    MotionChoice m_choice;
    MotionPosition m_position;
    int m_phases = 1;
    std::optional<double> m_phaseSeconds;
    bool m_playing = false;
    bool m_frameShown = true;
};

}  // namespace echolucent
