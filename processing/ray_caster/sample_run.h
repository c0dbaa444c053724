// Many samples of one ray at once, with the widest vectors of the machine at hand.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "processing/ray_caster/transfer_table.h"

namespace echolucent::ray_casting {

/// Voxels counted from a corner; positions in it are in voxels and small. All voxels around a position asked for must
/// exist, and so must `readAhead` voxels after them along x.
template <typename Voxel>
struct VoxelBlock {
    const Voxel* first;
    const std::uint8_t* mask;             ///< of the same voxel, 0 where there is no data; null: all are data
    std::int32_t rowStride, sliceStride;  ///< voxels; times the cells of a run and the voxel's bytes below 2^31
};

/// Bytes are gathered as 32-bit words: that many voxels along x beyond a sample's own two may be read (not used).
inline constexpr int readAhead = 3;

/// A gradient may lack data of that trilinear weight: less is the rounding of positions.
inline constexpr float missingWeight = 1e-5f;

/// Whether the voxels around samples all carry data, or the mask must be asked.
enum class DataAround { complete, masked };

/// Table positions that stand for something else.
inline constexpr float noDataPosition = -1.0f;     ///< less than half a sample's weight is on voxels with data
inline constexpr float notFinitePosition = -2.0f;  ///< a voxel said to carry data is not a number

/// Samples at most in one call of the functions below.
inline constexpr int batchSize = 16;
/// One value a sample. Results are written in whole vectors of up to eight.
using Batch = std::array<float, batchSize + 8>;

/// A straight run of samples: sample i lies at start + i * step in the block.
struct SampleRun {
    Float4 start, step;
};

/// Table positions (TransferTable::at) of samples 0 ... count - 1; `toTable` is stored value to table position. The
/// same bits on every instruction set, as for all here.
template <typename Voxel>
void tablePositionsAlong(const VoxelBlock<Voxel>& block, Interpolation interpolation, DataAround data,
                         const SampleRun& run, int count, float toTable, Batch& positions);

/// The components of vectors.
struct Gradients {
    Batch x, y, z;
};

/// Central differences of trilinear samples, `reach` (voxels) before and after on each axis, times `scale`, at samples
/// `samples[0 ... count - 1]` of the run; zero where one of the samples touches a voxel without data.
template <typename Voxel>
void gradientsAlong(const VoxelBlock<Voxel>& block, DataAround data, const SampleRun& run, const Batch& samples,
                    int count, Float4 reach, float scale, Gradients& gradients);

/// One directional light as Shading says it, for one ray.
struct DirectionalLight {
    static constexpr int highlightIntervals = 1024;
    Float4 towardsLight, half;  ///< unit vectors; half way between light and eye (zero: no highlight)
    float ambient, diffuse, evenLight, wrap, floorSquare;
    const float* highlight;  ///< over the cosine between normal and half, linear between; intervals + 2 values
};

/// What light does to samples: `factors` multiply their colours.
void lightOf(const DirectionalLight& light, const Gradients& gradients, int count, Batch& factors);

}  // namespace echolucent::ray_casting
