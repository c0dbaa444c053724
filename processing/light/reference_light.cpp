#include "processing/light/reference_light.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "processing/parallel.h"
#include "processing/ray_caster/plain/plain_caster.h"

namespace echolucent::light {

namespace {

constexpr int extinctionIntervals = 4080;
constexpr double mostExtinction = 1e6;  // per unit, of opacity 1
constexpr double hemisphereDegrees = 90.0;

std::vector<double> extinctionsOf(const OpacityCurve& curve) {
    std::vector<double> extinctions = sampledOpacities(curve, extinctionIntervals + 1);
    for (double& value : extinctions) value = std::min(-std::log1p(-value), mostExtinction);
    return extinctions;
}

/// A pixel of the plain route with light.
class LitPixels {
public:
    LitPixels(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings,
              const ReachingLight& light, const Reaching& reaching)
        : m_geometry(volume.geometry()),
          m_curve(curve),
          m_settings(settings),
          m_light(light),
          m_reaching(reaching),
          m_caster(volume, curve, settings),
          m_rays(volume.geometry(), settings),
          m_sampler(volume) {
        const Vec3& towards = settings.shading->towardsLight;
        const ViewFrame& frame = settings.camera.frame;
        m_towardsLight = normalized(frame.right * towards[0] + frame.down * towards[1] + frame.forward * towards[2]);
    }

    [[nodiscard]] PlainPixel at(int column, int row) const {
        PlainPixel pixel;
        const Vec3 direction = m_rays.rayThrough(column, row).direction;
        double transmittance = 1.0;
        for (const RaySample& sample : m_caster.samplesOf(column, row)) {
            if (!sample.intensity) continue;
            const double alpha = opacityForStep(opacityAt(m_curve, *sample.intensity), m_settings.step * sample.length);
            if (!(alpha > 0.0)) continue;
            const double seen = transmittance * alpha;
            pixel.colour +=
                lit(colourOf(m_settings.colourMap, *sample.intensity), sample.voxel, direction, seen) * seen;
            transmittance *= 1.0 - alpha;
            if (transmittance < m_settings.terminationTransmittance) break;
        }
        pixel.alpha = 1.0 - transmittance;
        return pixel;
    }

private:
    [[nodiscard]] Vec3 lit(const Vec3& colour, const Vec3& voxel, const Vec3& direction, double seen) const {
        constexpr double worthLight = 1.0 / 2048;
        const Shading& shading = *m_settings.shading;
        const auto surface =
            surfaceLight(shading, m_sampler.gradientAt(voxel, shading.gradientReach), m_towardsLight, direction);
        const auto reaching = seen >= worthLight ? m_reaching(m_geometry.gridMmFromVoxel(voxel)) : ReachingShares{};
        const Vec3 factor = reachingFactor(shading, m_light, reaching.key, reaching.around, surface);
        const Vec3 tint = shadowTintOf(m_settings.colourMap);
        Vec3 bright;
        for (int i = 0; i < 3; ++i)
            bright[i] = std::min(1.0, colour[i] * factor[i] * (tint[i] + (1.0 - tint[i]) * std::min(1.0, factor[i])));
        return bright;
    }

    const VolumeGeometry& m_geometry;
    const OpacityCurve& m_curve;
    const RayCastSettings& m_settings;
    const ReachingLight& m_light;
    const Reaching& m_reaching;
    PlainCaster m_caster;
    ray_casting::RayGeometry m_rays;
    VolumeSampler m_sampler;
    Vec3 m_towardsLight;
};

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
                                       const ReachingLight& light, const Reaching& reaching, const Progress& progress) {
    if (!settings.shading) throw std::invalid_argument("castRaysInLight: settings.shading must be set");
    const LitPixels pixels(volume, curve, settings, light, reaching);
    Picture picture = emptyPicture(settings.width, settings.height);
    ProgressCount rows(progress, static_cast<std::size_t>(settings.height));
    parallelFor(0, settings.height, [&](int row) {
        if (progress.cancelled()) return;
        float* rgba =
            picture.rgba.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(settings.width) * 4;
        for (int column = 0; column < settings.width; ++column, rgba += 4) {
            const PlainPixel pixel = pixels.at(column, row);
            for (int i = 0; i < 3; ++i) rgba[i] = static_cast<float>(pixel.colour[i]);
            rgba[3] = static_cast<float>(pixel.alpha);
        }
        rows.oneDone();
    });
    if (progress.cancelled()) return std::nullopt;
    return picture;
}

}  // namespace echolucent::light
