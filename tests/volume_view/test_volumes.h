// Small volumes with known content for the tests of the 3D view.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent::testing {

/// 8-bit voxels from a function of the voxel's index.
inline std::shared_ptr<const Volume> volumeOf(const VolumeGeometry& geometry,
                                              const std::function<int(double x, double y, double z)>& value) {
    std::vector<std::uint8_t> voxels;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                voxels.push_back(static_cast<std::uint8_t>(
                    value(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z))));
    return std::make_shared<const Volume>(geometry, std::move(voxels));
}

inline VolumeGeometry geometryOf(std::int64_t x, std::int64_t y, std::int64_t z, const Vec3& spacing = {1, 1, 1}) {
    VolumeGeometry geometry;
    geometry.size = {x, y, z};
    geometry.spacing = spacing;
    return geometry;
}

/// Fluid with a bright ball in the corner of small x, y and z, and hard speckle everywhere. It has no symmetry, so a
/// picture that is flipped, turned or shifted by a pixel differs.
inline std::shared_ptr<const Volume> ballInTheCorner(const Vec3& spacing = {1, 1, 1}) {
    return volumeOf(geometryOf(40, 36, 32, spacing), [](double x, double y, double z) {
        const bool ball = std::hypot(x - 11, y - 9, z - 8) < 7;
        const auto speckle = static_cast<unsigned>(x * 7919 + y * 104729 + z * 1299709) * 2654435761u >> 26;
        return (ball ? 180 : 20) + static_cast<int>(speckle);
    });
}

}  // namespace echolucent::testing
