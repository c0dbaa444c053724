// Text and pictures as parts of an HTML or SVG document.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace echolucent {

/// Writes &, <, > and both quotes as entities. Writes control characters other than line feeds as spaces, as XML does
/// not allow them.
[[nodiscard]] std::string escaped(std::string_view text);

/// An address "data:TYPE;base64," followed by the bytes.
[[nodiscard]] std::string dataUri(std::string_view type, std::string_view bytes);

/// An address "data:image/png;base64," followed by the PNG. rgb holds width * height * 3 bytes: 8-bit RGB, rows from
/// the top. A picture of at most 256 colours gets a palette, which takes far fewer bytes.
[[nodiscard]] std::string pngDataUri(int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace echolucent
