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

/// Which fragments make up each of `frames` frames: one fragment a frame, all fragments for a single frame, or what the
/// basic offset table says. Fails with what is wrong where none of these fits.
[[nodiscard]] tl::expected<FragmentMap, std::string> mapFragments(DcmPixelSequence& fragments, std::int64_t frames);

/// The bytes of a range of fragments put together; no value where a fragment cannot be read.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> fragmentBytes(DcmPixelSequence& fragments,
                                                                     const FragmentRange& range);

/// What a JPEG or JPEG-LS frame must look like by the data set.
struct JpegFrame {
    std::int64_t columns = 0;
    std::int64_t rows = 0;
    int samples = 1;
    int bitsAllocated = 8;
};

/// Compares the frame header of a JPEG or JPEG-LS codestream with `expected`, because decoders trust that header with
/// memory and time. The text is empty where they agree; else it says what is wrong.
[[nodiscard]] std::string jpegDisagreement(std::span<const std::uint8_t> data, const JpegFrame& expected);

}  // namespace echolucent
