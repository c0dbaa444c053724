// How a row of a designer's table reads and sets a field of its config.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/choice_names.h"
#include "processing/parameter.h"

namespace echolucent::config_rows {

template <typename Member>
struct Field;
template <typename C, typename V>
struct Field<V C::*> {
    using Config = C;
    using Value = V;
};
template <auto member>
using ConfigOf = typename Field<decltype(member)>::Config;
template <auto member>
using ValueOf = typename Field<decltype(member)>::Value;

/// What the text fields of a row say.
struct Words {
    std::string_view name, label, meaning, unit, source;
};

/// Where a row applies; its scope says the same in words.
template <typename Config>
using Applies = bool (*)(const Config&);
template <typename Config>
constexpr bool always(const Config&) {
    return true;
}

/// A row of a field of type double.
template <auto member, Applies<ConfigOf<member>> applies = always<ConfigOf<member>>>
Parameter<ConfigOf<member>> number(const Words& words, ParameterRange range, std::optional<ParameterRange> offered = {},
                                   ParameterScope scope = {}) {
    using Config = ConfigOf<member>;
    const auto get = [](const Config& config) -> std::optional<ParameterValue> {
        return applies(config) ? std::optional<ParameterValue>(config.*member) : std::nullopt;
    };
    const auto set = [](Config& config, const ParameterValue& value) {
        const std::optional<double> given = numberOf(value);
        if (!applies(config) || !given) return false;
        config.*member = *given;
        return true;
    };
    return {words.name, words.label, words.meaning, words.unit, words.source, range, {}, get, set, offered, scope};
}

/// A row of a field of an enumeration, whose choices `names` names in the order of their values.
template <auto member, const auto& names, Applies<ConfigOf<member>> applies = always<ConfigOf<member>>>
Parameter<ConfigOf<member>> choice(const Words& words, ParameterScope scope = {}) {
    using Config = ConfigOf<member>;
    const auto get = [](const Config& config) -> std::optional<ParameterValue> {
        if (!applies(config)) return std::nullopt;
        return std::string(nameIn(names, config.*member));
    };
    const auto set = [](Config& config, const ParameterValue& value) {
        const auto* name = std::get_if<std::string>(&value);
        const auto chosen = name != nullptr ? choiceNamed<ValueOf<member>>(names, *name) : std::nullopt;
        if (!applies(config) || !chosen) return false;
        config.*member = *chosen;
        return true;
    };
    return {words.name,
            words.label,
            words.meaning,
            words.unit,
            words.source,
            {},
            std::vector(names.begin(), names.end()),
            get,
            set,
            {},
            scope};
}

}  // namespace echolucent::config_rows
