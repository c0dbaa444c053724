// Encapsulated pixel data: which fragments make up a frame.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

class DcmPixelItem;
class DcmPixelSequence;

namespace echolucent {

/// Fragments [first, first + count) of a pixel sequence, counted from 0 behind its offset table.
struct FragmentRange {
    std::size_t first = 0;
    std::size_t count = 1;
};
using FragmentMap = std::vector<FragmentRange>;

/// The fragments of each frame. It must not outlive the pixel sequence.
struct FrameFragments {
    std::vector<DcmPixelItem*> items;  ///< all fragments
    FragmentMap frames;
    std::string warning{};  ///< a sentence if the file contradicts itself; else empty
};

/// Codings that mark where a picture begins and ends; JPEG-LS has the markers of JPEG.
enum class Codestream { none, jpeg, jpeg2000 };

/// Finds the fragments of each of `frames` frames. One fragment may be one frame, or all fragments a single frame. Else
/// the basic or the extended offset table tells (`extendedOffsets`, (7FE0,0001); it may be empty), or the fragments
/// that begin a picture behind one that has ended. Fails with what is wrong if none of these fits.
[[nodiscard]] tl::expected<FrameFragments, std::string> mapFragments(DcmPixelSequence& fragments, std::int64_t frames,
                                                                     Codestream kind,
                                                                     std::vector<std::uint64_t> extendedOffsets);

/// The bytes of a frame's fragments put together; no value if a fragment cannot be read.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> fragmentBytes(const FrameFragments& fragments,
                                                                     std::size_t frame);

}  // namespace echolucent
