#include "processing/ray_caster/plain/plain_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "processing/parallel.h"

namespace echolucent {

namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

double roundedToHalf(double value) {
    if (value == 0.0) return 0.0;
    constexpr int significantBits = 11, leastExponent = -13;  // as std::frexp() counts: 2^-14 is the least normal
    int exponent = 0;
    (void)std::frexp(value, &exponent);
    const double spacing = std::ldexp(1.0, std::max(exponent, leastExponent) - significantBits);
    return std::nearbyint(value / spacing) * spacing;
}

double stored(double value, CompositingPrecision precision) {
    switch (precision) {
        case CompositingPrecision::eightBit: return std::nearbyint(value * 255.0) / 255.0;
        case CompositingPrecision::half: return roundedToHalf(value);
        case CompositingPrecision::single: return static_cast<double>(static_cast<float>(value));
        case CompositingPrecision::twofold: return value;
    }
    return value;
}

}  // namespace

/// What one step of a ray shows.
struct PlainCaster::Step {
    double alpha = 0.0;
    Vec3 colour{0, 0, 0};
};

/// A step of a ray or what is left of it, in steps from the ray's origin.
struct PlainCaster::Stretch {
    double begin, end;
    [[nodiscard]] double length() const { return end - begin; }
    [[nodiscard]] Vec3 middleOn(const ray_casting::Ray& ray) const {
        return ray.origin + ray.step * (0.5 * (begin + end));
    }
};

PlainCaster::PlainCaster(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings,
                         const PlainCasting& casting)
    : m_geometry(volume.geometry()),
      m_curve(curve),
      m_settings(settings),
      m_casting(casting),
      m_rays(volume.geometry(), settings),
      m_sampler(volume, settings.interpolation) {
    const auto box = volume.geometry().depthsAlong(settings.camera.frame.forward);
    m_nearestMm = std::max(box.nearest, settings.nearPlaneDepthMm);
    m_farthestMm = box.farthest;
    if (!settings.shading) return;
    const Vec3& light = settings.shading->towardsLight;
    const ViewFrame& frame = settings.camera.frame;
    m_towardsLight = normalized(frame.right * light[0] + frame.down * light[1] + frame.forward * light[2]);
}

PlainPixel PlainCaster::pixel(int column, int row) const {
    const ray_casting::Ray ray = m_rays.rayThrough(column, row);
    return m_settings.mode == RenderMode::direct ? composited(ray) : projected(ray);
}

std::vector<RaySample> PlainCaster::samplesOf(int column, int row) const {
    const ray_casting::Ray ray = m_rays.rayThrough(column, row);
    std::vector<RaySample> samples;
    walk(ray, [&](const Stretch& stretch) {
        const Vec3 voxel = stretch.middleOn(ray);
        samples.push_back({voxel, stretch.length(), m_sampler.intensityAt(voxel)});
        return true;
    });
    return samples;
}

double PlainCaster::depthOf(const Vec3& voxel) const {
    return m_settings.camera.frame.forward.dot(m_geometry.gridMmFromVoxel(voxel));
}

/// Calls visit(stretch) from front to back until it returns false.
template <typename Visit>
void PlainCaster::walk(const ray_casting::Ray& ray, const Visit& visit) const {
    if (!(ray.enter < ray.leave)) return;
    for (double k = std::floor(ray.enter); k < ray.leave; ++k) {
        const Stretch whole{k, k + 1.0}, left{std::max(k, ray.enter), std::min(k + 1.0, ray.leave)};
        const bool seen = m_casting.wholeSteps ? k + 0.5 >= ray.enter && k + 0.5 < ray.leave : left.length() > 0.0;
        if (seen && !visit(m_casting.wholeSteps ? whole : left)) return;
    }
}

/// Eqs. 2 and 3.
PlainPixel PlainCaster::composited(const ray_casting::Ray& ray) const {
    PlainPixel pixel;
    double transmittance = 1.0;
    walk(ray, [&](const Stretch& stretch) {
        const Vec3 voxel = stretch.middleOn(ray);
        const Step step = sampleAt(voxel, stretch);
        if (!(step.alpha > 0.0)) return true;
        const double seen = transmittance * step.alpha;
        Vec3 colour = step.colour;
        if (m_settings.shading) colour = lit(colour, voxel, ray.direction, seen);
        if (m_settings.depthColouring) colour = colour.mul(tintAt(depthOf(voxel)));
        for (int channel = 0; channel < 3; ++channel)
            pixel.colour[channel] = stored(pixel.colour[channel] + seen * colour[channel], m_casting.precision);
        transmittance = stored(transmittance * (1.0 - step.alpha), m_casting.precision);
        if (pixel.depthMm == nowhere && transmittance <= 0.5) pixel.depthMm = depthOf(voxel);
        return transmittance >= m_settings.terminationTransmittance;
    });
    pixel.alpha = 1.0 - transmittance;
    return pixel;
}

