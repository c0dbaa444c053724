// What each pane is to show of the study: its voxels, what they are classified with, and whether both belong together.
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/otf/course_key.h"
#include "app/otf/pane_otfs.h"
#include "processing/classification.h"
#include "widgets/motion/otf_course.h"

namespace echolucent {

/// What a pane is to show now. A picture of it is made once it is ready.
struct ShownPane {
    std::shared_ptr<const Volume> voxels{};    ///< quiet if speckle is reduced, and cut by the scalpel; null: no study
    std::shared_ptr<const Volume> measured{};  ///< the same as they were read
    Classification classification{};
    bool newest = false;   ///< it is what the document asks for
    bool refused = false;  ///< what the document asks for was cancelled or has failed, and does not come by itself
    /// Voxels and classification are of one scan, or none will come. While a motion plays they are the frame's own.
    bool ready = false;
};

/// Follows document, study and OTFs. A pane shows the newest voxels of its phase; while the OTF for them is computed,
/// it shows those that its last OTF was made for. In a motion whose OTFs are smoothed it shows the smoothed one, of the
/// course of its frames.
class ShownPanes : public QObject {
    Q_OBJECT

public:
    /// All outlive this. `course` is that of the scene's adaptive OTF.
    ShownPanes(DocumentModel& model, OpenStudy& openStudy, PaneOtfs& otfs, OtfCourse& course,
               QObject* parent = nullptr);

    /// Whether a motion plays.
    void setPlaying(bool playing);
    [[nodiscard]] bool playing() const { return m_playing; }
    /// As of the newest changed().
    [[nodiscard]] const ShownPane& at(std::size_t pane) const;
    /// The adaptive curve of the scene as the present frame shows it; empty before a study's first.
    [[nodiscard]] const SampledCurve& adaptiveCurve() const;

signals:
    /// at() may be another, of any pane.
    void changed();
    /// The course of the scene's adaptive OTF has another frame.
    void courseChanged();

private:
    /// The adaptive OTFs of a place, frame by frame.
    struct Course {
        std::optional<CourseKey> key;
        OtfCourse course;
        // What was taken last.
        std::shared_ptr<const AdaptiveOtf> otf;
        MotionOtf mode = MotionOtf::oneOtf;
        double angle = 0.0;
        int phase = 0;
        Pose pose{};
        SampledCurve curve;  ///< that its mode shows
    };
    void follow();
    [[nodiscard]] ShownPane shownNow(std::size_t pane) const;
    void followCourse(std::size_t place);
    [[nodiscard]] MotionOtf modeOf(std::size_t place) const;
    [[nodiscard]] const SampledCurve* curveAt(std::size_t pane, const ComputedOtf& otf) const;
    /// Gives voxels to a pane whose OTF is not made for them.
    void takeVoxels(std::size_t place, int phase, ShownPane& pane) const;

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    PaneOtfs& m_otfs;
    OtfCourse& m_sceneCourse;
    bool m_playing = false;
    std::map<std::size_t, Course> m_courses;  ///< by place
    const Study* m_study = nullptr;           ///< told apart by address only
    std::vector<ShownPane> m_shown;           ///< by pane, as followed last
    std::map<std::size_t, ShownPane> m_last;  ///< ready ones that somebody looks at, by pane
};

}  // namespace echolucent
