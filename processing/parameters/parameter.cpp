#include "processing/parameters/parameter.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "processing/ascii_letters.h"

namespace echolucent {

std::string textOf(double number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 7).ptr;
    return {text.data(), end};
}

std::string optionOf(std::string_view name) {
    std::string option = "--" + std::string(name);
    std::ranges::replace(option, '_', '-');
    return option;
}

std::string camelCase(std::string_view name) {
    std::string camel;
    bool begins = false;
    for (const char letter : name) {
        if (letter != '_') camel += begins ? upperCase(letter) : letter;
        begins = letter == '_';
    }
    return camel;
}

std::string labelOf(const ParameterChoice& choice) {
    if (!choice.label.empty()) return std::string(choice.label);
    std::string label(choice.name);
    std::ranges::replace(label, '_', ' ');
    if (!label.empty()) label[0] = upperCase(label[0]);
    return label;
}

std::string shownValue(const AnyParameter& row, const ParameterValue& value) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "yes" : "no";
    if (const auto number = numberOf(value)) return textOf(*number);
    const std::string& name = std::get<std::string>(value);
    const auto found = std::ranges::find(row.choices, name, &ParameterChoice::name);
    return found != row.choices.end() ? labelOf(*found) : name;
}

std::string whenOf(const AnyParameter& row) {
    if (!row.when.empty()) return std::string(row.when);
    if (row.scope.parameter.empty()) return "always";
    return "if " + std::string(row.scope.parameter) + " is " + std::string(row.scope.choice);
}

std::string problemOfValue(const AnyParameter& row, const ParameterValue& value) {
    const auto number = numberOf(value);
    if (!number || inRange(*number, row.range)) return {};
    std::string label(row.label);
    if (!label.empty()) label[0] = lowerCase(label[0]);
    return "the " + label + " must be " + textOf(row.range.least) + " to " + textOf(row.range.largest);
}

}  // namespace echolucent
