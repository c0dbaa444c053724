// Gradient magnitudes as bytes, one a voxel, for pictures and light with two-dimensional OTFs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Gradient magnitudes (GradientMagnitude) in 255 equal steps. Byte b is the magnitude b / 255 * largest, and larger
/// magnitudes are 255. Magnitudes up to `largest` are off by at most largest / 510.
struct GradientLevels {
    double largest = 1.0;             ///< TwoDimensionalOtf::largestGradient, normalised intensity per unit
    std::vector<std::uint8_t> bytes;  ///< one a voxel, x fastest
};

/// The gradient levels of a volume without edges: `filled` is filledVoxels(volume). The result is empty only if
/// progress.cancel was raised. Throws std::invalid_argument if `largest` is not above 0.
[[nodiscard]] std::optional<GradientLevels> gradientLevels(const Volume& filled, double largest,
                                                           const Progress& progress = {});

}  // namespace echolucent
