// The codestream of a JPEG 2000 frame before it is decoded: what it declares, and that all of it is there.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace echolucent {

/// What one frame must look like, from the data set; a codestream that disagrees is refused before it is decoded.
struct Jpeg2000Frame {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t samples = 1;
    int bitsAllocated = 8;
};

/// A codestream or .jp2 in which every tile is followed by bytes that are no packet, so that a decoder fails where it
/// runs out of packets instead of taking the missing ones for empty: JPEG 2000 has no other mark of what was cut out.
/// It only proves that all packets begin: the last of them may go on into the seal.
struct SealedCodestream {
    std::vector<std::uint8_t> bytes;
    unsigned levels = 0;    ///< how often every sample of every tile can be halved in size
    bool isJp2 = false;     ///< whether the codestream stands in the boxes of a .jp2
    bool isSigned = false;  ///< whether any sample is signed
};

/// Walks the markers of one frame, a codestream or .jp2, compares them with `expected`, bounds what decoding may cost,
/// and seals it. Fails with what is wrong, as in Failure::problem, where both disagree, a tile or a part of one is
/// missing, or the tiles, precincts, code-blocks or layers are more than any encoder writes.
[[nodiscard]] tl::expected<SealedCodestream, std::string> sealCodestream(std::span<const std::uint8_t> data,
                                                                         const Jpeg2000Frame& expected);

}  // namespace echolucent
