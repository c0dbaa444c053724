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

/// The fragments of each frame. The object must not outlive the pixel sequence.
struct FrameFragments {
    std::vector<DcmPixelItem*> items;  ///< all fragments
    FragmentMap frames;
    std::string warning{};  ///< a sentence if the file contradicts itself; else empty
};

/// The coding of pictures that begin in a known way. They end in a known way too, but for RLE. `jpeg` is JPEG-LS too.
enum class Codestream { none, jpeg, jpeg2000, rle };

/// Finds the fragments of each of `frames` frames. A single frame has all fragments. If there are as many fragments as
/// frames, each frame has one; if not, empty fragments do not count. Else the basic offset table tells, or if that is
/// empty the extended one (`extendedOffsets`, (7FE0,0001); it may be empty too). If no table fits, a frame begins at
/// each fragment that begins a picture after the picture before has ended. Fails with what is wrong if none of these
/// fits, or if the fragments of a single frame hold several pictures.
[[nodiscard]] tl::expected<FrameFragments, std::string> mapFragments(DcmPixelSequence& fragments, std::int64_t frames,
                                                                     Codestream kind,
                                                                     std::vector<std::uint64_t> extendedOffsets);

/// The bytes of a frame's fragments put together; no value if a fragment cannot be read.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> fragmentBytes(const FrameFragments& fragments,
                                                                     std::size_t frame);

}  // namespace echolucent
