#include "processing/parameter.h"

#include <array>
#include <cctype>
#include <charconv>

namespace echolucent {

std::string textOf(double number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 7).ptr;
    return {text.data(), end};
}

std::string camelCase(std::string_view name) {
    std::string camel;
    bool upper = false;
    for (const char letter : name) {
        if (letter != '_')
            camel += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
        upper = letter == '_';
    }
    return camel;
}

}  // namespace echolucent
