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

/// Makes the document show each frame of the motion player. Tells the player once a frame is on the screen with its
/// OTF. Shows the course of the OTFs. Makes steps of choices in the motion panel. Knows no menu and no dock.
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

    /// Takes the phases of a study that was opened, and pauses the motion. Call beginAtRest() when its document begins.
    void setStudy(const Study& study);
    /// The document of the study has begun: the motion rests in its first frame.
    void beginAtRest();
    /// Pauses the motion and steps by a phase (-1 or 1) through those that play, in a loop. From a phase outside them,
    /// 1 goes to the first and -1 to the last.
    void stepPhase(int step);
    /// Lets the player go on once the picture of the present frame, made with the frame's OTF, is on the screen.
    void announceShownFrame();
    /// Pauses the motion and goes back to the frame at angle 0.
    void rewind();
    /// Pauses the motion, because the hand has moved the camera.
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
    QElapsedTimer m_frameClock;  ///< runs since the last frame
    double m_frameSeconds = 0;   ///< running mean; 0 before the first frame
    PacedWords m_frameRate{[this] { tellFrameRate(); }};
};

}  // namespace echolucent
