// Volumes whose light is known in closed form.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "processing/light/light_sweep.h"
#include "processing/volume/volume.h"

namespace echolucent::light_test {

/// Bytes of 0 or 255: 255 if `inside` is true for a voxel.
inline std::shared_ptr<const Volume> volumeOf(const VolumeGeometry& geometry,
                                              const std::function<bool(const Vec3& voxel)>& inside) {
    std::vector<std::uint8_t> voxels;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                voxels.push_back(
                    inside(Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z))) ? 255 : 0);
    return std::make_shared<const Volume>(geometry, std::move(voxels));
}

inline VolumeGeometry cubeGeometry(int edge) {
    VolumeGeometry geometry;
    geometry.size = {edge, edge, edge};
    return geometry;
}

/// Opacity 0 at intensity 0, linear to `opacity` per unit at intensity 1.
inline OpacityCurve rising(double opacity) { return ManualCurve{{{0.0, 0.0}, {1.0, opacity}}}; }

/// A light scene with a key light without penumbra. Light is computed voxel by voxel and attenuated by the whole
/// extinction.
inline LightScene keyAlong(const Vec3& towardsKey) {
    LightScene scene;
    scene.towardsKey = towardsKey;
    scene.keyHalfAngleDegrees = 0.0;
    scene.coarseness = 1;
    scene.attenuation = 1.0;
    return scene;
}

inline std::size_t offsetOf(const LightVolume& light, int x, int y, int z) {
    return 2 *
           (static_cast<std::size_t>(x) +
            static_cast<std::size_t>(light.size[0]) *
                (static_cast<std::size_t>(y) + static_cast<std::size_t>(light.size[1]) * static_cast<std::size_t>(z)));
}
inline int keyAt(const LightVolume& light, int x, int y, int z) { return light.reaching[offsetOf(light, x, y, z)]; }
inline int aroundAt(const LightVolume& light, int x, int y, int z) {
    return light.reaching[offsetOf(light, x, y, z) + 1];
}

}  // namespace echolucent::light_test