/// Maximum, minimum, mean.
PlainPixel PlainCaster::projected(const ray_casting::Ray& ray) const {
    PlainPixel pixel;
    double shown = 0.0, sum = 0.0, steps = 0.0;
    walk(ray, [&](const Stretch& stretch) {
        const Vec3 voxel = stretch.middleOn(ray);
        const auto intensity = m_sampler.intensityAt(voxel);
        if (!intensity) return true;
        const bool isShown = steps == 0.0 || (m_settings.mode == RenderMode::maximum && *intensity > shown) ||
                             (m_settings.mode == RenderMode::minimum && *intensity < shown);
        if (isShown) {
            shown = *intensity;
            pixel.depthMm = depthOf(voxel);
        }
        sum += *intensity * stretch.length();
        steps += stretch.length();
        return true;
    });
    if (steps == 0.0) return pixel;
    if (m_settings.mode == RenderMode::mean) shown = sum / steps;
    pixel.colour = colourOf(m_settings.colourMap, shown);
    pixel.alpha = 1.0;
    return pixel;
}

PlainCaster::Step PlainCaster::sampleAt(const Vec3& voxel, const Stretch& stretch) const {
    const auto intensity = m_sampler.intensityAt(voxel);
    if (!intensity) return {};
    const double length = m_settings.step * stretch.length();
    return {opacityForStep(opacityAt(m_curve, *intensity), length), colourOf(m_settings.colourMap, *intensity)};
}

/// Shading's formula; `seen` is what the sample adds to its pixel's opacity.
Vec3 PlainCaster::lit(const Vec3& colour, const Vec3& voxel, const Vec3& rayDirection, double seen) const {
    const Shading& shading = *m_settings.shading;
    const Vec3 gradient =
        seen >= m_casting.leastLitOpacity ? m_sampler.gradientAt(voxel, shading.gradientReach) : Vec3(0, 0, 0);
    const double magnitude = length(gradient);
    double surface = 0.0, diffuse = 0.0, specular = 0.0;
    if (magnitude > 0.0) {
        const Vec3 normal = gradient * (-1.0 / magnitude), half = m_towardsLight - rayDirection;
        surface = magnitude * magnitude / (magnitude * magnitude + shading.gradientFloor * shading.gradientFloor);
        diffuse = std::max(0.0, (normal.dot(m_towardsLight) + shading.wrap) / (1.0 + shading.wrap));
        if (length(half) > 0.0) specular = std::pow(std::max(0.0, normal.dot(normalized(half))), shading.specularPower);
    }
    const double factor = shading.ambient +
                          shading.diffuse * (surface * diffuse + (1.0 - surface) * shading.evenLight) +
                          surface * shading.specular * specular;
    const Vec3 tint = shadowTintOf(m_settings.colourMap);
    Vec3 bright;
    for (int channel = 0; channel < 3; ++channel)
        bright[channel] =
            std::min(1.0, colour[channel] * factor * (tint[channel] + (1.0 - tint[channel]) * std::min(1.0, factor)));
    return bright;
}

Vec3 PlainCaster::tintAt(double depthMm) const {
    const double extent = m_farthestMm - m_nearestMm;
    const double share = extent > 0.0 ? std::clamp((depthMm - m_nearestMm) / extent, 0.0, 1.0) : 0.0;
    const DepthColouring& tints = *m_settings.depthColouring;
    return tints.nearTint * (1.0 - share) + tints.farTint * share;
}

namespace {

void castRow(const PlainCaster& caster, int row, Picture& picture) {
    for (int column = 0; column < picture.width; ++column) {
        const PlainPixel pixel = caster.pixel(column, row);
        const std::size_t at =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(column);
        for (int channel = 0; channel < 3; ++channel)
            picture.rgba[at * 4 + static_cast<std::size_t>(channel)] = static_cast<float>(pixel.colour[channel]);
        picture.rgba[at * 4 + 3] = static_cast<float>(pixel.alpha);
        if (!picture.depthMm.empty()) picture.depthMm[at] = static_cast<float>(pixel.depthMm);
    }
}

}  // namespace

std::string_view nameOf(CompositingPrecision precision) {
    switch (precision) {
        case CompositingPrecision::eightBit: return "8 bit";
        case CompositingPrecision::half: return "half";
        case CompositingPrecision::single: return "single";
        case CompositingPrecision::twofold: return "double";
    }
    return "";
}

std::optional<Picture> castRaysPlainly(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings,
                                       const PlainCasting& casting, const Progress& progress) {
    const PlainCaster caster(volume, curve, settings, casting);
    Picture picture = emptyPicture(settings.width, settings.height, settings.findDepth);
    ProgressCount rows(progress, static_cast<std::size_t>(settings.height));
    parallelFor(0, settings.height, [&](int row) {
        if (progress.cancelled()) return;
        castRow(caster, row, picture);
        rows.oneDone();
    });
    if (progress.cancelled()) return std::nullopt;
    return picture;
}

}  // namespace echolucent
