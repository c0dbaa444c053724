#include "app/motion/course_key.h"

namespace echolucent {

Viewpoint motionStartOf(const Document& document, int view) {
    Viewpoint start =
        viewpointOf(document.beam.axis, poseOf(document, view).direction, cutOf(document, view).nearCutMm);
    start.cutSurface = cutOf(document, view).surface;
    start.box = viewpointOf(document, view).box;
    return start;
}

CourseKey courseKeyOf(const Document& document, int view, const AdaptiveOtfConfig& config, const CourseFrame& frame) {
    const MotionScenario scenario = document.motion.scenario;
    const auto rows = movesProbe(scenario) ? OtfCourse::Rows::angles : OtfCourse::Rows::phases;
    const int fixed = scenario == MotionScenario::both ? 0 : movesProbe(scenario) ? frame.phase : frame.angle;
    return {motionStartOf(document, view), strokesOf(document, view), document.motion.axis, config, rows, fixed};
}

}  // namespace echolucent
