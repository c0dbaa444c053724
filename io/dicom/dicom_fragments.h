// Encapsulated pixel data: which fragments make up a frame, and whether a JPEG frame is what the data set says.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

class DcmPixelSequence;

namespace echolucent {

/// Fragments [first, first + count) of a pixel sequence; fragment 0 is the offset table.
struct FragmentRange {
    std::size_t first = 1;
    std::size_t count = 1;
};
using FragmentMap = std::vector<FragmentRange>;

/// One fragment a frame, or all for a single frame, or as the basic offset table says; else what is wrong.
[[nodiscard]] tl::expected<FragmentMap, std::string> mapFragments(DcmPixelSequence& fragments, std::int64_t frames);

/// The bytes of a range put together; none where one cannot be read.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> fragmentBytes(DcmPixelSequence& fragments,
                                                                     const FragmentRange& range);

/// What a JPEG or JPEG-LS frame must look like.
struct JpegFrame {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    int samples = 1;
    int bitsAllocated = 8;
};

/// Reads the frame header of a JPEG or JPEG-LS codestream. Empty where it agrees with the data set, else what is wrong:
/// decoders trust that header with memory and time.
[[nodiscard]] std::string jpegDisagreement(std::span<const std::uint8_t> data, const JpegFrame& expected);

}  // namespace echolucent
