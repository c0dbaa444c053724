#include "processing/ray_caster/plain/plain_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "processing/parallel.h"
#include "processing/picture/reaching_light.h"
#include "processing/picture/view_limits.h"
#include "processing/progress_count.h"
#include "processing/sampling/gradient_magnitude.h"

namespace echolucent {

namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

double stored(double value, const PlainCasting& casting) {
    return casting.rounded == nullptr ? value : casting.rounded(value);
}

}  // namespace

/// One step of a ray.
struct PlainCaster::Step {
    double opacity = 0.0;  ///< by the classification alone, for the step's length
    double alpha = 0.0;    ///< `opacity` times the coverage by data
    double border = 0.0;   ///< PresenceUse::border()
    Vec3 colour{0, 0, 0};
};

/// A step as the viewer sees it.
struct PlainCaster::Seen {
    Vec3 colour, voxel, rayDirection;
    double added;  ///< to its pixel's opacity
    double unlit;  ///< share of a cut's face
};

namespace {

/// A step of a ray or the rest of a cut one, in steps from the ray's origin.
struct Stretch {
    double begin, end;
    [[nodiscard]] double length() const { return end - begin; }
    [[nodiscard]] Vec3 middleOn(const ray_casting::Ray& ray) const {
        return ray.origin + ray.step * (0.5 * (begin + end));
    }
};

/// Calls visit(stretch) from front to back until it returns false.
template <typename Visit>
void walk(const ray_casting::Ray& ray, bool wholeSteps, const Visit& visit) {
    if (!(ray.enter < ray.leave)) return;
    for (double k = std::floor(ray.enter); k < ray.leave; ++k) {
        const Stretch whole{k, k + 1.0}, left{std::max(k, ray.enter), std::min(k + 1.0, ray.leave)};
        const bool seen = wholeSteps ? k + 0.5 >= ray.enter && k + 0.5 < ray.leave : left.length() > 0.0;
        if (seen && !visit(wholeSteps ? whole : left)) return;
    }
}

}  // namespace

namespace {

/// White level of the volume of gradient magnitudes. These are at most the root of 3, so no sample is clamped.
constexpr double whiteOfGradients = 2.0;

Volume gradientsOf(const Volume& filled) {
    const VolumeGeometry& geometry = filled.geometry();
    const auto columns = static_cast<std::size_t>(geometry.size[0]);
    std::vector<float> magnitudes(static_cast<std::size_t>(geometry.voxelCount()));
    const GradientMagnitude gradients(filled);
    parallelFor(std::int64_t{0}, geometry.size[2], [&](std::int64_t z) {
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            gradients.row(y, z,
                          std::span(magnitudes).subspan(static_cast<std::size_t>(geometry.offset(0, y, z)), columns));
    });
    return Volume(geometry, VoxelArray<float>(std::move(magnitudes)), whiteOfGradients);
}

}  // namespace

PlainCaster::PlainCaster(const Volume& volume, Classification classification, const RayCastSettings& settings,
                         const PlainCasting& casting)
    : m_geometry(volume.geometry()),
      m_filled(filledVolume(volume)),
      m_classification(std::move(classification)),
      m_settings(settings),
      m_casting(casting),
      m_rays(volume.geometry(), settings),
      m_sampler(m_filled.voxels, settings.interpolation) {
    m_nearestMm = nearestDepthMm(settings, volume.geometry());
    m_farthestMm = volume.geometry().depthsAlong(settings.camera.frame.forward).farthest;
    if (m_classification.isTwoDimensional()) m_gradients = gradientsOf(m_filled.voxels);
    if (!settings.shading) return;
    const Vec3& light = settings.shading->towardsLight;
    const ViewFrame& frame = settings.camera.frame;
    m_towardsLight = normalized(frame.right * light[0] + frame.down * light[1] + frame.forward * light[2]);
    if (settings.mode != RenderMode::direct || !settings.shading->asksWhatReaches() || casting.reaching != nullptr)
        return;
    m_light = LightSweep(std::shared_ptr<const Volume>(std::shared_ptr<const Volume>(), &volume))
                  .lightVolume(m_classification, lightSceneOf(settings, volume.geometry()));
}

PlainPixel PlainCaster::pixel(int column, int row) const {
    const ray_casting::Ray ray = m_rays.rayThrough(column, row);
    return m_settings.mode == RenderMode::direct ? composited(ray) : projected(ray);
}

double PlainCaster::depthOf(const Vec3& voxel) const {
    return m_settings.camera.frame.forward.dot(m_geometry.gridMmFromVoxel(voxel));
}

/// The presence of data at a place, 0 to 1.
double PlainCaster::presenceAt(const Vec3& voxel) const {
    return m_filled.presence ? VolumeSampler(*m_filled.presence, m_settings.interpolation).intensityAt(voxel).value()
                             : 1.0;
}

namespace {

/// The factor of a cut face's share over half a step (CutFace).
double leftOfCutFace(double opacity, double units) {
    const double tissue = std::min(1.0, opacity / (units * CutFace::tissueOpacity));
    const double rate = 1.0 / CutFace::tissueDepth + (1.0 - tissue) / CutFace::fluidDepth;
    return 1.0 / (1.0 + 0.5 * units * rate);
}

}  // namespace

