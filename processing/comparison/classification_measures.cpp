#include "processing/comparison/classification_measures.h"

#include <cmath>

#include "processing/comparison/surface_samples.h"
#include "processing/parallel.h"

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

RayMeasures measuresAlong(const SurfaceSamples& ray, const OpacityTable& table) {
    RayMeasures measures;
    double near = 0.0;
    compositeAlong(ray.samples, table, leastTransmittance, [&](std::size_t i, double contribution) {
        const double behind = ray.firstBehind + static_cast<double>(i);
        const bool ofSurface = behind >= -contrastUnitsBefore && behind <= contrastUnitsBehind;
        (ofSurface ? measures.surface : measures.rest) += contribution * levels;
        measures.intensity += contribution;
        if (std::abs(behind) <= unitsNear) near += contribution;
    });
    measures.share = measures.intensity > 0.0 ? near / measures.intensity : 0.0;
    measures.shown = shownSurfaceOf(ray, table);
    return measures;
}

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
        all.shown.push_back(rays[i].shown);
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
        const SurfaceSampler sampler(shown, view, anyTwoDimensional(tables));
        parallelFor(LoopRange<std::size_t>(0, rays.size(), 64), [&](const auto& some) {
            for (std::size_t r = some.begin(); r < some.end() && !progress.cancelled(); ++r) {
                const SurfaceSamples ray = sampler.along(rays[r]);
                for (std::size_t c = 0; c < tables.size(); ++c)
                    measures[r * tables.size() + c] = measuresAlong(ray, tables[c]);
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
