// A filter takes large volumes slab by slab, so that it never holds floats for all voxels at once.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

/// Slices along z to filter together, and the slices that this needs in memory.
struct FilterSlab {
    std::int64_t first = 0, end = 0;          ///< the slices to filter; `end` is the first behind them
    std::int64_t firstHeld = 0, endHeld = 0;  ///< the slices in memory
};

/// Volumes of more voxels than this are filtered slab by slab. As floats, this many voxels take 64 MiB.
inline constexpr std::int64_t mostVoxelsAtOnce = std::int64_t{1} << 24;

/// The slabs of a grid; each slice is in one of them. A slab holds its own slices and up to `reach` slices behind them.
/// A grid of at most `mostVoxels` is one slab. Slabs of larger grids have about an eighth of `mostVoxels`, but at least
/// `reach` slices, and at least `threads` slices, since a thread filters one slice at a time. The last slab may be
/// thinner.
[[nodiscard]] std::vector<FilterSlab> filterSlabs(const VolumeGeometry& geometry, std::int64_t reach,
                                                  std::int64_t mostVoxels, std::int64_t threads);

}  // namespace echolucent
