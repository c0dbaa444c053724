#include "processing/comparison/plain_frames.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "processing/comparison/line_samples.h"
#include "processing/parallel.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/tube_core/slabs/tube_samples.h"

namespace echolucent {

namespace {

/// The samplers of the phases; each is made when a frame first needs it.
class Samplers {
public:
    explicit Samplers(std::span<const std::shared_ptr<const Volume>> phases) : m_phases(phases.begin(), phases.end()) {}
    const RaySampler& of(int phase, bool withGradients) {
        std::unique_ptr<RaySampler>& sampler = m_samplers[{phase, withGradients}];
        if (!sampler)
            sampler = std::make_unique<RaySampler>(*m_phases.at(static_cast<std::size_t>(phase)), withGradients);
        return *sampler;
    }

private:
    std::vector<std::shared_ptr<const Volume>> m_phases;
    std::map<std::pair<int, bool>, std::unique_ptr<RaySampler>> m_samplers;
};

/// Each ray is a tube core one sample wide, because the grid of tube cores knows what a view shows.
TubeGrid raysOver(const VolumeGeometry& geometry, const Viewpoint& view, double raySpacing) {
    const OrientedBox box = view.box.value_or(orientedBoxOf(DataBox(geometry)));
    const ViewFrame frame = frameOf(view);
    const auto count = [&](const Vec3& across) {
        constexpr double rounding = 1e-6;
        return std::max(
            1, static_cast<int>(std::ceil(box.extentAlong(across) / (raySpacing * geometry.unit()) - rounding)));
    };
    return {.columns = count(frame.right), .rows = count(frame.down), .spacing = raySpacing};
}

std::optional<Picture> render(const RaySampler& sampler, const Viewpoint& view, const OpacityTable& table,
                              double raySpacing, const Progress& progress) {
    const VolumeGeometry& geometry = sampler.volume().geometry();
    const TubeGrid grid = raysOver(geometry, view, raySpacing);
    const auto rays = samplesOf(tubeAxes(geometry, view, grid, 1), geometry, view, 1);
    Picture picture = emptyPicture(grid.columns, grid.rows);
    parallelFor(std::size_t{0}, rays.size(), [&](std::size_t r) {
        if (rays[r].slabs <= 0 || progress.cancelled()) return;
        const RaySamples samples = sampler.along(rays[r].first, rays[r].along, static_cast<std::size_t>(rays[r].slabs));
        double light = 0.0;
        const double left = compositeAlong(samples, table, 0.0, [&](std::size_t, double own) { light += own; });
        float* const pixel = picture.rgba.data() + 4 * r;
        std::fill(pixel, pixel + 3, static_cast<float>(light));
        pixel[3] = static_cast<float>(1.0 - left);
    });
    if (progress.cancelled()) return std::nullopt;
    return picture;
}

}  // namespace

ClassificationRenderer plainFrameRenderer(std::span<const std::shared_ptr<const Volume>> phases, double raySpacing,
                                          const Progress& progress) {
    if (!(std::isfinite(raySpacing) && raySpacing > 0.0))
        throw std::invalid_argument("plainFrameRenderer: the ray spacing must be above 0");
    return [samplers = std::make_shared<Samplers>(phases), raySpacing, progress](const SweepFrame& frame,
                                                                                 const Classification& classification) {
        const OpacityTable table(classification);
        return render(samplers->of(frame.phase, table.isTwoDimensional()), frame.view, table, raySpacing, progress);
    };
}

}  // namespace echolucent
