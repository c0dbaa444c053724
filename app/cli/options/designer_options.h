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
    std::string name;                   ///< empty if --designer is not given
    std::vector<std::string> settings;  ///< "NAME=VALUE"
    /// Adds the options to a command. This object must not move until get() is called.
    void addTo(CLI::App& command);
    /// The designer's config; no value if --designer is not given. Fails (wrong usage) if there is no such designer or
    /// parameter, if a setting has no "=", if a value is of another kind or out of range, or if a parameter plays no
    /// part beside the settings before it.
    [[nodiscard]] Result<std::optional<DesignerConfig>> get() const;
};

/// The names of all designers as a list in a sentence.
[[nodiscard]] std::string listedDesigners();

}  // namespace echolucent::cli
