// Rows of tables that say a parameter once. The range check, the command line, the JSON, the page in docs/ and the
// panels all read the same row, so that no range and no default stands twice.
#pragma once

#include <cctype>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace echolucent {

/// A parameter's value as tables, files and the command line carry it. A choice is carried as its name.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

/// Both ends are allowed values.
struct ParameterRange {
    double least = -std::numeric_limits<double>::infinity();
    double largest = std::numeric_limits<double>::infinity();
    friend bool operator==(const ParameterRange&, const ParameterRange&) = default;
};

/// Where a parameter applies: only while another parameter, a choice, has this name chosen. Where both are empty, the
/// parameter applies always.
struct ParameterScope {
    std::string_view parameter;
    std::string_view choice;
    friend bool operator==(const ParameterScope&, const ParameterScope&) = default;
};

/// One parameter of `Values`, a struct of plain values. Its default is what `get` reads from Values{} (or from the
/// alternative of Values that holds it).
template <typename Values>
struct Parameter {
    std::string_view name;     ///< key in JSON, words joined by underscores; the option is optionOf(name)
    std::string_view label;    ///< name for a person, sentence case
    std::string_view meaning;  ///< one sentence that begins with a capital and ends without a full stop
    std::string_view unit;  ///< "units", "mm", "degrees", "share", "standard deviations" and so on; a pure number and a
                            ///< choice have none
    std::string_view source;  ///< the paper's section or equation, or the experiment in docs/ that chose the default
    ParameterRange range;     ///< of numbers
    std::vector<std::string_view> choices;  ///< names of a choice, in the order people are shown; a number has none
    /// The value, or nothing where the parameter means nothing in these values, because it belongs to an alternative
    /// that was not chosen.
    std::optional<ParameterValue> (*get)(const Values&);
    /// Sets a value of the kind that `get` gives. It returns false and changes nothing where the parameter means
    /// nothing in these values, or where the value is of another kind or the name of no choice. It does not look at the
    /// range.
    bool (*set)(Values&, const ParameterValue&);
    /// What a control offers to the hand where the range is far wider; where it is not set, a control offers the range.
    std::optional<ParameterRange> offered = {};
    /// Both functions find the parameter only there. The parameter that it names stands before this one in its table.
    ParameterScope scope = {};

    [[nodiscard]] ParameterRange offeredRange() const { return offered.value_or(range); }
};

/// "--cell-size" of "cell_size".
[[nodiscard]] inline std::string optionOf(std::string_view name) {
    std::string option = "--";
    for (const char letter : name) option += letter == '_' ? '-' : letter;
    return option;
}

/// "cellSize" of "cell_size": a parameter's key in the settings file and in the object names of widgets.
[[nodiscard]] std::string camelCase(std::string_view name);

/// A number's value, or nothing where the value is a choice.
[[nodiscard]] inline std::optional<double> numberOf(const ParameterValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* real = std::get_if<double>(&value)) return *real;
    return std::nullopt;
}

/// A number as people write it: the shortest text of at most seven digits ("0.25", "1000000", "1e+12").
[[nodiscard]] std::string textOf(double number);

/// Whether a value lies within a range; a value that is not a number lies in none.
[[nodiscard]] inline bool inRange(double value, const ParameterRange& range) {
    return value >= range.least && value <= range.largest;
}

/// What is out of range, lower case, no full stop ("the cell size must be 2 to 32"), or an empty text where nothing is.
template <typename Values>
[[nodiscard]] std::string problemIn(std::span<const Parameter<Values>> table, const Values& values) {
    for (const Parameter<Values>& parameter : table) {
        const std::optional<ParameterValue> value = parameter.get(values);
        const std::optional<double> number = value ? numberOf(*value) : std::nullopt;
        if (!number || inRange(*number, parameter.range)) continue;
        std::string label(parameter.label);
        if (!label.empty()) label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
        return "the " + label + " must be " + textOf(parameter.range.least) + " to " + textOf(parameter.range.largest);
    }
    return {};
}

/// The row of a name, or null where the table has no row of that name.
template <typename Values>
[[nodiscard]] const Parameter<Values>* parameterNamed(std::span<const Parameter<Values>> table, std::string_view name) {
    for (const Parameter<Values>& parameter : table)
        if (parameter.name == name) return &parameter;
    return nullptr;
}

/// The default: the value in Values{}, with the alternative chosen that holds the parameter.
template <typename Values>
[[nodiscard]] ParameterValue defaultOf(std::span<const Parameter<Values>> table, const Parameter<Values>& parameter) {
    Values values;
    if (!parameter.scope.parameter.empty())
        parameterNamed(table, parameter.scope.parameter)->set(values, std::string(parameter.scope.choice));
    return parameter.get(values).value();
}

}  // namespace echolucent
