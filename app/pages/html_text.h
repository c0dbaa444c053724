// Text and pictures as parts of an HTML or SVG document.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace echolucent {

/// Writes &, <, > and both quotes as entities, and control characters, which XML does not allow, as spaces.
[[nodiscard]] std::string escaped(std::string_view text);

/// 8-bit RGB, rows from the top, as an address "data:image/png;base64," with the PNG behind it. rgb holds
/// width * height * 3 bytes. A picture of at most 256 colours is written with a palette, which takes far fewer bytes.
[[nodiscard]] std::string pngDataUri(int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace echolucent
