#include "processing/speckle_reduction/filter_spacing.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

Vec3 filterSpacing(const VolumeGeometry& geometry) {
    if (!geometry.spacingKnown) return {1, 1, 1};
    double logarithms = 0.0;
    int axes = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (geometry.size[static_cast<std::size_t>(axis)] < 2) continue;
        logarithms += std::log(geometry.spacing[axis]);
        ++axes;
    }
    if (axes == 0) return {1, 1, 1};
    const double perMean = std::exp(-logarithms / axes);
    Vec3 spacing = geometry.spacing * perMean;
    for (int axis = 0; axis < 3; ++axis) spacing[axis] = std::max(spacing[axis], leastFilterSpacing);
    return spacing;
}

}  // namespace echolucent
