#include "app/measuring/measures/reference_light.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "processing/parallel.h"
#include "processing/ray_caster/plain/plain_caster.h"

namespace echolucent::light {

namespace {

constexpr int extinctionIntervals = 4080;
constexpr double mostExtinction = 1e6;  // per unit, for opacity 1

std::vector<double> extinctionsOf(const OpacityCurve& curve) {
    std::vector<double> extinctions = sampledOpacities(curve, extinctionIntervals + 1);
    for (double& value : extinctions) value = std::min(-std::log1p(-value), mostExtinction);
    return extinctions;
}

}  // namespace

ReferenceLight::ReferenceLight(const Volume& volume, const OpacityCurve& curve, const LightScene& scene, int rings,
                               double step)
    : m_geometry(volume.geometry()),
      m_sampler(volume),
      m_rendered(scene.rendered, volume.geometry().spacing),
      m_step(step),
      m_attenuation(scene.attenuation),
      m_extinctions(extinctionsOf(curve)),
      m_key(denseDirectionsWithin(scene.towardsKey, scene.keyHalfAngleDegrees, rings)),
      m_around(denseDirectionsWithin(scene.towardsViewer, hemisphereDegrees, rings)) {}

ReachingShares ReferenceLight::at(const Vec3& gridMm) const { return {along(gridMm, m_key), along(gridMm, m_around)}; }

double ReferenceLight::extinctionPerUnit(const Vec3& voxel) const {
    const auto intensity = m_sampler.intensityAt(voxel);
    if (!intensity) return 0.0;
    const double position = *intensity * extinctionIntervals;
    const auto entry = static_cast<std::size_t>(std::min(position, extinctionIntervals - 1.0));
    const double share = position - static_cast<double>(entry);
    return m_extinctions[entry] * (1.0 - share) + m_extinctions[entry + 1] * share;
}

double ReferenceLight::along(const Vec3& gridMm, const std::vector<WeightedDirection>& directions) const {
    constexpr double dark = 20.0;  // optical depth
    double sum = 0.0;
    for (const WeightedDirection& direction : directions) {
        double depth = 0.0;
        for (int i = 0; depth < dark; ++i) {
            const Vec3 place = gridMm + direction.towards * ((i + 0.5) * m_step * m_geometry.unit());
            const Vec3 voxel = m_geometry.voxelFromGridMm(place);
            if (!inBox(m_geometry, voxel)) break;
            if (m_rendered.contains(place)) depth += m_attenuation * m_step * extinctionPerUnit(voxel);
        }
        sum += direction.weight * std::exp(-depth);
    }
    return sum;
}

std::optional<Picture> castRaysInLight(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings,
                                       const Reaching& reaching, const Progress& progress) {
    if (!settings.shading) throw std::invalid_argument("castRaysInLight: settings.shading must be set");
    constexpr double worthLight = 1.0 / 2048;
    return castRaysPlainly(volume, curve, settings, {.leastLitOpacity = worthLight, .reaching = &reaching}, progress);
}

}  // namespace echolucent::light
