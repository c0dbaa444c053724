#include "processing/viewpoint/viewpoint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/choice_names.h"
#include "processing/viewpoint/box_section.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<6> beamAxisNames{"+x", "-x", "+y", "-y", "+z", "-z"};

/// The fixed turn that brings +z onto the beam axis.
Mat3 beamFrame(BeamAxis axis) {
    switch (axis) {
        case BeamAxis::plusX: return rotationY(90);
        case BeamAxis::minusX: return rotationY(-90);
        case BeamAxis::plusY: return rotationX(-90);
        case BeamAxis::minusY: return rotationX(90);
        case BeamAxis::plusZ: return Mat3::eye();
        case BeamAxis::minusZ: return rotationY(180);
    }
    return Mat3::eye();
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

}  // namespace

std::string_view nameOf(BeamAxis axis) { return nameIn(beamAxisNames, axis); }

std::optional<BeamAxis> beamAxisFromName(std::string_view name) { return choiceNamed<BeamAxis>(beamAxisNames, name); }

ViewFrame frameOf(const Viewpoint& view) {
    const Mat3 turn = beamFrame(view.beamAxis) * rotationY(view.azimuthDegrees) * rotationX(view.elevationDegrees) *
                      rotationZ(view.rollDegrees);
    return {Vec3(turn.col(0).val), Vec3(turn.col(1).val), Vec3(turn.col(2).val)};
}

Viewpoint viewAlong(const Vec3& forward, const Vec3& down, BeamAxis beamAxis) {
    Viewpoint view;
    view.beamAxis = beamAxis;
    const Mat3 toBeamFrame = beamFrame(beamAxis).t();
    const Vec3 direction = normalized(toBeamFrame * forward);
    // R_y(azimuth) R_x(elevation) (0,0,1) = (sin az cos el, -sin el, cos az cos el)
    // Near the poles the arc tangent keeps its digits; the arc sine would lose half of them.
    const double acrossPoles = std::hypot(direction[0], direction[2]);
    view.elevationDegrees = degrees(std::atan2(-direction[1], acrossPoles));
    if (acrossPoles > 1e-12) view.azimuthDegrees = degrees(std::atan2(direction[0], direction[2]));
    const ViewFrame unrolled = frameOf(view);
    view.rollDegrees = degrees(std::atan2(-unrolled.right.dot(down), unrolled.down.dot(down)));
    return view;
}

Viewpoint withFrontAcross(Viewpoint view, double depthMm) {
    view.frontPlane.reset();
    if (depthMm > 0.0) view.frontPlane = FrontPlane{frameOf(view).forward, depthMm};
    return view;
}

bool hasObliqueFront(const Viewpoint& view) {
    return view.frontPlane && view.frontPlane->forward != frameOf(view).forward;
}

double frontDepthMm(const Viewpoint& view) { return view.frontPlane ? view.frontPlane->depthMm : 0.0; }

Viewpoint turnedAbout(const Viewpoint& view, const Vec3& axis, double degrees) {
    Viewpoint turned = view;
    // Azimuth and elevation turn about the axes that the picture has before its roll.
    const Vec3 unrolled = rotationZ(view.rollDegrees) * axis;
    if (unrolled[1] == 0.0 && unrolled[2] == 0.0) {
        turned.elevationDegrees += degrees * unrolled[0];
    } else if (unrolled[0] == 0.0 && unrolled[2] == 0.0 && view.elevationDegrees == 0.0) {
        turned.azimuthDegrees += degrees * unrolled[1];
    } else if (unrolled[0] == 0.0 && unrolled[1] == 0.0) {
        turned.rollDegrees += degrees * unrolled[2];
    } else {
        const ViewFrame frame = frameOf(view);
        const Vec3 inGrid = frame.right * axis[0] + frame.down * axis[1] + frame.forward * axis[2];
        const Viewpoint along = viewAlong(rotatedAbout(inGrid, degrees, frame.forward),
                                          rotatedAbout(inGrid, degrees, frame.down), view.beamAxis);
        turned.azimuthDegrees = along.azimuthDegrees;
        turned.elevationDegrees = along.elevationDegrees;
        turned.rollDegrees = along.rollDegrees;
    }
    return turned;
}

Viewpoint withinPoles(const Viewpoint& view) {
    Viewpoint within = view;
    if (std::abs(view.elevationDegrees) <= 90.0) return within;
    const double elevation = within.elevationDegrees = std::remainder(view.elevationDegrees, 360.0);
    if (std::abs(elevation) <= 90.0) return within;
    // Over a pole the view looks back: R_x(e) = R_y(180) R_x(180 - e) R_z(180).
    within.azimuthDegrees = std::remainder(view.azimuthDegrees + 180.0, 360.0);
    within.elevationDegrees = std::copysign(180.0, elevation) - elevation;
    within.rollDegrees = std::remainder(view.rollDegrees + 180.0, 360.0);
    return within;
}

Viewpoint withoutRounding(Viewpoint view) {
    constexpr double rounding = 1e-6;  // degrees
    for (double* angle : {&view.azimuthDegrees, &view.elevationDegrees, &view.rollDegrees}) {
        const double whole = std::round(*angle);
        if (std::abs(*angle - whole) < rounding) *angle = whole == -180.0 ? 180.0 : whole + 0.0;
    }
    return view;
}

Vec3 directionInVoxels(const Viewpoint& view, const VolumeGeometry& geometry) {
    return normalized(geometry.voxelFromGridMm(frameOf(view).forward));
}

double depthAlongViewMm(const Viewpoint& view, const VolumeGeometry& geometry) {
    const auto depths = geometry.depthsAlong(frameOf(view).forward);
    return depths.farthest - depths.nearest;
}

CuttingFace cuttingFaceOf(const FrontPlane& front, const VolumeGeometry& geometry) {
    return {front.forward, geometry.depthsAlong(front.forward).nearest + std::max(0.0, front.depthMm)};
}

double nearPlaneDepthMm(const Viewpoint& view, const VolumeGeometry& geometry) {
    if (view.frontPlane && !hasObliqueFront(view)) return cuttingFaceOf(*view.frontPlane, geometry).depthMm;
    return geometry.depthsAlong(frameOf(view).forward).nearest;
}

}  // namespace echolucent
