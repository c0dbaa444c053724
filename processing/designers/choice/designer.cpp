#include "processing/designers/choice/designer.h"

#include <variant>

namespace echolucent {

std::optional<Design> design(const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
    return std::visit([&](const auto& values) { return design(values, input, progress); }, config);
}

std::string problemOf(const DesignerConfig& config) {
    return std::visit([](const auto& values) { return problemIn(parametersOf(values), values); }, config);
}

}  // namespace echolucent
