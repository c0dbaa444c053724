#include "processing/document/planes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<3> planeNames{"A", "B", "C"};

/// Share of the picture that the data box fills at magnification 1.
constexpr double filledShare = 0.94;

ViewFrame axesOf(const Planes& planes, BeamAxis beam) { return frameOf(viewpointOf(beam, planes.direction, 0.0)); }

ViewFrame frameOf(PlaneName plane, const ViewFrame& axes) {
    switch (plane) {
        case PlaneName::a: return {axes.right, axes.forward, -axes.down};
        case PlaneName::b: return {axes.down, axes.forward, axes.right};
        case PlaneName::c: return axes;
    }
    return axes;
}

/// A vector turned by an angle about an axis of length 1, right-handed (Rodrigues' formula).
Vec3 turnedAbout(const Vec3& axis, double radians, const Vec3& vector) {
    return vector * std::cos(radians) + axis.cross(vector) * std::sin(radians) +
           axis * (axis.dot(vector) * (1.0 - std::cos(radians)));
}

double extentAlong(const Vec3& axis, const Vec3& size) {
    return std::abs(axis[0]) * size[0] + std::abs(axis[1]) * size[1] + std::abs(axis[2]) * size[2];
}

/// Height of a picture in which the data box fits whichever of the three unturned planes it shows.
double fittedHeightMm(BeamAxis beam, const DataBox& data, double aspect) {
    const ViewFrame axes = frameOf(Viewpoint{.beamAxis = beam});
    double height = 0.0;
    for (const PlaneName plane : allPlaneNames) {
        const ViewFrame frame = frameOf(plane, axes);
        height = std::max(
            {height, extentAlong(frame.down, data.sizeMm()), extentAlong(frame.right, data.sizeMm()) / aspect});
    }
    return height / filledShare;
}

}  // namespace

std::string_view nameOf(PlaneName plane) { return nameIn(planeNames, plane); }

std::optional<PlaneName> planeNamed(std::string_view name) { return choiceNamed<PlaneName>(planeNames, name); }

ViewFrame frameOf(PlaneName plane, const Planes& planes, BeamAxis beam) { return frameOf(plane, axesOf(planes, beam)); }

Vec3 referencePointOf(const Planes& planes, const DataBox& data) { return data.centreMm() + planes.offsetMm; }

Planes withReferencePoint(Planes planes, const Vec3& gridMm, const DataBox& data) {
    for (int axis = 0; axis < 3; ++axis)
        planes.offsetMm[axis] = std::clamp(gridMm[axis], data.lowMm[axis], data.highMm[axis]) - data.centreMm()[axis];
    return planes;
}

Planes stepped(const Planes& planes, PlaneName plane, double mm, BeamAxis beam, const DataBox& data) {
    const Vec3 forward = frameOf(plane, planes, beam).forward, from = referencePointOf(planes, data);
    // A step that would leave the data ends at their border, on the way: it does not slide along it.
    double within = mm;
    for (int axis = 0; axis < 3; ++axis) {
        if (forward[axis] == 0.0) continue;
        const double toLow = (data.lowMm[axis] - from[axis]) / forward[axis];
        const double toHigh = (data.highMm[axis] - from[axis]) / forward[axis];
        within = std::clamp(within, std::min({toLow, toHigh, 0.0}), std::max({toLow, toHigh, 0.0}));
    }
    return withReferencePoint(planes, from + forward * within, data);
}

Planes turned(const Planes& planes, PlaneName plane, double degrees, BeamAxis beam) {
    const Vec3 axis = frameOf(plane, planes, beam).forward;
    // Where the picture turns clockwise, its axes turn the other way within the volume.
    const double radians = -degrees * std::numbers::pi / 180.0;
    const ViewFrame before = axesOf(planes, beam);
    Planes next = planes;
    next.direction = directionOf(
        viewAlong(turnedAbout(axis, radians, before.forward), turnedAbout(axis, radians, before.down), beam, 0.0));
    for (const PlaneName each : allPlaneNames) {
        const ViewFrame from = frameOf(each, planes, beam), to = frameOf(each, next, beam);
        PlaneCrop& crop = next.crops[indexOf(each)];
        crop.panRightMm += (to.right - from.right).dot(planes.offsetMm);
        crop.panDownMm += (to.down - from.down).dot(planes.offsetMm);
    }
    return next;
}

PlaneView planeViewOf(const Planes& planes, PlaneName plane, BeamAxis beam, const DataBox& data, double aspect) {
    const PlaneCrop& crop = planes.crops[indexOf(plane)];
    const ViewFrame frame = frameOf(plane, planes, beam);
    const Vec3 centre = data.centreMm() + frame.right * crop.panRightMm + frame.down * crop.panDownMm +
                        frame.forward * frame.forward.dot(planes.offsetMm);
    return {centre, frame, fittedHeightMm(beam, data, aspect) / crop.magnification};
}

}  // namespace echolucent
