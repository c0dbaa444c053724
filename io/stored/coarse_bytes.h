// Reads every n-th voxel of files that store voxels raw.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/stored/stored_bytes.h"
#include "io/stored/stored_volume.h"
#include "io/voxels/voxel_bytes.h"
#include "processing/progress.h"
#include "processing/volume/coarse_grid.h"

namespace echolucent {

/// The coarse grid of a stored volume whose voxels can be read at any place: stored raw, phase after phase, on a
/// Cartesian grid with a spacing that scanners have, and with rows of at most 4 MiB. No value for all others, and for
/// volumes for which coarseGridOf() of their geometry has none.
[[nodiscard]] std::optional<CoarseGrid> coarseGridOf(const StoredVolume& stored);

/// The stored bytes of the first phase's voxels on a coarse grid. Only the slices of the grid are read. Fails
/// (unreadable) if a file cannot be read, (cancelled) if the person ended it.
[[nodiscard]] Result<VoxelBytes> readCoarseBytes(const StoredVolume& stored, StoredBytes& source,
                                                 const CoarseGrid& grid, const Progress& progress);

}  // namespace echolucent
