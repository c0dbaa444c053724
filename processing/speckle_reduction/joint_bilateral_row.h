// One row of a joint bilateral filter, many voxels at a time. Products and sums are separate and the order of terms is
// fixed, so that the bits are the same on any instruction set.
#pragma once

#include <cstdint>
#include <span>

namespace echolucent {

/// A neighbour that may take part in a mean.
struct BilateralTap {
    std::int64_t offset;  ///< from the voxel in the middle, in voxels of the padded grid
    float weight;         ///< by the distance of the neighbour, above 0
};

/// results[i] is the mean of the values around i. The weight of a value is (1 - d^2)^2, Tukey's biweight, times
/// the weight of its tap. d is the difference between the value's guide and the guide in the middle; from d = 1 on the
/// weight is 0. guide[i] and values[i] are the voxel in the middle. All taps must lie in memory, and the voxel in the
/// middle must be one of them.
void bilateralRow(const float* guide, const float* values, std::span<const BilateralTap> taps, std::size_t count,
                  float* results);

}  // namespace echolucent
