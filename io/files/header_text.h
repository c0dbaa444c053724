// Text headers: lines, numbers and words, read strictly.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echolucent {

/// No header of a text format is longer than this many bytes.
constexpr std::size_t headerLimit = std::size_t{1} << 20;

/// The text without white space at its ends.
[[nodiscard]] std::string trimmed(std::string_view text);
/// The text with the letters A to Z made small; bytes beyond ASCII stay.
[[nodiscard]] std::string lowerCase(std::string_view text);
/// The words that white space separates.
[[nodiscard]] std::vector<std::string> wordsOf(std::string_view text);

/// The whole number that `word` is; no value where it is anything else.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(std::string_view word);
/// The number that `word` is (decimal, "nan" or "inf"); no value where it is anything else.
[[nodiscard]] std::optional<double> realNumber(std::string_view word);
/// The finite number above 0 that `word` is; no value where it is anything else.
[[nodiscard]] std::optional<double> positiveNumber(std::string_view word);
/// All words of `text` as numbers; no value where one of them is none.
[[nodiscard]] std::optional<std::vector<std::int64_t>> wholeNumbers(std::string_view text);
[[nodiscard]] std::optional<std::vector<double>> realNumbers(std::string_view text);

/// The text with control characters and bytes beyond ASCII replaced and at most 60 characters: fit for a sentence.
[[nodiscard]] std::string quotedText(std::string_view text);

/// Cuts one line (without its end, LF or CR LF) off the front of `rest`; no value where `rest` is empty.
[[nodiscard]] std::optional<std::string_view> nextLine(std::string_view& rest);

}  // namespace echolucent
