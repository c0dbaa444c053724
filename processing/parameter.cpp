#include "processing/parameter.h"

#include <array>
#include <charconv>

namespace echolucent {

std::string textOf(double number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 7).ptr;
    return {text.data(), end};
}

}  // namespace echolucent
