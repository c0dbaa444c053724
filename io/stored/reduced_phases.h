// Reads the phases of a volume that is too large to be kept, slice by slice, as means of blocks.
#pragma once

#include <cstdint>
#include <vector>

#include "io/stored/stored_bytes.h"
#include "io/stored/stored_volume.h"
#include "io/voxels/voxel_bytes.h"
#include "processing/volume/reduction.h"

namespace echolucent {

/// Reads all phases of `stored` from `source` and keeps their means, one value for each voxel, in this machine's byte
/// order. Colour is reduced to luma. Beside the means, memory holds one slice only, or that slice of all phases if they
/// are interleaved. Fails as StoredBytes::read(), and (unreadable) if the machine has too little memory for these
/// slices.
[[nodiscard]] Result<std::vector<VoxelBytes>> readReducedPhases(const StoredVolume& stored, StoredBytes& source,
                                                                const Reduction& reduction, const Progress& progress);

}  // namespace echolucent
