// Pictures as PNG files, through libpng.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "processing/result.h"

namespace echolucent {

/// Writes 8-bit RGB, rows from the top, atomically. rgb holds width * height * 3 bytes.
[[nodiscard]] Result<void> writePng(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

}  // namespace echolucent
