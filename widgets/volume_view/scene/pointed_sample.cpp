#include "widgets/volume_view/scene/pointed_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace echolucent {

namespace {

struct Ray {
    Vec3 origin;
    Vec3 direction;  // unit
    double begin = 0.0, end = 0.0;  // mm along the direction
};

Ray rayThrough(const RayCastSettings& settings, double x, double y) {
    const Camera& camera = settings.camera;
    const bool parallel = camera.projection == Projection::parallel;
    const double height = parallel ? camera.heightMm
                                   : 2.0 * camera.distanceMm *
                                         std::tan(camera.viewAngleDegrees / 2.0 * std::numbers::pi / 180.0);
    const double mmPerPixel = height / settings.height;
    const Vec3 inFocalPlane = camera.frame.right * ((x - settings.width / 2.0) * mmPerPixel) +
                              camera.frame.down * ((y - settings.height / 2.0) * mmPerPixel);
    if (parallel) return {camera.focalPoint + inFocalPlane, camera.frame.forward};
    return {camera.focalPoint - camera.frame.forward * camera.distanceMm,
            normalized(camera.frame.forward * camera.distanceMm + inFocalPlane)};
}

/// Limits the ray to the box, to what lies behind the near cut and, in perspective, before the eye's front.
void clip(Ray& ray, const VolumeGeometry& geometry, const RayCastSettings& settings) {
    ray.begin = settings.camera.projection == Projection::parallel ? -std::numeric_limits<double>::infinity() : 0.0;
    ray.end = std::numeric_limits<double>::infinity();
    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0) {
            if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) ray.end = -ray.end;
            continue;
        }
        const auto [near, far] = std::minmax({(low[axis] - ray.origin[axis]) / ray.direction[axis],
                                              (high[axis] - ray.origin[axis]) / ray.direction[axis]});
        ray.begin = std::max(ray.begin, near);
        ray.end = std::min(ray.end, far);
    }
    const Vec3& forward = settings.camera.frame.forward;
    ray.begin = std::max(ray.begin, (settings.nearPlaneDepthMm - forward.dot(ray.origin)) / forward.dot(ray.direction));
}

/// Trilinear between voxel centres, constant beyond the outermost; empty at a voxel without data.
std::optional<double> intensityAt(const Volume& volume, const Vec3& gridMm, Interpolation interpolation) {
    const VolumeGeometry& geometry = volume.geometry();
    const Vec3 voxel = geometry.voxelFromGridMm(gridMm);
    std::array<std::int64_t, 3> lower{}, upper{}, nearest{};
    Vec3 share;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double last = static_cast<double>(geometry.size[axis] - 1);
        const double position = std::clamp(voxel[static_cast<int>(axis)], 0.0, last);
        lower[axis] = static_cast<std::int64_t>(position);
        upper[axis] = std::min(lower[axis] + 1, geometry.size[axis] - 1);
        nearest[axis] = std::llround(position);
        share[static_cast<int>(axis)] = position - static_cast<double>(lower[axis]);
    }
    const std::int64_t nearestOffset = geometry.offset(nearest[0], nearest[1], nearest[2]);
    if (!volume.hasData(nearestOffset)) return std::nullopt;
    if (interpolation == Interpolation::nearest) return volume.normalisedIntensity(nearestOffset);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const bool x = corner & 1, y = corner & 2, z = corner & 4;
        const double weight = (x ? share[0] : 1 - share[0]) * (y ? share[1] : 1 - share[1]) * (z ? share[2] : 1 - share[2]);
        if (weight == 0.0) continue;
        sum += weight * volume.normalisedIntensity(geometry.offset(x ? upper[0] : lower[0], y ? upper[1] : lower[1],
                                                                   z ? upper[2] : lower[2]));
    }
    return sum;
}

}  // namespace

std::optional<PointedSample> samplePointedAt(const PictureRequest& request, double x, double y) {
    if (!request.volume) return std::nullopt;
    constexpr double visible = 1.0 / 255.0;  // less does not show on a screen
    const Volume& volume = *request.volume;
    Ray ray = rayThrough(request.settings, x, y);
    clip(ray, volume.geometry(), request.settings);
    const double stepMm = request.settings.step * volume.geometry().unit();
    double transmittance = 1.0, largest = 0.0;
    std::optional<PointedSample> pointed;
    for (std::int64_t i = 0; ray.begin + (static_cast<double>(i) + 0.5) * stepMm < ray.end; ++i) {
        const Vec3 position = ray.origin + ray.direction * (ray.begin + (static_cast<double>(i) + 0.5) * stepMm);
        const auto intensity = intensityAt(volume, position, request.settings.interpolation);
        if (!intensity) continue;
        const double opacity = opacityAt(request.curve, *intensity);
        const double share = opacityForStep(opacity, request.settings.step);
        if (transmittance * share > largest) {
            largest = transmittance * share;
            pointed = PointedSample{*intensity, opacity, position};
        }
        transmittance *= 1.0 - share;
        if (transmittance <= 0.5) return PointedSample{*intensity, opacity, position};
    }
    return 1.0 - transmittance < visible ? std::nullopt : pointed;
}

}  // namespace echolucent
