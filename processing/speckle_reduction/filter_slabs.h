// Large volumes pass through a filter slab by slab, so that its floats never stand for all voxels at once.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

/// Slices along z that are filtered together, and those that are held for it: what the filter reaches is among them.
struct FilterSlab {
    std::int64_t first = 0, end = 0;          ///< the slices that are filtered; `end` is the first that is not
    std::int64_t firstHeld = 0, endHeld = 0;  ///< the slices that are held
};

/// More voxels than this are not filtered at once: in floats, 64 MiB.
inline constexpr std::int64_t mostVoxelsOfOneSlab = std::int64_t{1} << 24;

/// The slabs of a grid, each slice in one of them, for a filter that reaches so many slices to both sides. It is one
/// slab where the grid has no more than `mostVoxels`; slabs are else at least as thick as the filter reaches, so that
/// no more is held twice than filtered.
[[nodiscard]] std::vector<FilterSlab> filterSlabs(const VolumeGeometry& geometry, std::int64_t reach,
                                                  std::int64_t mostVoxels = mostVoxelsOfOneSlab);

/// The normalised intensities of the slices that a slab holds, 0 where there is no data, as a volume of floats of white
/// level 1: what is above the white level is 1, what is below 0 is 0, so that neither very large nor very small stored
/// values leave what a float can hold.
[[nodiscard]] Volume intensitiesOf(const Volume& volume, const FilterSlab& slab);

}  // namespace echolucent
