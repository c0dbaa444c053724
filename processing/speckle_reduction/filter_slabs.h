// Large volumes pass through a filter slab by slab, so that its floats never stand for all voxels at once.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

/// Slices along z that are filtered together, and those that are held for it.
struct FilterSlab {
    std::int64_t first = 0, end = 0;          ///< the slices that are filtered; `end` is the first that is not
    std::int64_t firstHeld = 0, endHeld = 0;  ///< the slices that are held
};

/// Volumes of more voxels than this are filtered slab by slab. As floats, so many take 64 MiB.
inline constexpr std::int64_t mostVoxelsAtOnce = std::int64_t{1} << 24;

/// The slabs of a grid, each slice in one of them; each holds its own and `reach` slices behind them, as far as there
/// are so many. It is one slab where the grid has no more than `mostVoxels`. Slabs of larger grids have an eighth of
/// that, but at least `reach` slices, and at least one for each of `threads`, which filter a slice each.
[[nodiscard]] std::vector<FilterSlab> filterSlabs(const VolumeGeometry& geometry, std::int64_t reach,
                                                  std::int64_t mostVoxels, std::int64_t threads);

}  // namespace echolucent
