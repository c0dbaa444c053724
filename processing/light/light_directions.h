// The directions from which light comes: a few stand for all directions of a cone.
#pragma once

#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent::light {

/// At this half-angle the cone is a whole hemisphere.
inline constexpr double hemisphereDegrees = 90.0;

struct WeightedDirection {
    Vec3 towards;  ///< of length 1, grid mm: towards the light
    double weight = 1.0;
};

/// How many directions stand for a cone; each rule is named by this number.
enum class DirectionRule { one = 1, four = 4, seven = 7, twelve = 12 };

/// Directions within `halfAngleDegrees` (0 to 90) of `axis` (any length above 0); their weights sum to 1. An angle of 0
/// gives the axis alone. A direction counts by its cosine with the axis. So 90 degrees is the light of a whole
/// hemisphere on a surface that faces it. Seen along the axis, the cone is then an evenly weighted disc. The rules
/// integrate polynomials over a disc to degree 1, 3, 5 and 7 (Stroud 1971, S2 3-1, S2 5-1, S2 7-1).
[[nodiscard]] std::vector<WeightedDirection> directionsWithin(const Vec3& axis, double halfAngleDegrees,
                                                              DirectionRule rule);

/// The same light from 3 rings^2 directions of equal weight, each for an equal part of the disc.
[[nodiscard]] std::vector<WeightedDirection> denseDirectionsWithin(const Vec3& axis, double halfAngleDegrees,
                                                                   int rings);

}  // namespace echolucent::light
