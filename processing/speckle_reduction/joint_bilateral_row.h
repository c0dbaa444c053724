// One row of a joint bilateral filter, many voxels at a time. Products and sums are separate and the order of terms is
// fixed, so that the bits are the same on any instruction set.
#pragma once

#include <cstdint>
#include <span>

namespace echolucent {

/// A neighbour that may take part in a mean.
struct BilateralTap {
    std::int64_t offset;  ///< from the voxel in the middle, in voxels of the padded grid
    float weight;         ///< by its distance, above 0
};

/// results[i] is the mean of the values around i. Each is weighted by its tap's weight times Tukey's biweight
/// (1 - d^2)^2, with d the distance of its guide from the guide in the middle; 0 from a distance of 1 on. guide[i] and
/// values[i] are the voxel in the middle. All taps must lie in memory, the voxel in the middle among them.
void bilateralRow(const float* guide, const float* values, std::span<const BilateralTap> taps, std::size_t count,
                  float* results);

}  // namespace echolucent
