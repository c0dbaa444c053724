#include "widgets/volume_view/scene/pointed_sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace echolucent {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Ray {
    Vec3 origin;
    Vec3 direction;                 // unit
    double begin = 0.0, end = 0.0;  // mm along the direction
};

Ray rayThrough(const RayCastSettings& settings, double x, double y) {
    const Camera& camera = settings.camera;
    const bool parallel = camera.projection == Projection::parallel;
    const double height =
        parallel ? camera.heightMm
                 : 2.0 * camera.distanceMm * std::tan(camera.viewAngleDegrees / 2.0 * std::numbers::pi / 180.0);
    const double mmPerPixel = height / settings.height;
    const Vec3 inFocalPlane = camera.frame.right * ((x - settings.width / 2.0) * mmPerPixel) +
                              camera.frame.down * ((y - settings.height / 2.0) * mmPerPixel);
    if (parallel) return {camera.focalPoint + inFocalPlane, camera.frame.forward};
    return {camera.focalPoint - camera.frame.forward * camera.distanceMm,
            normalized(camera.frame.forward * camera.distanceMm + inFocalPlane)};
}

void clipToBox(Ray& ray, const Vec3& low, const Vec3& high) {
    for (int axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0.0) {
            if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) ray.end = -infinite;
            continue;
        }
        const auto [near, far] = std::minmax({(low[axis] - ray.origin[axis]) / ray.direction[axis],
                                              (high[axis] - ray.origin[axis]) / ray.direction[axis]});
        ray.begin = std::max(ray.begin, near);
        ray.end = std::min(ray.end, far);
    }
}

void clipToPlane(Ray& ray, const ClippingPlane& plane) {
    const double slope = plane.normal.dot(ray.direction), inside = plane.normal.dot(ray.origin - plane.point);
    if (slope > 0.0) {
        ray.begin = std::max(ray.begin, -inside / slope);
    } else if (slope < 0.0) {
        ray.end = std::min(ray.end, -inside / slope);
    } else if (inside < 0.0) {
        ray.end = -infinite;
    }
}

/// Depth of the opaque actor at a point of the picture, mm; infinite where there is none.
double opaqueDepthAt(const RayCastSettings& settings, double x, double y) {
    const DepthMap& map = *settings.opaqueDepth;
    if (map.width < 1 || map.height < 1) return infinite;
    const int column = std::clamp(static_cast<int>(x / settings.width * map.width), 0, map.width - 1);
    const int row = std::clamp(static_cast<int>(y / settings.height * map.height), 0, map.height - 1);
    return map.depthMm[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
                       static_cast<std::size_t>(column)];
}

/// Limits the ray to the volume's box, to what lies behind the near cut and, in perspective, before the eye's front,
/// and to what the settings leave of that.
void clip(Ray& ray, const VolumeGeometry& geometry, const RayCastSettings& settings, double x, double y) {
    ray.begin = settings.camera.projection == Projection::parallel ? -infinite : 0.0;
    ray.end = infinite;
    clipToBox(ray, geometry.boxMinMm(), geometry.boxMaxMm());
    if (settings.box) clipToBox(ray, settings.box->low, settings.box->high);
    for (const ClippingPlane& plane : settings.clippingPlanes) clipToPlane(ray, plane);
    const Vec3& forward = settings.camera.frame.forward;
    const auto alongRay = [&](double depth) { return (depth - forward.dot(ray.origin)) / forward.dot(ray.direction); };
    ray.begin = std::max(ray.begin, alongRay(settings.nearPlaneDepthMm));
    if (settings.opaqueDepth) ray.end = std::min(ray.end, alongRay(opaqueDepthAt(settings, x, y)));
}

