// The phases of a stored volume that is too large to be kept: means of blocks, read slice by slice.
#pragma once

#include <cstdint>
#include <vector>

#include "io/stored/stored_bytes.h"
#include "io/stored/stored_volume.h"
#include "io/voxels/voxel_bytes.h"
#include "processing/volume/reduction.h"

namespace echolucent {

/// Reads all phases of `stored` from `source` and keeps their means, one value a voxel, in this machine's byte order;
/// colour is reduced to luma. Beside the means, memory is taken for the slices at one place along z only: one, or as
/// many as there are phases where these are interleaved. Fails as StoredBytes::read(), and (unreadable) where the
/// machine has no memory for these slices.
[[nodiscard]] Result<std::vector<VoxelBytes>> readReducedPhases(const StoredVolume& stored, StoredBytes& source,
                                                                const Reduction& reduction, const Progress& progress);

}  // namespace echolucent
