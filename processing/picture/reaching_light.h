// How the light that reaches a sample changes its colour.
#pragma once

#include "processing/picture/shading.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// Shading's ambient and diffuse light in a picture with a light volume. They are brighter, since less light reaches
/// each place. Chosen by looking.
inline constexpr double ambientWithReachingLight = 0.5, diffuseWithReachingLight = 1.3;

/// If a step adds a certain opacity to its pixel, it is lit by its gradient. If it adds at least this share of that
/// opacity, the light volume says how much light reaches it. If it adds less, all light reaches it.
inline constexpr double leastReachedShare = 1.0 / 16;

/// What a sample's gradient says of the light on it, in the terms of Shading. All are 0 if the gradient is 0.
/// `share` is w, `diffuse` is max(0, (n.l + wrap) / (1 + wrap)), `highlight` is max(0, n.h)^specularPower.
struct SurfaceLight {
    double share = 0.0, diffuse = 0.0, highlight = 0.0;
};
/// `towardsLight` and `rayDirection` are unit; the gradient is in normalised intensity per unit.
[[nodiscard]] SurfaceLight surfaceLight(const Shading& shading, const Vec3& gradient, const Vec3& towardsLight,
                                        const Vec3& rayDirection);

/// The factor of a sample's colour, for red, green and blue. k is the share of the key light that reaches the sample, o
/// the share of the light around the viewer, both in [0,1]:
///     c      = (k + translucency (sqrt(k) - k),  k,  k + translucency (k k - k))
///     k'     = 1 - shadow (1 - c)                  o' = 1 - occlusion (1 - o)
///     factor = ambient o' + k' (diffuse (w lambert + (1 - w) evenLight) + w specular highlight)
/// w, lambert and highlight are the share, diffuse and highlight of `surface`. If shadow and occlusion are 0, this is
/// the factor of Shading. Shading applies the factor, channel by channel. Tissue scatters red deepest and blue least,
/// so light through a little tissue is warm. Full light is white, and no place glows without light.
[[nodiscard]] Vec3 reachingFactor(const Shading& shading, double key, double around, const SurfaceLight& surface);

}  // namespace echolucent
