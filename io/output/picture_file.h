// Pictures as PNG files, through libpng.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "processing/result.h"

namespace echolucent {

/// 8-bit RGB, rows from the top, as the bytes of a PNG file. rgb holds width * height * 3 bytes (else
/// std::invalid_argument).
[[nodiscard]] std::string pngBytes(int width, int height, std::span<const std::uint8_t> rgb);

/// Writes 8-bit RGB, rows from the top, atomically. rgb holds width * height * 3 bytes.
[[nodiscard]] Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace echolucent
