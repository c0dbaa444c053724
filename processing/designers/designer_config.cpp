#include "processing/designers/designer_config.h"

#include <cstddef>
#include <utility>
#include <variant>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<allDesigners.size()> designerNames{"adaptive",         "levoy", "kindlmann",  "template",
                                                         "contour-spectrum", "otsu",  "percentile", "fetal-preset",
                                                         "echo-ramp"};
constexpr ChoiceNames<allDesigners.size()> designerLabels{
    "Adaptive",  "Levoy",           "Kindlmann and Durkin", "Template", "Contour spectrum",
    "Otsu ramp", "Percentile ramp", "Fetal preset",         "Echo ramp"};

static_assert(std::variant_size_v<DesignerConfig> == allDesigners.size());

template <std::size_t... index>
DesignerConfig defaultAt(std::size_t wanted, std::index_sequence<index...>) {
    DesignerConfig config;
    (void)((index == wanted ? (config.emplace<index>(), true) : false) || ...);
    return config;
}

}  // namespace

std::string_view nameOf(Designer designer) { return nameIn(designerNames, designer); }
std::optional<Designer> designerFromName(std::string_view name) { return choiceNamed<Designer>(designerNames, name); }
std::string_view labelOf(Designer designer) { return nameIn(designerLabels, designer); }

DesignerConfig defaultConfigOf(Designer designer) {
    return defaultAt(static_cast<std::size_t>(designer),
                     std::make_index_sequence<std::variant_size_v<DesignerConfig>>());
}

}  // namespace echolucent
