// The stored value that is shown as white, where no file declares one, and whether a declared one can be true.
#pragma once

#include <cstdint>
#include <span>

#include "processing/volume/voxels.h"

namespace echolucent {

/// What the finite voxels above 0 say of white. All values are stored values; they are 0 where there is no such voxel.
struct WhiteLevel {
    double level = 0.0;      ///< shown as normalised intensity 1
    double middle = 0.0;     ///< about half of the voxels above 0 lie below it (within 1 %)
    double largest = 0.0;    ///< largest finite value; it exceeds `level` where hot voxels were left out
    std::int64_t above = 0;  ///< number of voxels above `level`
};

/// The white level of all phases together, so that they share one. It is the 99.99 % percentile of the voxels above 0
/// (in small volumes at most eight voxels, and no more than 1 %, lie above it), raised to the largest value that is
/// reached from there without a gap of more than a tenth (or of one, where voxels are whole numbers): ordinary data
/// keep their largest value, and hot voxels, which stand alone above a gap, move nothing. Where even the percentile is
/// 2^20 times (120 dB) what 99 % of the voxels stay below, float voxels hold values that no echo has (memory that was
/// never written, a division by next to nothing): only values below four times that bound, a power of two, are looked
/// at then.
[[nodiscard]] WhiteLevel whiteLevelOf(std::span<const Voxels> phases);

/// How a declared white level suits the voxels.
enum class DeclaredWhite {
    suits,
    notAboveZero,  ///< it is 0, negative or not a number
    tooHigh,       ///< it is more than eight times the voxels' own white level: their picture would be black
    tooLow,        ///< it lies below half of the voxels above 0: most of the picture would be white
};

/// Judges a declared white level (a stored value) beside what the voxels say. Voxels without a value above 0 suit any
/// level above 0.
[[nodiscard]] DeclaredWhite judgeDeclaredWhite(double declared, const WhiteLevel& measured);

}  // namespace echolucent
