#include "processing/motion/motion_mode.h"

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<6> axisNames{"x", "y", "z", "screen_vertical", "screen_horizontal", "picture_plane"};
constexpr ChoiceNames<3> scenarioNames{"probe", "object", "both"};
constexpr ChoiceNames<allMotionOtfs.size()> otfNames{"one_otf", "each_view", "mean", "moving_least_squares",
                                                     "least_flicker"};

}  // namespace

std::string_view nameOf(MotionAxis axis) { return nameIn(axisNames, axis); }
std::optional<MotionAxis> motionAxisFromName(std::string_view name) { return choiceNamed<MotionAxis>(axisNames, name); }

MotionAxis screenAxisOf(MotionAxis axis) {
    switch (axis) {
        case MotionAxis::x: return MotionAxis::screenHorizontal;
        case MotionAxis::y: return MotionAxis::screenVertical;
        case MotionAxis::z: return MotionAxis::picturePlane;
        default: return axis;
    }
}

std::string_view nameOf(MotionScenario scenario) { return nameIn(scenarioNames, scenario); }
std::optional<MotionScenario> motionScenarioFromName(std::string_view name) {
    return choiceNamed<MotionScenario>(scenarioNames, name);
}

std::string_view nameOf(MotionOtf otf) { return nameIn(otfNames, otf); }
std::optional<MotionOtf> motionOtfFromName(std::string_view name) { return choiceNamed<MotionOtf>(otfNames, name); }

std::optional<OtfSmoothing> smoothingOf(MotionOtf otf) {
    switch (otf) {
        case MotionOtf::oneOtf: return std::nullopt;
        case MotionOtf::eachView: return OtfSmoothing::none;
        case MotionOtf::mean: return OtfSmoothing::mean;
        case MotionOtf::movingLeastSquares: return OtfSmoothing::movingLeastSquares;
        case MotionOtf::leastFlicker: return OtfSmoothing::leastFlicker;
    }
    return std::nullopt;
}

}  // namespace echolucent
