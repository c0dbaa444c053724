// What light that reaches a sample makes of its colour.
#pragma once

#include "processing/picture/shading.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// Shading's ambient and diffuse light in a picture that uses a light volume: they make up for what reaches no place.
/// Chosen by looking.
inline constexpr double ambientWithReachingLight = 0.5, diffuseWithReachingLight = 1.3;

/// What a sample's gradient says of the light on it (Shading): w, max(0, (n.l + wrap) / (1 + wrap)) and
/// max(0, n.h)^specularPower.
struct SurfaceLight {
    double share = 0.0, diffuse = 0.0, highlight = 0.0;
};
/// `towardsLight` and `rayDirection` are unit; the gradient is in normalised intensity per unit.
[[nodiscard]] SurfaceLight surfaceLight(const Shading& shading, const Vec3& gradient, const Vec3& towardsLight,
                                        const Vec3& rayDirection);

/// The factor of a sample's colour, for red, green and blue. With k and o in [0,1] what reaches the sample of the key
/// light and of the light around the viewer:
///     c      = (k + translucency (sqrt(k) - k),  k,  k + translucency (k k - k))
///     k'     = 1 - shadow (1 - c)                  o' = 1 - occlusion (1 - o)
///     factor = ambient o' + k' (diffuse (w lambert + (1 - w) evenLight) + w specular highlight)
/// With both strengths 0 that is the factor of Shading; what becomes of it stands there too, channel by channel. Red is
/// scattered deepest and blue least, so that light that has gone through a little tissue is warm; full light is white,
/// and where no light comes nothing glows.
[[nodiscard]] Vec3 reachingFactor(const Shading& shading, double key, double around, const SurfaceLight& surface);

}  // namespace echolucent
