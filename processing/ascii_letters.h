// Upper and lower case of ASCII letters, which is the same on every desktop. The C library leaves the I of a Turkish
// one as it is.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace echolucent {

[[nodiscard]] constexpr char upperCase(char letter) {
    return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
}
[[nodiscard]] constexpr char lowerCase(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

/// The text with A to Z in lower case. Bytes beyond ASCII stay.
[[nodiscard]] inline std::string lowerCase(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char letter) { return lowerCase(letter); });
    return lower;
}

}  // namespace echolucent
