// Reads lines, numbers and words of text headers, strictly.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace echolucent {

/// The most bytes of a text header.
constexpr std::size_t headerLimit = std::size_t{1} << 20;

/// The text without white space at its ends.
[[nodiscard]] std::string trimmed(std::string_view text);
/// The words between white space.
[[nodiscard]] std::vector<std::string> wordsOf(std::string_view text);

/// A word as a whole number; no value if it is anything else.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(std::string_view word);
/// A word as a number (decimal, "nan" or "inf"); no value if it is anything else, or too large. Numbers too small for a
/// double are 0.
[[nodiscard]] std::optional<double> realNumber(std::string_view word);
/// A word as a finite number above 0; no value if it is anything else.
[[nodiscard]] std::optional<double> positiveNumber(std::string_view word);
/// All words of `text` as numbers; no value if one is no number.
[[nodiscard]] std::optional<std::vector<std::int64_t>> wholeNumbers(std::string_view text);
[[nodiscard]] std::optional<std::vector<double>> realNumbers(std::string_view text);
/// The text with points for decimal commas ("0,5 0,5 1,2"), as programs write them in some countries. No value if it
/// has none, or if a word is no number then.
[[nodiscard]] std::optional<std::string> withDecimalPoints(std::string_view text);

/// The text in quotes, fit for a sentence: at most 60 bytes of it, then "...", with "?" for control characters and
/// bytes beyond ASCII.
[[nodiscard]] std::string quotedText(std::string_view text);

/// A sentence that names the keys of a header that stand twice, with the same value; there is at least one.
[[nodiscard]] std::string repeatedNote(const std::set<std::string>& keys);
/// A sentence that says that the decimal commas of the header's value `text` under `key` are read as points.
[[nodiscard]] std::string decimalCommasNote(const std::string& key, std::string_view text);
/// The remedy for a value that is no list of numbers. It tells of commas if the value has any.
[[nodiscard]] std::string remedyOfNumbers(std::string_view text);

/// The text without the mark of byte order (UTF-8) that some editors put before it.
[[nodiscard]] std::string_view withoutByteOrderMark(std::string_view text);

/// Whether the first line ends with CR alone, as old Macintosh programs wrote it. Such lines are not read.
[[nodiscard]] bool endsLinesWithLoneCr(std::string_view text);
/// What is wrong with such a header, and the remedy.
inline const char* const loneCrProblem = "has a header whose lines end with CR alone";
inline const char* const loneCrRemedy = "Save the header with LF or CR LF at the end of its lines.";

/// Cuts one line (without its end, LF or CR LF) off the front of `rest`; no value if `rest` is empty.
[[nodiscard]] std::optional<std::string_view> nextLine(std::string_view& rest);

}  // namespace echolucent
