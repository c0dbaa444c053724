// The options that choose and configure an OTF designer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "processing/designers/designer_config.h"
#include "processing/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace echolucent::cli {

/// --designer NAME and --set NAME=VALUE.
struct DesignerOptions {
    std::string name;                   ///< empty where no designer was asked for
    std::vector<std::string> settings;  ///< "NAME=VALUE"
    /// Adds the options to a command. They must stay where they are from here to get().
    void addTo(CLI::App& command);
    /// The config that was asked for; no value where no designer was. Fails (wrong usage) where there is no such
    /// designer or parameter, or where a value is of another kind or out of range.
    [[nodiscard]] Result<std::optional<DesignerConfig>> get() const;
};

/// The names of all designers as a sentence lists them.
[[nodiscard]] std::string listedDesigners();

}  // namespace echolucent::cli
