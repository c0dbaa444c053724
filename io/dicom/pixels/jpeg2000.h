// JPEG 2000 frames through OpenJPEG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace echolucent {

/// What one frame must look like, from the data set; a codestream that disagrees is refused before it is decoded.
struct Jpeg2000Frame {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t samples = 1;
};

/// Decodes a codestream or .jp2 into planes of 32-bit values, sample after sample. The text is empty, or says what is
/// wrong. `colourIsYbr` is set to whether the first plane is luma already.
[[nodiscard]] std::string decodeJpeg2000(std::span<const std::uint8_t> data, const Jpeg2000Frame& expected,
                                         std::vector<std::int32_t>& values, bool& colourIsYbr);

}  // namespace echolucent
