#include "processing/picture/picture_place.h"

#include <cmath>
#include <numbers>

namespace echolucent {

namespace {

double tangentOfHalfAngle(const Camera& camera) {
    return std::tan(camera.viewAngleDegrees / 2.0 * std::numbers::pi / 180.0);
}

/// Depth of the eye along the view, from the grid origin.
double eyeDepth(const Camera& camera) { return camera.frame.forward.dot(camera.focalPoint) - camera.distanceMm; }

/// Height of the shown region at a depth, mm.
double heightAt(const Camera& camera, double depthMm) {
    if (camera.projection == Projection::parallel) return camera.heightMm;
    return 2.0 * tangentOfHalfAngle(camera) * (depthMm - eyeDepth(camera));
}

}  // namespace

std::optional<PicturePlace> placeInPicture(const Camera& camera, const Vec3& gridMm) {
    const double height = heightAt(camera, camera.frame.forward.dot(gridMm));
    if (!(height > 0.0)) return std::nullopt;
    const Vec3 from = gridMm - camera.focalPoint;
    return PicturePlace{camera.frame.right.dot(from) / height, camera.frame.down.dot(from) / height};
}

Vec3 gridPlaceAt(const Camera& camera, const PicturePlace& place, double depthMm) {
    const double height = heightAt(camera, depthMm);
    const ViewFrame& frame = camera.frame;
    return camera.focalPoint + frame.right * (place[0] * height) + frame.down * (place[1] * height) +
           frame.forward * (depthMm - frame.forward.dot(camera.focalPoint));
}

std::string problemOf(const Camera& camera) {
    if (const std::string frame = problemOf(camera.frame); !frame.empty()) return frame;
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(camera.focalPoint[axis])) return "has a focal point that is not finite";
    if (!std::isfinite(camera.heightMm) || !(camera.heightMm > 0.0)) return "has a height that is not above 0";
    if (!(camera.viewAngleDegrees > 0.0 && camera.viewAngleDegrees < 180.0))
        return "has a view angle outside 0 to 180 degrees";
    if (!std::isfinite(camera.distanceMm) || !(camera.distanceMm >= 0.0)) return "has a distance below 0";
    return {};
}

}  // namespace echolucent
