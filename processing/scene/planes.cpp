#include "processing/scene/planes.h"

#include <algorithm>
#include <cmath>

#include "processing/choice_names.h"
#include "processing/viewpoint/box_section.h"
#include "processing/viewpoint/oriented_box.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<3> planeNames{"A", "B", "C"};

/// Share of the picture that the data box fills at magnification 1.
constexpr double filledShare = 0.94;

ViewFrame axesOf(const Planes& planes, BeamAxis beam) { return frameOf(viewpointOf(beam, planes.direction)); }

ViewFrame frameOf(PlaneName plane, const ViewFrame& axes) {
    switch (plane) {
        case PlaneName::a: return {axes.right, axes.forward, -axes.down};
        case PlaneName::b: return {axes.down, axes.forward, axes.right};
        case PlaneName::c: return axes;
    }
    return axes;
}

/// Height (mm) of a picture in which the data box fits into each of the three unturned planes.
double threePlanesHeightMm(BeamAxis beam, const DataBox& data, double aspect) {
    const ViewFrame axes = frameOf(Viewpoint{.beamAxis = beam});
    const OrientedBox whole = orientedBoxOf(data);
    double height = 0.0;
    for (const PlaneName plane : allPlaneNames) {
        const ViewFrame frame = frameOf(plane, axes);
        height = std::max({height, whole.extentAlong(frame.down), whole.extentAlong(frame.right) / aspect});
    }
    return height / filledShare;
}

}  // namespace

std::string_view nameOf(PlaneName plane) { return nameIn(planeNames, plane); }

ViewFrame frameOf(PlaneName plane, const Planes& planes, BeamAxis beam) { return frameOf(plane, axesOf(planes, beam)); }

Vec3 referencePointOf(const Planes& planes, const DataBox& data) { return data.centreMm() + planes.offsetMm; }

Planes withReferencePoint(Planes planes, const Vec3& gridMm, const DataBox& data) {
    const Vec3 from = referencePointOf(planes, data), way = gridMm - from;
    double share = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double room = (way[axis] > 0.0 ? data.highMm[axis] : data.lowMm[axis]) - from[axis];
        if (std::abs(way[axis]) > std::abs(room)) share = std::min(share, room / way[axis]);
    }
    if (!(share > 0.0)) return planes;
    planes.offsetMm = from + way * share - data.centreMm();
    return planes;
}

Planes stepped(const Planes& planes, PlaneName plane, double mm, BeamAxis beam, const DataBox& data) {
    return withReferencePoint(planes, referencePointOf(planes, data) + frameOf(plane, planes, beam).forward * mm, data);
}

Planes turned(const Planes& planes, PlaneName plane, double degrees, BeamAxis beam) {
    const Vec3 axis = frameOf(plane, planes, beam).forward;
    // If the picture turns clockwise, the plane's axes turn the other way within the volume.
    const double turn = -degrees;
    const ViewFrame before = axesOf(planes, beam);
    Planes next = planes;
    next.direction =
        directionOf(viewAlong(rotatedAbout(axis, turn, before.forward), rotatedAbout(axis, turn, before.down), beam));
    for (const PlaneName each : allPlaneNames) {
        const ViewFrame from = frameOf(each, planes, beam), to = frameOf(each, next, beam);
        PlaneCrop& crop = next.crops[indexOf(each)];
        crop.panRightMm += (to.right - from.right).dot(planes.offsetMm);
        crop.panDownMm += (to.down - from.down).dot(planes.offsetMm);
    }
    return next;
}

Pose turnedAlong(const Pose& pose, const Planes& before, const Planes& after, BeamAxis beam) {
    if (after.direction == before.direction) return pose;
    const ViewFrame from = axesOf(before, beam), to = axesOf(after, beam);
    const auto turn = [&](const Vec3& vector) {
        return to.right * from.right.dot(vector) + to.down * from.down.dot(vector) +
               to.forward * from.forward.dot(vector);
    };
    const ViewFrame view = frameOf(viewpointOf(beam, pose.direction));
    Pose next = pose;
    next.direction = directionOf(viewAlong(turn(view.forward), turn(view.down), beam));
    next.offsetMm = after.offsetMm + turn(pose.offsetMm - after.offsetMm);
    return next;
}

PlaneView planeViewOf(const Planes& planes, PlaneName plane, BeamAxis beam, const DataBox& data, double aspect) {
    const PlaneCrop& crop = planes.crops[indexOf(plane)];
    const ViewFrame frame = frameOf(plane, planes, beam);
    const Vec3 centre = data.centreMm() + frame.right * crop.panRightMm + frame.down * crop.panDownMm +
                        frame.forward * frame.forward.dot(planes.offsetMm);
    return {centre, frame, threePlanesHeightMm(beam, data, aspect) / crop.magnification};
}

}  // namespace echolucent
