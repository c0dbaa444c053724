// The colours of PALETTE COLOR pixels as luma; plain and segmented palettes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

class DcmItem;

namespace echolucent {

/// A palette reduced to grey.
struct DicomPalette {
    std::vector<std::uint8_t> luma;  ///< luma of each entry (ITU-R BT.601)
    std::int64_t first = 0;          ///< the pixel value of the first entry
    bool segmented = false;          ///< whether it was stored as segments
    std::vector<std::string> notes;  ///< sentences on what was assumed
};

/// Reads the palette of a data set into `palette`. Whether its entries hold 8, 16 or some bits between is decided once
/// for all three colours. `isSigned` tells whether pixels are signed, as the pixel value of the first entry then is.
/// Gives an empty text, or says what is wrong, as in Failure::problem.
[[nodiscard]] std::string readPalette(DcmItem& item, bool isSigned, DicomPalette& palette);

/// A note if pixels that are grey by name have the palette of some colours beside it; else an empty text.
[[nodiscard]] std::string supplementalPalette(DcmItem& item);

/// The `count` entries of a segmented palette (PS3.3 C.7.9.2): discrete segments, straight lines and copies of earlier
/// segments. Each element of `data` is one number of the palette: a word of 16 bits, or a byte if entries have 8 bits
/// (`bytes`). No value if a segment is of unknown kind or of length 0, if it runs beyond the data or beyond `count`, or
/// if the segments give fewer entries than `count`. No value either if a line has no entry before it, or if a copy
/// names no earlier segment, or another copy.
[[nodiscard]] std::optional<std::vector<std::uint16_t>> expandSegments(std::span<const std::uint16_t> data, bool bytes,
                                                                       std::size_t count);

}  // namespace echolucent
