#include "processing/explanation/tube_explanation.h"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>

#include "processing/adaptive/adapted_curve.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/halved_lengths.h"
#include "processing/adaptive/read_tube_cores.h"
#include "processing/choice_names.h"
#include "processing/detection/choose_detection.h"
#include "processing/detection/detection_by_ratio.h"
#include "processing/intensity/no_data.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/stage_runner.h"
#include "processing/tube_core/surface_reading.h"
#include "processing/tube_core/tube_weights.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<5> stateNames{"weighs", "no weight", "no surface", "outside", "never placed"};

void requireHeld(const AdaptiveOtf& otf, int number) {
    if (number < 0 || static_cast<std::size_t>(number) >= otf.tubes.size())
        throw std::invalid_argument("explainTube: the grid does not hold this tube core");
}

/// The voxels in which the run's tube cores were read.
Volume readVolume(const Volume& volume, const AdaptiveOtf& otf) {
    return otf.surfacesWhereDataBegin ? volume.withDataMask(dataMaskWithoutGuess(volume)) : volume;
}

/// The voxels for which the run's curve is meant, with the mask of those read; nothing if they are those read.
std::optional<Volume> shownVolume(const Volume& read, const QuietVoxels& shown, const AdaptiveOtf& otf) {
    if (otf.reduction == SpeckleReduction::off || shown.volume == nullptr) return std::nullopt;
    return shown.volume->withDataMask(read.dataMask());
}

/// Samples slab by slab; NaN without data.
std::vector<double> meansAlong(const Volume& volume, Interpolation sampling, const TubeSamples& samples) {
    std::vector<SlabMoments> moments;
    std::vector<double> values;
    sampleSlabs(volume, sampling, samples, moments, values);
    std::vector<double> means(moments.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < moments.size(); ++k)
        if (moments[k].count > 0) means[k] = moments[k].mean;
    return means;
}

AxisIntensities axisOf(const Volume& read, const std::optional<Volume>& shown, const CellRule& rule,
                       const TubeSamples& samples) {
    TubeSamples axis = samples;
    axis.cellSize = 1;
    axis.onVoxels = false;
    AxisIntensities along{meansAlong(read, Interpolation::trilinear, axis), {}, {}};
    if (shown) along.shown = meansAlong(*shown, Interpolation::trilinear, axis);
    along.slabMeans = meansAlong(read, rule.sampling, samples);
    return along;
}

/// The cell of the largest mean; of complete cells alone if asked for. -1 if there is none.
int largestCell(const CellStatistics& cells, const IndexRange& range, bool completeAlone) {
    int largest = -1;
    for (int i = range.first; i <= range.last; ++i) {
        const auto cell = static_cast<std::size_t>(i);
        if (completeAlone && cells.complete[cell] == 0) continue;
        if (largest < 0 || cells.means[cell] > cells.means[static_cast<std::size_t>(largest)]) largest = i;
    }
    return largest;
}

CellsRead cellsReadOf(const CellStatistics& cells, const TubeCore& tube, const AdaptiveOtfConfig& config) {
    CellsRead read;
    read.tube = {cells.firstCell, cells.lastCell};
    if (tube.status != TubeStatus::surface) return read;
    const SurfaceCells of = surfaceCells(read.tube, tube.surfaceCell, config.surface, config.cells.size);
    read.prior = of.prior;
    read.low = of.near.value_or(of.prior);
    read.high = of.high;
    read.slope = of.slope;
    read.lowMaxCell = largestCell(cells, of.prior, true);
    read.highCell = largestCell(cells, of.high, false);
    return read;
}

/// Reads the tube core's row again, because a run keeps neither exact cells nor scales. If the ratio gave no surface,
/// reads all rows: only together they have the thresholds that tell whether one was found and could not be read.
void explainReading(const Volume& volume, std::span<const TubeSamples> all, const Progress& progress,
                    TubeExplanation& explained) {
    const AdaptiveOtfConfig& config = explained.config;
    const auto* ratio = std::get_if<RatioRule>(&config.detection);
    const bool together = ratio != nullptr && explained.state == TubeState::noSurface;
    const auto columns = static_cast<std::size_t>(config.grid.columns);
    const auto number = static_cast<std::size_t>(explained.number);
    const std::size_t begin = together ? 0 : number / columns * columns, place = number - begin;
    const auto row = together ? all : all.subspan(begin, columns);
    const Progress silent{{}, progress.cancel};
    StageTimes times;
    StageRunner run(silent, times);
    const auto detection = detectionOf(config.detection, row, config.cells.size);
    readTubeCores(volume, row, config.grid.columns, config.cells, *detection, run);
    if (progress.cancelled()) return;
    detection->computeInterfaceFunction(run);
    if (progress.cancelled()) return;
    CellStatistics scratch;
    const CellStatistics& cells = detection->cellsOf(place, scratch);
    explained.cells = cellsReadOf(cells, explained.tube, config);
    explained.scales = detection->traceOf(cells);
    if (ratio == nullptr) return;
    explained.contrastCells = contrastCellsOf(cells, *ratio, config.cells.size);
    std::vector<int> tracked;
    if (!together) return;
    if (const auto surface = detection->surfaceOf(place, cells, tracked)) explained.unreadSurface = surface->cell;
}

