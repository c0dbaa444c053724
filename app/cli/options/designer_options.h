// The options that choose and configure an OTF designer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/designers/choice/designer_config.h"
#include "processing/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace echolucent::cli {

/// --designer NAME and --set NAME=VALUE.
struct DesignerOptions {
    std::string name;                   ///< empty if no designer was asked for
    std::vector<std::string> settings;  ///< "NAME=VALUE"
    /// Adds the options to a command. They must not move until get().
    void addTo(CLI::App& command);
    /// The wanted config; no value if no designer was asked for. Fails (wrong usage) if there is no such designer or
    /// parameter, or if a value is of another kind or out of range.
    [[nodiscard]] Result<std::optional<DesignerConfig>> get() const;
};

/// The names of all designers as a list in a sentence.
[[nodiscard]] std::string listedDesigners();

}  // namespace echolucent::cli
