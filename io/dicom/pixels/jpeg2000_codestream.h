// The codestream of a JPEG 2000 frame before it is decoded: what it declares, and whether all of it is there.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace echolucent {

/// What the data set says of a frame. A codestream that disagrees is refused before it is decoded.
struct Jpeg2000Frame {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t samples = 1;
    int bitsAllocated = 8;
};

/// A codestream or .jp2 with a seal behind every tile: bytes that are no packet. A decoder that runs out of packets
/// then fails instead of taking the missing ones for empty. JPEG 2000 has no other mark of missing data. The seal only
/// proves that all packets begin: the last of them may go on into the seal.
struct SealedCodestream {
    std::vector<std::uint8_t> bytes;
    unsigned levels = 0;    ///< how often all samples of all tiles can be halved in size
    bool isJp2 = false;     ///< whether the codestream stands in the boxes of a .jp2
    bool isSigned = false;  ///< whether any sample is signed
    int bits = 0;           ///< of the sample that has most
    /// Whether the decoder turns three samples of another colour space into red, green and blue.
    bool transformsColours = false;
};

/// Walks the markers of one frame, a codestream or .jp2, compares them with `expected`, bounds the cost of decoding,
/// and seals it. Fails with what is wrong, as in Failure::problem, if the codestream disagrees with `expected`, or if a
/// tile or a part of one is missing. It also fails if planes are subsampled, if the headers of packets are kept apart,
/// or if there are more tiles, precincts, code-blocks or layers than any encoder writes.
[[nodiscard]] tl::expected<SealedCodestream, std::string> sealCodestream(std::span<const std::uint8_t> data,
                                                                         const Jpeg2000Frame& expected);

}  // namespace echolucent
