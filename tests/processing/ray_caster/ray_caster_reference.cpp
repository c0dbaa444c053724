#include "tests/processing/ray_caster/ray_caster_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace echolucent {

namespace {

template <typename ValueAt>
double nearestOf(const ValueAt& valueAt, const Vec3& voxel) {
    return valueAt(std::array<std::int64_t, 3>{std::llround(std::floor(voxel[0] + 0.5)),
                                               std::llround(std::floor(voxel[1] + 0.5)),
                                               std::llround(std::floor(voxel[2] + 0.5))});
}

template <typename ValueAt>
double trilinearOf(const ValueAt& valueAt, const Vec3& voxel) {
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        std::array<std::int64_t, 3> at{};
        double weight = 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double position = voxel[static_cast<int>(axis)];
            const bool far = (corner >> axis & 1) != 0;
            at[axis] = std::llround(std::floor(position)) + (far ? 1 : 0);
            weight *= far ? position - std::floor(position) : 1.0 - (position - std::floor(position));
        }
        sum += weight * valueAt(at);
    }
    return sum;
}

}  // namespace

ReferencePixel ReferenceCaster::pixel(int column, int row) const {
    ReferencePixel out{0, 0, 0, 0};
    const std::vector<Sample> samples = samplesOf(column, row);
    for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample)
        for (std::size_t channel = 0; channel < 4; ++channel) {
            const double in = channel < 3 ? sample->colour[static_cast<int>(channel)] : 1.0;
            out[channel] = out[channel] * (1.0 - sample->alpha) + in * sample->alpha;
        }
    return out;
}

std::vector<ReferenceCaster::Sample> ReferenceCaster::samplesOf(int column, int row) const {
    m_closestToHalf = 1.0;
    const Camera& camera = m_settings.camera;
    const Vec3 forward = camera.frame.forward;
    const bool parallel = camera.projection == Projection::parallel;
    const double pixelSize =
        (parallel ? camera.heightMm : 2 * std::tan(camera.viewAngleDegrees / 2 * std::numbers::pi / 180)) /
        m_settings.height;
    const Vec3 offset = camera.frame.right * ((column + 0.5 - m_settings.width / 2.0) * pixelSize) +
                        camera.frame.down * ((row + 0.5 - m_settings.height / 2.0) * pixelSize);
    Vec3 origin, direction;
    if (parallel) {
        direction = forward;
        origin = camera.focalPoint + offset;
        origin = origin + forward * (startDepth() - origin.dot(forward));
    } else {
        direction = normalized(forward + offset);
        const Vec3 eye = camera.focalPoint - forward * camera.distanceMm;
        origin = eye + direction * std::max(0.0, startDepth() - eye.dot(forward));
    }
    return alongRay(origin, direction);
}

double ReferenceCaster::startDepth() const {
    double foremost = std::numeric_limits<double>::infinity();
    for (const double x : {m_geometry.boxMinMm()[0], m_geometry.boxMaxMm()[0]})
        for (const double y : {m_geometry.boxMinMm()[1], m_geometry.boxMaxMm()[1]})
            for (const double z : {m_geometry.boxMinMm()[2], m_geometry.boxMaxMm()[2]})
                foremost = std::min(foremost, m_settings.camera.frame.forward.dot(Vec3(x, y, z)));
    const auto& front = m_settings.front;
    return front && front->inwards == m_settings.camera.frame.forward ? std::max(foremost, front->depthMm) : foremost;
}

std::pair<double, double> ReferenceCaster::partInside(const Vec3& origin, const Vec3& direction, double stepMm) const {
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double low = m_geometry.boxMinMm()[axis] - origin[axis];
        const double high = m_geometry.boxMaxMm()[axis] - origin[axis];
        if (direction[axis] == 0.0) {
            if (low > 0.0 || high <= 0.0) leave = 0.0;
            continue;
        }
        const double a = low / direction[axis] / stepMm, b = high / direction[axis] / stepMm;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    const auto keepFrom = [&](const Vec3& point, const Vec3& normal) {
        const double distance = normal.dot(origin - point), perStep = normal.dot(direction) * stepMm;
        if (perStep > 0.0) enter = std::max(enter, -distance / perStep);
        if (perStep < 0.0) leave = std::min(leave, -distance / perStep);
        if (perStep == 0.0 && distance < 0.0) leave = 0.0;
    };
    if (m_settings.front) keepFrom(m_settings.front->inwards * m_settings.front->depthMm, m_settings.front->inwards);
    for (const ClippingPlane& plane : m_settings.clippingPlanes) keepFrom(plane.point, plane.normal);
    for (int axis = 0; axis < 3 && m_settings.box; ++axis) {
        Vec3 along{0, 0, 0};
        along[axis] = 1.0;
        keepFrom(m_settings.box->low, along);
        keepFrom(m_settings.box->high, -along);
    }
    return {enter, leave};
}

