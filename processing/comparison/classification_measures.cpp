#include "processing/comparison/classification_measures.h"

#include <algorithm>
#include <cmath>

#include "processing/comparison/line_samples.h"
#include "processing/parallel.h"
#include "processing/viewpoint/shown_stretch.h"

namespace echolucent {

namespace {

constexpr double contrastUnitsBefore = 2.0, contrastUnitsBehind = 6.0;  // the light from here is the surface's
constexpr double unitsNear = 3.0;
constexpr double levels = 255.0;
/// At most a hundred millionth of white can still come through, less than any figure shows.
constexpr double leastTransmittance = 1e-8;

/// What a classification makes of one ray.
struct RayMeasures {
    double surface = 0.0, rest = 0.0;  ///< light for SurfaceContrast, levels of 255
    double share = 0.0;                ///< of the light, for NearLight
    double intensity = 0.0;
    ShownSurface shown = ShownSurface::never;
};

/// The samples of a ray, one unit apart, and how far the first one lies behind the surface.
class SampledRay {
public:
    /// `nearPlane` is nearPlaneDepthMm() of the view that looks along `forward`.
    SampledRay(const RaySampler& sampler, const SurfaceRay& ray, const Vec3& forward, double nearPlane,
               const ShownStretches& shown) {
        const VolumeGeometry& geometry = sampler.volume().geometry();
        const double unit = geometry.unit();
        const auto stretch = shown.of(ray.pointMm);
        if (!stretch) return;
        constexpr double rounding = 1e-9;  // units
        const double pointDepth = forward.dot(ray.pointMm);
        // Samples lie in the middle of steps counted from the near plane.
        const double first =
            std::max(0.0, std::ceil((pointDepth + stretch->begin - nearPlane) / unit - 0.5 - rounding));
        const double last = std::floor((pointDepth + stretch->end - nearPlane) / unit - 0.5 + rounding);
        if (last < first) return;
        const double firstDepth = nearPlane + (first + 0.5) * unit;
        const Vec3 firstMm = ray.pointMm + forward * (firstDepth - pointDepth);
        m_samples = sampler.along(geometry.voxelFromGridMm(firstMm), geometry.voxelFromGridMm(forward * unit),
                                  static_cast<std::size_t>(last - first) + 1);
        m_firstBehind = (firstDepth - ray.surfaceDepthMm) / unit;
    }

    [[nodiscard]] RayMeasures measuresWith(const OpacityTable& table) const {
        RayMeasures measures;
        double near = 0.0;
        compositeAlong(m_samples, table, leastTransmittance, [&](std::size_t i, double contribution) {
            const double behind = m_firstBehind + static_cast<double>(i);
            const bool ofSurface = behind >= -contrastUnitsBefore && behind <= contrastUnitsBehind;
            (ofSurface ? measures.surface : measures.rest) += contribution * levels;
            measures.intensity += contribution;
            if (std::abs(behind) <= unitsNear) near += contribution;
        });
        measures.share = measures.intensity > 0.0 ? near / measures.intensity : 0.0;
        const auto sample = shownSample(m_samples, table);
        measures.shown = shownSurfaceAt(sample ? std::optional(m_firstBehind + *sample) : std::nullopt);
        return measures;
    }

private:
    double m_firstBehind = 0.0;  ///< units
    RaySamples m_samples;
};

/// The measures of every stride-th ray from `first` on.
ClassificationMeasures summed(const std::vector<RayMeasures>& rays, std::size_t first, std::size_t stride) {
    ClassificationMeasures all;
    SurfaceContrast& contrast = all.contrast;
    for (std::size_t i = first; i < rays.size(); i += stride) {
        ++contrast.rays;
        contrast.meanSurface += rays[i].surface;
        contrast.meanRest += rays[i].rest;
        all.light.meanShare += rays[i].share;
        all.light.meanIntensity += rays[i].intensity;
        all.depth.count(rays[i].shown);
    }
    if (contrast.rays == 0) return all;
    contrast.meanSurface /= contrast.rays;
    contrast.meanRest /= contrast.rays;
    all.light.meanShare /= contrast.rays;
    all.light.meanIntensity /= contrast.rays;
    for (std::size_t i = first; i < rays.size(); i += stride) {
        contrast.varianceSurface += std::pow(rays[i].surface - contrast.meanSurface, 2);
        contrast.varianceRest += std::pow(rays[i].rest - contrast.meanRest, 2);
    }
    contrast.varianceSurface /= contrast.rays;
    contrast.varianceRest /= contrast.rays;
    return all;
}

}  // namespace

std::optional<double> SurfaceContrast::contrastToNoise() const {
    const double variance = varianceSurface + varianceRest;
    if (rays == 0 || !(variance > 0)) return std::nullopt;
    return (meanSurface - meanRest) / std::sqrt(variance);
}

std::optional<std::vector<ClassificationMeasures>> measuresOf(const Volume& shown, const Viewpoint& view,
                                                              std::span<const SurfaceRay> rays,
                                                              std::span<const Classification> classifications,
                                                              const Progress& progress) {
    const std::vector<OpacityTable> tables = tablesOf(classifications);
    std::vector<RayMeasures> measures(rays.size() * tables.size());
    if (!measures.empty()) {
        const RaySampler sampler(shown, anyTwoDimensional(tables));
        const Vec3 forward = frameOf(view).forward;
        const double nearPlane = nearPlaneDepthMm(view, shown.geometry());
        const ShownStretches stretches(view, shown.geometry());
        parallelFor(LoopRange<std::size_t>(0, rays.size(), 64), [&](const auto& some) {
            for (std::size_t r = some.begin(); r < some.end() && !progress.cancelled(); ++r) {
                const SampledRay ray(sampler, rays[r], forward, nearPlane, stretches);
                for (std::size_t c = 0; c < tables.size(); ++c)
                    measures[r * tables.size() + c] = ray.measuresWith(tables[c]);
            }
        });
    }
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    // Each ray has its place, and sums have one order, so that any number of threads gives the same bits.
    std::vector<ClassificationMeasures> all;
    for (std::size_t c = 0; c < tables.size(); ++c) all.push_back(summed(measures, c, tables.size()));
    return all;
}

}  // namespace echolucent
