// From where light comes: a few directions that stand for all directions of a cone.
#pragma once

#include <vector>

#include "processing/volume/geometry.h"

namespace echolucent::light {

/// The half-angle of the cone that is a whole hemisphere.
inline constexpr double hemisphereDegrees = 90.0;

struct WeightedDirection {
    Vec3 towards;  ///< unit, grid mm: towards the light
    double weight = 1.0;
};

/// How many directions stand for a cone: a rule's name is its number of directions.
enum class DirectionRule { one = 1, four = 4, seven = 7, twelve = 12 };

/// Directions within `halfAngleDegrees` (0 to 90) of `axis` (any length above 0); their weights sum to 1. A direction
/// counts by its cosine with the axis, so that 90 degrees is the light of a whole hemisphere on a surface that faces
/// it: cones are discs then, seen from above, and the rules are those that integrate polynomials over a disc to degree
/// 1, 3, 5 and 7 (Stroud 1971, S2 3-1, S2 5-1, S2 7-1). Where the angle is 0, the axis is the only direction.
[[nodiscard]] std::vector<WeightedDirection> directionsWithin(const Vec3& axis, double halfAngleDegrees,
                                                              DirectionRule rule);

/// The same light from many directions of equal weight, 3 rings^2 of them, each for an equal part of the disc.
[[nodiscard]] std::vector<WeightedDirection> denseDirectionsWithin(const Vec3& axis, double halfAngleDegrees,
                                                                   int rings);

}  // namespace echolucent::light
