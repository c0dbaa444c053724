// A volume with marked voxels on an anisotropic grid that lies obliquely in the patient.
#pragma once

#include <memory>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

inline VolumeGeometry obliqueGrid() {
    VolumeGeometry geometry{.size = {90, 60, 40}, .spacing = {0.31, 0.57, 1.13}, .origin = {-41.5, 12.25, 103.75}};
    geometry.direction = rotationZ(31.7) * rotationX(-18.3) * rotationY(47.9);
    geometry.patientFrameKnown = true;
    return geometry;
}

/// Marked voxels, in no common plane of the grid.
inline const std::vector<Vec3> markedVoxels{{12, 9, 6},   {70, 44, 31}, {25, 50, 12},
                                            {61, 14, 28}, {80, 30, 9},  {44, 33, 20}};

/// A dark volume with a bright block of 3 x 3 x 3 voxels around each marked voxel.
inline std::shared_ptr<const Volume> markedPoints(const VolumeGeometry& geometry) {
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 20);
    for (const Vec3& marked : markedVoxels)
        for (int i = 0; i < 27; ++i) {
            const auto x = static_cast<std::int64_t>(marked[0]) + i % 3 - 1;
            const auto y = static_cast<std::int64_t>(marked[1]) + i / 3 % 3 - 1;
            const auto z = static_cast<std::int64_t>(marked[2]) + i / 9 - 1;
            voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] = 240;
        }
    return std::make_shared<const Volume>(geometry, Voxels(voxels), 255.0);
}

}  // namespace echolucent