std::vector<ReferenceCaster::Sample> ReferenceCaster::alongRay(const Vec3& origin, const Vec3& direction) const {
    const double stepMm = m_settings.step * m_geometry.unit();
    const auto [enter, leave] = partInside(origin, direction, stepMm);
    std::vector<Sample> samples;
    double before = 1.0, unlit = 1.0;
    for (double step = std::floor(enter); step < leave; step += 1.0) {
        // Steps are cut at both ends of the rendered part.
        const double begin = std::max(step, enter), end = std::min(step + 1.0, leave);
        if (!(begin < end)) continue;
        const auto sample =
            sampleAt(origin + direction * ((begin + end) / 2 * stepMm), direction, before, end - begin, unlit);
        if (!sample) continue;
        samples.push_back(*sample);
        before *= 1.0 - sample->alpha;
    }
    return samples;
}

std::optional<ReferenceCaster::Sample> ReferenceCaster::sampleAt(const Vec3& point, const Vec3& direction,
                                                                 double before, double length, double& unlit) const {
    const Vec3 voxel = m_geometry.voxelFromGridMm(point);
    const bool nearestOnly = m_settings.interpolation == Interpolation::nearest;
    const double presence = !m_filled.presence ? 1.0
                            : nearestOnly      ? nearest(*m_filled.presence, voxel) / 255
                                               : trilinear(*m_filled.presence, voxel) / 255;
    const bool allOrNothing = nearestOnly || m_settings.mode != RenderMode::direct;
    if (allOrNothing) m_closestToHalf = std::min(m_closestToHalf, std::abs(presence - 0.5));
    const double covered = allOrNothing ? (presence >= 0.5 ? 1.0 : 0.0) : std::clamp((presence - 0.25) / 0.5, 0.0, 1.0);
    const double stored = nearestOnly ? nearest(m_volume, voxel) : trilinear(m_volume, voxel);
    const double intensity = std::clamp(stored / m_volume.whiteLevel(), 0.0, 1.0);
    const double units = m_settings.step * length;
    const double opacity = opacityForStep(opacityOf(voxel, intensity), units);
    const double inFluid = 1.0 - std::min(1.0, opacity / units * 16.0);
    const double left = 1.0 / (1.0 + units / 2 * (1.0 / 16 + inFluid));
    const double border = m_filled.presence ? std::clamp((0.875 - presence) / 0.375, 0.0, 1.0) : 0.0;
    const double unlitHere = std::max(unlit * left, border);
    unlit = unlitHere * left;
    if (covered == 0.0) return std::nullopt;
    const double alpha = opacity * covered;
    Vec3 colour = colourOf(m_settings.colourMap, intensity);
    if (m_settings.shading) colour = lit(colour, voxel, direction, before * alpha, unlitHere);
    return Sample{colour, alpha, intensity, point.dot(m_settings.camera.frame.forward), length};
}

double ReferenceCaster::opacityOf(const Vec3& voxel, double intensity) const {
    if (!m_classification.isTwoDimensional()) return opacityAt(m_classification.curve(), intensity);
    const auto magnitude = [&](const std::array<std::int64_t, 3>& at) { return gradientMagnitude(at); };
    const double gradient = m_settings.interpolation == Interpolation::nearest ? nearestOf(magnitude, voxel)
                                                                               : trilinearOf(magnitude, voxel);
    return opacityAt(*m_classification.twoDimensional(), intensity, gradient);
}

