// The colours that PALETTE COLOR pixels stand for, as luma; plain and segmented palettes.
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
    std::int64_t first = 0;          ///< pixel value that stands for the first entry
    bool segmented = false;          ///< whether it was stored as segments
};

/// Reads the palette of a data set into `palette`. The text is empty, or says what is wrong with the palette, as in
/// Failure::problem.
[[nodiscard]] std::string readPalette(DcmItem& item, DicomPalette& palette);

/// The `count` entries that a segmented palette (PS3.3 C.7.9.2) describes: discrete segments, straight lines and copies
/// of segments that stand before. `data` holds one number a word or, where entries have 8 bits (`bytes`), one a byte;
/// no value where a segment runs beyond the data or beyond `count`, where a copy names no segment before it, or where
/// the segments give fewer entries.
[[nodiscard]] std::optional<std::vector<std::uint16_t>> expandSegments(std::span<const std::uint16_t> data, bool bytes,
                                                                       std::size_t count);

}  // namespace echolucent
