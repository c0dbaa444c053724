#include "app/otf/course_key.h"

namespace echolucent {

CourseKey courseKeyOf(const Document& document, const AdaptiveOtfConfig& config, const CourseFrame& frame) {
    const MotionScenario scenario = document.motion.scenario;
    const auto rows = movesProbe(scenario) ? OtfCourse::Rows::angles : OtfCourse::Rows::phases;
    const int fixed = scenario == MotionScenario::both ? 0 : movesProbe(scenario) ? frame.phase : frame.angle;
    return {motionStartOf(document), document.scene.strokes, document.motion.axis, config, rows, fixed};
}

}  // namespace echolucent
