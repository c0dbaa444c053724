// Light in the kernel's numbers.
#pragma once

#include <array>

#include "processing/picture/colour_map.h"
#include "processing/picture/shading.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/geometry.h"

namespace echolucent::ray_casting {

/// The directional light of a Shading, and the gradient's reach.
struct LightSource {
    static constexpr int highlightIntervals = 1024;
    /// A reference step is lit as a surface if it adds at least this much to its pixel's opacity.
    static constexpr double worthGradient = 1.0 / 128;

    std::array<float, 3> towardsLight{};  ///< unit, grid mm
    std::array<double, 3> reach{};        ///< voxels
    std::array<float, 3> unitsPerVoxel{};
    float ambient = 0, diffuse = 0, evenLight = 0, wrap = 0, floorSquare = 0;
    float shadow = 0, occlusion = 0, translucency = 0;
    std::array<float, 3> shadowTint{};
    std::array<float, highlightIntervals + 2> highlight{};  ///< over the cosine between normal and half vector
};
[[nodiscard]] LightSource lightSource(const Shading& shading, const VolumeGeometry& geometry, const ViewFrame& frame,
                                      ColourMap colourMap);

}  // namespace echolucent::ray_casting
