#include "processing/lesson/lesson_condition.h"

#include <algorithm>
#include <cmath>

#include "processing/choice_names.h"
#include "processing/document/comparison.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<8> conditionKindNames{"all",  "any",     "equal",   "not_equal",
                                            "less", "greater", "between", "present"};

bool isList(const LessonCondition& condition) {
    return condition.kind == ConditionKind::all || condition.kind == ConditionKind::any;
}

void addNames(const LessonCondition& condition, std::vector<std::string>& names) {
    if (!isList(condition) && std::ranges::find(names, condition.name) == names.end()) names.push_back(condition.name);
    for (const LessonCondition& part : condition.parts) addNames(part, names);
}

std::string problemWithin(const LessonCondition& condition, int depth) {
    if (depth > deepestCondition) return "nests deeper than 4 conditions";
    if (isList(condition)) {
        if (condition.parts.empty() || condition.parts.size() > mostConditionParts)
            return "must hold 1 to 20 conditions";
        for (const LessonCondition& part : condition.parts)
            if (std::string problem = problemWithin(part, depth + 1); !problem.empty()) return problem;
        return {};
    }
    if (condition.name.empty()) return "must name a value";
    const bool ofNumbers = condition.kind == ConditionKind::less || condition.kind == ConditionKind::greater ||
                           condition.kind == ConditionKind::between;
    const auto* number = std::get_if<double>(&condition.value);
    if (ofNumbers && (number == nullptr || !std::isfinite(*number))) return "must compare with a number";
    if (condition.kind == ConditionKind::between && !(condition.largest >= *number))
        return "must be between a number and one that is not below it";
    return {};
}

}  // namespace

std::string_view nameOf(ConditionKind kind) { return nameIn(conditionKindNames, kind); }

std::optional<ConditionKind> conditionKindFromName(std::string_view name) {
    return choiceNamed<ConditionKind>(conditionKindNames, name);
}

bool holds(const LessonCondition& condition, const NamedValue& valueOf) {
    const auto partHolds = [&](const LessonCondition& part) { return holds(part, valueOf); };
    if (condition.kind == ConditionKind::all) return std::ranges::all_of(condition.parts, partHolds);
    if (condition.kind == ConditionKind::any) return std::ranges::any_of(condition.parts, partHolds);
    const std::optional<DocumentValue> value = valueOf(condition.name);
    if (!value) return false;
    const auto* number = std::get_if<double>(&*value);
    const auto* limit = std::get_if<double>(&condition.value);
    switch (condition.kind) {
        case ConditionKind::equal: return *value == condition.value;
        case ConditionKind::notEqual: return *value != condition.value;
        case ConditionKind::present: return !std::holds_alternative<std::monostate>(*value);
        case ConditionKind::less: return number != nullptr && limit != nullptr && *number < *limit;
        case ConditionKind::greater: return number != nullptr && limit != nullptr && *number > *limit;
        default: return number != nullptr && limit != nullptr && *number >= *limit && *number <= condition.largest;
    }
}

std::size_t conditionsIn(const LessonCondition& condition) {
    std::size_t count = 1;
    for (const LessonCondition& part : condition.parts) count += conditionsIn(part);
    return count;
}

std::vector<std::string> namesIn(const LessonCondition& condition) {
    std::vector<std::string> names;
    addNames(condition, names);
    return names;
}

std::string problemOf(const LessonCondition& condition) { return problemWithin(condition, 1); }

const std::vector<LessonMeasure>& lessonMeasures() {
    static const std::vector<LessonMeasure> measures{
        {"measured.tubes", "tube cores that meet the volume, once the adaptive OTF is computed"},
        {"measured.tubes_with_weight", "those of them that found a surface with a weight"},
        {"measured.tube_core", "the number of the tube core that a person has chosen"},
        {"measured.panes[N].right", "rays that pane N shows right, in percent, once the comparison is measured"},
        {"measured.panes[N].early", "rays that it shows too early, in percent"},
        {"measured.panes[N].late", "rays that it shows too late, in percent"},
        {"measured.panes[N].never", "rays that it never shows, in percent"},
        {"measured.panes[N].contrast", "its CNR_S"},
    };
    return measures;
}

bool isLessonMeasure(std::string_view name) {
    std::string plain(name);
    const std::size_t bracket = plain.find('[');
    if (bracket != std::string::npos) {
        const bool ofPane = bracket + 2 < plain.size() && plain[bracket + 2] == ']' && plain[bracket + 1] >= '0' &&
                            plain[bracket + 1] < static_cast<char>('0' + mostPanes);
        if (!ofPane) return false;
        plain[bracket + 1] = 'N';
    }
    return std::ranges::find(lessonMeasures(), plain, &LessonMeasure::name) != lessonMeasures().end();
}

}  // namespace echolucent
