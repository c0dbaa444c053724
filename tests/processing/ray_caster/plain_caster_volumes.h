// Layered volumes and settings for the tests of the plain route.
#pragma once

#include <algorithm>
#include <vector>

#include "processing/ray_caster/plain/plain_caster.h"
#include "ray_caster_reference.h"

namespace echolucent {

/// A volume of `layers` along z. Each is constant across.
template <typename Voxel>
Volume layered(const std::vector<Voxel>& layers, double white = 255.0) {
    VolumeGeometry geometry;
    geometry.size = {12, 12, static_cast<std::int64_t>(layers.size())};
    std::vector<Voxel> voxels;
    for (const Voxel layer : layers) voxels.insert(voxels.end(), 144, layer);
    return Volume(geometry, std::move(voxels), white);
}

inline Volume slab(std::size_t depth, std::uint8_t value) { return layered(std::vector<std::uint8_t>(depth, value)); }

/// A curve of opacity p from intensity a up to b, and of 0 elsewhere.
inline OpacityCurve between(double a, double b, double p) { return ManualCurve{{{a, 0}, {a, p}, {b, p}, {b, 0}}}; }

inline RayCastSettings greySettings(const Volume& volume) {
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 5, 5);
    settings.colourMap = ColourMap::grey;
    settings.findDepth = true;
    return settings;
}

inline Picture cast(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings,
                    const PlainCasting& casting = {}) {
    return *castRaysPlainly(volume, curve, settings, casting);
}

inline double centreDepth(const Picture& picture) { return static_cast<double>(picture.depthMm.at(2 * 5 + 2)); }

/// The rounding of values in [0,1] that end as float.
inline constexpr double floatError = 1.2e-7;

}  // namespace echolucent
