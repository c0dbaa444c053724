// Gradient magnitudes row by row, for the tests of gradients.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "processing/sampling/gradient_magnitude.h"

namespace echolucent {

/// The gradient magnitudes of all voxels, x fastest, normalised intensity per unit.
inline std::vector<float> magnitudesOf(const Volume& volume) {
    const auto& size = volume.geometry().size;
    const GradientMagnitude gradients(volume);
    std::vector<float> all(static_cast<std::size_t>(volume.geometry().voxelCount()));
    const auto columns = static_cast<std::size_t>(size[0]);
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            gradients.row(y, z, std::span(all).subspan(static_cast<std::size_t>(y + size[1] * z) * columns, columns));
    return all;
}

}  // namespace echolucent
