#include "io/files/header_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "io/files/input_problems.h"

namespace echolucent {

namespace {

constexpr std::string_view whiteSpace = " \t\r\n\f\v";

/// Whether a number that no double can hold is too small, not too large.
bool isTooSmall(std::string_view word) {
    const auto mark = std::min(word.find_first_of("eE"), word.size());
    const std::string_view digits = word.substr(0, mark);
    const auto point = std::min(digits.find('.'), digits.size());
    const auto first = std::min(digits.find_first_of("123456789"), digits.size());
    if (mark == word.size()) return first > point;
    std::string_view exponent = word.substr(mark + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    std::int64_t power = 0;
    const auto [end, error] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
    if (error != std::errc()) return exponent.starts_with('-');
    return static_cast<double>(power) + static_cast<double>(point) - static_cast<double>(first) < 0;
}

template <typename T>
std::optional<T> numberFrom(std::string_view word) {
    if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size()) return std::nullopt;
    if (error == std::errc()) return value;
    // Memory that was never set is written as numbers below the smallest double.
    if (std::is_floating_point_v<T> && error == std::errc::result_out_of_range && isTooSmall(word)) return T{};
    return std::nullopt;
}

template <typename T>
std::optional<std::vector<T>> numbersFrom(std::string_view text) {
    std::vector<T> values;
    for (const std::string& word : wordsOf(text)) {
        const auto value = numberFrom<T>(word);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

}  // namespace

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(whiteSpace);
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(whiteSpace) - first + 1));
}

std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    std::size_t position = 0;
    while ((position = text.find_first_not_of(whiteSpace, position)) != std::string_view::npos) {
        const auto end = std::min(text.find_first_of(whiteSpace, position), text.size());
        words.emplace_back(text.substr(position, end - position));
        position = end;
    }
    return words;
}

std::optional<std::int64_t> wholeNumber(std::string_view word) { return numberFrom<std::int64_t>(word); }
std::optional<double> realNumber(std::string_view word) { return numberFrom<double>(word); }
std::optional<double> positiveNumber(std::string_view word) {
    const auto value = realNumber(word);
    return value && std::isfinite(*value) && *value > 0.0 ? value : std::nullopt;
}
std::optional<std::vector<std::int64_t>> wholeNumbers(std::string_view text) { return numbersFrom<std::int64_t>(text); }
std::optional<std::vector<double>> realNumbers(std::string_view text) { return numbersFrom<double>(text); }

std::optional<std::string> withDecimalPoints(std::string_view text) {
    bool found = false;
    std::string points;
    for (std::string& word : wordsOf(text)) {
        if (const auto comma = word.find(','); comma != std::string::npos) {
            const auto isDigit = [&](std::size_t at) { return at < word.size() && word[at] >= '0' && word[at] <= '9'; };
            // A point beside it, or no digit behind it, leaves doubt whether the comma separates numbers.
            if (word.find('.') != std::string::npos || comma == 0 || !isDigit(comma - 1) || !isDigit(comma + 1))
                return std::nullopt;
            word[comma] = '.';
            found = true;
        }
        if (!realNumber(word)) return std::nullopt;
        points += points.empty() ? word : " " + word;
    }
    return found ? std::optional(points) : std::nullopt;
}

std::string quotedText(std::string_view text) {
    std::string plain = "\"";
    for (const char character : text.substr(0, 60)) {
        const bool printable = character >= 0x20 && character < 0x7f;
        plain += printable ? character : '?';
    }
    return plain + (text.size() > 60 ? "...\"" : "\"");
}

std::string repeatedNote(const std::set<std::string>& keys) {
    const std::string first = quotedText(*keys.begin());
    if (keys.size() == 1) return first + " stands twice in the header, with the same value.";
    return fmt::format("{} and {} more stand twice in the header, with the same values.", first, keys.size() - 1);
}

std::string decimalCommasNote(const std::string& key, std::string_view text) {
    return key + " has decimal commas, " + quotedText(text) + ": they are read as points.";
}

std::string remedyOfNumbers(std::string_view text) {
    return text.find(',') == std::string_view::npos
               ? correctHeader
               : "Write decimal points, and blanks between the numbers: a comma may be either.";
}

std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    return text;
}

bool endsLinesWithLoneCr(std::string_view text) {
    const auto first = text.find_first_of("\r\n");
    if (first == std::string_view::npos || text[first] == '\n') return false;
    const auto next = text.find_first_not_of('\r', first);
    return next != std::string_view::npos && text[next] != '\n';
}

std::optional<std::string_view> nextLine(std::string_view& rest) {
    if (rest.empty()) return std::nullopt;
    const auto end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

}  // namespace echolucent
