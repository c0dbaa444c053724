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

/// Calls visit(intensity, place) for each sample of the ray that has data, from front to back, until it returns false.
template <typename Visit>
void forEachSample(const PictureRequest& request, const Ray& ray, const Visit& visit) {
    const double stepMm = request.settings.step * request.volume->geometry().unit();
    for (std::int64_t i = 0; ray.begin + (static_cast<double>(i) + 0.5) * stepMm < ray.end; ++i) {
        const Vec3 place = ray.origin + ray.direction * (ray.begin + (static_cast<double>(i) + 0.5) * stepMm);
        const auto intensity = intensityAt(*request.volume, place, request.settings.interpolation);
        if (intensity && !visit(*intensity, place)) return;
    }
}

/// Of direct volume rendering.
std::optional<PointedSample> sampleSeen(const PictureRequest& request, const Ray& ray) {
    constexpr double visible = 1.0 / 255.0;  // less does not show on a screen
    double transmittance = 1.0, largest = 0.0;
    std::optional<PointedSample> pointed;
    forEachSample(request, ray, [&](double intensity, const Vec3& place) {
        const double opacity = opacityAt(request.curve, intensity);
        const double share = opacityForStep(opacity, request.settings.step);
        const bool decides = transmittance * (1.0 - share) <= 0.5;
        if (decides || transmittance * share > largest) {
            largest = transmittance * share;
            pointed = PointedSample{intensity, opacity, place};
        }
        transmittance *= 1.0 - share;
        return !decides;
    });
    return 1.0 - transmittance < visible ? std::nullopt : pointed;
}

std::optional<PointedSample> extremeSample(const PictureRequest& request, const Ray& ray) {
    const bool maximum = request.settings.mode == RenderMode::maximum;
    std::optional<PointedSample> extreme;
    forEachSample(request, ray, [&](double intensity, const Vec3& place) {
        if (!extreme || (maximum ? intensity > extreme->intensity : intensity < extreme->intensity))
            extreme = PointedSample{intensity, opacityAt(request.curve, intensity), place};
        return true;
    });
    return extreme;
}

std::optional<PointedSample> meanOfSamples(const PictureRequest& request, const Ray& ray) {
    double sum = 0.0;
    std::int64_t count = 0;
    std::optional<PointedSample> mean;
    forEachSample(request, ray, [&](double intensity, const Vec3& place) {
        sum += intensity;
        if (++count == 1) mean = PointedSample{0.0, 0.0, place};
        return true;
    });
    if (!mean) return std::nullopt;
    mean->intensity = sum / static_cast<double>(count);
    mean->opacity = opacityAt(request.curve, mean->intensity);
    return mean;
}

}  // namespace

std::optional<PointedSample> samplePointedAt(const PictureRequest& request, double x, double y) {
    if (!request.volume) return std::nullopt;
    Ray ray = rayThrough(request.settings, x, y);
    clip(ray, request.volume->geometry(), request.settings);
    switch (request.settings.mode) {
        case RenderMode::direct: return sampleSeen(request, ray);
        case RenderMode::maximum:
        case RenderMode::minimum: return extremeSample(request, ray);
        case RenderMode::mean: return meanOfSamples(request, ray);
    }
    return std::nullopt;
}

}  // namespace echolucent
