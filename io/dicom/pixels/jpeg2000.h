// JPEG 2000 frames through OpenJPEG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/dicom/pixels/jpeg2000_codestream.h"
#include "io/dicom/pixels/stream_colours.h"

namespace echolucent {

/// The decoded samples of one frame.
struct Jpeg2000Samples {
    std::vector<std::int32_t> values;  ///< in planes, sample after sample
    bool isSigned = false;             ///< whether the codestream declares signed values of any sample
    int bits = 0;                      ///< that the codestream declares of the sample that has most
    StreamColours colours{};           ///< of three samples: as decoded
};

/// Decodes a codestream or .jp2. Gives an empty text, or says what is wrong: what sealCodestream() finds, or that
/// planes or other parts of the frame are missing or damaged.
[[nodiscard]] std::string decodeJpeg2000(std::span<const std::uint8_t> data, const Jpeg2000Frame& expected,
                                         Jpeg2000Samples& samples);

}  // namespace echolucent
