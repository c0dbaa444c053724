// Options made from the rows of a table of parameters, and their values on the command line.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "app/cli/options/option_text.h"
#include "processing/parameters/parameter.h"
#include "processing/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace echolucent::cli {

/// The help of a row's option: its meaning, its choices, its unit and the choice that it belongs to.
[[nodiscard]] std::string helpOf(const AnyParameter& row);
/// "must be 2 to 32 units".
[[nodiscard]] std::string mustBe(const AnyParameter& row);
/// The allowed values of a row, as a sentence. `like` has the kind of its values.
[[nodiscard]] std::string allowedBy(const AnyParameter& row, const ParameterValue& like);

/// The values that the command line gives for the rows of a table.
class GivenParameters {
public:
    /// Adds an option for a row. The option is called `names`, or optionOf() the row's name if `names` is empty. A row
    /// with a bool gets a flag. `row` must outlive the parsing, and this object must not move until then.
    CLI::Option& add(CLI::App& command, const AnyParameter& row, const ParameterValue& standard,
                     const std::string& names = {});
    /// Adds a second option, `name`, for a row whose value is a double. Its first option is `added`; both together are
    /// refused.
    void addShort(CLI::App& command, const AnyParameter& row, const std::string& name, CLI::Option& added);

    [[nodiscard]] bool has(std::string_view parameter) const { return m_given.contains(parameter); }

    /// Sets the given values, in the table's order: so a choice comes before what belongs to it. Fails (wrong usage) if
    /// a value is out of range or no choice, or belongs to a choice that is not made.
    template <typename Values>
    [[nodiscard]] Result<void> override(const ParameterTable<Values>& table, Values& values) const {
        for (const Parameter<Values>& row : table) {
            const auto given = m_given.find(row.name);
            if (given == m_given.end()) continue;
            if (auto checked = check(row, given->second); !checked) return checked;
            if (row.set(values, given->second.value)) continue;
            return belongsElsewhere(row, given->second, *parameterNamed(table, row.scope.parameter)->get(values));
        }
        return {};
    }

private:
    struct Given {
        std::string option;  ///< what failures call it
        ParameterValue value;
    };
    [[nodiscard]] static Result<void> check(const AnyParameter& row, const Given& given);
    [[nodiscard]] static tl::unexpected<Failure> belongsElsewhere(const AnyParameter& row, const Given& given,
                                                                  const ParameterValue& chosen);
    std::map<std::string_view, Given> m_given;  ///< by the parameter's name
};

}  // namespace echolucent::cli
