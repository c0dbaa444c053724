// Pictures as PNG files, through libpng.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "processing/result.h"

namespace echolucent {

/// The bytes of a PNG file that holds `rgb`: 8-bit red, green, blue, rows from the top, width * height * 3 bytes.
/// Throws std::invalid_argument where `rgb` has another size.
[[nodiscard]] std::string pngBytes(int width, int height, std::span<const std::uint8_t> rgb);

/// A picture of at most 256 colours, rows from the top, as the bytes of a PNG file with a palette: a third of the bytes
/// of pngBytes() or less. indices holds width * height places in the palette; the palette holds three bytes (red,
/// green, blue) a colour. Throws std::invalid_argument where these numbers do not fit each other.
[[nodiscard]] std::string palettePngBytes(int width, int height, std::span<const std::uint8_t> indices,
                                          std::span<const std::uint8_t> palette);

/// Writes the PNG file of pngBytes() to `path`, whole or not at all. Fails (unwritable) where that cannot be done.
[[nodiscard]] Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace echolucent
