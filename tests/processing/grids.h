// Grids for tests of volumes and their readers.
#pragma once

#include <array>
#include <cstdint>

#include "processing/volume/volume.h"

namespace echolucent {

/// A grid of this many voxels along x, y and z; the spacing is in mm.
inline VolumeGeometry gridOf(const std::array<std::int64_t, 3>& size, const Vec3& spacing = {1, 1, 1}) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    return geometry;
}

}  // namespace echolucent
