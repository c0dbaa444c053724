#include "processing/light/light_directions.h"

#include <cmath>
#include <numbers>

namespace echolucent::light {

namespace {

/// A direction as a place on the unit disc across the axis.
struct DiscPlace {
    double right, down, weight;
};

void addRing(std::vector<DiscPlace>& places, double radius, int count, double firstTurn, double weight) {
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + firstTurn) / count;
        places.push_back({radius * std::cos(angle), radius * std::sin(angle), weight});
    }
}

std::vector<DiscPlace> placesOf(DirectionRule rule) {
    std::vector<DiscPlace> places;
    switch (rule) {
        case DirectionRule::one: return {{0.0, 0.0, 1.0}};
        case DirectionRule::four: addRing(places, std::sqrt(1.0 / 2.0), 4, 0.5, 1.0 / 4.0); break;
        case DirectionRule::seven:
            places.push_back({0.0, 0.0, 1.0 / 4.0});
            addRing(places, std::sqrt(2.0 / 3.0), 6, 0.0, 1.0 / 8.0);
            break;
        case DirectionRule::twelve: {
            const double root = std::sqrt(29.0);
            addRing(places, std::sqrt(3.0 / 4.0), 4, 0.0, 2.0 / 27.0);
            addRing(places, std::sqrt((27.0 - 3.0 * root) / 52.0), 4, 0.5, (551.0 + 41.0 * root) / 6264.0);
            addRing(places, std::sqrt((27.0 + 3.0 * root) / 52.0), 4, 0.5, (551.0 - 41.0 * root) / 6264.0);
            break;
        }
    }
    return places;
}

/// Two unit vectors across a unit axis (Duff et al. 2017). They turn smoothly with the axis, but jump if axis[2]
/// changes its sign.
struct Across {
    Vec3 right, down;
    explicit Across(const Vec3& axis) {
        const double sign = std::copysign(1.0, axis[2]), a = -1.0 / (sign + axis[2]), b = axis[0] * axis[1] * a;
        right = {1.0 + sign * axis[0] * axis[0] * a, sign * b, -sign * axis[0]};
        down = {b, sign + axis[1] * axis[1] * a, -axis[1]};
    }
};

std::vector<WeightedDirection> directionsOf(const std::vector<DiscPlace>& places, const Vec3& axis,
                                            double halfAngleDegrees) {
    const Vec3 unit = normalized(axis);
    if (!(halfAngleDegrees > 0.0)) return {{unit, 1.0}};
    const double sine = std::sin(halfAngleDegrees * std::numbers::pi / 180.0);
    const Across across(unit);
    std::vector<WeightedDirection> directions;
    for (const DiscPlace& place : places) {
        const double right = sine * place.right, down = sine * place.down;
        const double forward = std::sqrt(1.0 - right * right - down * down);
        directions.push_back({across.right * right + across.down * down + unit * forward, place.weight});
    }
    return directions;
}

}  // namespace

std::vector<WeightedDirection> directionsWithin(const Vec3& axis, double halfAngleDegrees, DirectionRule rule) {
    return directionsOf(placesOf(rule), axis, halfAngleDegrees);
}

std::vector<WeightedDirection> denseDirectionsWithin(const Vec3& axis, double halfAngleDegrees, int rings) {
    // Ring i of n lies between the radii i / n and (i + 1) / n and has 3 (2 i + 1) places.
    std::vector<DiscPlace> places;
    const double weight = 1.0 / (3.0 * rings * rings);
    for (int ring = 0; ring < rings; ++ring) {
        const double inner = static_cast<double>(ring) / rings, outer = (ring + 1.0) / rings;
        addRing(places, std::sqrt(0.5 * (inner * inner + outer * outer)), 3 * (2 * ring + 1), 0.25 + 0.3 * ring,
                weight);
    }
    return directionsOf(places, axis, halfAngleDegrees);
}

}  // namespace echolucent::light
