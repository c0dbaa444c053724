// The options of a picture's look, made from the table of the look.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/options/parameter_options.h"
#include "processing/picture/look.h"
#include "processing/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace echolucent::cli {

/// An option for each row of lookParameters(), with the defaults of lookAtStart(). Short forms: --shade,
/// --depth-colour, --perspective and --light.
struct LookOptions {
    /// `names` are the rows that get an option. If `names` is empty, all rows get one, and the short forms --shade,
    /// --perspective and --light are added. This object must not move until get() is called.
    void addTo(CLI::App& command, const std::vector<std::string_view>& names = {});
    /// Fails (wrong usage) if an option is out of range or plays no part in the mode.
    [[nodiscard]] Result<Look> get() const;

private:
    [[nodiscard]] Result<void> checkParts(const Look& look) const;

    GivenParameters m_given;
    bool m_perspective = false, m_shade = false;
    std::string m_light;
};

}  // namespace echolucent::cli
