#include "processing/near_cut.h"

#include <algorithm>
#include <span>
#include <vector>

#include "processing/tube_core/rules/ratio_rule.h"

namespace echolucent {

namespace {

/// A stretch of fluid along one tube core, mm behind the volume's foremost point along the view.
struct FluidStretch {
    double begin = 0.0, end = 0.0;
};

/// The stretches of at least leastFluid cells whose means stay below the level, with a surface behind them. One that
/// begins where its tube does begins at the very front: nothing stands before it.
void addStretches(const TubeCore& tube, const RatioRule& rule, double fluidIntensity, double leastContrast,
                  double firstMm, double unit, std::vector<FluidStretch>& stretches) {
    const int last = static_cast<int>(tube.cellMeans.size()) - 1;
    const auto isFluid = [&](int cell) { return tube.cellMeans[static_cast<std::size_t>(cell)] < fluidIntensity; };
    for (int cell = tube.firstCell; cell <= last; ++cell) {
        if (!isFluid(cell)) continue;
        const int begin = cell;
        while (cell <= last && isFluid(cell)) ++cell;
        if (cell > last || cell - begin < rule.leastFluid) continue;
        const auto nearby = std::span(tube.interfaceFunction)
                                .subspan(static_cast<std::size_t>(std::max(begin, cell - rule.slabsBehind)))
                                .first(static_cast<std::size_t>(std::min(last, cell + rule.slabsBehind) -
                                                                std::max(begin, cell - rule.slabsBehind) + 1));
        if (*std::max_element(nearby.begin(), nearby.end()) < leastContrast) continue;
        stretches.push_back({begin == tube.firstCell ? 0.0 : firstMm + begin * unit, firstMm + cell * unit});
    }
}

std::vector<FluidStretch> fluidStretches(const AdaptiveOtf& otf, const VolumeGeometry& geometry) {
    const ViewFrame frame = frameOf(otf.view);
    const double front = nearPlaneDepthMm(otf.view, geometry);
    // Lengths are the ratio rule's, also where surfaces were detected by variance.
    const auto* chosen = std::get_if<RatioRule>(&otf.config.detection);
    const RatioRule rule = chosen != nullptr ? *chosen : RatioRule{};
    std::vector<FluidStretch> stretches;
    for (const TubeCore& tube : otf.tubes) {
        if (!(tube.d > 0.0)) continue;
        const double fluid = otf.fluidIntensity.value_or((*tube.lowIntensity + *tube.highIntensity) / 2.0);
        const double first = frame.forward.dot(geometry.gridMmFromVoxel(tube.firstSampleVoxel)) - front;
        addStretches(tube, rule, fluid, otf.leastContrast.value_or(0.0), first, geometry.unit(), stretches);
    }
    return stretches;
}

int inFluid(const std::vector<FluidStretch>& stretches, double depth) {
    return static_cast<int>(std::count_if(stretches.begin(), stretches.end(), [depth](const FluidStretch& stretch) {
        return stretch.begin <= depth && depth < stretch.end;
    }));
}

/// The least depth at which nearly as many tubes are in fluid as anywhere, weighed by how much of the volume is left
/// behind it: a cut through the last chamber shows little. 0 where the front does nearly as well.
double bestCut(const std::vector<FluidStretch>& stretches, double volumeDepth) {
    const auto worth = [&](double depth) { return inFluid(stretches, depth) * (1.0 - depth / volumeDepth); };
    std::vector<double> depths;
    double most = 0.0;
    for (const FluidStretch& stretch : stretches) {
        depths.push_back(stretch.begin);
        most = std::max(most, worth(stretch.begin));
    }
    constexpr double goodEnough = 0.8;  // of the best: then nothing is cut
    if (worth(0.0) >= goodEnough * most) return 0.0;
    std::sort(depths.begin(), depths.end());
    // The last few tubes would push the cut deep into the others' fluid.
    constexpr double nearlyAll = 0.95;
    return *std::find_if(depths.begin(), depths.end(), [&](double depth) { return worth(depth) >= nearlyAll * most; });
}

}  // namespace

std::optional<NearCutSuggestion> suggestNearCut(const Volume& volume, const Viewpoint& view,
                                                const AdaptiveOtfConfig& config, const Progress& progress) {
    Viewpoint uncut = view;
    uncut.nearCutMm = 0.0;
    const auto otf = adaptOpacity(volume, uncut, config, progress);
    if (!otf) return std::nullopt;
    const auto without = [&](const char* why) { return NearCutSuggestion{0.0, otf->tubesWithWeight, 0, why}; };
    if (otf->tubesWithWeight == 0 || otf->surfacesWhereDataBegin)
        return without("No surface behind fluid was found that counts, so no near cut can be suggested.");
    const auto stretches = fluidStretches(*otf, volume.geometry());
    if (stretches.empty()) return without("No stretch of fluid is long enough to suggest a near cut.");
    NearCutSuggestion suggestion{.tubesWithWeight = otf->tubesWithWeight, .message = {}};
    suggestion.nearCutMm = bestCut(stretches, depthAlongViewMm(uncut, volume.geometry()));
    // Where a cell of fluid begins the wall's ramp is not over yet: at its middle it is.
    if (suggestion.nearCutMm > 0.0) suggestion.nearCutMm += (config.cells.size - 1) / 2.0 * volume.geometry().unit();
    suggestion.tubesInFluid = inFluid(stretches, suggestion.nearCutMm);
    return suggestion;
}

}  // namespace echolucent
