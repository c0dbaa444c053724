// JPEG and JPEG-LS frames: what their headers declare, and decoding of JPEG by DCMTK.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/dicom/pixels/stream_colours.h"

namespace echolucent {

/// What the data set says of a JPEG or JPEG-LS frame.
struct JpegFrame {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    int samples = 1;
    int bitsAllocated = 8;
    bool isSigned = false;
};

/// What the header of a JPEG or JPEG-LS frame declares.
struct JpegHeader {
    std::string problem;  ///< as in Failure::problem; empty if the frame can be decoded
    int bits = 0;         ///< of each sample; 0 if there is a problem
    /// Of JPEG with three samples. APP14 (Adobe), components named R, G and B, a JFIF marker, chroma of fewer samples
    /// and, if there is no other sign, components named 1, 2 and 3 tell. Of lossless JPEG only the first two do,
    /// because nobody converts colours with loss for it and libraries write JFIF markers there all the same.
    StreamColours colours{};
};

/// Walks the markers of a JPEG or JPEG-LS codestream and compares them with `expected`, because decoders trust them
/// with memory and time. Checks size, samples and bits, and (of JPEG) that the bytes are enough to hold the picture.
/// Also checks that the picture has an end, and no more scans than any encoder writes.
[[nodiscard]] JpegHeader readJpegHeader(std::span<const std::uint8_t> data, const JpegFrame& expected);

/// Decodes a JPEG frame (not JPEG-LS) with this header, which readJpegHeader() found to be good, into `out`. `out`
/// holds columns * rows * samples values of bitsAllocated / 8 bytes, the samples of a pixel one after the other; no
/// colours are converted. Gives an empty text, or says what is wrong, also if the decoder had to make up values.
[[nodiscard]] std::string decodeJpeg(std::vector<std::uint8_t>& data, const JpegHeader& header,
                                     const JpegFrame& expected, std::span<std::uint8_t> out);

/// Spreads the bytes in the first half of `values` to words of this machine's byte order.
void widenBytes(std::span<std::uint8_t> values);

}  // namespace echolucent
