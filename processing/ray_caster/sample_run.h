// Many samples of one ray at once, with the widest vectors of the machine at hand.
#pragma once

#include <cstddef>
#include <cstdint>

#include "processing/ray_caster/transfer_table.h"

namespace echolucent::ray_casting {

/// Voxels counted from a corner; positions in it are in voxels and small. All voxels around a position asked for must
/// exist, and so must `readAhead<Voxel>` voxels after them along x.
template <typename Voxel>
struct VoxelBlock {
    const Voxel* first;
    std::int32_t rowStride, sliceStride;  ///< voxels; times the cells of a run and the voxel's bytes below 2^31
};

/// Vectors are gathered as 32-bit words: that many voxels along x beyond a sample's own two may be read (not used).
template <typename Voxel>
inline constexpr int readAhead = sizeof(Voxel) == 1 ? 3 : sizeof(Voxel) == 2 ? 1 : 0;

/// Results are written in whole vectors: arrays for n results need room for n + runPadding.
inline constexpr int runPadding = 8;

/// Table positions (TransferTable::at) of the samples start + i * step, i = 0 ... count - 1; `toTable` is stored value
/// to table position. -1 where the value is not finite. The same bits on every instruction set.
template <typename Voxel>
void tablePositionsAlong(const VoxelBlock<Voxel>& block, Interpolation interpolation, Float4 start, Float4 step,
                         int count, float toTable, float* positions);

/// Trilinear samples of stored values at eight positions.
template <typename Voxel>
void trilinearAtEight(const VoxelBlock<Voxel>& block, const float* x, const float* y, const float* z, float* values);

}  // namespace echolucent::ray_casting
