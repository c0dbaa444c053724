#include "app/cli/options/parameter_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

namespace echolucent::cli {

namespace {

std::vector<std::string_view> namesOf(const std::vector<ParameterChoice>& choices) {
    std::vector<std::string_view> names;
    for (const ParameterChoice& choice : choices) names.push_back(choice.name);
    return names;
}

std::string ends(const ParameterRange& range) { return textOf(range.least) + " to " + textOf(range.largest); }

}  // namespace

std::string helpOf(const AnyParameter& row) {
    std::string help(row.meaning);
    if (!row.choices.empty()) help += ": " + listed(namesOf(row.choices));
    if (!row.unit.empty()) help += fmt::format(", {}", row.unit);
    if (!row.scope.parameter.empty())
        help += fmt::format(" (with {} {})", optionOf(row.scope.parameter), row.scope.choice);
    return help;
}

std::string mustBe(const AnyParameter& row) {
    const bool hasUnit = !row.unit.empty() && row.unit != "share";
    return fmt::format("must be {}{}{}", ends(row.range), hasUnit ? " " : "", hasUnit ? row.unit : "");
}

std::string allowedBy(const AnyParameter& row, const ParameterValue& like) {
    if (!row.choices.empty()) return "Use " + listed(namesOf(row.choices)) + ".";
    if (std::holds_alternative<bool>(like)) return "Use true or false.";
    const std::string unit = row.unit.empty() ? std::string() : fmt::format(" ({})", row.unit);
    return fmt::format("Use a number from {}{}.", ends(row.range), unit);
}

CLI::Option& GivenParameters::add(CLI::App& command, const AnyParameter& row, const ParameterValue& standard,
                                  const std::string& names) {
    const std::string option = optionOf(row.name), all = names.empty() ? option : names;
    const auto taking = [this, &row, option](const auto& value) {
        m_given[row.name] = {option, ParameterValue(value)};
    };
    if (std::holds_alternative<bool>(standard))
        return *command.add_flag_function(
            all, [taking](std::int64_t count) { taking(count > 0); }, helpOf(row));
    CLI::Option* added = nullptr;
    if (std::holds_alternative<std::string>(standard))
        added = command.add_option_function<std::string>(all, taking, helpOf(row))->type_name("NAME");
    else if (std::holds_alternative<std::int64_t>(standard))
        added = command.add_option_function<std::int64_t>(all, taking, helpOf(row))->type_name("N");
    else
        added = command.add_option_function<double>(all, taking, helpOf(row))->type_name("NUMBER");
    added->default_str(wordOf(standard));
    return *added;
}

void GivenParameters::addShort(CLI::App& command, const AnyParameter& row, const std::string& name,
                               CLI::Option& added) {
    command
        .add_option_function<double>(
            name,
            [this, &row, name](double value) {
                m_given[row.name] = {name, ParameterValue(value)};
            },
            "Short for " + optionOf(row.name))
        ->type_name("NUMBER")
        ->excludes(&added);
}

Result<void> GivenParameters::check(const AnyParameter& row, const Given& given) {
    if (const auto number = numberOf(given.value); number && !inRange(*number, row.range))
        return wrongUsage(given.option, mustBe(row));
    const auto* name = std::get_if<std::string>(&given.value);
    if (name == nullptr || std::ranges::find(row.choices, *name, &ParameterChoice::name) != row.choices.end())
        return {};
    return wrongUsage(given.option, "is \"" + *name + "\"", allowedBy(row, given.value));
}

tl::unexpected<Failure> GivenParameters::belongsElsewhere(const AnyParameter& row, const Given& given,
                                                          const ParameterValue& chosen) {
    const std::string owner = optionOf(row.scope.parameter);
    return wrongUsage(given.option,
                      fmt::format("belongs to {} {}, and {} is chosen", owner, row.scope.choice, wordOf(chosen)),
                      fmt::format("Give {} {} too, or leave it out.", owner, row.scope.choice));
}

}  // namespace echolucent::cli
