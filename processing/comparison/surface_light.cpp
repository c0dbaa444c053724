#include "processing/comparison/surface_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "processing/adaptive/halved_lengths.h"
#include "processing/parallel.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/tube_core/slabs/tube_samples.h"

namespace echolucent {

namespace {

constexpr double unitsOfSurface = 3.0;

struct TubeLight {
    double share = 0.0, intensity = 0.0;
};

/// The ray along a tube core's axis, from the tube's first sample on, and the place of its surface.
struct TubeRay {
    RaySamples samples;
    double surface = 0.0;  ///< place of the surface, in samples behind the first

    TubeRay(const RaySampler& sampler, const TubeCore& tube, const TubeAxis& axis, std::size_t most) {
        const VolumeGeometry& geometry = sampler.volume().geometry();
        const double unit = geometry.unit();
        const Vec3 first = geometry.gridMmFromVoxel(tube.firstSampleVoxel);
        const auto span = spanInBox(geometry, first, axis.directionMm);
        if (!span) return;
        const auto count = static_cast<std::size_t>(std::max(0.0, std::floor(span->to / unit))) + 1;
        samples = sampler.along(tube.firstSampleVoxel, geometry.voxelFromGridMm(axis.directionMm * unit),
                                std::min(count, most));
        surface = axis.directionMm.dot(geometry.gridMmFromVoxel(*tube.surfaceVoxel) - first) / unit;
    }

    [[nodiscard]] TubeLight lightOf(const OpacityTable& table) const {
        double ofSurface = 0.0, all = 0.0;
        compositeAlong(samples, table, 0.0, [&](std::size_t i, double contribution) {
            all += contribution;
            if (std::abs(static_cast<double>(i) - surface) <= unitsOfSurface) ofSurface += contribution;
        });
        return {all > 0 ? ofSurface / all : 0.0, all};
    }
};

/// The light of every stride-th value from `first` on.
SurfaceLight surfaceLightOf(const std::vector<TubeLight>& lights, std::size_t first, std::size_t stride) {
    std::vector<double> shares, intensities;
    for (std::size_t i = first; i < lights.size(); i += stride) {
        shares.push_back(lights[i].share);
        intensities.push_back(lights[i].intensity);
    }
    SurfaceLight light;
    light.rays = static_cast<int>(shares.size());
    if (shares.empty()) return light;
    light.meanShare = std::accumulate(shares.begin(), shares.end(), 0.0) / light.rays;
    light.meanIntensity = std::accumulate(intensities.begin(), intensities.end(), 0.0) / light.rays;
    return light;
}

/// How many samples of each tube core a view's box and front leave; no limit if tube cores end with the volume only.
std::vector<std::size_t> samplesShown(const VolumeGeometry& geometry, const AdaptiveOtf& otf,
                                      std::span<const TubeAxis> axes) {
    std::vector<std::size_t> shown(axes.size(), std::numeric_limits<std::size_t>::max());
    if (!otf.view.box && !otf.view.cutSurface && !hasObliqueFront(otf.view)) return shown;
    const auto samples = samplesOf(axes, geometry, otf.view, configUsed(otf).cells.size);
    for (std::size_t t = 0; t < shown.size(); ++t) shown[t] = static_cast<std::size_t>(samples[t].slabs);
    return shown;
}

}  // namespace

std::vector<SurfaceLight> surfaceLights(const Volume& volume, const AdaptiveOtf& otf,
                                        std::span<const Classification> classifications) {
    const std::vector<OpacityTable> tables = tablesOf(classifications);
    return surfaceLights(RaySampler(volume, anyTwoDimensional(tables)), otf, tables);
}

std::vector<SurfaceLight> surfaceLights(const RaySampler& sampler, const AdaptiveOtf& otf,
                                        std::span<const OpacityTable> tables) {
    const VolumeGeometry& geometry = sampler.volume().geometry();
    std::vector<std::size_t> used;
    for (std::size_t t = 0; t < otf.tubes.size(); ++t)
        if (otf.tubes[t].surfaceVoxel && otf.tubes[t].d > 0) used.push_back(t);
    if (used.empty()) return std::vector<SurfaceLight>(tables.size());
    const auto axes = tubeAxes(geometry, otf.view, otf.config.grid, configUsed(otf).cells.size);
    const auto shown = samplesShown(geometry, otf, axes);
    std::vector<TubeLight> lights(used.size() * tables.size());
    parallelFor(std::size_t{0}, used.size(), [&](std::size_t i) {
        const TubeRay ray(sampler, otf.tubes[used[i]], axes[used[i]], shown[used[i]]);
        for (std::size_t c = 0; c < tables.size(); ++c) lights[i * tables.size() + c] = ray.lightOf(tables[c]);
    });
    std::vector<SurfaceLight> all;
    for (std::size_t c = 0; c < tables.size(); ++c) all.push_back(surfaceLightOf(lights, c, tables.size()));
    return all;
}

SurfaceLight surfaceLight(const Volume& volume, const AdaptiveOtf& otf, const Classification& classification) {
    return surfaceLights(volume, otf, std::span(&classification, 1)).front();
}

}  // namespace echolucent
