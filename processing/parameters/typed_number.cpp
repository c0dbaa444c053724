#include "processing/parameters/typed_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace echolucent {

namespace {

constexpr std::size_t digitsOfGroup = 3;

bool isNumeral(char letter) { return letter >= '0' && letter <= '9'; }
bool areNumerals(std::string_view text) { return std::ranges::all_of(text, isNumeral); }

std::optional<double> valueOf(const std::string& plain) {
    double value = 0;
    const auto [end, problem] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    const bool whole = problem == std::errc() && end == plain.data() + plain.size() && std::isfinite(value);
    return whole ? std::optional(value) : std::nullopt;
}

/// Takes the part behind 'e' or 'E' off the text: a sign and digits, empty if there is none. No value if it is wrong.
std::optional<std::string> takeExponent(std::string_view& text) {
    const auto at = text.find_first_of("eE");
    if (at == std::string_view::npos) return std::string();
    const std::string_view exponent = text.substr(at + 1);
    text = text.substr(0, at);
    const std::string_view digits = exponent.substr(exponent.starts_with('-') || exponent.starts_with('+') ? 1 : 0);
    if (digits.empty() || !areNumerals(digits)) return std::nullopt;
    return "e" + std::string(exponent.substr(exponent.starts_with('+') ? 1 : 0));
}

/// The digits of whole numbers, plain or in groups of three with one kind of separator. No value if they are neither.
std::optional<std::string> wholeDigits(std::string_view text) {
    const auto first = std::ranges::find_if_not(text, isNumeral);
    if (first == text.end()) return std::string(text);
    const char separator = *first;
    std::string digits;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        const std::string_view group = text.substr(begin, end - begin);
        const bool full = begin == 0 ? !group.empty() && group.size() <= digitsOfGroup : group.size() == digitsOfGroup;
        if (!full || !areNumerals(group)) return std::nullopt;
        digits += group;
        begin = end + 1;
    }
    return digits;
}

/// Where the decimal mark stands; npos if there is none.
std::size_t decimalMark(std::string_view text) {
    const auto points = std::ranges::count(text, '.'), commas = std::ranges::count(text, ',');
    if (points > 0 && commas > 0) return text.find_last_of(".,");
    return points == 1 || commas == 1 ? text.find_first_of(".,") : std::string_view::npos;
}

bool mayGroup(std::string_view text, std::size_t mark, std::string_view exponent) {
    const std::string_view before = text.substr(0, mark), behind = text.substr(mark + 1);
    return text[mark] == ',' && exponent.empty() && !before.empty() && before.size() <= digitsOfGroup &&
           before.front() != '0' && areNumerals(before) && behind.size() == digitsOfGroup;
}

std::string_view trimmedOfBlanks(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

bool isWhole(const TypedNumber& typed) { return !typed.hasMark && typed.value == std::floor(typed.value); }

}  // namespace

std::optional<TypedNumber> typedNumber(std::string_view text) {
    text = trimmedOfBlanks(text);
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    const auto exponent = takeExponent(text);
    if (!exponent) return std::nullopt;
    const std::size_t mark = decimalMark(text);
    const std::string_view behind = mark == std::string_view::npos ? std::string_view() : text.substr(mark + 1);
    const auto digits = wholeDigits(text.substr(0, mark));
    if (!digits || !areNumerals(behind) || digits->size() + behind.size() == 0) return std::nullopt;
    const std::string sign = negative ? "-" : "";
    const auto value = valueOf(sign + *digits + '.' + std::string(behind) + *exponent);
    if (!value) return std::nullopt;
    TypedNumber typed{*value};
    typed.hasMark = mark != std::string_view::npos;
    if (typed.hasMark && mayGroup(text, mark, *exponent))
        typed.otherwise = valueOf(sign + *digits + std::string(behind));
    return typed;
}

std::optional<double> numberTyped(std::string_view text, const ParameterRange& range, bool whole) {
    const auto typed = typedNumber(text);
    if (!typed || isDoubtful(text, range, whole)) return std::nullopt;
    if (inRange(typed->value, range) && (!whole || isWhole(*typed))) return typed->value;
    return typed->otherwise && inRange(*typed->otherwise, range) ? typed->otherwise : std::nullopt;
}

bool isDoubtful(std::string_view text, const ParameterRange& range, bool whole) {
    const auto typed = typedNumber(text);
    return typed && typed->otherwise && !whole && inRange(typed->value, range) && inRange(*typed->otherwise, range);
}

std::string remedyOfDoubt(std::string_view text) {
    const auto typed = typedNumber(text);
    if (!typed || !typed->otherwise) return {};
    return "Write " + textOf(typed->value) + " or " + textOf(*typed->otherwise) + ".";
}

}  // namespace echolucent
