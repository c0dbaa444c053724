#include "processing/picture/reaching_light.h"

#include <algorithm>
#include <cmath>

namespace echolucent {

SurfaceLight surfaceLight(const Shading& shading, const Vec3& gradient, const Vec3& towardsLight,
                          const Vec3& rayDirection) {
    const double magnitude = length(gradient);
    if (!(magnitude > 0.0)) return {};
    const Vec3 normal = gradient * (-1.0 / magnitude), half = towardsLight - rayDirection;
    SurfaceLight light;
    light.share = magnitude * magnitude / (magnitude * magnitude + shading.gradientFloor * shading.gradientFloor);
    light.diffuse = std::max(0.0, (normal.dot(towardsLight) + shading.wrap) / (1.0 + shading.wrap));
    if (length(half) > 0.0)
        light.highlight = std::pow(std::max(0.0, normal.dot(normalized(half))), shading.specularPower);
    return light;
}

Vec3 reachingFactor(const Shading& shading, double key, double around, const SurfaceLight& surface) {
    const ReachingLight& light = shading.reaching;
    const double even = surface.share * surface.diffuse + (1.0 - surface.share) * shading.evenLight;
    const double direct = shading.diffuse * even + surface.share * shading.specular * surface.highlight;
    const double open = 1.0 - light.occlusion * (1.0 - around);
    const Vec3 warm{key + light.translucency * (std::sqrt(key) - key), key,
                    key + light.translucency * (key * key - key)};
    const Vec3 lit = Vec3::all(1.0 - light.shadow) + warm * light.shadow;
    return Vec3::all(shading.ambient * open) + lit * direct;
}

}  // namespace echolucent
