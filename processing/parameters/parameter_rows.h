// Makes rows of tables. number(), flag() and choice() take the way to a member; the row reads and sets the member.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "processing/choice_names.h"
#include "processing/parameters/parameter.h"

namespace echolucent::parameter_rows {

/// The text fields of a row.
struct Words {
    std::string_view name, label, meaning, unit, source;
};

/// Further fields of a row, as in AnyParameter.
struct More {
    std::optional<ParameterRange> offered{};
    ParameterScope scope{};
    std::optional<ParameterSteps> steps{};
    bool inPanels = true;
};

// The way to a value is a list of steps. Each step is one of
// - a member of the object reached so far,
// - a member of one alternative of the variant reached so far (no value if the variant holds another alternative),
// - a function that asks the object reached so far whether there is a value.
template <typename Step>
struct StepTraits;
template <typename Owner_, typename Value_>
struct StepTraits<Value_ Owner_::*> {
    using Owner = Owner_;
};
template <typename Owner_>
struct StepTraits<bool (*)(const Owner_&)> {
    using Owner = Owner_;
};

template <auto step, typename Object>
auto* stepFrom(Object& object) {
    using Owner = typename StepTraits<decltype(step)>::Owner;
    if constexpr (!std::is_member_object_pointer_v<decltype(step)>) {
        return step(object) ? &object : nullptr;
    } else if constexpr (std::is_same_v<std::remove_const_t<Object>, Owner>) {
        return &(object.*step);
    } else {
        auto* alternative = std::get_if<Owner>(&object);
        return alternative == nullptr ? nullptr : &(alternative->*step);
    }
}

/// The value at the end of the way, or null if there is none.
template <auto step, auto... further, typename Object>
auto* valueAt(Object& object) {
    auto* next = stepFrom<step>(object);
    if constexpr (sizeof...(further) == 0)
        return next;
    else
        return next == nullptr ? nullptr : valueAt<further...>(*next);
}

template <auto first, auto...>
struct Start {
    using Values = typename StepTraits<decltype(first)>::Owner;
};
template <auto... way>
using ValuesOf = typename Start<way...>::Values;
template <auto... way>
using ValueOf = std::remove_pointer_t<decltype(valueAt<way...>(std::declval<ValuesOf<way...>&>()))>;

template <typename Values>
Parameter<Values> rowOf(const Words& words, const More& more) {
    Parameter<Values> row;
    row.name = words.name;
    row.label = words.label;
    row.meaning = words.meaning;
    row.unit = words.unit;
    row.source = words.source;
    row.scope = more.scope;
    row.offered = more.offered;
    row.steps = more.steps;
    row.inPanels = more.inPanels;
    return row;
}

template <auto... way>
bool setNumber(ValuesOf<way...>& values, const ParameterValue& value) {
    auto* member = valueAt<way...>(values);
    const auto number = numberOf(value);
    if (member == nullptr || !number) return false;
    if constexpr (std::is_same_v<ValueOf<way...>, int>) {
        const auto* whole = std::get_if<std::int64_t>(&value);
        if (whole == nullptr) return false;
        using Limits = std::numeric_limits<int>;
        *member = static_cast<int>(std::clamp<std::int64_t>(*whole, Limits::min(), Limits::max()));
    } else {
        *member = *number;
    }
    return true;
}

/// A row of a value of type double or int.
template <auto... way>
Parameter<ValuesOf<way...>> number(const Words& words, const ParameterRange& range, const More& more = {}) {
    using Values = ValuesOf<way...>;
    Parameter<Values> row = rowOf<Values>(words, more);
    row.range = range;
    row.get = [](const Values& values) -> std::optional<ParameterValue> {
        const auto* member = valueAt<way...>(values);
        if (member == nullptr) return std::nullopt;
        if constexpr (std::is_same_v<ValueOf<way...>, int>)
            return std::int64_t{*member};
        else
            return double{*member};
    };
    row.set = setNumber<way...>;
    return row;
}

/// A row of a value of type bool.
template <auto... way>
Parameter<ValuesOf<way...>> flag(const Words& words, const More& more = {}) {
    using Values = ValuesOf<way...>;
    Parameter<Values> row = rowOf<Values>(words, more);
    row.get = [](const Values& values) -> std::optional<ParameterValue> {
        const bool* member = valueAt<way...>(values);
        return member != nullptr ? std::optional<ParameterValue>(*member) : std::nullopt;
    };
    row.set = [](Values& values, const ParameterValue& value) {
        bool* member = valueAt<way...>(values);
        const bool* given = std::get_if<bool>(&value);
        if (member == nullptr || given == nullptr) return false;
        *member = *given;
        return true;
    };
    return row;
}

/// One of the values that choice() offers.
template <typename Value>
struct Choice {
    Value value;
    std::string_view name;
    std::string_view label = {};
};
template <typename Value, typename... Texts>
Choice(Value, Texts...) -> Choice<Value>;  // clang 14 does not deduce this for a plain struct

/// All values of an enumeration, in their order.
template <typename Value, std::size_t count>
constexpr std::array<Choice<Value>, count> choicesOf(const ChoiceNames<count>& names) {
    std::array<Choice<Value>, count> choices{};
    for (std::size_t i = 0; i < count; ++i) choices[i] = {static_cast<Value>(i), names[i]};
    return choices;
}

/// A row of a value that is one of `choices`, an array of Choice.
template <const auto& choices, auto... way>
Parameter<ValuesOf<way...>> choice(const Words& words, const More& more = {}) {
    using Values = ValuesOf<way...>;
    Parameter<Values> row = rowOf<Values>(words, more);
    for (const auto& each : choices) row.choices.push_back({each.name, each.label});
    row.get = [](const Values& values) -> std::optional<ParameterValue> {
        const auto* member = valueAt<way...>(values);
        if (member == nullptr) return std::nullopt;
        for (const auto& each : choices)
            if (each.value == *member) return std::string(each.name);
        return std::nullopt;
    };
    row.set = [](Values& values, const ParameterValue& value) {
        auto* member = valueAt<way...>(values);
        const auto* name = std::get_if<std::string>(&value);
        if (member == nullptr || name == nullptr) return false;
        for (const auto& each : choices)
            if (each.name == *name) return *member = each.value, true;
        return false;
    };
    return row;
}

/// A row that says which of two alternatives a variant holds. Each alternative has its own choice. Choosing the present
/// alternative again keeps its values.
template <auto variant, typename First, const ParameterChoice& first, typename Second, const ParameterChoice& second>
Parameter<ValuesOf<variant>> alternative(const Words& words) {
    using Values = ValuesOf<variant>;
    Parameter<Values> row = rowOf<Values>(words, {});
    row.choices = {first, second};
    row.get = [](const Values& values) -> std::optional<ParameterValue> {
        return std::string(std::holds_alternative<First>(values.*variant) ? first.name : second.name);
    };
    row.set = [](Values& values, const ParameterValue& value) {
        const auto choose = [&]<typename Alternative>(Alternative made, std::string_view name) {
            if (value != ParameterValue(std::string(name))) return false;
            if (!std::holds_alternative<Alternative>(values.*variant)) values.*variant = made;
            return true;
        };
        return choose(First{}, first.name) || choose(Second{}, second.name);
    };
    return row;
}

/// The rows, each with `scope` in place of its own.
template <typename Values>
std::vector<Parameter<Values>> within(const ParameterScope& scope, std::vector<Parameter<Values>> rows) {
    for (Parameter<Values>& row : rows) row.scope = scope;
    return rows;
}

/// The row, which plays a part only if `plays` says so. `when` says the same in words.
template <typename Values>
Parameter<Values> playing(bool (*plays)(const Values&), std::string_view when, Parameter<Values> row) {
    row.plays = plays;
    row.when = when;
    return row;
}

}  // namespace echolucent::parameter_rows
