// Decides what each pane shows of the study: voxels, classification, and whether both belong together.
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

/// What a pane shows. Its picture is made once `ready` is true.
struct ShownPane {
    std::shared_ptr<const Volume> voxels{};    ///< quiet if speckle is reduced, and cut by the scalpel; null: no study
    std::shared_ptr<const Volume> measured{};  ///< the raw voxels of the same phase, cut by the scalpel
    Classification classification{};
    bool newest = false;   ///< whether the pane's OTF is the one that the document asks for
    bool refused = false;  ///< the requested OTF was cancelled or has failed, and does not come by itself
    /// Voxels and classification are of one scan, or no OTF will come. While a motion plays, both are the frame's own.
    bool ready = false;
};

/// Follows document, study and OTFs. A pane shows the newest voxels of its phase. While their OTF is computed, it shows
/// the voxels of its last OTF. In a motion with smoothed OTFs it shows the smoothed one, from the course of its frames.
class ShownPanes : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object. `course` is that of the scene's adaptive OTF.
    ShownPanes(DocumentModel& model, OpenStudy& openStudy, PaneOtfs& otfs, OtfCourse& course,
               QObject* parent = nullptr);

    void setPlaying(bool playing);
    [[nodiscard]] bool playing() const { return m_playing; }
    /// The state at the last changed().
    [[nodiscard]] const ShownPane& at(std::size_t pane) const;
    /// The adaptive curve of the scene as the present frame shows it; empty before a study's first.
    [[nodiscard]] const SampledCurve& adaptiveCurve() const;

signals:
    /// at() may differ for any pane.
    void changed();
    /// The course of the scene's adaptive OTF may have changed.
    void courseChanged();

private:
    /// The adaptive OTFs of a place, frame by frame.
    struct Course {
        std::optional<CourseKey> key;
        OtfCourse course;
        // The values taken last.
        std::shared_ptr<const AdaptiveOtf> otf;
        MotionOtf mode = MotionOtf::oneOtf;
        double angle = 0.0;
        int phase = 0;
        Pose pose{};
        SampledCurve curve;  ///< the curve that its mode shows
    };
    void follow();
    [[nodiscard]] ShownPane shownNow(std::size_t pane) const;
    void followCourse(std::size_t place);
    [[nodiscard]] MotionOtf modeOf(std::size_t place) const;
    [[nodiscard]] const SampledCurve* curveAt(std::size_t pane, const ComputedOtf& otf) const;
    /// Gives a pane the newest voxels of a phase. If quiet ones come soon, the pane keeps the voxels that it shows. If
    /// it shows none yet, it is not ready until they are there.
    void takeVoxels(std::size_t place, int phase, ShownPane& pane) const;

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    PaneOtfs& m_otfs;
    OtfCourse& m_sceneCourse;
    bool m_playing = false;
    std::map<std::size_t, Course> m_courses;  ///< by place
    const Study* m_study = nullptr;           ///< compared by address only
    std::vector<ShownPane> m_shown;           ///< by pane, as followed last
    std::map<std::size_t, ShownPane> m_last;  ///< what each pane that somebody looks at showed when it was ready last
};

}  // namespace echolucent
