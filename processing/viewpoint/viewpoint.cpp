#include "processing/viewpoint/viewpoint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/choice_names.h"

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

double frontDepthMm(const Viewpoint& view) { return view.frontPlane ? view.frontPlane->depthMm : 0.0; }

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
    const Vec3 forward = frameOf(view).forward;
    const bool across = view.frontPlane && view.frontPlane->forward == forward;
    return across ? cuttingFaceOf(*view.frontPlane, geometry).depthMm : geometry.depthsAlong(forward).nearest;
}

double entryDepthMm(const Viewpoint& view, const VolumeGeometry& geometry, const Vec3& pointMm) {
    const double nearest = nearPlaneDepthMm(view, geometry);
    const Vec3 forward = frameOf(view).forward;
    if (!view.frontPlane || view.frontPlane->forward == forward) return nearest;
    const CuttingFace face = cuttingFaceOf(*view.frontPlane, geometry);
    const double slope = face.inwards.dot(forward);
    if (!(slope > 0.0)) return nearest;
    return std::max(nearest, forward.dot(pointMm) + (face.depthMm - face.inwards.dot(pointMm)) / slope);
}

}  // namespace echolucent
