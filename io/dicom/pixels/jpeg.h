// JPEG and JPEG-LS frames: what their own headers declare, and JPEG through DCMTK's decoders.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace echolucent {

/// What a JPEG or JPEG-LS frame must look like by the data set.
struct JpegFrame {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    int samples = 1;
    int bitsAllocated = 8;
    bool isSigned = false;
};

/// What the header of a JPEG or JPEG-LS frame has to say.
struct JpegHeader {
    std::string problem;  ///< as in Failure::problem; empty where the frame can be decoded
    int bits = 0;         ///< of each sample
};

/// Walks the markers of a JPEG or JPEG-LS codestream and compares them with `expected`, because decoders trust them
/// with memory and time: size, samples and bits, that the picture can be in as few bytes, that it ends, and that it
/// does not come in more scans than any encoder writes.
[[nodiscard]] JpegHeader readJpegHeader(std::span<const std::uint8_t> data, const JpegFrame& expected);

/// Decodes a JPEG frame (not JPEG-LS) that readJpegHeader() has found no problem with into `out`, which holds
/// columns * rows * samples values of bitsAllocated / 8 bytes, the samples of a pixel one after the other. The text is
/// empty, or says what is wrong; a decoder that had to make up values is wrong. `lumaFirst` is set where the frame says
/// that its first sample is luma.
[[nodiscard]] std::string decodeJpeg(std::vector<std::uint8_t>& data, const JpegFrame& expected,
                                     std::span<std::uint8_t> out, bool& lumaFirst);

}  // namespace echolucent
