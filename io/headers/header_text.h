// Text headers: lines, numbers and words, read strictly.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echolucent {

/// Headers of text formats are never longer; what is longer is not a header.
constexpr std::size_t headerLimit = std::size_t{1} << 20;

[[nodiscard]] std::string trimmed(std::string_view text);
[[nodiscard]] std::string lowerCase(std::string_view text);
/// Words between white space.
[[nodiscard]] std::vector<std::string> wordsOf(std::string_view text);

/// A whole number and nothing else.
[[nodiscard]] std::optional<std::int64_t> wholeNumber(std::string_view word);
/// A decimal number, "nan" or "inf", and nothing else.
[[nodiscard]] std::optional<double> realNumber(std::string_view word);
/// A finite number above 0 and nothing else.
[[nodiscard]] std::optional<double> positiveNumber(std::string_view word);
/// All words as numbers, or none where one is not.
[[nodiscard]] std::optional<std::vector<std::int64_t>> wholeNumbers(std::string_view text);
[[nodiscard]] std::optional<std::vector<double>> realNumbers(std::string_view text);

/// The text with control characters and bytes beyond ASCII replaced and at most 60 characters: fit for a sentence.
[[nodiscard]] std::string quotedText(std::string_view text);

/// Cuts one line (without its end, LF or CR LF) off the front of `rest`; none where `rest` is empty.
[[nodiscard]] std::optional<std::string_view> nextLine(std::string_view& rest);

}  // namespace echolucent
