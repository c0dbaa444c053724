// A simulated scan in which opening finds beam and front.
#pragma once

#include <algorithm>
#include <memory>

#include "processing/phantom/phantom.h"
#include "tests/processing/beam/turned_volume.h"

namespace echolucent {

/// A sector scan whose probe stood at y = 0, with fluid behind a wall.
inline std::shared_ptr<const Volume> walledSector() {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {72, 72, 72};
    config.spacing = Vec3(1, 1, 1);
    config.seed = 8;
    config.frontWall = true;
    const Volume volume = *makePhantom(config);
    const Volume turned = turnedTo(volume, sectorMask(Sector::pyramid, config.size), BeamAxis::plusY);
    // A file has no mask, so voxels that no sector reaches are 0.
    auto voxels = std::get<VoxelArray<std::uint8_t>>(turned.voxels()).toVector();
    for (std::size_t i = 0; i < voxels.size(); ++i)
        voxels[i] = turned.dataMask()[i] == 0 ? std::uint8_t{0} : std::max<std::uint8_t>(voxels[i], 1);
    VolumeGeometry geometry = turned.geometry();
    geometry.spacing = Vec3(1, 1, 1);
    return std::make_shared<const Volume>(geometry, Voxels(std::move(voxels)));
}

}  // namespace echolucent
