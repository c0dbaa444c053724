// When a step of a lesson is done: a closed list of comparisons, and no code.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/document/document_value.h"

namespace echolucent {

enum class ConditionKind {
    all,       ///< each of the parts holds
    any,       ///< one of the parts holds
    equal,     ///< the value is this one
    notEqual,  ///< there is a value, and it is another one
    less,      ///< the number is below this one
    greater,   ///< the number is above this one
    between,   ///< the number is at least `value` and at most `largest`
    present,   ///< there is a value, and it is not nothing
};
/// "all", "any", "equal", "not_equal", "less", "greater", "between", "present".
[[nodiscard]] std::string_view nameOf(ConditionKind kind);
[[nodiscard]] std::optional<ConditionKind> conditionKindFromName(std::string_view name);

/// The most parts of a condition, and how deep they may stand in each other.
inline constexpr std::size_t mostConditionParts = 20;
inline constexpr int deepestCondition = 4;

/// A condition on named values: paths into the document (io/document/document_paths.h), and what the window measured.
struct LessonCondition {
    ConditionKind kind = ConditionKind::all;
    std::string name{};  ///< of the value; not for all and any
    DocumentValue value{};
    double largest = 0.0;                  ///< of between
    std::vector<LessonCondition> parts{};  ///< of all and any
    friend bool operator==(const LessonCondition&, const LessonCondition&) = default;
};

/// The value of a name; none if it is not known now.
using NamedValue = std::function<std::optional<DocumentValue>(std::string_view name)>;
/// Whether a condition holds. A comparison of a value that is not known does not hold.
[[nodiscard]] bool holds(const LessonCondition& condition, const NamedValue& valueOf);
/// How many conditions there are in a condition, with itself.
[[nodiscard]] std::size_t conditionsIn(const LessonCondition& condition);
/// The names in a condition, in their order, each once.
[[nodiscard]] std::vector<std::string> namesIn(const LessonCondition& condition);
/// What is wrong with a condition: lower case, no full stop. Empty if nothing is.
[[nodiscard]] std::string problemOf(const LessonCondition& condition);

/// A number that the window measures, by the beginning of its name.
struct LessonMeasure {
    std::string_view name;     ///< "measured.tubes", or "measured.panes[N].right" of a pane counted from 0
    std::string_view meaning;  ///< a phrase for docs/lessons.md
};
[[nodiscard]] const std::vector<LessonMeasure>& lessonMeasures();
/// Whether a name is one of lessonMeasures(), with a number of a pane for N.
[[nodiscard]] bool isLessonMeasure(std::string_view name);

}  // namespace echolucent
