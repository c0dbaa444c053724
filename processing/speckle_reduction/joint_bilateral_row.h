// One row of a joint bilateral filter, many voxels at a time. Products and sums are kept apart and terms are added in
// one order, so that the bits are the same on any instruction set.
#pragma once

#include <cstdint>
#include <span>

namespace echolucent {

/// A neighbour that may take part in a mean.
struct BilateralTap {
    std::int64_t offset;  ///< from the voxel in the middle, in voxels of the padded grid
    float weight;         ///< by its distance, above 0
};

/// results[i] is the mean of the values around i, each weighted by its tap's weight times Tukey's biweight
/// (1 - d^2)^2 of how far its guide is from the guide in the middle, d; nothing from a distance of 1 on. guide[i] and
/// values[i] are the voxel in the middle; all taps must lie in memory.
/// The voxel in the middle must be among the taps.
void bilateralRow(const float* guide, const float* values, std::span<const BilateralTap> taps, std::size_t count,
                  float* results);

}  // namespace echolucent
