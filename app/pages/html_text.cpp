#include "app/pages/html_text.h"

#include <map>
#include <optional>
#include <vector>

#include "io/writers/picture_file.h"

namespace echolucent {

namespace {

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63u];
    }
    return text;
}

/// A picture as indices into a palette of its own colours.
struct Indexed {
    std::vector<std::uint8_t> indices, palette;
};

/// No value if the picture has more than 256 colours.
std::optional<Indexed> indexed(std::span<const std::uint8_t> rgb) {
    constexpr std::size_t mostColours = 256;
    Indexed picture;
    std::map<std::uint32_t, std::uint8_t> places;
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
        const std::uint32_t colour = std::uint32_t{rgb[i]} << 16 | std::uint32_t{rgb[i + 1]} << 8 | rgb[i + 2];
        const auto [place, isNew] = places.emplace(colour, static_cast<std::uint8_t>(places.size()));
        if (isNew && places.size() > mostColours) return std::nullopt;
        if (isNew) picture.palette.insert(picture.palette.end(), &rgb[i], &rgb[i] + 3);
        picture.indices.push_back(place->second);
    }
    return picture;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    for (const char c : text) switch (c) {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            case '"': safe += "&quot;"; break;
            case '\'': safe += "&#39;"; break;
            default: safe += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
        }
    return safe;
}

std::string dataUri(std::string_view type, std::string_view bytes) {
    return "data:" + std::string(type) + ";base64," + base64(bytes);
}

std::string pngDataUri(int width, int height, std::span<const std::uint8_t> rgb) {
    const auto few = indexed(rgb);
    return dataUri("image/png",
                   few ? palettePngBytes(width, height, few->indices, few->palette) : pngBytes(width, height, rgb));
}

}  // namespace echolucent
