#include "processing/ray_caster/ray_geometry.h"

#include "processing/ray_caster/sample_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace echolucent::ray_casting {

namespace {

/// Room at the far side of the inner box for the rounding of float positions in the kernel.
constexpr double innerMargin = 1e-3;

bool isFinite(const Vec3& vector) {
    return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

void requireSensible(const RayCastSettings& settings) {
    if (settings.width < 1 || settings.height < 1) throw std::invalid_argument("castRays: the picture has no pixel");
    if (!std::isfinite(settings.step) || !(settings.step > 0.0))
        throw std::invalid_argument("castRays: the step must be finite and above 0");
    if (std::isnan(settings.nearPlaneDepthMm)) throw std::invalid_argument("castRays: the near plane is not a number");
    const Camera& camera = settings.camera;
    if (!isFinite(camera.focalPoint) || !isFinite(camera.frame.right) || !isFinite(camera.frame.down) ||
        !isFinite(camera.frame.forward))
        throw std::invalid_argument("castRays: the camera is not finite");
    const bool parallel = camera.projection == Projection::parallel;
    if (parallel && !(std::isfinite(camera.heightMm) && camera.heightMm > 0.0))
        throw std::invalid_argument("castRays: the picture's height must be finite and above 0");
    if (!parallel && !(camera.viewAngleDegrees > 0.0 && camera.viewAngleDegrees < 180.0))
        throw std::invalid_argument("castRays: the view angle must lie between 0 and 180 degrees");
    if (!parallel && !(std::isfinite(camera.distanceMm) && camera.distanceMm >= 0.0))
        throw std::invalid_argument("castRays: the eye's distance must be finite and not negative");
}

double foremostDepth(const VolumeGeometry& geometry, const Vec3& forward) {
    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
    double depth = 0.0;
    for (int axis = 0; axis < 3; ++axis) depth += std::min(forward[axis] * low[axis], forward[axis] * high[axis]);
    return depth;
}

/// Narrows [first, last) to the parameters t at which low <= origin + t * step < high.
void narrow(double origin, double step, double low, double high, double& first, double& last) {
    if (!(low < high)) {
        last = first;
        return;
    }
    if (step == 0.0) {
        if (!(origin >= low && origin < high)) last = first;
        return;
    }
    double enter = (low - origin) / step, leave = (high - origin) / step;
    if (enter > leave) std::swap(enter, leave);
    first = std::max(first, enter);
    last = std::min(last, leave);
}

/// The samples k whose k + 0.5 lies in [first, last).
std::pair<std::int64_t, std::int64_t> samplesBetween(double first, double last) {
    if (!(first < last)) return {0, 0};
    return {static_cast<std::int64_t>(std::ceil(first - 0.5)), static_cast<std::int64_t>(std::ceil(last - 0.5))};
}

}  // namespace

RayGeometry::RayGeometry(const VolumeGeometry& geometry, const RayCastSettings& settings)
    : m_geometry(geometry),
      m_camera(settings.camera),
      m_width(settings.width),
      m_height(settings.height),
      m_stepMm(settings.step * geometry.unit()) {
    requireSensible(settings);
    const Vec3& forward = m_camera.frame.forward;
    for (int axis = 0; axis < 3; ++axis) {
        m_inverseSpacing[axis] = 1.0 / geometry.spacing[axis];
        m_innerMax[axis] = static_cast<double>(geometry.size[static_cast<std::size_t>(axis)] - 1) - innerMargin;
    }
    m_innerMax[0] -= readAhead;
    m_stepVoxel = forward.mul(m_inverseSpacing) * m_stepMm;
    m_nearDepth = settings.nearPlaneDepthMm;
    if (m_camera.projection == Projection::parallel) {
        m_pixel = m_camera.heightMm / m_height;
        m_startDepth = std::max(foremostDepth(geometry, forward), m_nearDepth);
    } else {
        m_pixel = 2.0 * std::tan(m_camera.viewAngleDegrees * std::numbers::pi / 360.0) / m_height;
        const double eyeDepth = forward.dot(m_camera.focalPoint) - m_camera.distanceMm;
        m_nearDepth -= eyeDepth;
        m_startDepth = std::max({foremostDepth(geometry, forward) - eyeDepth, m_nearDepth, 0.0});
    }
}

Ray RayGeometry::rayThrough(int column, int row) const {
    const Vec3 offset = m_camera.frame.right * ((column + 0.5 - m_width * 0.5) * m_pixel) +
                        m_camera.frame.down * ((row + 0.5 - m_height * 0.5) * m_pixel);
    return m_camera.projection == Projection::parallel ? parallelRay(offset) : perspectiveRay(offset);
}

Ray RayGeometry::parallelRay(const Vec3& offset) const {
    Ray ray;
    const Vec3& forward = m_camera.frame.forward;
    const Vec3 point = m_camera.focalPoint + offset;
    const Vec3 start = point + forward * (m_startDepth - forward.dot(point));
    ray.origin = start.mul(m_inverseSpacing);
    ray.step = m_stepVoxel;
    ray.direction = forward;
    clip(ray, 0.0);
    return ray;
}

Ray RayGeometry::perspectiveRay(const Vec3& offset) const {
    Ray ray;
    const Vec3& forward = m_camera.frame.forward;
    const Vec3 eye = m_camera.focalPoint - forward * m_camera.distanceMm;
    ray.direction = normalized(forward + offset);
    ray.origin = (eye + ray.direction * m_startDepth).mul(m_inverseSpacing);
    ray.step = ray.direction.mul(m_inverseSpacing) * m_stepMm;
    // A ray towards the picture's corner is at a smaller depth than its distance: it may start before the near plane.
    const double nearDistance = m_nearDepth / ray.direction.dot(forward);
    clip(ray, std::max((nearDistance - m_startDepth) / m_stepMm, 0.0));
    return ray;
}

void RayGeometry::clip(Ray& ray, double firstStep) const {
    const double endless = std::numeric_limits<double>::max();
    double first = firstStep, last = endless, innerFirst = firstStep, innerLast = endless;
    for (int axis = 0; axis < 3; ++axis) {
        const auto size = static_cast<double>(m_geometry.size[static_cast<std::size_t>(axis)]);
        narrow(ray.origin[axis], ray.step[axis], -0.5, size - 0.5, first, last);
        narrow(ray.origin[axis], ray.step[axis], 0.0, m_innerMax[axis], innerFirst, innerLast);
    }
    std::tie(ray.first, ray.last) = samplesBetween(first, last);
    std::tie(ray.innerFirst, ray.innerLast) = samplesBetween(innerFirst, innerLast);
    ray.innerFirst = std::clamp(ray.innerFirst, ray.first, ray.last);
    ray.innerLast = std::clamp(ray.innerLast, ray.innerFirst, ray.last);
}

}  // namespace echolucent::ray_casting
