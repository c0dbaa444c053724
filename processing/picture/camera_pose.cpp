#include "processing/picture/camera_pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echolucent {

namespace {

double halfAngle(double degrees) { return degrees / 2.0 * std::numbers::pi / 180.0; }

}  // namespace

ZoomLimits zoomLimits(const VolumeGeometry& geometry) {
    return {2.0 * geometry.unit(), 10.0 * length(geometry.boxMaxMm() - geometry.boxMinMm())};
}

Camera cameraFor(const CameraPose& pose) {
    Camera camera;
    camera.focalPoint = pose.focalPoint;
    camera.frame = frameOf(pose.view);
    camera.projection = pose.projection;
    camera.heightMm = pose.heightMm;
    camera.distanceMm = pose.heightMm / 2.0 / std::tan(halfAngle(camera.viewAngleDegrees));
    return camera;
}

CameraPose fittedPose(const DataBox& box, const Viewpoint& view, Projection projection, double aspect) {
    const Camera fitted = defaultCamera(box, view, aspect);
    // In perspective the box's front appears larger than its middle. The distance of the default camera allows for
    // that.
    const double height = projection == Projection::parallel
                              ? fitted.heightMm
                              : 2.0 * fitted.distanceMm * std::tan(halfAngle(fitted.viewAngleDegrees));
    return {view, fitted.focalPoint, height, projection};
}

CameraPose orbited(CameraPose pose, double right, double down) {
    const double shares = std::hypot(right, down);
    if (shares == 0.0) return pose;
    pose.view = withinPoles(turnedAbout(pose.view, {-down / shares, right / shares, 0.0}, degreesPerHeight * shares));
    pose.view.azimuthDegrees = wrappedDegrees(pose.view.azimuthDegrees);
    return pose;
}

CameraPose panned(CameraPose pose, double right, double down) {
    const ViewFrame frame = frameOf(pose.view);
    pose.focalPoint -= (frame.right * right + frame.down * down) * pose.heightMm;
    return pose;
}

CameraPose zoomed(CameraPose pose, double factor, const ZoomLimits& limits) {
    pose.heightMm = std::clamp(pose.heightMm / factor, limits.smallestHeightMm, limits.largestHeightMm);
    return pose;
}

CameraPose zoomedAbout(const CameraPose& pose, double right, double down, double factor, const ZoomLimits& limits) {
    CameraPose next = zoomed(pose, factor, limits);
    const ViewFrame frame = frameOf(pose.view);
    next.focalPoint += (frame.right * right + frame.down * down) * (pose.heightMm - next.heightMm);
    return next;
}

}  // namespace echolucent
