#include "app/cli/options/option_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>

#include "io/files/header_text.h"

namespace echolucent::cli {

tl::unexpected<Failure> wrongUsage(const std::string& option, const std::string& problem, const std::string& remedy) {
    return fail(FailureKind::wrongUsage, "", option, problem, remedy);
}

Result<std::vector<double>> parseNumbers(const std::string& text, std::size_t count, const std::string& option,
                                         const std::string& example) {
    std::string spaced = text;
    for (char& character : spaced)
        if (character == 'x' || character == 'X' || character == ',') character = ' ';
    const auto values = realNumbers(spaced);
    // Count the separators too: "3xx4" is a slip, not two numbers.
    const auto separators = static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return c == 'x' || c == 'X' || c == ','; }));
    if (!values || values->size() != count || separators + 1 != count)
        return wrongUsage(option, fmt::format("must be like {}, not {}", example, quotedText(text)));
    return *values;
}

Result<std::array<int, 2>> parseWholePair(const std::string& text, int least, int largest, const std::string& option,
                                          const std::string& example) {
    const auto numbers = parseNumbers(text, 2, option, example);
    if (!numbers) return tl::unexpected<Failure>(numbers.error());
    for (const double number : *numbers)
        if (!(number >= least && number <= largest) || number != std::floor(number))
            return wrongUsage(option, fmt::format("must be two whole numbers from {} to {}", least, largest),
                              "Write it as " + example + ".");
    return std::array<int, 2>{static_cast<int>((*numbers)[0]), static_cast<int>((*numbers)[1])};
}

bool isAngle(double degrees) { return std::abs(degrees) <= 36000.0; }

std::string listed(const std::vector<std::string_view>& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 < names.size() ? ", " : " or ";
        list += names[i];
    }
    return list;
}

void sayNote(const std::string& note) {
    if (!note.empty()) std::fprintf(stderr, "%s\n", note.c_str());
}

std::string wordOf(const ParameterValue& value) {
    if (const auto number = numberOf(value)) return textOf(*number);
    if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
    return std::get<std::string>(value);
}

}  // namespace echolucent::cli