/// As castRays(): the nearest voxel, or the mean of the data voxels around by their trilinear weights; empty at a voxel
/// without data, or where less than half the weight is data. Constant beyond the outermost voxel centres.
std::optional<double> intensityAt(const Volume& volume, const Vec3& gridMm, Interpolation interpolation) {
    const VolumeGeometry& geometry = volume.geometry();
    const Vec3 voxel = geometry.voxelFromGridMm(gridMm);
    std::array<std::array<std::int64_t, 2>, 3> around{};
    std::array<std::array<double, 2>, 3> weights{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const double position = std::clamp(voxel[axis], 0.0, static_cast<double>(geometry.size[i] - 1));
        const auto lower = static_cast<std::int64_t>(position);
        double share = position - static_cast<double>(lower);
        if (interpolation == Interpolation::nearest) share = std::round(share);
        around[i] = {lower, std::min(lower + 1, geometry.size[i] - 1)};
        weights[i] = {1.0 - share, share};
    }
    double sum = 0.0, weightOfData = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        const std::size_t x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
        const double weight = weights[0][x] * weights[1][y] * weights[2][z];
        const std::int64_t offset = geometry.offset(around[0][x], around[1][y], around[2][z]);
        if (weight == 0.0 || !volume.hasData(offset)) continue;
        sum += weight * volume.normalisedIntensity(offset);
        weightOfData += weight;
    }
    if (weightOfData < 0.5) return std::nullopt;
    return sum / weightOfData;
}

/// Calls back with position and intensity of every sample with data, front to back, until it returns false.
template <typename Visit>
void followRay(const PictureRequest& request, double x, double y, const Visit& visit) {
    const RayCastSettings& settings = request.settings;
    const VolumeGeometry& geometry = request.volume->geometry();
    Ray ray = rayThrough(settings, x, y);
    clip(ray, geometry, settings, x, y);
    const double stepMm = settings.step * geometry.unit();
    for (std::int64_t i = 0;; ++i) {
        const double along = ray.begin + (static_cast<double>(i) + 0.5) * stepMm;
        if (!(along < ray.end)) return;
        const Vec3 position = ray.origin + ray.direction * along;
        const auto intensity = intensityAt(*request.volume, position, settings.interpolation);
        if (intensity && !visit(position, *intensity)) return;
    }
}

std::optional<PointedSample> sampleByOpacity(const PictureRequest& request, double x, double y) {
    constexpr double visible = 1.0 / 255.0;  // less does not show on a screen
    double transmittance = 1.0, largest = 0.0;
    std::optional<PointedSample> pointed;
    followRay(request, x, y, [&](const Vec3& position, double intensity) {
        const double opacity = opacityAt(request.curve, intensity);
        const double share = opacityForStep(opacity, request.settings.step);
        const bool half = transmittance * (1.0 - share) <= 0.5;
        if (half || transmittance * share > largest) {
            largest = transmittance * share;
            pointed = PointedSample{intensity, opacity, position};
        }
        transmittance *= 1.0 - share;
        return !half;
    });
    return 1.0 - transmittance < visible ? std::nullopt : pointed;
}

std::optional<PointedSample> sampleByIntensity(const PictureRequest& request, double x, double y) {
    const RenderMode mode = request.settings.mode;
    std::optional<PointedSample> pointed;
    double sum = 0.0;
    int count = 0;
    followRay(request, x, y, [&](const Vec3& position, double intensity) {
        const bool chosen = !pointed || (mode == RenderMode::maximum && intensity > pointed->intensity) ||
                            (mode == RenderMode::minimum && intensity < pointed->intensity);
        if (chosen) pointed = PointedSample{intensity, 0.0, position};
        sum += intensity;
        ++count;
        return true;
    });
    if (!pointed) return std::nullopt;
    if (mode == RenderMode::mean) pointed->intensity = sum / count;
    pointed->opacity = opacityAt(request.curve, pointed->intensity);
    return pointed;
}

}  // namespace

std::optional<PointedSample> samplePointedAt(const PictureRequest& request, double x, double y) {
    if (!request.volume) return std::nullopt;
    return request.settings.mode == RenderMode::direct ? sampleByOpacity(request, x, y)
                                                       : sampleByIntensity(request, x, y);
}

}  // namespace echolucent