double ReferenceCaster::gradientMagnitude(std::array<std::int64_t, 3> at) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
        at[axis] = std::clamp<std::int64_t>(at[axis], 0, m_geometry.size[axis] - 1);
    const auto intensity = [&](const std::array<std::int64_t, 3>& voxel) {
        return std::clamp(value(m_volume, voxel) / m_volume.whiteLevel(), 0.0, 1.0);
    };
    double square = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<std::int64_t, 3> before = at, after = at;
        before[axis] = std::max<std::int64_t>(0, at[axis] - 1);
        after[axis] = std::min(m_geometry.size[axis] - 1, at[axis] + 1);
        if (before[axis] == after[axis]) continue;
        const double units = static_cast<double>(after[axis] - before[axis]) *
                             m_geometry.spacing[static_cast<int>(axis)] / m_geometry.unit();
        square += std::pow((intensity(after) - intensity(before)) / units, 2);
    }
    return std::sqrt(square);
}

double ReferenceCaster::value(const Volume& volume, std::array<std::int64_t, 3> at) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
        at[axis] = std::clamp<std::int64_t>(at[axis], 0, m_geometry.size[axis] - 1);
    return volume.storedValue(m_geometry.offset(at[0], at[1], at[2]));
}

double ReferenceCaster::nearest(const Volume& volume, const Vec3& voxel) const {
    return nearestOf([&](const auto& at) { return value(volume, at); }, voxel);
}

double ReferenceCaster::trilinear(const Volume& volume, const Vec3& voxel) const {
    return trilinearOf([&](const auto& at) { return value(volume, at); }, voxel);
}

Vec3 ReferenceCaster::lit(const Vec3& colour, const Vec3& voxel, const Vec3& direction, double seen,
                          double unlit) const {
    const Shading& shading = *m_settings.shading;
    const bool worth = seen >= std::min(1.0, m_settings.step) / 128;
    Vec3 gradient{0, 0, 0};
    for (int axis = 0; axis < 3 && worth; ++axis) {
        const double last = static_cast<double>(m_geometry.size[static_cast<std::size_t>(axis)] - 1);
        const double reach = shading.gradientReach * m_geometry.unit() / m_geometry.spacing[axis];
        Vec3 before = voxel, after = voxel;
        before[axis] = std::clamp(voxel[axis] - reach, 0.0, last);
        after[axis] = std::clamp(voxel[axis] + reach, 0.0, last);
        if (!(after[axis] > before[axis])) continue;
        const double units = (after[axis] - before[axis]) * m_geometry.spacing[axis] / m_geometry.unit();
        gradient[axis] = (trilinear(m_volume, after) - trilinear(m_volume, before)) / m_volume.whiteLevel() / units;
    }
    const double magnitude = length(gradient);
    double surface = 0.0, facing = 0.0, highlight = 0.0;
    if (magnitude > 0.0) {
        const ViewFrame& frame = m_settings.camera.frame;
        const Vec3 light = normalized(frame.right * shading.towardsLight[0] + frame.down * shading.towardsLight[1] +
                                      frame.forward * shading.towardsLight[2]);
        const Vec3 normal = gradient * (-1.0 / magnitude);
        surface = magnitude * magnitude / (magnitude * magnitude + shading.gradientFloor * shading.gradientFloor);
        facing = std::max(0.0, (normal.dot(light) + shading.wrap) / (1.0 + shading.wrap));
        highlight = shading.specular *
                    std::pow(std::max(0.0, normal.dot(normalized(light - direction))), shading.specularPower);
    }
    ReachingShares reaching;
    if (m_light && seen >= std::min(1.0, m_settings.step) / 2048)
        reaching = reachingAt(*m_light, m_geometry.gridMmFromVoxel(voxel));
    const double around = shading.reaching.occlusion * reaching.around + 1.0 - shading.reaching.occlusion;
    const double key = shading.diffuse * (surface * facing + (1.0 - surface) * shading.evenLight) + surface * highlight;
    const auto factorOf = [&](double scattered) {
        const double reached = reaching.key + shading.reaching.translucency * (scattered - reaching.key);
        return shading.ambient * around + key * (1.0 - shading.reaching.shadow * (1.0 - reached));
    };
    const Vec3 factors{factorOf(std::sqrt(reaching.key)), factorOf(reaching.key),
                       factorOf(reaching.key * reaching.key)};
    const Vec3 tint = shadowTintOf(m_settings.colourMap);
    const auto shadow = [&](int channel, double f) { return tint[channel] + (1 - tint[channel]) * std::min(1.0, f); };
    Vec3 bright;
    for (int channel = 0; channel < 3; ++channel) {
        const double here = unlit + (1.0 - unlit) * factors[channel];
        bright[channel] = std::min(1.0, colour[channel] * here * shadow(channel, here));
    }
    return bright;
}

}  // namespace echolucent
