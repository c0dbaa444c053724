// The stored value that is shown as white, where no file declares one.
#pragma once

#include <cstdint>
#include <span>

#include "processing/volume/voxels.h"

namespace echolucent {

struct WhiteLevel {
    double level = 0.0;      ///< stored value of normalised intensity 1; 0 where no finite value lies above 0
    double largest = 0.0;    ///< largest finite value; it exceeds `level` only where float voxels hold absurd values
    std::int64_t above = 0;  ///< number of voxels above `level`
};

/// The largest finite value of all phases, so that they share one level. Float voxels may hold values that no echo has
/// (memory that was never written, a division by next to nothing): where the largest is at least 2^20 times, that is
/// 120 dB above, what 99 % of the voxels above 0 stay below, it would make a black picture of all others. Then values
/// from four times that bound on do not count. (The bound is a power of two.)
[[nodiscard]] WhiteLevel whiteLevelOf(std::span<const Voxels> phases);

}  // namespace echolucent
