// Where the light of a shaded picture stands, in the two angles that a person moves.
#pragma once

#include "processing/volume/geometry.h"

namespace echolucent {

/// As seen from what is looked at; (0, 0) is the viewer's own place. The default is the direction (-0.45, -0.55, -0.7)
/// in camera axes: upper left in front of the viewer.
struct LightDirection {
    double azimuthDegrees = -32.7352262721076;    ///< to the right of the viewer, [-180, 180]
    double elevationDegrees = 33.46175054954344;  ///< above the viewer, [-90, 90]
    friend bool operator==(const LightDirection&, const LightDirection&) = default;
};

/// The unit vector for Shading::towardsLight, in camera axes (right, down, forward). Exact in multiples of 90 degrees.
[[nodiscard]] Vec3 towardsLight(const LightDirection& light);

/// The light moved by a drag in shares of the picture's height, to the right and down: it follows the hand, half a turn
/// for a height. The azimuth wraps, the elevation stops at +-90 degrees.
[[nodiscard]] LightDirection moved(const LightDirection& light, double right, double down);

}  // namespace echolucent
