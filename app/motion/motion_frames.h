// The motion of probe and object in the window, frame by frame.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <memory>
#include <optional>

#include "app/document/document_view.h"
#include "app/motion/course_key.h"
#include "app/motion/motion_player.h"
#include "app/otf/otf_computing.h"
#include "app/otf/view_designs.h"
#include "widgets/motion/otf_course.h"
#include "widgets/paced_words.h"

namespace echolucent {

class MotionPanel;
class OtfCoursePanel;

/// Shows each frame of the motion player with its OTF, keeps the course of the OTFs, and makes steps of what is chosen
/// in the motion's panel. Knows no menu and no dock.
class MotionFrames : public QObject {
    Q_OBJECT

public:
    struct Parts {
        DocumentModel& model;
        OpenStudy& openStudy;
        OtfComputing& computing;
        const ViewDesigns& designs;
        DocumentView& view;
        VolumeViewWidget& picture;
        MotionPlayer& player;
        OtfCourse& course;
        MotionPanel& panel;
        OtfCoursePanel& coursePanel;
        HandGesture& hand;
    };
    explicit MotionFrames(const Parts& parts, QObject* parent = nullptr);

    /// Another study is open, whose document is about to begin.
    void setStudy(const Study& study);
    /// Its document has begun: the motion is at rest in its first frame.
    void beginAtRest();
    /// Steps by a phase (-1 or 1) through those that play, over and over; from another phase, to the nearest end of
    /// them in that order. What plays is paused.
    void stepPhase(int step);
    /// Another phase is shown by hand, with the one OTF of the motion.
    void showWithOneOtf();
    /// Takes an OTF that was computed just now, and returns the curve that the present frame shows of it.
    [[nodiscard]] SampledCurve curveToShow(std::shared_ptr<const AdaptiveOtf> otf);
    /// Made the adaptive curve that is shown; null before a study's first.
    [[nodiscard]] const AdaptiveOtf* otf() const { return m_otf.get(); }
    /// The curve is in place: a frame that waited for it is shown.
    void showWaitingFrame();
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
    void takeMode();
    void takeAngle();
    void showFrame(double angle, int phase);
    void showFrameWithItsOtf();
    void showFrameRate();
    void tellFrameRate();
    [[nodiscard]] MotionOtf mode() const { return m_parts.model.document().motion.otf; }
    [[nodiscard]] Viewpoint frameView() const;
    [[nodiscard]] CourseFrame courseFrame() const;
    void keepCourseOf(const AdaptiveOtfConfig& config);

    Parts m_parts;
    MotionOtf m_mode = MotionOtf::oneOtf;      ///< the choice for which OTFs were asked last
    std::shared_ptr<const AdaptiveOtf> m_otf;  ///< see otf()
    bool m_frameWaits = false;                 ///< the present frame is shown once its OTF is there
    std::optional<CourseKey> m_courseKey;
    QElapsedTimer m_frameClock;  ///< runs since the frame shown last
    double m_frameSeconds = 0;   ///< running mean; 0 before the first frame
    PacedWords m_frameRate{[this] { tellFrameRate(); }};
};

}  // namespace echolucent
