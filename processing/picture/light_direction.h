// The direction of the light in a shaded picture, in the two angles that a person moves.
#pragma once

#include "processing/volume/geometry.h"

namespace echolucent {

/// The direction as seen from the scene; (0, 0) is the viewer's own place. The default is the direction (-0.45, -0.55,
/// -0.7) in camera axes: upper left in front of the viewer.
struct LightDirection {
    double azimuthDegrees = -32.7352262721076;    ///< to the right of the viewer, [-180, 180]
    double elevationDegrees = 33.46175054954344;  ///< above the viewer, [-90, 90]
    friend bool operator==(const LightDirection&, const LightDirection&) = default;
};

/// The unit vector for Shading::towardsLight, in camera axes (right, down, forward). Exact at multiples of 90 degrees.
[[nodiscard]] Vec3 towardsLight(const LightDirection& light);

/// Moves the light by a drag to the right and down, in shares of the picture's height. The light follows the hand, half
/// a turn for a height. The azimuth wraps, the elevation stops at +-90 degrees.
[[nodiscard]] LightDirection moved(const LightDirection& light, double right, double down);

}  // namespace echolucent
