#include "processing/comparison/classification_measures.h"

#include "processing/adaptive/halved_lengths.h"
#include "processing/comparison/line_samples.h"
#include "processing/tube_core/slabs/tube_grid.h"

namespace echolucent {

std::vector<SurfaceRay> tubeCoreRays(const VolumeGeometry& geometry, const AdaptiveOtf& otf) {
    const auto axes = tubeAxes(geometry, otf.view, otf.config.grid, configUsed(otf).cells.size);
    std::vector<SurfaceRay> rays;
    for (std::size_t t = 0; t < otf.tubes.size() && t < axes.size(); ++t) {
        const TubeCore& tube = otf.tubes[t];
        if (!tube.surfaceVoxel || !(tube.d > 0.0) || !axes[t].entryVoxel) continue;
        const auto depthOf = [&](const Vec3& voxel) {
            return axes[t].directionMm.dot(geometry.gridMmFromVoxel(voxel));
        };
        const double entry = depthOf(*axes[t].entryVoxel);
        rays.push_back(
            {axes[t].pointMm, depthOf(*tube.surfaceVoxel), entry, entry + *axes[t].lengthUnits * geometry.unit()});
    }
    return rays;
}

std::optional<std::vector<ClassificationMeasures>> measuresOf(const Volume& shown, const AdaptiveOtf& otf,
                                                              std::span<const Classification> classifications,
                                                              const Progress& progress) {
    std::vector<ClassificationMeasures> measures(classifications.size());
    const auto rays = tubeCoreRays(shown.geometry(), otf);
    if (rays.empty() || classifications.empty()) return progress.cancelled() ? std::nullopt : std::optional(measures);
    const std::vector<OpacityTable> tables = tablesOf(classifications);
    const RaySampler sampler(shown, anyTwoDimensional(tables));
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0 / 3.0);
    const auto contrasts = surfaceContrasts(sampler, rays, otf.view, tables);
    if (progress.cancelled()) return std::nullopt;
    progress.at(2.0 / 3.0);
    const auto lights = surfaceLights(sampler, otf, tables);
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    for (std::size_t c = 0; c < measures.size(); ++c) measures[c] = {contrasts[c], lights[c]};
    return measures;
}

}  // namespace echolucent
