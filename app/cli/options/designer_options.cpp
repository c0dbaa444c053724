#include "app/cli/options/designer_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <charconv>

#include "app/cli/options/option_text.h"
#include "processing/designers/designer.h"

namespace echolucent::cli {

namespace {

constexpr const char* setOption = "--set";

/// A text as a parameter's value of the kind that `like` has; no value where it is none.
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
    return std::holds_alternative<std::int64_t>(like) ? number(std::int64_t{}) : number(double{});
}

/// What a value of a row may be, as the end of a sentence.
template <typename Values>
std::string allowedBy(const Parameter<Values>& row, const ParameterValue& like) {
    if (!row.choices.empty()) return "Use " + listed(row.choices) + ".";
    if (std::holds_alternative<bool>(like)) return "Use true or false.";
    const std::string unit = row.unit.empty() ? std::string() : fmt::format(" ({})", row.unit);
    return fmt::format("Use a number from {} to {}{}.", textOf(row.range.least), textOf(row.range.largest), unit);
}

/// Sets one parameter of a config.
Result<void> set(DesignerConfig& config, const std::string& name, const std::string& text) {
    Result<void> done;
    std::string known;
    std::visit(
        [&](auto& values) {
            for (const auto& row : parametersOf(values)) {
                known += fmt::format("{}{}", known.empty() ? "" : ", ", row.name);
                if (row.name != name) continue;
                const auto like = row.get(values);
                if (!like) {
                    done = wrongUsage(setOption, fmt::format("names \"{}\", which plays no part here", name),
                                      fmt::format("Set {} to {} before it.", row.scope.parameter, row.scope.choice));
                    return;
                }
                const auto value = valueFrom(text, *like);
                const auto number = value ? numberOf(*value) : std::nullopt;
                if (!value || (number && !inRange(*number, row.range)) || !row.set(values, *value)) {
                    done = wrongUsage(setOption, fmt::format("says \"{}\" for {}", text, name), allowedBy(row, *like));
                    return;
                }
                return;
            }
            done = wrongUsage(
                setOption,
                fmt::format("names \"{}\", which is no parameter of {}", name, echolucent::nameOf(designerOf(config))),
                known.empty() ? "It has none." : "It has " + known + ".");
        },
        config);
    return done;
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
        if (const auto done = set(config, setting.substr(0, sign), setting.substr(sign + 1)); !done)
            return tl::unexpected<Failure>(done.error());
    }
    if (const std::string problem = problemOf(config); !problem.empty()) return wrongUsage(setOption, problem);
    return std::optional(config);
}

}  // namespace echolucent::cli
