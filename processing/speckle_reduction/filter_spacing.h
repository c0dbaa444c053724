// The length in which the filters of speckle reduction measure.
#pragma once

#include "processing/volume/volume.h"

namespace echolucent {

/// In mean voxels, so that a filter stays bounded on flat voxels: a reach of 3 is 12 voxels at most.
inline constexpr double leastFilterSpacing = 0.25;
/// The distance between neighbours along each axis, in mean voxels: the geometric mean of the spacings is 1, so that a
/// filter gathers as many voxels as it would where all spacings are equal. Axes of one voxel have no say; where the
/// spacing is not known, every distance is 1. None is below leastFilterSpacing.
[[nodiscard]] Vec3 filterSpacing(const VolumeGeometry& geometry);

}  // namespace echolucent
