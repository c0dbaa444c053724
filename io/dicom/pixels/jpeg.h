// JPEG and JPEG-LS frames: what their headers declare, and decoding of JPEG by DCMTK.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

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
};

/// Walks the markers of a JPEG or JPEG-LS codestream and compares them with `expected`, because decoders trust them
/// with memory and time. Checks size, samples and bits, and (of JPEG) that the bytes are enough to hold the picture.
/// Also checks that the picture has an end, and no more scans than any encoder writes.
[[nodiscard]] JpegHeader readJpegHeader(std::span<const std::uint8_t> data, const JpegFrame& expected);

/// Checks a JPEG frame (not JPEG-LS) with readJpegHeader() and decodes it into `out`. `out` holds columns * rows *
/// samples values of bitsAllocated / 8 bytes, the samples of a pixel one after the other. Gives an empty text, or says
/// what is wrong, also if the decoder had to make up values. `lumaFirst` is set if the frame says that its first sample
/// is luma.
[[nodiscard]] std::string decodeJpeg(std::vector<std::uint8_t>& data, const JpegFrame& expected,
                                     std::span<std::uint8_t> out, bool& lumaFirst);

}  // namespace echolucent
