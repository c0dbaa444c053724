// Rows of a volume under a separable filter, many voxels at a time. Products and sums are separate and the order of
// terms is fixed, so that the bits are the same on any instruction set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace echolucent {

/// One row for each tap of a filter. Voxel is std::uint8_t, std::uint16_t or float.
template <typename Voxel>
struct VoxelRows {
    const Voxel* first = nullptr;        ///< row of the first tap
    const std::uint8_t* mask = nullptr;  ///< mask of that row, or null
    std::int64_t stride = 0;             ///< from tap to tap, voxels
    std::size_t count = 0;               ///< voxels in a row
};

/// sums[i] = sum over the taps t of taps[t] * (first + t * stride)[i], over voxels whose mask is not 0. weightSums[i]
/// is the sum of the taps that took part. Without a mask all voxels take part, and weightSums does not change.
void sumRows(const VoxelRows<std::uint8_t>& rows, std::span<const float> taps, float* sums, float* weightSums);
void sumRows(const VoxelRows<std::uint16_t>& rows, std::span<const float> taps, float* sums, float* weightSums);
void sumRows(const VoxelRows<float>& rows, std::span<const float> taps, float* sums, float* weightSums);

/// The range into which means are clamped, in stored values.
struct StoredRange {
    float lowest, highest;
};

/// voxels[i] = sums[i] / weights[i], clamped into the range, rounded if voxels are whole numbers. If a weight is 0, the
/// voxel is some value of the range.
void storeMeans(std::span<const float> sums, const float* weights, const StoredRange& range, std::uint8_t* voxels);
void storeMeans(std::span<const float> sums, const float* weights, const StoredRange& range, std::uint16_t* voxels);
void storeMeans(std::span<const float> sums, const float* weights, const StoredRange& range, float* voxels);

}  // namespace echolucent
