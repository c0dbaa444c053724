// Makes left-handed grids right-handed: one of their axes is turned round, in geometry and voxels. All that follows
// (rays, planes, tube cores, writers) takes the axes of a grid for right-handed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/stored/stored_volume.h"
#include "io/voxels/voxel_bytes.h"
#include "processing/volume/coarse_grid.h"
#include "processing/volume/grid_axis.h"
#include "processing/volume/reduction.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The axis to turn round if a grid is left-handed: the one that runs most against an axis of the file's own frame. Of
/// several alike it is the last, and if none runs against one, z. So a file whose only fault is an axis that runs
/// backwards becomes what it would be without. No value if the grid is right-handed, or if voxels lie along beams.
[[nodiscard]] std::optional<GridAxis> axisToTurn(const StoredVolume& stored);

/// What the report says of the axis.
[[nodiscard]] std::string handednessInWords(GridAxis turned);

/// The geometry whose voxels lie where they lay, but are counted from the other end of an axis. A reduction then has
/// its smaller block at the other end too.
[[nodiscard]] VolumeGeometry turnedRound(const VolumeGeometry& geometry, GridAxis axis);
/// Blocks counted from the other end of an axis.
[[nodiscard]] Reduction turnedRound(const Reduction& reduction, GridAxis axis);
/// The same voxels of the volume on a coarse grid, as the volume is stored. `grid` is of turnedRound(stored, axis).
[[nodiscard]] CoarseGrid asStored(const CoarseGrid& grid, const VolumeGeometry& stored, GridAxis axis);

/// Turns voxels of `bytes` bytes each round along an axis, in place: all phases, each of `size`.
void turnRound(std::vector<VoxelBytes>& phases, const std::array<std::int64_t, 3>& size, std::size_t bytes,
               GridAxis axis);

}  // namespace echolucent
