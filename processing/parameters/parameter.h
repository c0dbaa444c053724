// Tables that say each parameter once. The range check, the command line, the JSON, the pages in docs/ and the panels
// all read the same row, so no range and no default stands twice.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
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

/// One of the values of a choice.
struct ParameterChoice {
    std::string_view name;     ///< in files and on the command line
    std::string_view label{};  ///< for a person, sentence case; if empty, labelOf() makes one of the name
    friend bool operator==(const ParameterChoice&, const ParameterChoice&) = default;
};

/// When a parameter applies: only if the parameter named `parameter` has the choice named `choice`. If both names are
/// empty, it always applies.
struct ParameterScope {
    std::string_view parameter{};
    std::string_view choice{};
    friend bool operator==(const ParameterScope&, const ParameterScope&) = default;
};

/// How a control moves a number.
struct ParameterSteps {
    double step = 1.0;
    int decimals = 0;  ///< digits shown after the point
};

/// What a table says of a parameter, for any struct of values.
struct AnyParameter {
    std::string_view name;     ///< key in JSON, words joined by underscores; the option is optionOf(name)
    std::string_view label;    ///< name for a person, sentence case
    std::string_view meaning;  ///< one sentence that begins with a capital and ends without a full stop
    std::string_view unit;     ///< "units", "mm", "degrees", "share", "standard deviations" and so on; empty for a pure
                               ///< number and a choice
    std::string_view source;   ///< the paper's section or equation, or the experiment in docs/ that chose the default
    ParameterRange range{};    ///< of a number
    std::vector<ParameterChoice> choices{};  ///< in the order people are shown; empty for a number and a flag
    /// The parameter has a value only in this scope. The parameter that the scope names comes earlier in the table.
    ParameterScope scope{};
    std::string_view when{};  ///< when it plays a part, in words; empty: always, or in its scope
    /// The range that a control offers, if the allowed range is far wider. Without a value a control offers the allowed
    /// range.
    std::optional<ParameterRange> offered{};
    std::optional<ParameterSteps> steps{};  ///< of its control; without a value, the range decides
    bool inPanels = true;                   ///< whether a panel has a control for it

    [[nodiscard]] ParameterRange offeredRange() const { return offered.value_or(range); }
};

/// A parameter of `Values`, a struct of plain values.
template <typename Values>
struct Parameter : AnyParameter {
    /// The value. Empty if the parameter belongs to an alternative that the values do not choose.
    std::optional<ParameterValue> (*get)(const Values&) = nullptr;
    /// Sets a value of the kind that `get` gives. Returns false and changes nothing if the parameter means nothing in
    /// these values, if the value is of another kind, or if no choice has that name. Ignores the range.
    bool (*set)(Values&, const ParameterValue&) = nullptr;
    /// Whether a value that is there can change a result. Null: always.
    bool (*plays)(const Values&) = nullptr;
};

/// All parameters of `Values`, in the order in which people are shown them.
template <typename Values>
struct ParameterTable {
    std::vector<Parameter<Values>> rows{};
    Values standard{};  ///< the values that a person begins with: the defaults
    /// What is wrong between rows that are each in range (problemIn() calls it). Null if nothing can be wrong.
    std::string (*problem)(const Values&) = nullptr;

    [[nodiscard]] auto begin() const { return rows.begin(); }
    [[nodiscard]] auto end() const { return rows.end(); }
    [[nodiscard]] std::size_t size() const { return rows.size(); }
    [[nodiscard]] bool empty() const { return rows.empty(); }
};

/// "--cell-size" of "cell_size".
[[nodiscard]] std::string optionOf(std::string_view name);

/// "cellSize" of "cell_size": a parameter's name in the object names of widgets.
[[nodiscard]] std::string camelCase(std::string_view name);

/// The value as a number. Empty if it is a choice or a flag.
[[nodiscard]] inline std::optional<double> numberOf(const ParameterValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* real = std::get_if<double>(&value)) return *real;
    return std::nullopt;
}

/// A number rounded to seven digits, as people write it ("0.25", "1000000", "1e+12").
[[nodiscard]] std::string textOf(double number);

/// A choice's name for a person: its label, or its name in sentence case ("Tube cores" of "tube_cores").
[[nodiscard]] std::string labelOf(const ParameterChoice& choice);

/// A value of a row for a person: "yes" or "no", a choice's label, or the number.
[[nodiscard]] std::string shownValue(const AnyParameter& row, const ParameterValue& value);

/// When a row applies, in words that end a sentence: "always", "if form is ramp", "in direct mode".
[[nodiscard]] std::string whenOf(const AnyParameter& row);

/// Whether a value lies within a range; NaN lies in none.
[[nodiscard]] inline bool inRange(double value, const ParameterRange& range) {
    return value >= range.least && value <= range.largest;
}

/// What is wrong with a value of a row, lower case, no full stop ("the cell size must be 2 to 32"). Only a number out
/// of the range is wrong, else the result is empty.
[[nodiscard]] std::string problemOfValue(const AnyParameter& row, const ParameterValue& value);

/// The first thing that is wrong in the values, by their rows, then by ParameterTable::problem. Empty if nothing is
/// wrong.
template <typename Values>
[[nodiscard]] std::string problemIn(const ParameterTable<Values>& table, const Values& values) {
    for (const Parameter<Values>& row : table)
        if (const auto value = row.get(values))
            if (std::string problem = problemOfValue(row, *value); !problem.empty()) return problem;
    return table.problem != nullptr ? table.problem(values) : std::string();
}

/// The row of that name. Null if there is none.
template <typename Values>
[[nodiscard]] const Parameter<Values>* parameterNamed(const ParameterTable<Values>& table, std::string_view name) {
    for (const Parameter<Values>& row : table)
        if (row.name == name) return &row;
    return nullptr;
}

/// Whether a row's value is there and can change a result. For example, the light's direction cannot change a picture
/// without light.
template <typename Values>
[[nodiscard]] bool playsAPart(const Parameter<Values>& row, const Values& values) {
    return row.get(values).has_value() && (row.plays == nullptr || row.plays(values));
}

/// Makes the choice in `values` that the row's scope names, so that the row has a value. Does nothing if the row always
/// applies.
template <typename Values>
void chooseScope(const ParameterTable<Values>& table, const AnyParameter& row, Values& values) {
    if (row.scope.parameter.empty()) return;
    const Parameter<Values>& choice = *parameterNamed(table, row.scope.parameter);
    if (choice.get(values) != ParameterValue(std::string(row.scope.choice)))
        choice.set(values, std::string(row.scope.choice));
}

/// The default: the value in ParameterTable::standard, after the choice that gives the row its value.
template <typename Values>
[[nodiscard]] ParameterValue defaultOf(const ParameterTable<Values>& table, const Parameter<Values>& row) {
    Values values = table.standard;
    chooseScope(table, row, values);
    return row.get(values).value();
}

/// A row of any table, and its default.
struct ParameterDefault {
    const AnyParameter* row = nullptr;
    ParameterValue standard{};
};
/// All rows of a table, with their defaults. The table must outlive them.
template <typename Values>
[[nodiscard]] std::vector<ParameterDefault> defaultsOf(const ParameterTable<Values>& table) {
    std::vector<ParameterDefault> all;
    for (const Parameter<Values>& row : table) all.push_back({&row, defaultOf(table, row)});
    return all;
}

}  // namespace echolucent