/// Eqs. 2 and 3.
PlainPixel PlainCaster::composited(const ray_casting::Ray& ray) const {
    PlainPixel pixel;
    double transmittance = 1.0, unlit = 1.0;
    walk(ray, m_casting.wholeSteps, [&](const Stretch& stretch) {
        const Vec3 voxel = stretch.middleOn(ray);
        const Step step = sampleAt(voxel, stretch.length());
        const double left = leftOfCutFace(step.opacity, m_settings.step * stretch.length());
        const double unlitHere = std::max(unlit * left, step.border);
        unlit = unlitHere * left;
        if (!(step.alpha > 0.0)) return true;
        const double seen = transmittance * step.alpha;
        Vec3 colour = step.colour;
        if (m_settings.shading) colour = lit({colour, voxel, ray.direction, seen, unlitHere});
        if (m_settings.depthColouring) colour = colour.mul(tintAt(depthOf(voxel)));
        for (int channel = 0; channel < 3; ++channel)
            pixel.colour[channel] = stored(pixel.colour[channel] + seen * colour[channel], m_casting);
        transmittance = stored(transmittance * (1.0 - step.alpha), m_casting);
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
    walk(ray, m_casting.wholeSteps, [&](const Stretch& stretch) {
        const Vec3 voxel = stretch.middleOn(ray);
        const auto intensity = presenceAt(voxel) < 0.5 ? std::nullopt : m_sampler.intensityAt(voxel);
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

/// Opacity per reference step.
double PlainCaster::opacityOf(const Vec3& voxel, double intensity) const {
    if (!m_gradients) return opacityAt(m_classification.curve(), intensity);
    const double share = VolumeSampler(*m_gradients, m_settings.interpolation).intensityAt(voxel).value();
    return opacityAt(m_classification, intensity, share * whiteOfGradients);
}

PlainCaster::Step PlainCaster::sampleAt(const Vec3& voxel, double length) const {
    const double presence = presenceAt(voxel), intensity = m_sampler.intensityAt(voxel).value_or(0.0);
    const double opacity = opacityForStep(opacityOf(voxel, intensity), m_settings.step * length);
    const bool nearest = m_settings.interpolation == Interpolation::nearest;
    const double coverage = nearest ? (presence >= 0.5 ? 1.0 : 0.0) : PresenceUse::coverage(presence);
    return {opacity, opacity * coverage, m_filled.presence ? PresenceUse::border(presence) : 0.0,
            colourOf(m_settings.colourMap, intensity)};
}

/// Shading's factor, for each channel.
Vec3 PlainCaster::factorsAt(const Seen& seen) const {
    const Shading& shading = *m_settings.shading;
    const bool worth = seen.added >= m_casting.leastLitOpacity;
    const Vec3 gradient = worth ? m_sampler.gradientAt(seen.voxel, shading.gradientReach) : Vec3(0, 0, 0);
    const SurfaceLight surface = surfaceLight(shading, gradient, m_towardsLight, seen.rayDirection);
    ReachingShares reaching;
    const Vec3 place = m_geometry.gridMmFromVoxel(seen.voxel);
    if (m_casting.reaching != nullptr && worth)
        reaching = (*m_casting.reaching)(place);
    else if (m_light && seen.added >= leastReachedShare * m_casting.leastLitOpacity)
        reaching = reachingAt(*m_light, place);
    return reachingFactor(shading, reaching.key, reaching.around, surface);
}

/// Shading's formula.
Vec3 PlainCaster::lit(const Seen& seen) const {
    const Vec3 factors = factorsAt(seen), tint = shadowTintOf(m_settings.colourMap);
    Vec3 bright;
    for (int channel = 0; channel < 3; ++channel) {
        const double factor = (1.0 - seen.unlit) * factors[channel] + seen.unlit;
        bright[channel] = std::min(
            1.0, seen.colour[channel] * factor * (tint[channel] + (1.0 - tint[channel]) * std::min(1.0, factor)));
    }
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

std::vector<RaySample> samplesAlongRay(const Volume& volume, const RayCastSettings& settings, int column, int row) {
    const ray_casting::Ray ray = ray_casting::RayGeometry(volume.geometry(), settings).rayThrough(column, row);
    const VolumeSampler sampler(volume, settings.interpolation);
    std::vector<RaySample> samples;
    walk(ray, false, [&](const Stretch& stretch) {
        const Vec3 voxel = stretch.middleOn(ray);
        samples.push_back({voxel, stretch.length(), sampler.intensityAt(voxel)});
        return true;
    });
    return samples;
}

namespace {

std::optional<Picture> castOne(const Volume& volume, const Classification& classification,
                               const RayCastSettings& settings, const PlainCasting& casting, const Progress& progress) {
    const PlainCaster caster(volume, classification, settings, casting);
    Picture picture = emptyPicture(settings.width, settings.height, settings.findDepth);
    ProgressCount rows(progress, static_cast<std::size_t>(settings.height));
    parallelFor(0, settings.height, [&](int row) {
        if (progress.cancelled()) return;
        castRow(caster, row, picture);
        rows.oneDone();
    });
    if (progress.cancelled()) return std::nullopt;
    if (settings.brightness != 1.0) brighten(picture, settings.brightness);
    return picture;
}

}  // namespace

std::optional<Picture> castRaysPlainly(const Volume& volume, const Classification& classification,
                                       const RayCastSettings& settings, const PlainCasting& casting,
                                       const Progress& progress) {
    auto picture = castOne(volume, classification, settings, casting, progress);
    if (!picture || settings.mode != RenderMode::direct || settings.mixing.share == 0.0) return picture;
    const auto other = castOne(volume, classification, mixedIn(settings), casting, progress);
    if (!other) return std::nullopt;
    mixIn(*picture, *other, settings.mixing.share);
    return picture;
}

}  // namespace echolucent
