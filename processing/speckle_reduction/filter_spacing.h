// The unit of length in the filters of speckle reduction.
#pragma once

#include "processing/volume/volume.h"

namespace echolucent {

/// The least distance between neighbours, in mean voxels. It bounds a filter on flat voxels: a reach of 3 is at most 12
/// voxels.
inline constexpr double leastFilterSpacing = 0.25;
/// The distance between neighbours along each axis, in mean voxels. The geometric mean of the distances is 1, so a
/// filter takes as many voxels as with equal spacings. Axes of one voxel do not count. If the spacing is not known,
/// every distance is 1. Distances below leastFilterSpacing are then raised to it.
[[nodiscard]] Vec3 filterSpacing(const VolumeGeometry& geometry);

}  // namespace echolucent
