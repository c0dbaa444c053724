#include "app/measuring/measures/surface_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/measuring/measures/line_samples.h"
#include "app/measuring/measures/median.h"
#include "processing/parallel.h"
#include "processing/tube_core/tube_grid.h"

namespace echolucent {

namespace {

constexpr double unitsOfSurface = 3.0;

struct TubeLight {
    double share = 0.0, intensity = 0.0;
};

/// The light of the ray along a tube core's axis, from the tube's first sample on.
TubeLight lightAlong(const Volume& volume, const TubeCore& tube, const TubeAxis& axis, const OpacityTable& table) {
    const VolumeGeometry& geometry = volume.geometry();
    const double unit = geometry.unit();
    const Vec3 first = geometry.gridMmFromVoxel(tube.firstSampleVoxel);
    const auto span = spanInBox(geometry, first, axis.directionMm);
    if (!span) return {};
    std::vector<double> intensities(static_cast<std::size_t>(std::max(0.0, std::floor(span->to / unit))) + 1);
    sampleLine(volume, tube.firstSampleVoxel, geometry.voxelFromGridMm(axis.directionMm * unit), intensities);
    const double surface = axis.directionMm.dot(geometry.gridMmFromVoxel(*tube.surfaceVoxel) - first) / unit;
    double transmittance = 1.0, ofSurface = 0.0, all = 0.0;
    for (std::size_t i = 0; i < intensities.size(); ++i) {
        if (std::isnan(intensities[i])) continue;
        const double opacity = table.at(intensities[i]);
        const double light = transmittance * opacity * intensities[i];
        all += light;
        if (std::abs(static_cast<double>(i) - surface) <= unitsOfSurface) ofSurface += light;
        transmittance *= 1.0 - opacity;
    }
    return {all > 0 ? ofSurface / all : 0.0, all};
}

}  // namespace

SurfaceLight surfaceLight(const Volume& volume, const AdaptiveOtf& otf, const OpacityCurve& curve) {
    const auto axes = tubeAxes(volume.geometry(), otf.view, otf.config.grid, otf.config.cells.size);
    std::vector<std::size_t> used;
    for (std::size_t t = 0; t < otf.tubes.size(); ++t)
        if (otf.tubes[t].surfaceVoxel && otf.tubes[t].d > 0) used.push_back(t);
    SurfaceLight light;
    light.rays = static_cast<int>(used.size());
    if (used.empty()) return light;
    const OpacityTable table(curve);
    std::vector<double> shares(used.size()), intensities(used.size());
    parallelFor(std::size_t{0}, used.size(), [&](std::size_t i) {
        const TubeLight own = lightAlong(volume, otf.tubes[used[i]], axes[used[i]], table);
        shares[i] = own.share;
        intensities[i] = own.intensity;
    });
    light.meanShare = std::accumulate(shares.begin(), shares.end(), 0.0) / light.rays;
    light.meanIntensity = std::accumulate(intensities.begin(), intensities.end(), 0.0) / light.rays;
    light.medianShare = medianOf(shares);
    return light;
}

}  // namespace echolucent
