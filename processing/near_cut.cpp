#include "processing/near_cut.h"

#include <algorithm>
#include <vector>

namespace echolucent {

namespace {

/// The stretch of fluid in front of one tube's surface, mm behind the volume's foremost point along the view.
struct FluidStretch {
    double begin = 0.0, end = 0.0;
    bool fromTheStart = false;  ///< nothing but fluid lies before the surface
};

/// The cell in which the fluid before the surface begins: as far to the front as the cells' means stay below the level.
int firstFluidCell(const TubeCore& tube, int cellSize, double fluidIntensity) {
    int cell = std::max(tube.firstCell, tube.surfaceCell - cellSize);
    while (cell > tube.firstCell && tube.cellMeans[static_cast<std::size_t>(cell - 1)] < fluidIntensity) --cell;
    return cell;
}

std::vector<FluidStretch> fluidStretches(const AdaptiveOtf& otf, const VolumeGeometry& geometry) {
    const ViewFrame frame = frameOf(otf.view);
    const double unit = geometry.unit(), front = nearPlaneDepthMm(otf.view, geometry);
    std::vector<FluidStretch> stretches;
    for (const TubeCore& tube : otf.tubes) {
        if (!(tube.d > 0.0)) continue;
        const double fluid = otf.fluidIntensity.value_or((*tube.lowIntensity + *tube.highIntensity) / 2.0);
        const int cell = firstFluidCell(tube, otf.config.cellSize, fluid);
        const double first = frame.forward.dot(geometry.gridMmFromVoxel(tube.firstSampleVoxel)) - front;
        stretches.push_back({first + cell * unit, first + tube.surfaceCell * unit, cell == tube.firstCell});
    }
    return stretches;
}

int inFluid(const std::vector<FluidStretch>& stretches, double depth) {
    return static_cast<int>(std::count_if(stretches.begin(), stretches.end(), [depth](const FluidStretch& stretch) {
        return (stretch.fromTheStart || stretch.begin <= depth) && depth < stretch.end;
    }));
}

/// The least depth at which nearly as many tubes are in fluid as at the best one.
double bestCut(const std::vector<FluidStretch>& stretches) {
    std::vector<double> depths{0.0};
    for (const FluidStretch& stretch : stretches)
        if (!stretch.fromTheStart) depths.push_back(stretch.begin);
    std::sort(depths.begin(), depths.end());
    int most = 0;
    for (const double depth : depths) most = std::max(most, inFluid(stretches, depth));
    // A few tubes that enter through a wall at the side are not worth what a cut takes from the others.
    constexpr double enoughUncut = 0.8;
    if (inFluid(stretches, 0.0) >= enoughUncut * most) return 0.0;
    // The last few tubes would push the cut deep into the others' fluid.
    constexpr double nearlyAll = 0.95;
    for (const double depth : depths)
        if (inFluid(stretches, depth) >= nearlyAll * most) return depth;
    return 0.0;
}

}  // namespace

std::optional<NearCutSuggestion> suggestNearCut(const Volume& volume, const View& view, const AdaptiveOtfConfig& config,
                                                const Progress& progress) {
    View uncut = view;
    uncut.nearCutMm = 0.0;
    const auto otf = adaptOpacity(volume, uncut, config, progress);
    if (!otf) return std::nullopt;
    NearCutSuggestion suggestion;
    suggestion.tubesWithSurface = otf->tubesWithSurface;
    if (otf->tubesWithSurface == 0) {
        suggestion.message = "No surface behind fluid was found, so no near cut can be suggested.";
        return suggestion;
    }
    const auto stretches = fluidStretches(*otf, volume.geometry());
    suggestion.nearCutMm = bestCut(stretches);
    // Where a cell of fluid begins the wall's ramp is not over yet: at its middle it is.
    if (suggestion.nearCutMm > 0.0) suggestion.nearCutMm += (config.cellSize - 1) / 2.0 * volume.geometry().unit();
    suggestion.tubesInFluid = inFluid(stretches, suggestion.nearCutMm);
    if (suggestion.nearCutMm == 0.0)
        suggestion.message = "Nothing stands in front of the fluid: no near cut is needed.";
    return suggestion;
}

}  // namespace echolucent
