// How much light reaches each place of a volume, as a picture reads it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent {

/// How much light reaches places of a grid over a volume. Between places it is read trilinearly, beyond the outermost
/// places at the outermost.
struct LightVolume {
    std::array<int, 3> size{};  ///< places along x, y, z
    Vec3 firstMm;               ///< grid mm of place (0,0,0)
    Vec3 spacingMm;             ///< mm between places along x, y, z
    /// Two bytes a place, x fastest: first how much of the key light, then how much of the light around the viewer
    /// reaches it; 255 is all of it.
    std::vector<std::uint8_t> reaching;
    friend bool operator==(const LightVolume&, const LightVolume&) = default;
};

/// What reaches a place, in [0,1].
struct ReachingShares {
    double key = 1.0, around = 1.0;
};

/// The shares at a place in grid mm, in double.
[[nodiscard]] ReachingShares reachingAt(const LightVolume& light, const Vec3& gridMm);

}  // namespace echolucent
