// Writes pictures as PNG files, through libpng.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "processing/result.h"

namespace echolucent {

/// A PNG file of `rgb`: 8-bit red, green, blue, rows from the top, width * height * 3 bytes. Throws
/// std::invalid_argument if `rgb` has another size, std::runtime_error if libpng fails.
[[nodiscard]] std::string pngBytes(int width, int height, std::span<const std::uint8_t> rgb);

/// A PNG file with a palette of at most 256 colours, rows from the top: a third of the bytes of pngBytes() or less.
/// `indices` holds width * height places in the palette, which has three bytes (red, green, blue) for each colour.
/// Throws std::invalid_argument if these numbers do not fit each other, std::runtime_error if libpng fails.
[[nodiscard]] std::string palettePngBytes(int width, int height, std::span<const std::uint8_t> indices,
                                          std::span<const std::uint8_t> palette);

/// Writes pngBytes() to `path`, whole or not at all. Fails (unwritable) if libpng fails or the file cannot be written.
/// Throws std::invalid_argument if `rgb` has another size.
[[nodiscard]] Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace echolucent
