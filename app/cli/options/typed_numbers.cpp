#include "app/cli/options/typed_numbers.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/files/header_text.h"
#include "processing/parameters/typed_number.h"

namespace echolucent::cli {

namespace {

/// Whether an option is one number, by the name of its kind. What follows a colon is its range.
bool isOneNumber(const CLI::Option& option) {
    constexpr std::array<std::string_view, 10> kindsOfNumbers{"NUMBER", "FLOAT",   "N",  "INT", "DEG",
                                                              "MM",     "MM|auto", "DB", "A",   "RATE"};
    const std::string kind = option.get_type_name();
    return std::ranges::find(kindsOfNumbers, std::string_view(kind).substr(0, kind.find(':'))) != kindsOfNumbers.end();
}

/// Writes a number with a comma with a point. Returns what is wrong with it; empty if nothing is.
std::string pointed(std::string& text) {
    if (text.find(',') == std::string::npos) return {};
    const auto typed = typedNumber(text);
    if (!typed) return {};
    if (typed->otherwise) return quotedText(text) + " has two meanings. " + remedyOfDoubt(text);
    text = fmt::format("{}", typed->value);
    return {};
}

}  // namespace

void understandCommas(CLI::App& program) {
    for (CLI::Option* option : program.get_options())
        if (isOneNumber(*option)) option->transform(CLI::Validator(pointed, ""));
    for (CLI::App* command : program.get_subcommands({})) understandCommas(*command);
}

}  // namespace echolucent::cli
