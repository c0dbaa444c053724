#include "processing/light/light_grid.h"

#include <algorithm>
#include <cmath>

namespace echolucent::light {

LightGrid::LightGrid(const VolumeGeometry& geometry, int coarseness) {
    const double wanted = coarseness * geometry.unit();
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const auto along =
            std::clamp(std::llround(wanted / geometry.spacing[axis]), 1LL, static_cast<long long>(geometry.size[i]));
        voxels[i] = static_cast<int>(along);
        size[i] = static_cast<int>((geometry.size[i] + along - 1) / along);
        spacingMm[axis] = geometry.spacing[axis] * static_cast<double>(along);
        firstMm[axis] = geometry.spacing[axis] * 0.5 * static_cast<double>(along - 1);
    }
}

}  // namespace echolucent::light
