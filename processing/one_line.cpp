#include "processing/one_line.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace echolucent {

namespace {

struct Letter {
    char32_t code = 0;
    std::size_t bytes = 1;
    bool valid = false;  ///< whether it is UTF-8; if not, it is one byte
};

/// The letter at the beginning of a text that is not empty.
Letter firstLetter(std::string_view text) {
    const auto first = static_cast<std::uint8_t>(text[0]);
    if (first < 0x80) return {first, 1, true};
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < bytes) return {};
    char32_t code = first & (0x7fU >> bytes);
    for (std::size_t index = 1; index < bytes; ++index) {
        const auto next = static_cast<std::uint8_t>(text[index]);
        if ((next & 0xc0U) != 0x80) return {};
        code = (code << 6U) | (next & 0x3fU);
    }
    // Each letter has one valid spelling only, and a half of a surrogate pair is no letter.
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    if (code < least[bytes] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return {};
    return {code, bytes, true};
}

/// Whether a byte of UTF-8 is the first one of a letter.
bool beginsLetter(char byte) { return (static_cast<std::uint8_t>(byte) & 0xc0U) != 0x80; }

bool isBlankHere(char32_t code) {
    return code < 0x20 || (code >= 0x7f && code <= 0x9f) || code == 0x2028 || code == 0x2029 ||
           (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string oneLine(std::string_view text, std::size_t longest) {
    std::string line;
    while (!text.empty()) {
        const Letter letter = firstLetter(text);
        const std::string_view shown = !letter.valid              ? "\xef\xbf\xbd"
                                       : isBlankHere(letter.code) ? " "
                                                                  : text.substr(0, letter.bytes);
        if (line.size() + shown.size() > longest) return line + "...";
        line += shown;
        text.remove_prefix(letter.bytes);
    }
    return line;
}

std::size_t letterCount(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, beginsLetter));
}

std::string_view firstLetters(std::string_view text, std::size_t most) {
    std::size_t letters = 0, end = 0;
    for (; end < text.size(); ++end)
        if (beginsLetter(text[end]) && letters++ == most) break;
    return text.substr(0, end);
}

}  // namespace echolucent
