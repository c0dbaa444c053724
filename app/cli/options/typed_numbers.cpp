#include "app/cli/options/typed_numbers.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "io/files/header_text.h"
#include "processing/parameters/typed_number.h"

namespace echolucent::cli {

namespace {

constexpr std::array<std::string_view, 3> kindsOfWholeNumbers{"N", "INT", "UINT"};
constexpr std::array<std::string_view, 8> kindsOfNumbers{"NUMBER", "FLOAT", "DEG", "MM", "MM|auto", "DB", "A", "RATE"};

/// Whether an option has one of the wanted kinds, by its name. What follows a colon is its range.
bool hasKind(std::span<const std::string_view> wanted, const CLI::Option& option) {
    const std::string kind = option.get_type_name();
    return std::ranges::find(wanted, std::string_view(kind).substr(0, kind.find(':'))) != wanted.end();
}

/// Writes a number with a comma as the program reads it. Returns what is wrong with it; empty if nothing is.
std::string withoutComma(std::string& text, bool whole) {
    if (text.find(',') == std::string::npos) return {};
    const auto typed = typedNumber(text);
    if (!typed) return {};
    if (whole) {
        if (const auto number = numberTyped(text, exactWholeNumbers, true)) text = fmt::format("{:.0f}", *number);
        return {};
    }
    if (typed->otherwise) return quotedText(text) + " has two meanings. " + remedyOfDoubt(text);
    text = fmt::format("{}", typed->value);
    return {};
}

}  // namespace

void understandCommas(CLI::App& program) {
    for (CLI::Option* option : program.get_options())
        for (const bool whole : {false, true})
            if (hasKind(whole ? std::span<const std::string_view>(kindsOfWholeNumbers) : kindsOfNumbers, *option))
                option->transform(CLI::Validator([whole](std::string& text) { return withoutComma(text, whole); }, ""));
    for (CLI::App* command : program.get_subcommands({})) understandCommas(*command);
}

}  // namespace echolucent::cli
