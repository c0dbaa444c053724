#include "processing/motion/motion_mode.h"

namespace echolucent {

namespace {

constexpr std::array<std::string_view, 3> axisNames{"x", "y", "z"};
constexpr std::array<std::string_view, 3> scenarioNames{"probe", "object", "both"};
constexpr std::array<std::string_view, allMotionOtfs.size()> otfNames{"one_otf", "each_view", "mean",
                                                                      "moving_least_squares", "least_flicker"};

template <typename Choice, std::size_t count>
std::optional<Choice> choiceNamed(const std::array<std::string_view, count>& names, std::string_view name) {
    for (std::size_t i = 0; i < count; ++i)
        if (names[i] == name) return static_cast<Choice>(i);
    return std::nullopt;
}

}  // namespace

std::string_view nameOf(MotionAxis axis) { return axisNames.at(static_cast<std::size_t>(axis)); }
std::optional<MotionAxis> motionAxisFromName(std::string_view name) { return choiceNamed<MotionAxis>(axisNames, name); }

std::string_view nameOf(MotionScenario scenario) { return scenarioNames.at(static_cast<std::size_t>(scenario)); }
std::optional<MotionScenario> motionScenarioFromName(std::string_view name) {
    return choiceNamed<MotionScenario>(scenarioNames, name);
}

std::string_view nameOf(MotionOtf otf) { return otfNames.at(static_cast<std::size_t>(otf)); }
std::optional<MotionOtf> motionOtfFromName(std::string_view name) { return choiceNamed<MotionOtf>(otfNames, name); }

}  // namespace echolucent
