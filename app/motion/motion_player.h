// Plays the motion of the probe, of the object, or of both: which frame comes next, and when.
#pragma once

#include <QObject>
#include <QTimer>

#include "processing/motion/motion_mode.h"

namespace echolucent {

/// A moving probe turns from firstMotionAngle to lastMotionAngle in steps of one degree; a moving object goes on by one
/// phase a frame, over and over. A step is taken only when the frame before has been shown and the minimum frame
/// interval is over, so playing never outruns the renderer.
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
    [[nodiscard]] double angle() const { return m_angle; }
    /// The phase of the 4D study, counted from 0.
    [[nodiscard]] int phase() const { return m_phase; }
    [[nodiscard]] MotionScenario scenario() const { return m_scenario; }
    [[nodiscard]] MotionAxis axis() const { return m_axis; }
    /// The least time between two steps, ms, 33 at first. At 0, steps follow each other as fast as frames are shown.
    void setMinimumFrameInterval(int milliseconds);

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
    void setScenario(echolucent::MotionScenario scenario);
    /// A study of `count` phases (>= 1) is shown from its first phase; emits nothing.
    void setPhaseCount(int count);
    /// Another phase is shown, by hand; emits nothing. Needs a phase of the study.
    void setPhase(int phase);
    /// Where another axis is chosen while the angle is not 0, the motion starts from its view again: emits frameChanged
    /// with angle 0.
    void setAxis(echolucent::MotionAxis axis);
    /// Whether the motion turns at its ends and shows them once; else it starts from the first angle again.
    void setPingPong(bool pingPong);
    /// The present frame is on the screen. To be called for every frame, played or scrubbed.
    void frameShown();

signals:
    /// Another frame is to be shown.
    void frameChanged(double degrees, int phase);
    void playingChanged(bool playing);

private:
    void advanceIfReady();
    void moveTo(int angle, int phase);
    [[nodiscard]] int nextAngle();

    QTimer m_interval;  // runs while the minimum frame interval is not over
    MotionAxis m_axis = MotionAxis::y;
    MotionScenario m_scenario = MotionScenario::probe;
    int m_angle = 0;
    int m_phase = 0;
    int m_phaseCount = 1;
    int m_direction = 1;
    bool m_playing = false;
    bool m_pingPong = true;
    bool m_frameShown = true;
};

}  // namespace echolucent
