#include "processing/scene/planes_holding.h"

#include <cmath>
#include <numbers>

#include "processing/viewpoint/box_section.h"

namespace echolucent {

namespace {

struct PlaneTurn {
    Vec3 axis{1, 0, 0};
    double degrees = 0.0;
};

/// The least turn of a normal that lets a plane across it hold all places.
PlaneTurn turnToHold(const std::vector<Vec3>& places, const Vec3& normal) {
    const Vec3 first = places[1] - places[0], second = places.back() - places[0];
    const Vec3 longest = length(first) > length(second) ? first : second, across = first.cross(second);
    if (length(longest) == 0.0) return {};
    constexpr double leastSine = 1e-9;  // of the angle between sides that do not lie on one straight line
    Vec3 next;
    if (length(across) > leastSine * length(first) * length(second)) {
        next = normalized(across) * (across.dot(normal) < 0.0 ? -1.0 : 1.0);
    } else {
        const Vec3 along = normalized(longest), left = normal - along * along.dot(normal);
        // If the line lies along the normal, every direction across it is as near. Another plane turns less in any
        // case.
        if (length(left) < leastSine) return {.degrees = 90.0};
        next = normalized(left);
    }
    const Vec3 axis = normal.cross(next);
    if (length(axis) == 0.0) return {};
    return {normalized(axis), std::atan2(length(axis), normal.dot(next)) * 180.0 / std::numbers::pi};
}

}  // namespace

Planes planesHolding(const Planes& planes, const std::vector<Vec3>& placesMm, BeamAxis beam, const DataBox& data) {
    Vec3 middle{0, 0, 0};
    for (const Vec3& place : placesMm) middle += place * (1.0 / static_cast<double>(placesMm.size()));
    // A turn or step below a rounding is not made, so that a second call changes nothing.
    constexpr double sameDegrees = 1e-9, sameMm = 1e-9;
    PlaneName plane = PlaneName::a;
    PlaneTurn least;
    double leastStep = 0.0;
    for (const PlaneName each : allPlaneNames) {
        const Vec3 now = frameOf(each, planes, beam).forward;
        const PlaneTurn turn = turnToHold(placesMm, now);
        const double step = std::abs(now.dot(middle - referencePointOf(planes, data)));
        const bool alike = std::abs(turn.degrees - least.degrees) <= sameDegrees;
        if (each != PlaneName::a && (alike ? step >= leastStep : turn.degrees > least.degrees)) continue;
        plane = each;
        least = turn;
        leastStep = step;
    }
    Planes next = planes;
    if (least.degrees > sameDegrees) {
        const ViewFrame axes = frameOf(PlaneName::c, planes, beam);
        next.direction = directionOf(viewAlong(rotatedAbout(least.axis, least.degrees, axes.forward),
                                               rotatedAbout(least.axis, least.degrees, axes.down), beam));
    }
    const ViewFrame frame = frameOf(plane, next, beam);
    const auto missing = [&](const Planes& at) { return frame.forward.dot(middle - referencePointOf(at, data)); };
    if (std::abs(missing(next)) > sameMm) next = stepped(next, plane, missing(next), beam, data);
    // If the straight way there leaves the data, the planes meet amid the places.
    if (std::abs(missing(next)) > sameMm) next = withReferencePoint(next, middle, data);
    if (PlaneCrop& crop = next.crops[indexOf(plane)]; crop.magnification > 1.0) {
        crop.panRightMm = frame.right.dot(middle - data.centreMm());
        crop.panDownMm = frame.down.dot(middle - data.centreMm());
    }
    return next;
}

}  // namespace echolucent
