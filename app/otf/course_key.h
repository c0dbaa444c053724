// What the frames of one course of OTFs share.
#pragma once

#include "processing/document/document.h"
#include "processing/shared_list.h"
#include "widgets/motion/otf_course.h"

namespace echolucent {

/// What the rows of a course share within a study. Another key begins a new course.
struct CourseKey {
    Viewpoint start;
    SharedList<ScalpelStroke> strokes;
    MotionAxis axis = MotionAxis::screenVertical;
    AdaptiveOtfConfig config;
    OtfCourse::Rows rows = OtfCourse::Rows::angles;
    int fixed = 0;  ///< the phase or the angle that stays; 0 if both change
    friend bool operator==(const CourseKey&, const CourseKey&) = default;
};

/// The key of the course of a pane's frame. `config` is that of the frame's OTF.
[[nodiscard]] CourseKey courseKeyOf(const Document& document, const AdaptiveOtfConfig& config,
                                    const CourseFrame& frame);

}  // namespace echolucent
