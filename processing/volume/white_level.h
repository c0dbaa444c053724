// The stored value to show as white, if no file declares one, and whether a declared value can be true.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "processing/volume/voxels.h"

namespace echolucent {

/// The white level that the finite voxels above 0 suggest. All values are stored values, and 0 if there is no such
/// voxel.
struct WhiteLevel {
    double level = 0.0;      ///< shown as normalised intensity 1
    double middle = 0.0;     ///< about half of the voxels above 0 lie below it (within 1 %)
    double largest = 0.0;    ///< largest finite value; above `level` if hot voxels were left out
    std::int64_t above = 0;  ///< number of voxels above `level`
    std::int64_t all = 0;    ///< number of finite voxels above 0
};

/// The white level that all phases share. It begins at the 99.99 % percentile of the voxels above 0. (In small volumes
/// at most eight voxels, and no more than 1 %, lie above it.) From there it rises to the largest value that it reaches
/// without a gap of more than a tenth. Whole numbers that differ by one have no gap between them. So ordinary data keep
/// their largest value, and hot voxels, alone above a gap, move nothing.
/// Float voxels can hold values that no echo has, from memory never written or a division by almost nothing. Such
/// values are assumed if the 99.99 % percentile is at least 2^20 times (120 dB) the power of two above 99 % of the
/// voxels. Then only values below four times that power count.
[[nodiscard]] WhiteLevel whiteLevelOf(std::span<const Voxels> phases);

/// Hands over values in blocks, of any length and in any order, by calling its argument for each.
using ValueBlocks = std::function<void(const std::function<void(std::span<const double>)>& take)>;
/// The same of values that are not in memory as voxels. `values` is called twice and hands over the same each time.
[[nodiscard]] WhiteLevel whiteLevelOf(const ValueBlocks& values, bool wholeNumbers);

/// How a declared white level suits the voxels.
enum class DeclaredWhite {
    suits,
    notAboveZero,  ///< it is 0, negative or not a number
    tooHigh,       ///< it exceeds eight times the voxels' own white level: their picture would be black
    tooLow,        ///< it lies below half of the voxels above 0: most of the picture would be white
};

/// Compares a declared white level (a stored value) with the voxels' own. Voxels without a value above 0 suit any level
/// above 0.
[[nodiscard]] DeclaredWhite judgeDeclaredWhite(double declared, const WhiteLevel& measured);

}  // namespace echolucent
