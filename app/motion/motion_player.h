// Plays the motion of the probe, of the object, or of both: decides which frame comes next, and when.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>

#include "app/motion/frame_pacing.h"
#include "processing/motion/motion_choice.h"

namespace echolucent {

/// nextFrame() gives the order of frames, frameSeconds() the interval after each (see FramePacing). A step needs the
/// frame before it on the screen. So playing never outruns the renderer and skips no frame. If frames take longer than
/// their interval, the motion is slower than asked for.
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
    /// How long the present frame is shown before the next one.
    [[nodiscard]] FramePacing::Time interval() const;
    /// Sets the interval between steps in milliseconds, in place of frameSeconds(). No value brings frameSeconds()
    /// back. At 0 each step follows as soon as the frame before is shown.
    void setMinimumFrameInterval(std::optional<int> milliseconds);

    /// Takes the next step at once, without waiting for the interval. Returns false and takes no step if paused, or if
    /// the present frame is not on the screen yet.
    bool stepNow();

public slots:
    void play();
    void pause();
    void togglePlaying();
    /// Sets the angle, rounded to whole degrees and clamped into the range. Emits frameChanged if it differs. Ignores a
    /// number that is not finite.
    void setAngle(double degrees);
    /// Moves the angle on by this many degrees, clamped into the range.
    void stepBy(int degrees);
    /// Sets what moves, in which order and how fast. If the axis changes while the angle is not 0, the motion starts
    /// from its view again: emits frameChanged with angle 0.
    void setChoice(const echolucent::MotionChoice& choice);
    /// Takes the phases of another study and begins at its first phase; emits nothing. The study has `phases` phases
    /// (>= 1).
    void setStudy(int phases, const PhaseTimes& times);
    /// The hand shows another phase of the study; emits nothing.
    void setPhase(int phase);
    /// The present frame is on the screen. Call this for every frame, played or scrubbed.
    void frameShown();

signals:
    /// Another frame must be shown.
    void frameChanged(double degrees, int phase);
    void playingChanged(bool playing);

private:
    [[nodiscard]] FramePacing::Time now() const { return FramePacing::Time(m_clock.nsecsElapsed()); }
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
    PhaseTimes m_times;
    bool m_playing = false;
    bool m_frameShown = true;
};

}  // namespace echolucent
