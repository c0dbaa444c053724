// Whether the commas in voxels that are written as text separate numbers or stand for decimal points.
#pragma once

#include <cstdint>

#include "io/files/input_file.h"
#include "io/voxels/voxel_source.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What the text of an extent holds.
struct TextNumbers {
    std::uint64_t words = 0;         ///< between white space
    std::uint64_t numbers = 0;       ///< between white space and commas
    std::uint64_t commasWithin = 0;  ///< commas directly between two digits
    bool hasOtherCommas = false;     ///< whether a comma stands elsewhere, beside a point, or twice in a word

    /// Whether the text fits as this many numbers, with decimal commas or none.
    [[nodiscard]] bool fitAsWords(std::uint64_t values) const { return !hasOtherCommas && words == values; }
    /// Whether there are more numbers than `values`, as if decimal commas had been taken for separators.
    [[nodiscard]] bool seemSplit(std::uint64_t values) const {
        return numbers > values && commasWithin > 0 && (!hasOtherCommas || commasWithin >= values / 2);
    }
};

/// Whether a comma stands in an extent of text. It reads up to the first one, far faster than numbers are counted or
/// decoded. Fails as countNumbers().
[[nodiscard]] Result<bool> holdsComma(const InputFile& file, const VoxelExtent& extent, const Progress& progress);

/// Reads an extent of text once. Fails (unreadable) if the file cannot be read; (cancelled) if the person ended it.
[[nodiscard]] Result<TextNumbers> countNumbers(const InputFile& file, const VoxelExtent& extent,
                                               const Progress& progress);

}  // namespace echolucent
