#include "processing/ray_caster/ray_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace echolucent::ray_casting {

namespace {

bool isFinite(const Vec3& vector) {
    return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

void requireSensible(const Shading& shading) {
    if (!(shading.gradientReach > 0.0)) throw std::invalid_argument("castRays: the gradient's reach must be above 0");
    for (const double strength : {shading.reaching.shadow, shading.reaching.occlusion, shading.reaching.translucency})
        if (!(strength >= 0.0 && strength <= 1.0))
            throw std::invalid_argument("castRays: strengths of light must lie between 0 and 1");
}

void requireSensible(const RayCastSettings& settings) {
    if (settings.width < 1 || settings.height < 1) throw std::invalid_argument("castRays: the picture has no pixel");
    if (!std::isfinite(settings.step) || !(settings.step > 0.0))
        throw std::invalid_argument("castRays: the step must be finite and above 0");
    if (settings.front && (!isFinite(settings.front->inwards) || length(settings.front->inwards) == 0.0 ||
                           std::isnan(settings.front->depthMm)))
        throw std::invalid_argument("castRays: the front needs a finite direction and a depth");
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
    if (settings.box && !(isFinite(settings.box->low) && isFinite(settings.box->high)))
        throw std::invalid_argument("castRays: the render box is not finite");
    for (const ClippingPlane& plane : settings.clippingPlanes)
        if (!isFinite(plane.point) || !isFinite(plane.normal) || length(plane.normal) == 0.0)
            throw std::invalid_argument("castRays: a clipping plane needs a finite point and a normal");
    if (std::isnan(settings.terminationTransmittance))
        throw std::invalid_argument("castRays: the transmittance at which rays end is not a number");
    if (!(settings.pixelTolerance >= 0.0))
        throw std::invalid_argument("castRays: the tolerance of pixels must not be negative");
    if (settings.cutSurface && !problemOf(*settings.cutSurface).empty())
        throw std::invalid_argument("castRays: the cut surface " + problemOf(*settings.cutSurface));
    if (settings.shading) requireSensible(*settings.shading);
    if (!(settings.mixing.share >= 0.0 && settings.mixing.share <= 1.0))
        throw std::invalid_argument("castRays: the share of a mixed picture must lie between 0 and 1");
    if (!(settings.brightness > 0.0) || !std::isfinite(settings.brightness))
        throw std::invalid_argument("castRays: the brightness must be finite and above 0");
}

}  // namespace

RayGeometry::RayGeometry(const VolumeGeometry& geometry, const RayCastSettings& settings)
    : m_parallel(settings.camera.projection == Projection::parallel),
      m_width(settings.width),
      m_height(settings.height),
      m_stepMm(settings.step * geometry.unit()),
      m_forward(settings.camera.frame.forward),
      m_right(settings.camera.frame.right),
      m_down(settings.camera.frame.down),
      m_cutSurface(settings.cutSurface) {
    requireSensible(settings);
    if (settings.front && settings.front->inwards == m_forward) m_nearDepth = settings.front->depthMm;
    const Camera& camera = settings.camera;
    for (int axis = 0; axis < 3; ++axis) {
        m_inverseSpacing[axis] = 1.0 / geometry.spacing[axis];
        m_step[axis] = m_forward[axis] * m_inverseSpacing[axis] * m_stepMm;
        m_perStep[axis] = 1.0 / m_step[axis];
    }
    const double foremostDepth = geometry.depthsAlong(m_forward).nearest;
    m_eye = camera.focalPoint - m_forward * camera.distanceMm;
    const auto acrossPicture = [&](double pixel) {
        m_perColumn = camera.frame.right * pixel;
        m_perRow = camera.frame.down * pixel;
        return m_perColumn * (0.5 - m_width * 0.5) + m_perRow * (0.5 - m_height * 0.5);
    };
    if (m_parallel) {
        m_startDepth = std::max(foremostDepth, m_nearDepth);
        const Vec3 point = camera.focalPoint + acrossPicture(camera.heightMm / m_height);
        m_first = point + m_forward * (m_startDepth - m_forward.dot(point));
    } else {
        m_first =
            m_forward + acrossPicture(2.0 * std::tan(camera.viewAngleDegrees * std::numbers::pi / 360.0) / m_height);
        m_eyeDepth = m_forward.dot(m_eye);
        m_nearDepth -= m_eyeDepth;
        m_startDepth = std::max({foremostDepth - m_eyeDepth, m_nearDepth, 0.0});
    }
    limit(geometry, settings);
}

void RayGeometry::limit(const VolumeGeometry& geometry, const RayCastSettings& settings) {
    for (int axis = 0; axis < 3; ++axis) {
        m_low[axis] = -0.5;
        m_high[axis] = static_cast<double>(geometry.size[static_cast<std::size_t>(axis)]) - 0.5;
        if (!settings.box) continue;
        m_low[axis] = std::max(m_low[axis], settings.box->low[axis] * m_inverseSpacing[axis]);
        m_high[axis] = std::min(m_high[axis], settings.box->high[axis] * m_inverseSpacing[axis]);
        m_high[axis] = std::max(m_high[axis], m_low[axis]);  // a box without inside holds nothing
    }
    if (settings.front && settings.front->inwards != m_forward)
        m_halfSpaces.push_back({settings.front->inwards.mul(geometry.spacing), -settings.front->depthMm});
    for (const ClippingPlane& plane : settings.clippingPlanes)
        m_halfSpaces.push_back({plane.normal.mul(geometry.spacing), -plane.normal.dot(plane.point)});
}

RayGeometry::PixelBox RayGeometry::visiblePixels() const {
    const PixelBox whole{0, m_width, 0, m_height};
    double low[2] = {1e30, 1e30}, high[2] = {-1e30, -1e30};
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 point;
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = ((corner >> axis & 1) != 0 ? m_high[axis] : m_low[axis]) / m_inverseSpacing[axis];
        Vec3 seen = point - m_eye;
        const double depth = seen.dot(m_forward);
        if (!m_parallel && !(depth > 1e-9 * length(seen))) return whole;  // around or behind the eye
        // First the way from the ray of pixel (0,0) to the corner, then this way in pixels.
        seen = m_parallel ? point - m_first : seen * (1.0 / depth) - m_first;
        const double across[2] = {seen.dot(m_right) / length(m_perColumn), seen.dot(m_down) / length(m_perRow)};
        for (int i = 0; i < 2; ++i) {
            low[i] = std::min(low[i], across[i]);
            high[i] = std::max(high[i], across[i]);
        }
    }
    const auto limited = [](double pixel, int pixels) {
        return static_cast<int>(std::clamp(pixel, 0.0, static_cast<double>(pixels)));
    };
    // One more pixel on each side, for rounding.
    return {limited(std::floor(low[0]) - 1.0, m_width), limited(std::ceil(high[0]) + 2.0, m_width),
            limited(std::floor(low[1]) - 1.0, m_height), limited(std::ceil(high[1]) + 2.0, m_height)};
}

