#include "processing/designers/designer.h"

#include <variant>

#include "processing/parameter.h"

namespace echolucent {

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
