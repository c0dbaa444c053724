// How much light reaches each place of a volume, as a picture reads it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent {

/// How much light reaches the places of a grid over a volume. Light is read trilinearly between places, and as the
/// nearest outermost place beyond them.
struct LightVolume {
    std::array<int, 3> size{};  ///< places along x, y, z
    Vec3 firstMm;               ///< grid mm of place (0,0,0)
    Vec3 spacingMm;             ///< mm between places along x, y, z
    /// Two bytes a place, x fastest: the share of the key light that reaches the place, then that of the light around
    /// the viewer. 255 is all light.
    std::vector<std::uint8_t> reaching;
    friend bool operator==(const LightVolume&, const LightVolume&) = default;
};

/// The shares of light that reach a place, in [0,1].
struct ReachingShares {
    double key = 1.0, around = 1.0;
};

/// The shares at a place in grid mm, in double precision.
[[nodiscard]] ReachingShares reachingAt(const LightVolume& light, const Vec3& gridMm);

}  // namespace echolucent