double RayGeometry::widestPixelMm(const VolumeGeometry& geometry) const {
    const double pixel = std::max(length(m_perColumn), length(m_perRow));
    return m_parallel ? pixel : pixel * std::max(geometry.depthsAlong(m_forward).farthest - m_eyeDepth, 0.0);
}

RayPlan RayGeometry::plan() const {
    RayPlan plan{m_parallel, m_first, m_perColumn, m_perRow,     m_step,      m_eye,      m_forward,
                 m_low,      m_high,  m_stepMm,    m_startDepth, m_nearDepth, m_eyeDepth, m_halfSpaces};
    if (!m_parallel) return plan;
    for (Vec3* way : {&plan.first, &plan.perColumn, &plan.perRow}) *way = way->mul(m_inverseSpacing);
    return plan;
}

Ray RayGeometry::rayThrough(int column, int row) const {
    RayBundle<1> bundle;
    fill(bundle, {column}, {row});
    Ray ray;
    for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = bundle.origin[axis][0];
        ray.step[axis] = bundle.step[axis][0];
        ray.direction[axis] = ray.step[axis] / (m_inverseSpacing[axis] * m_stepMm);
    }
    ray.enter = bundle.enter[0];
    ray.leave = bundle.leave[0];
    ray.first = static_cast<std::int64_t>(bundle.first[0]);
    ray.last = static_cast<std::int64_t>(bundle.last[0]);
    ray.depthMm = bundle.depthMm[0];
    ray.depthStepMm = bundle.depthStepMm[0];
    return ray;
}

}  // namespace echolucent::ray_casting
