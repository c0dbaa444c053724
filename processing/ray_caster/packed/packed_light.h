// A light volume in the order the kernel reads it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/light/light_volume.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent::ray_casting {

/// Eight bytes for each place (x,y): the key light at places (x,y), (x,y+1), (x+1,y), (x+1,y+1) of its slice, then the
/// light around the viewer at the same places. So two loads of eight bytes give both lights between eight places.
struct PackedLight {
    static constexpr int bytesPerPlace = 8;

    PackedLight(const LightVolume& light, const VolumeGeometry& geometry);

    std::vector<std::uint8_t> places;  ///< with one slice more than the light volume, for places that are rounded up
    std::array<std::int32_t, 3> size;  ///< places along x, y, z, without that slice
    std::array<double, 3> perVoxel, firstVoxel{};  ///< place = (voxel position) * perVoxel + firstVoxel
};

}  // namespace echolucent::ray_casting
