#include "app/cli/options/designer_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <charconv>
#include <type_traits>

#include "app/cli/options/option_text.h"
#include "app/cli/options/parameter_options.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/designers/choice/designer.h"
#include "processing/parameters/typed_number.h"

namespace echolucent::cli {

namespace {

constexpr const char* setOption = "--set";

/// Reads a text as a value of the kind of `like`. No value if the text is not of that kind.
std::optional<ParameterValue> valueFrom(const std::string& text, const ParameterValue& like) {
    if (std::holds_alternative<std::string>(like)) return text;
    if (std::holds_alternative<bool>(like)) {
        if (text == "true" || text == "false") return text == "true";
        return std::nullopt;
    }
    const auto number = [&]<typename Number>(Number value) -> std::optional<ParameterValue> {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
        return value;
    };
    const bool whole = std::holds_alternative<std::int64_t>(like);
    if (text.find(',') == std::string::npos) return whole ? number(std::int64_t{}) : number(double{});
    if (whole) {
        const auto count = numberTyped(text, exactWholeNumbers, true);
        return count ? std::optional<ParameterValue>(static_cast<std::int64_t>(*count)) : std::nullopt;
    }
    const auto typed = typedNumber(text);
    return typed && !typed->otherwise ? std::optional<ParameterValue>(typed->value) : std::nullopt;
}

/// The remedy for a name that is no row of a designer's table.
template <typename Values>
std::string knownOf(const ParameterTable<Values>& table, const std::string& name) {
    if (std::is_same_v<Values, AdaptiveConfig> && parameterNamed(methodParameters(), name) != nullptr)
        return fmt::format("The method's own options set it: {}.", optionOf(name));
    std::string known;
    for (const AnyParameter& each : table) known += fmt::format("{}{}", known.empty() ? "" : ", ", each.name);
    return known.empty() ? "It has none." : "It has " + known + ".";
}

template <typename Values>
Result<void> set(const ParameterTable<Values>& table, Values& values, const std::string& name,
                 const std::string& text) {
    const Parameter<Values>* row = parameterNamed(table, name);
    if (row == nullptr)
        return wrongUsage(setOption, fmt::format("names \"{}\", which is no parameter of {}", name, Values::words.name),
                          knownOf(table, name));
    const auto like = row->get(values);
    if (!like)
        return wrongUsage(setOption, fmt::format("names \"{}\", which plays no part here", name),
                          fmt::format("Set {} to {} before it.", row->scope.parameter, row->scope.choice));
    const auto value = valueFrom(text, *like);
    if (!value || !problemOfValue(*row, *value).empty() || !row->set(values, *value))
        return wrongUsage(setOption, fmt::format("says \"{}\" for {}", text, name), allowedBy(*row, *like));
    return {};
}

}  // namespace

std::string listedDesigners() {
    std::vector<std::string_view> names;
    names.reserve(allDesigners.size());
    for (const Designer designer : allDesigners) names.push_back(echolucent::nameOf(designer));
    return listed(names);
}

void DesignerOptions::addTo(CLI::App& command) {
    command.add_option("--designer", name, "The OTF designer: " + listedDesigners())->type_name("NAME");
    command
        .add_option(setOption, settings,
                    "A parameter of the designer (docs/designers); may be given several times, and what decides "
                    "whether another plays a part stands before it")
        ->type_name("NAME=VALUE")
        ->needs("--designer")
        ->allow_extra_args(false);
}

Result<std::optional<DesignerConfig>> DesignerOptions::get() const {
    if (name.empty()) return std::optional<DesignerConfig>();
    const auto designer = designerFromName(name);
    if (!designer) return wrongUsage("--designer", "is \"" + name + "\"", "Use " + listedDesigners() + ".");
    DesignerConfig config = defaultConfigOf(*designer);
    for (const std::string& setting : settings) {
        const std::size_t sign = setting.find('=');
        if (sign == std::string::npos)
            return wrongUsage(setOption, "is \"" + setting + "\"", "Write NAME=VALUE, as in opacity=0.5.");
        const auto done = std::visit(
            [&](auto& values) {
                return set(parametersOf(values), values, setting.substr(0, sign), setting.substr(sign + 1));
            },
            config);
        if (!done) return tl::unexpected<Failure>(done.error());
    }
    if (const std::string problem = problemOf(config); !problem.empty()) return wrongUsage(setOption, problem);
    return std::optional(config);
}

}  // namespace echolucent::cli
