// The motion of probe and object in the window, frame by frame.
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "app/motion/motion_player.h"
#include "app/otf/shown_panes.h"
#include "app/picture/document_view.h"
#include "widgets/paced_words.h"
#include "widgets/threads/works.h"

namespace echolucent {

class MotionPanel;
class OtfCoursePanel;

/// Makes the document show each frame of the motion player, tells the player once a frame is on the screen with its
/// OTF, shows the course of the OTFs, and makes steps of what is chosen in the motion's panel. Knows no menu and no
/// dock.
class MotionFrames : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        Works& works;
        const PaneOtfs& otfs;
        ShownPanes& panes;
        DocumentView& view;
        VolumeViewWidget& picture;
        MotionPlayer& player;
        MotionPanel& panel;
        OtfCoursePanel& coursePanel;
    };
    explicit MotionFrames(const Parts& parts, QObject* parent = nullptr);

    /// Another study is open, whose document is about to begin.
    void setStudy(const Study& study);
    /// Its document has begun: the motion is at rest in its first frame.
    void beginAtRest();
    /// Steps by a phase (-1 or 1) through those that play, over and over; from another phase, to the nearest end of
    /// them in that order. What plays is paused.
    void stepPhase(int step);
    /// The player goes on once the picture of the present frame, made with the frame's OTF, is on the screen.
    void announceShownFrame();
    /// Back to the frame at angle 0.
    void rewind();
    /// The hand has moved the camera: the motion is over.
    void endByHand();

private:
    void connectPanel();
    void takeFromPanel(const MotionChoice& choice, const QString& what);
    void takeChoices();
    void takeAngle();
    void takePhase();
    void showFrame(double angle, int phase);
    void showFrameRate();
    void tellFrameRate();

    Parts m_parts;
    Works::UnderWay m_plays;
    QElapsedTimer m_frameClock;  ///< runs since the frame shown last
    double m_frameSeconds = 0;   ///< running mean; 0 before the first frame
    PacedWords m_frameRate{[this] { tellFrameRate(); }};
};

}  // namespace echolucent
