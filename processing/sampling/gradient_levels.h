// Gradient magnitudes as bytes, one a voxel: what pictures and light of two-dimensional OTFs read.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Gradient magnitudes (GradientMagnitude) in 255 equal steps: byte b is the magnitude b / 255 * largest, and what is
/// larger is 255. Magnitudes are off by at most largest / 510.
struct GradientLevels {
    double largest = 1.0;             ///< TwoDimensionalOtf::largestGradient, normalised intensity per unit
    std::vector<std::uint8_t> bytes;  ///< one a voxel, x fastest
};

/// Makes one pass over the volume without edges (filledVoxels()). The result is empty only where progress.cancel was
/// raised. Throws std::invalid_argument where `largest` is not above 0.
[[nodiscard]] std::optional<GradientLevels> gradientLevels(const Volume& filled, double largest,
                                                           const Progress& progress = {});

}  // namespace echolucent
