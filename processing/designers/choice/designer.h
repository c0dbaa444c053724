// The OTF designers by name: a config of any of them in, a classification and its explanation out.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "processing/designers/choice/designer_config.h"
#include "processing/designers/design.h"
#include "processing/parameters/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// Runs a designer, which promises what processing/designers/designer_declarations.h says.
[[nodiscard]] std::optional<Design> design(const DesignerConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

/// What is out of range: lower case, no full stop; empty if nothing is.
[[nodiscard]] std::string problemOf(const DesignerConfig& config);

/// Calls visit(row, values) for each row of the designer's table of parameters. `values` is the config in its own type.
template <typename Visit>
void forEachParameter(const DesignerConfig& config, const Visit& visit) {
    std::visit(
        [&](const auto& values) {
            for (const auto& row : parametersOf(values)) visit(row, values);
        },
        config);
}
/// The same for a config that `visit` may change.
template <typename Visit>
void forEachParameter(DesignerConfig& config, const Visit& visit) {
    std::visit(
        [&](auto& values) {
            for (const auto& row : parametersOf(values)) visit(row, values);
        },
        config);
}

}  // namespace echolucent
