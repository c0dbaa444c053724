#include "processing/ray_caster/light_source.h"

#include <algorithm>
#include <cmath>

namespace echolucent::ray_casting {

LightSource lightSource(const Shading& shading, const VolumeGeometry& geometry, const ViewFrame& frame,
                        ColourMap colourMap) {
    LightSource source;
    const Vec3& light = shading.towardsLight;
    const Vec3 towards = normalized(frame.right * light[0] + frame.down * light[1] + frame.forward * light[2]);
    const Vec3 tint = shadowTintOf(colourMap);
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double units = geometry.spacing[axis] / geometry.unit();
        source.towardsLight[i] = static_cast<float>(towards[axis]);
        source.unitsPerVoxel[i] = static_cast<float>(units);
        source.reach[i] = shading.gradientReach / units;
        source.shadowTint[i] = static_cast<float>(tint[axis]);
    }
    source.ambient = static_cast<float>(shading.ambient);
    source.diffuse = static_cast<float>(shading.diffuse);
    source.evenLight = static_cast<float>(shading.evenLight);
    source.wrap = static_cast<float>(shading.wrap);
    source.shadow = static_cast<float>(shading.reaching.shadow);
    source.occlusion = static_cast<float>(shading.reaching.occlusion);
    source.translucency = static_cast<float>(shading.reaching.translucency);
    source.floorSquare = static_cast<float>(shading.gradientFloor * shading.gradientFloor);
    for (std::size_t i = 0; i < source.highlight.size(); ++i) {
        const double cosine = std::min(1.0, static_cast<double>(i) / LightSource::highlightIntervals);
        source.highlight[i] = static_cast<float>(shading.specular * std::pow(cosine, shading.specularPower));
    }
    return source;
}

}  // namespace echolucent::ray_casting
