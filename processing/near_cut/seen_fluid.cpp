#include "processing/near_cut/seen_fluid.h"

#include <algorithm>
#include <array>
#include <utility>

#include "processing/near_cut/tissue_level.h"
#include "processing/parallel.h"

namespace echolucent {

namespace {

/// Shares of the tissue's intensity below which a sample may be fluid. Blood full of echo needs the highest share. At
/// the lowest share, a chamber is not yet joined with merely dim tissue.
constexpr std::array fluidLevels{0.35, 0.45, 0.55};
constexpr double leastCavityEdge = 6.4;  // samples, a tenth of the data's extent

void countTubes(SeenFluid& seen) {
    seen.front = seen.tubes.samples;
    for (std::size_t tube = 0; tube < seen.tubes.tubes(); ++tube) {
        const float* echo = seen.tubes.tube(tube);
        const float* end = echo + seen.tubes.samples;
        const float* first = std::find_if(echo, end, [](float value) { return value >= 0.0F; });
        if (first == end) continue;
        ++seen.meetData;
        seen.front = std::min(seen.front, static_cast<int>(first - echo));
    }
    seen.beginsInFluid.resize(seen.tubes.tubes());
    std::vector<bool> any(seen.tubes.tubes());
    double samples = 0.0;
    for (const auto& stretches : seen.levels)
        for (const FluidStretch& stretch : stretches) {
            any[static_cast<std::size_t>(stretch.tube)] = true;
            if (!stretch.atFront) continue;
            seen.beginsInFluid[static_cast<std::size_t>(stretch.tube)] = true;
            samples += stretch.length();
            seen.frontContrast += stretch.length() * stretch.contrast;
        }
    if (samples > 0.0) seen.frontContrast /= samples;
    seen.beginInFluid = static_cast<int>(std::count(seen.beginsInFluid.begin(), seen.beginsInFluid.end(), true));
    seen.meetFluid = static_cast<int>(std::count(any.begin(), any.end(), true));
}

}  // namespace

std::optional<SearchedEcho> searchedEchoOf(const Volume& volume, const Progress& progress) {
    auto smooth = SmoothEcho::of(volume, progress);
    if (!smooth) return std::nullopt;
    const auto tissue = tissueLevel(smooth->intensities());
    return SearchedEcho{std::move(*smooth), tissue};
}

SeenFluid seenFluid(const SearchedEcho& echo, const VolumeGeometry& geometry, const Viewpoint& view) {
    SeenFluid seen;
    if (!echo.tissue) return seen;
    seen.tissue = *echo.tissue;
    seen.tubes = readTubeEcho(echo.smooth, geometry, view);
    seen.levels.resize(fluidLevels.size());
    parallelFor(std::size_t{0}, fluidLevels.size(), [&](std::size_t i) {
        seen.levels[i] = fluidStretches(seen.tubes, static_cast<float>(fluidLevels[i] * seen.tissue), leastCavityEdge);
    });
    countTubes(seen);
    return seen;
}

}  // namespace echolucent