template <typename ValueOf>
WeightRank rankOf(const AdaptiveOtf& otf, std::size_t number, const ValueOf& valueOf, bool positiveAlone) {
    WeightRank rank;
    rank.total = otf.tubesMeetingVolume;
    std::vector<double> counted;
    std::optional<std::size_t> own;
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) {
        if (otf.tubes[t].status != TubeStatus::surface) continue;
        const double value = *valueOf(otf.tubes[t]);
        rank.values.push_back(value);
        if (t == number) rank.value = value;
        if (positiveAlone && !(value > 0.0)) continue;
        if (t == number) own = counted.size();
        counted.push_back(value);
    }
    if (own) rank.rank = inclusiveRanks(std::move(counted), otf.config.weights.rankBins)[*own];
    std::ranges::sort(rank.values);
    return rank;
}

ExplainedCurve curveOf(const AdaptiveOtf& otf) { return {otf.curve, otf.tubesWithWeight, otf.trust, otf.message}; }

ExplainedCurve aloneOf(const Volume& voxels, const AdaptiveOtf& otf, std::size_t number, const TubeSamples& samples) {
    TubeCore tube = curveTubeOf(otf, number);
    if (otf.surfacesWhereDataBegin) tube.d = 0.0;
    tube.surfaceCell = otf.tubes[number].surfaceCell;
    const std::span<const TubeCore> one(&tube, 1);
    const CurveRule rule = curveRuleOf(otf);
    std::optional<FoundRamp> wall;
    if (asksForEveryWall(rule))
        wall = rampForEveryWall(axisProfiles(voxels, {&samples, 1}, one, configUsed(otf).cells), one);
    AdaptedCurve adapted = adaptedCurve(rule, otf.config.initial, one, AdaptiveOtf::sampleCount, wall);
    return {std::move(adapted.curve), tubesWithWeight(one), adapted.trust, {}};
}

}  // namespace

std::string_view nameOf(TubeState state) { return nameIn(stateNames, state); }

AdaptiveOtfConfig configWithout(AdaptiveOtfConfig config, int number) {
    std::vector<int>& without = config.grid.withoutTubes;
    const auto place = std::ranges::lower_bound(without, number);
    if (place == without.end() || *place != number) without.insert(place, number);
    return config;
}

TubeState stateOf(const AdaptiveOtf& otf, int number) {
    requireHeld(otf, number);
    const auto place = static_cast<std::size_t>(number);
    if (isNeverPlaced(otf.config.grid, place)) return TubeState::neverPlaced;
    switch (otf.tubes[place].status) {
        case TubeStatus::surface: return otf.tubes[place].d > 0.0 ? TubeState::weighs : TubeState::weighsNothing;
        case TubeStatus::none: return TubeState::noSurface;
        case TubeStatus::outside: break;
    }
    return TubeState::outside;
}

std::optional<TubeExplanation> explainTube(const Volume& volume, const QuietVoxels& shown, const AdaptiveOtf& otf,
                                           int number, const Progress& progress) {
    requireHeld(otf, number);
    if (shown.volume != nullptr && shown.volume->geometry().size != volume.geometry().size)
        throw std::invalid_argument("explainTube: the shown voxels have another grid");
    const auto place = static_cast<std::size_t>(number);
    TubeExplanation explained;
    explained.number = number;
    explained.config = configUsed(otf);
    explained.state = stateOf(otf, number);
    explained.tube = otf.tubes[place];
    if (!otf.quiet.empty()) explained.quiet = otf.quiet[place];
    explained.lengthsHalved = otf.lengthsHalved;
    explained.surfacesWhereDataBegin = otf.surfacesWhereDataBegin;
    explained.reduction = otf.reduction;
    explained.tubesMeetingVolume = otf.tubesMeetingVolume;
    explained.dMax = otf.dMax;
    explained.sumOfD = sumOfD(otf);
    explained.leastContrast = otf.leastContrast;
    explained.fluidIntensity = otf.fluidIntensity;

    const AdaptiveOtfConfig& config = explained.config;
    const Volume read = readVolume(volume, otf);
    const std::optional<Volume> quiet = shownVolume(read, shown, otf);
    const auto axes = tubeAxes(volume.geometry(), otf.view, config.grid, config.cells.size);
    const auto samples = samplesOf(axes, volume.geometry(), otf.view, config.cells.size);
    explained.axis = axisOf(read, quiet, config.cells, samples[place]);
    explainReading(read, samples, progress, explained);

    explained.intensityRank = rankOf(
        otf, place, [](const TubeCore& tube) { return tube.lowIntensityMax; }, false);
    explained.intensityRank.weight = explained.tube.intensityWeight;
    explained.slopeRank = rankOf(
        otf, place, [](const TubeCore& tube) { return tube.slope; }, true);
    explained.slopeRank.weight = explained.tube.slopeWeight;
    if (explained.state == TubeState::weighs && !otf.surfacesWhereDataBegin) {
        const CurveRule rule = curveRuleOf(otf);
        const TubeCore tube = curveTubeOf(otf, place);
        explained.factor = factorOf(tube, number, rule);
        if (const auto* ramp = std::get_if<RampRule>(&rule)) explained.ramp = rampEnds(tube, *ramp);
    }

    explained.initial = sampledOpacities(config.initial, AdaptiveOtf::sampleCount);
    explained.full = curveOf(otf);
    explained.alone = aloneOf(quiet ? *quiet : read, otf, place, samples[place]);
    explained.without = explained.full;
    if (explained.state != TubeState::neverPlaced) {
        const auto without = adaptOpacity(volume, otf.view, configWithout(otf.config, number), progress, shown);
        if (!without) return std::nullopt;
        explained.without = curveOf(*without);
    }
    if (progress.cancelled()) return std::nullopt;
    return explained;
}

}  // namespace echolucent
