#include "processing/light/light_volume.h"

#include <algorithm>
#include <cstddef>

namespace echolucent {

ReachingShares reachingAt(const LightVolume& light, const Vec3& gridMm) {
    std::array<int, 3> low{};
    std::array<double, 3> share{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double last = light.size[i] - 1;
        const double at = std::clamp((gridMm[axis] - light.firstMm[axis]) / light.spacingMm[axis], 0.0, last);
        low[i] = std::min(static_cast<int>(at), std::max(light.size[i] - 2, 0));
        share[i] = at - low[i];
    }
    double key = 0.0, around = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        std::size_t offset = 0;
        for (std::size_t i = 3; i-- > 0;) {
            const int up = (corner >> i) & 1;
            weight *= up != 0 ? share[i] : 1.0 - share[i];
            const int place = std::min(low[i] + up, light.size[i] - 1);
            offset = offset * static_cast<std::size_t>(light.size[i]) + static_cast<std::size_t>(place);
        }
        key += weight * light.reaching[2 * offset];
        around += weight * light.reaching[2 * offset + 1];
    }
    return {key / 255.0, around / 255.0};
}

}  // namespace echolucent
