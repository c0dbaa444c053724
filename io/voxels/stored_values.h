// The values of stored voxels before they are kept: what they reach, and how they are kept above a black that is not 0.
#pragma once

#include <vector>

#include "io/voxels/voxel_types.h"
#include "processing/volume/black_level.h"
#include "processing/volume/value_scale.h"

namespace echolucent {

/// Values of all phases as they are stored in the file (not in memory, as Volume::storedValue()), in this machine's
/// byte order, and the line that makes them the file's. It keeps references: all three must outlive it.
struct StoredValues {
    const std::vector<VoxelBytes>& phases;
    StoredType type;
    const Rescale& rescale;
};

[[nodiscard]] bool isWholeNumber(StoredType type);

/// Whether black can only be 0, and float32 holds the values: none lies below 0, they do not all lie near one that is
/// not 0, and none is beyond float32. Bytes that are not rescaled are ordinary unless negative. It reads most volumes
/// once, and no voxel twice.
[[nodiscard]] bool areOrdinary(const StoredValues& values);

/// What the file's values reach.
[[nodiscard]] ValueExtent extentOf(const StoredValues& values);
/// The file's values, in blocks.
[[nodiscard]] ValueBlocks blocksOf(const StoredValues& values);

/// Converts the bytes of every phase into voxels that give the file's values by `scale`. Whole numbers stay whole if
/// they are not rescaled and fit above black: as uint8 (from int8) or uint16. All others become float32, after black
/// was taken off them in double. Finite values beyond float32 become its largest one. `extent` is that of the values.
/// The memory of `phases` is freed on the way.
[[nodiscard]] ConvertedVoxels convertToScale(std::vector<VoxelBytes> phases, StoredType type, const Rescale& rescale,
                                             const ValueScale& scale, const ValueExtent& extent);

}  // namespace echolucent
