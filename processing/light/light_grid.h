// The coarse grid of a light volume.
#pragma once

#include <array>
#include <cstddef>

#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent::light {

inline constexpr int coarsest =
    16;  ///< the largest LightScene::coarseness, and the most voxels of a place along an axis

/// Places over a volume from the grid's low corner on, each of `voxels` voxels along each axis. The last places of an
/// axis may reach beyond the volume.
struct LightGrid {
    std::array<int, 3> voxels{1, 1, 1};  ///< along x, y, z in a place
    std::array<int, 3> size{1, 1, 1};    ///< places along x, y, z
    Vec3 firstMm, spacingMm;             ///< grid mm: the centre of place (0,0,0), and the way from place to place

    /// Places `coarseness` units apart along each axis, rounded to whole voxels: at least one, at most the volume's.
    LightGrid(const VolumeGeometry& geometry, int coarseness);
    [[nodiscard]] std::size_t places() const {
        return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
               static_cast<std::size_t>(size[2]);
    }
    [[nodiscard]] Vec3 gridMm(int x, int y, int z) const { return firstMm + spacingMm.mul(Vec3(x, y, z)); }
};

}  // namespace echolucent::light
