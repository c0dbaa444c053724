// The options of a picture's look, made from the table of the look.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "processing/parameter.h"
#include "processing/picture/look.h"
#include "processing/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace echolucent::cli {

/// An option for each row of lookParameters(), whose default is lookAtStart(), and the short forms --shade,
/// --depth-colour, --perspective and --light.
struct LookOptions {
    /// `names` are those of the rows that get an option; where there are none, all rows get one. The options must stay
    /// where they are from here to get().
    void addTo(CLI::App& command, const std::vector<std::string_view>& names = {});
    /// Fails (wrong usage) where an option is out of range or plays no part in the mode.
    [[nodiscard]] Result<Look> get() const;

private:
    /// What stands on the command line for one row.
    struct Given {
        const Parameter<Look>* parameter = nullptr;
        const CLI::Option* option = nullptr;
        bool flag = false;
        double number = 0.0;
        std::string choice;
        [[nodiscard]] ParameterValue value() const;
    };
    [[nodiscard]] Result<void> checkParts(const Look& look) const;
    void addRow(CLI::App& command, const Parameter<Look>& parameter);

    std::deque<Given> m_given;  // a deque: the options point at its elements
    bool m_perspective = false, m_shade = false;
    std::string m_light;
};

}  // namespace echolucent::cli
