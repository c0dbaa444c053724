// What the frames of one course of OTFs have in common.
#pragma once

#include "processing/document/document.h"
#include "processing/shared_list.h"
#include "widgets/motion/otf_course.h"

namespace echolucent {

/// What the course's rows have in common within a study; another one begins a new course.
struct CourseKey {
    Viewpoint start;
    SharedList<ScalpelStroke> strokes;
    MotionAxis axis = MotionAxis::y;
    AdaptiveOtfConfig config;
    OtfCourse::Rows rows = OtfCourse::Rows::angles;
    int fixed = 0;  ///< the phase or the angle that stays; 0 where both change
    friend bool operator==(const CourseKey&, const CourseKey&) = default;
};

/// From where the scene is seen at angle 0 of a motion: its pose, its front and its box.
[[nodiscard]] Viewpoint motionStartOf(const Document& document);

/// The key of the course to which a frame of a pane belongs; `config` is what its OTF was computed with.
[[nodiscard]] CourseKey courseKeyOf(const Document& document, const AdaptiveOtfConfig& config,
                                    const CourseFrame& frame);

}  // namespace echolucent
