// How a row of methodParameters() reads and sets its field of an AdaptiveOtfConfig.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/parameter.h"

namespace echolucent::method_rows {

using Row = Parameter<AdaptiveOtfConfig>;

// Where each rule stands in the config; null where another rule is chosen.
inline TubeGrid* find(AdaptiveOtfConfig& config, TubeGrid*) { return &config.grid; }
inline CellRule* find(AdaptiveOtfConfig& config, CellRule*) { return &config.cells; }
inline SurfaceRule* find(AdaptiveOtfConfig& config, SurfaceRule*) { return &config.surface; }
inline WeightRule* find(AdaptiveOtfConfig& config, WeightRule*) { return &config.weights; }
inline VarianceRule* find(AdaptiveOtfConfig& config, VarianceRule*) {
    return std::get_if<VarianceRule>(&config.detection);
}
inline RatioRule* find(AdaptiveOtfConfig& config, RatioRule*) { return std::get_if<RatioRule>(&config.detection); }
inline ProductRule* find(AdaptiveOtfConfig& config, ProductRule*) { return std::get_if<ProductRule>(&config.curve); }
inline RampRule* find(AdaptiveOtfConfig& config, RampRule*) { return std::get_if<RampRule>(&config.curve); }

template <typename Rule>
inline constexpr ParameterScope scopeOf{};
template <>
inline constexpr ParameterScope scopeOf<VarianceRule>{"interface_function", "variance"};
template <>
inline constexpr ParameterScope scopeOf<RatioRule>{"interface_function", "ratio"};
template <>
inline constexpr ParameterScope scopeOf<ProductRule>{"form", "product"};
template <>
inline constexpr ParameterScope scopeOf<RampRule>{"form", "ramp"};

template <typename Member>
struct Field;
template <typename R, typename V>
struct Field<V R::*> {
    using Rule = R;
    using Value = V;
};
template <auto member>
using RuleOf = typename Field<decltype(member)>::Rule;
template <auto member>
using ValueOf = typename Field<decltype(member)>::Value;

/// The field in a config, or null where it means nothing there.
template <auto member>
ValueOf<member>* fieldIn(AdaptiveOtfConfig& config) {
    RuleOf<member>* rule = find(config, static_cast<RuleOf<member>*>(nullptr));
    return rule == nullptr ? nullptr : &(rule->*member);
}
template <auto member>
const ValueOf<member>* fieldIn(const AdaptiveOtfConfig& config) {
    return fieldIn<member>(const_cast<AdaptiveOtfConfig&>(config));
}

inline int wholeOf(std::int64_t value) {
    return static_cast<int>(std::clamp<std::int64_t>(value, std::numeric_limits<int>::min(),  //
                                                     std::numeric_limits<int>::max()));
}

template <auto member>
std::optional<ParameterValue> numberIn(const AdaptiveOtfConfig& config) {
    const auto* field = fieldIn<member>(config);
    if (field == nullptr) return std::nullopt;
    if constexpr (std::is_same_v<ValueOf<member>, int>)
        return std::int64_t{*field};
    else
        return *field;
}

template <auto member>
bool setNumberIn(AdaptiveOtfConfig& config, const ParameterValue& value) {
    auto* field = fieldIn<member>(config);
    if (field == nullptr) return false;
    const auto* whole = std::get_if<std::int64_t>(&value);
    if constexpr (std::is_same_v<ValueOf<member>, int>) {
        if (whole == nullptr) return false;
        *field = wholeOf(*whole);
    } else {
        const auto number = numberOf(value);
        if (!number) return false;
        *field = *number;
    }
    return true;
}

/// Sets how many tube cores lie across or down. Where that changes, an index means another tube core: none is left out
/// any more.
template <auto member>
bool setTubeCountIn(AdaptiveOtfConfig& config, const ParameterValue& value) {
    const int before = config.grid.*member;
    if (!setNumberIn<member>(config, value)) return false;
    if (config.grid.*member != before) config.grid.withoutTubes.clear();
    return true;
}

/// What the text fields of a row say.
struct Words {
    std::string_view name, label, meaning, unit, source;
};

template <auto member>
Row number(const Words& words, ParameterRange range, std::optional<ParameterRange> offered = {}) {
    return {words.name, words.label,      words.meaning,       words.unit, words.source,           range,
            {},         numberIn<member>, setNumberIn<member>, offered,    scopeOf<RuleOf<member>>};
}

template <auto member>
Row tubeCount(const Words& words, ParameterRange range, ParameterRange offered) {
    Row row = number<member>(words, range, offered);
    row.set = setTubeCountIn<member>;
    return row;
}

template <typename Value>
struct Named {
    Value value;
    std::string_view name;
};
template <typename Value>
Named(Value, const char*) -> Named<Value>;  // of a plain struct clang 14 does not find it by itself
template <auto member, const auto& names>
std::optional<ParameterValue> choiceIn(const AdaptiveOtfConfig& config) {
    const auto* field = fieldIn<member>(config);
    if (field == nullptr) return std::nullopt;
    for (const auto& named : names)
        if (named.value == *field) return std::string(named.name);
    return std::nullopt;
}

template <auto member, const auto& names>
bool setChoiceIn(AdaptiveOtfConfig& config, const ParameterValue& value) {
    auto* field = fieldIn<member>(config);
    const auto* name = std::get_if<std::string>(&value);
    if (field == nullptr || name == nullptr) return false;
    const auto found =
        std::find_if(names.begin(), names.end(), [name](const auto& named) { return named.name == *name; });
    if (found == names.end()) return false;
    *field = found->value;
    return true;
}

template <auto member, const auto& names>
Row choice(const Words& words) {
    std::vector<std::string_view> all;
    for (const auto& named : names) all.push_back(named.name);
    return {words.name,
            words.label,
            words.meaning,
            words.unit,
            words.source,
            {},
            all,
            choiceIn<member, names>,
            setChoiceIn<member, names>,
            {},
            scopeOf<RuleOf<member>>};
}

/// A row that says which of two rules a variant of the config holds.
template <auto variant, typename First, typename Second>
Row alternative(const Words& words) {
    const auto get = [](const AdaptiveOtfConfig& config) -> std::optional<ParameterValue> {
        const bool first = std::holds_alternative<First>(config.*variant);
        return std::string(first ? scopeOf<First>.choice : scopeOf<Second>.choice);
    };
    const auto set = [](AdaptiveOtfConfig& config, const ParameterValue& value) {
        const auto* name = std::get_if<std::string>(&value);
        const auto choose = [&]<typename Rule>(Rule rule) {
            if (name == nullptr || *name != scopeOf<Rule>.choice) return false;
            // What was set of the rule that is chosen already stays.
            if (!std::holds_alternative<Rule>(config.*variant)) config.*variant = rule;
            return true;
        };
        return choose(First{}) || choose(Second{});
    };
    return {words.name,
            words.label,
            words.meaning,
            words.unit,
            words.source,
            {},
            {scopeOf<First>.choice, scopeOf<Second>.choice},
            get,
            set};
}

}  // namespace echolucent::method_rows
