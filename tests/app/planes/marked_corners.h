// A volume whose corners are told apart by their brightness.
#pragma once

#include <memory>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

/// The stored value of a corner's block. Bit 0 of the corner's number is set at larger x, bit 1 at larger y, bit 2 at
/// larger z.
inline int cornerValue(int corner) { return 60 + 25 * corner; }

/// A dark volume whose corners differ: blocks of 6 voxels, 4 from the faces. White is 255.
inline std::shared_ptr<const Volume> markedCorners() {
    VolumeGeometry geometry;
    geometry.size = {40, 44, 48};
    geometry.spacing = {1.0, 0.8, 1.2};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 10);
    for (int corner = 0; corner < 8; ++corner)
        for (int i = 0; i < 6 * 6 * 6; ++i) {
            const std::int64_t inner[] = {i % 6, i / 6 % 6, i / 36};
            std::int64_t at[3];
            for (int axis = 0; axis < 3; ++axis) {
                const std::int64_t size = geometry.size[static_cast<std::size_t>(axis)];
                at[axis] = (corner >> axis & 1 ? size - 10 : 4) + inner[axis];
            }
            voxels[static_cast<std::size_t>(geometry.offset(at[0], at[1], at[2]))] =
                static_cast<std::uint8_t>(cornerValue(corner));
        }
    return std::make_shared<const Volume>(geometry, Voxels(voxels), 255.0);
}

/// The middle of a corner's block, grid mm.
inline Vec3 cornerMm(const VolumeGeometry& geometry, int corner) {
    Vec3 voxel;
    for (int axis = 0; axis < 3; ++axis)
        voxel[axis] =
            corner >> axis & 1 ? static_cast<double>(geometry.size[static_cast<std::size_t>(axis)]) - 7.5 : 6.5;
    return geometry.gridMmFromVoxel(voxel);
}

}  // namespace echolucent
