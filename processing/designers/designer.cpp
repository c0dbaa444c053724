#include "processing/designers/designer.h"

#include <cstddef>
#include <utility>

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

std::optional<Design> design(const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
    return std::visit([&](const auto& values) { return design(values, input, progress); }, config);
}

std::string problemOf(const DesignerConfig& config) {
    // What a person draws, and a reference, stand in no table.
    if (const auto* kindlmann = std::get_if<KindlmannConfig>(&config)) return problemOf(*kindlmann);
    if (const auto* carried = std::get_if<TemplateConfig>(&config)) return problemOf(*carried);
    return std::visit([](const auto& values) { return problemIn(parametersOf(values), values); }, config);
}

}  // namespace echolucent
