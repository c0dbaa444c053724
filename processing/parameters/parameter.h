// Rows of tables that say a parameter once. The range check, the command line, the JSON, the pages in docs/ and the
// panels all read the same row, so that no range and no default stands twice.
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
    std::string_view label{};  ///< for a person, sentence case; empty: the name says it (labelOf())
    friend bool operator==(const ParameterChoice&, const ParameterChoice&) = default;
};

/// Where a parameter applies: only while another parameter, a choice, has this name chosen. If both are empty, the
/// parameter applies always.
struct ParameterScope {
    std::string_view parameter{};
    std::string_view choice{};
    friend bool operator==(const ParameterScope&, const ParameterScope&) = default;
};

/// How a control moves a number.
struct ParameterSteps {
    double step = 1.0;
    int decimals = 0;  ///< that it shows
};

/// What a table says of a parameter, whatever values it is of.
struct AnyParameter {
    std::string_view name;     ///< key in JSON, words joined by underscores; the option is optionOf(name)
    std::string_view label;    ///< name for a person, sentence case
    std::string_view meaning;  ///< one sentence that begins with a capital and ends without a full stop
    std::string_view unit;  ///< "units", "mm", "degrees", "share", "standard deviations" and so on; a pure number and a
                            ///< choice have none
    std::string_view source;  ///< the paper's section or equation, or the experiment in docs/ that chose the default
    ParameterRange range{};   ///< of numbers
    std::vector<ParameterChoice> choices{};  ///< in the order people are shown; a number and a flag have none
    /// It has a value only there. The parameter that it names stands before this one in its table.
    ParameterScope scope{};
    std::string_view when{};  ///< when it plays a part, in words; empty: always, or in its scope
    /// What a control offers to the hand if the range is far wider; without a value a control offers the range.
    std::optional<ParameterRange> offered{};
    std::optional<ParameterSteps> steps{};  ///< of its control; without a value they follow from the range
    bool inPanels = true;                   ///< whether a panel has a control for it

    [[nodiscard]] ParameterRange offeredRange() const { return offered.value_or(range); }
};

/// A parameter of `Values`, a struct of plain values.
template <typename Values>
struct Parameter : AnyParameter {
    /// The value, or nothing if the parameter means nothing in these values, because it belongs to an alternative that
    /// is not chosen.
    std::optional<ParameterValue> (*get)(const Values&) = nullptr;
    /// Sets a value of the kind that `get` gives. It returns false and changes nothing if the parameter means nothing
    /// in these values, or if the value is of another kind or the name of no choice. It does not look at the range.
    bool (*set)(Values&, const ParameterValue&) = nullptr;
    /// Whether a value that is there can change what is made of the values; null: always.
    bool (*plays)(const Values&) = nullptr;
};

/// All parameters of `Values`, in the order in which people are shown them.
template <typename Values>
struct ParameterTable {
    std::vector<Parameter<Values>> rows{};
    Values standard{};  ///< the values that a person begins with: the defaults
    /// What is wrong between rows that are each in range (problemIn() calls it); null: nothing can be.
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

/// A number's value, or nothing if the value is a choice or a flag.
[[nodiscard]] inline std::optional<double> numberOf(const ParameterValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* real = std::get_if<double>(&value)) return *real;
    return std::nullopt;
}

/// A number as people write it: the shortest text of at most seven digits ("0.25", "1000000", "1e+12").
[[nodiscard]] std::string textOf(double number);

/// A choice's name for a person: its label, or its name in sentence case ("Tube cores" of "tube_cores").
[[nodiscard]] std::string labelOf(const ParameterChoice& choice);

/// A value of a row for a person: "yes" or "no", a choice's label, or the number.
[[nodiscard]] std::string shownValue(const AnyParameter& row, const ParameterValue& value);

/// When a row applies, in words that end a sentence: "always", "if form is ramp", "in direct mode".
[[nodiscard]] std::string whenOf(const AnyParameter& row);

/// Whether a value lies within a range; a value that is not a number lies in none.
[[nodiscard]] inline bool inRange(double value, const ParameterRange& range) {
    return value >= range.least && value <= range.largest;
}

/// What is wrong with a value of a row, lower case, no full stop ("the cell size must be 2 to 32"); an empty text if
/// nothing is.
[[nodiscard]] std::string problemOfValue(const AnyParameter& row, const ParameterValue& value);

/// What is wrong in the values, by their rows and by ParameterTable::problem; an empty text if nothing is.
template <typename Values>
[[nodiscard]] std::string problemIn(const ParameterTable<Values>& table, const Values& values) {
    for (const Parameter<Values>& row : table)
        if (const auto value = row.get(values))
            if (std::string problem = problemOfValue(row, *value); !problem.empty()) return problem;
    return table.problem != nullptr ? table.problem(values) : std::string();
}

/// The row of a name, or null if the table has no row of that name.
template <typename Values>
[[nodiscard]] const Parameter<Values>* parameterNamed(const ParameterTable<Values>& table, std::string_view name) {
    for (const Parameter<Values>& row : table)
        if (row.name == name) return &row;
    return nullptr;
}

/// Whether a row's value is there and can change what is made of the values: a light plays no part in a picture without
/// light.
template <typename Values>
[[nodiscard]] bool playsAPart(const Parameter<Values>& row, const Values& values) {
    return row.get(values).has_value() && (row.plays == nullptr || row.plays(values));
}

/// Makes the choice that a row belongs to, so that it has a value.
template <typename Values>
void chooseScope(const ParameterTable<Values>& table, const AnyParameter& row, Values& values) {
    if (row.scope.parameter.empty()) return;
    const Parameter<Values>& choice = *parameterNamed(table, row.scope.parameter);
    if (choice.get(values) != ParameterValue(std::string(row.scope.choice)))
        choice.set(values, std::string(row.scope.choice));
}

/// The default: the value in ParameterTable::standard, with the choice made that the row belongs to.
template <typename Values>
[[nodiscard]] ParameterValue defaultOf(const ParameterTable<Values>& table, const Parameter<Values>& row) {
    Values values = table.standard;
    chooseScope(table, row, values);
    return row.get(values).value();
}

/// A row of whatever table, and its default.
struct ParameterDefault {
    const AnyParameter* row = nullptr;
    ParameterValue standard{};
};
/// All rows of a table, which outlives them.
template <typename Values>
[[nodiscard]] std::vector<ParameterDefault> defaultsOf(const ParameterTable<Values>& table) {
    std::vector<ParameterDefault> all;
    for (const Parameter<Values>& row : table) all.push_back({&row, defaultOf(table, row)});
    return all;
}

}  // namespace echolucent
