#include "processing/adaptive/adaptive_otf.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "processing/adaptive/adapted_curve.h"
#include "processing/adaptive/halved_lengths.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/read_tube_cores.h"
#include "processing/detection/choose_detection.h"
#include "processing/intensity/no_data.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/stage_runner.h"
#include "processing/tube_core/surface_reading.h"
#include "processing/tube_core/tube_weights.h"

namespace echolucent {

namespace {

void requireOneGrid(const Volume& volume, const QuietVoxels& shown) {
    if (shown.volume != nullptr && shown.volume->geometry().size != volume.geometry().size)
        throw std::invalid_argument("adaptOpacity: the shown voxels have another grid");
}

AdaptiveOtf unrun(const VolumeGeometry& geometry, const Viewpoint& view, const AdaptiveOtfConfig& config) {
    AdaptiveOtf otf;
    otf.config = config;
    otf.view = view;
    otf.tubeSpacingUnits = tubeSpacingUnits(geometry, view, config.grid, config.cells.size);
    otf.directionVoxel = directionInVoxels(view, geometry);
    otf.tubeLengthUnit = geometry.unit();
    return otf;
}

/// A tube core after reading, before the search for its surface.
TubeCore tubeCoreOf(const TubeAxis& axis, const TubeSamples& samples, const CellStatistics& cells) {
    TubeCore tube;
    tube.column = axis.column;
    tube.row = axis.row;
    if (!axis.entryVoxel || !cells.anyData) return tube;
    tube.status = TubeStatus::none;
    tube.entryVoxel = axis.entryVoxel;
    tube.firstSampleVoxel = samples.first;
    tube.firstCell = cells.firstCell;
    tube.cellMeans.assign(cells.means.begin(), cells.means.end());
    return tube;
}

/// The curve that the rule makes of tube cores in the voxels `shown`.
AdaptedCurve curveOf(const CurveRule& rule, const Volume& shown, std::span<const TubeSamples> samples,
                     std::span<const TubeCore> tubes, AdaptiveOtf& otf, const Progress& progress) {
    const AdaptiveOtfConfig& config = otf.config;
    if (asksForEveryWall(rule))
        otf.everyWall = rampForEveryWall(axisProfiles(shown, samples, tubes, config.cells, progress), tubes);
    return adaptedCurve(rule, config.initial, tubes, AdaptiveOtf::sampleCount, otf.everyWall);
}

/// The curve for the shown voxels; empty if the work was cancelled.
std::optional<AdaptedCurve> curveFor(const Volume& volume, const QuietVoxels& shown,
                                     std::span<const TubeSamples> samples, AdaptiveOtf& otf, const Progress& progress) {
    const AdaptiveOtfConfig& config = otf.config;
    if (otf.reduction == SpeckleReduction::off || otf.tubesWithWeight == 0)
        return curveOf(config.curve, volume, samples, otf.tubes, otf, progress);
    // The surfaces were found with the mask of `volume`, and the shown voxels may have another one. So read them with
    // the mask of `volume`.
    const auto& mask = volume.dataMask();
    const Volume masked = shown.volume->dataMask() == mask ? *shown.volume : shown.volume->withDataMask(mask);
    const auto quiet = readQuiet(masked, config, samples, otf.tubes, progress);
    if (!quiet) return std::nullopt;
    otf.speckleLeft = quiet->speckleLeft;
    for (const TubeCore& tube : quiet->tubes)
        otf.quiet.push_back({tube.lowIntensity, tube.highIntensity, tube.fluidSpread});
    return curveOf(quiet->curve, masked, samples, quiet->tubes, otf, progress);
}

/// Why the curve is the initial function, as a sentence; empty if it is not.
std::string messageFor(const AdaptiveOtf& otf) {
    const std::string consequence = ": the initial function is used.";
    if (otf.tubesWithWeight > 0) return {};
    if (otf.config.grid.withoutTubes.size() == otf.tubes.size()) return "No tube core is placed" + consequence;
    if (otf.tubesMeetingVolume == 0) return "No tube core meets the volume's data" + consequence;
    int found = 0, usable = 0;
    for (const TubeCore& tube : otf.tubes) {
        if (tube.status != TubeStatus::surface) continue;
        ++found;
        if (tube.extraWeight > 0.0) ++usable;
    }
    if (found == 0) return "No surface found" + consequence;
    if (usable == 0) return "No surface found that stands out from the speckle" + consequence;
    if (otf.dMax == 0.0) return "The strength is 0" + consequence;
    // Ranks compare tube cores with each other. If each tube core has a surface and all largest prior means are equal
    // (or there is one tube core only), w_I is 0. If no slope is above 0, w_S is 0.
    return "The surfaces found do not differ enough to weigh them (" + std::to_string(usable) + " found)" + consequence;
}

std::optional<AdaptiveOtf> adaptToData(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config,
                                       const Progress& progress, const QuietVoxels& shown) {
    AdaptiveOtf otf = unrun(volume.geometry(), view, config);
    otf.reduction = shown.volume != nullptr ? shown.reduction : SpeckleReduction::off;
    if (otf.reduction != SpeckleReduction::off) otf.speckleLeft.reset();  // until it is measured
    StageRunner run(progress, otf.times);

    // Place the tube cores and read them.
    if (!run.begin(samplingStage)) return std::nullopt;
    const auto axes = tubeAxes(volume.geometry(), view, config.grid, config.cells.size);
    const auto samples = samplesOf(axes, volume.geometry(), view, config.cells.size);
    const auto detection = detectionOf(config.detection, samples, config.cells.size);
    readTubeCores(volume, samples, config.grid.columns, config.cells, *detection, run);

    // The interface indicating function.
    if (!run.begin(interfaceFunctionStage)) return std::nullopt;
    detection->computeInterfaceFunction(run);
    otf.leastContrast = detection->leastContrast();
    otf.fluidIntensity = detection->fluidIntensity();

    // Find the surfaces, and read I_L, I_H and slope around them.
    if (!run.begin(detectionStage)) return std::nullopt;
    otf.tubes.resize(axes.size());
    run.forEach(
        axes.size(), [] { return CellStatistics(); },
        [&](std::size_t t, CellStatistics& scratch) {
            const CellStatistics& cells = detection->cellsOf(t, scratch);
            TubeCore& tube = otf.tubes[t] = tubeCoreOf(axes[t], samples[t], cells);
            if (tube.status == TubeStatus::outside) return;
            tube.interfaceFunction = detection->interfaceFunctionOf(t, cells);
            const auto surface = detection->surfaceOf(t, cells, tube.trackedCells);
            if (!surface || !readSurface(cells, surface->cell, config.surface, config.cells.size, tube)) return;
            tube.status = TubeStatus::surface;
            tube.surfaceVoxel = samples[t].onAxis(surface->cell + (config.cells.size - 1) / 2.0);
            tube.contrast = surface->contrast;
            tube.fluidSpread = detection->spreadAt(*tube.lowIntensity);
        });

    // Weigh the tube cores (eqs. 8 to 11).
    if (!run.begin(weightsStage)) return std::nullopt;
    otf.tubesMeetingVolume = tubesMeetingVolume(otf.tubes);
    if (otf.tubesMeetingVolume > 0) otf.dMax = strengthOf(config.curve) / otf.tubesMeetingVolume;
    weighTubes(otf.tubes, otf.dMax, detection->leastEdgeToNoise(), config.weights);
    otf.tubesWithWeight = tubesWithWeight(otf.tubes);

    // The curve (eqs. 4 to 7, or the mean ramp), for the shown voxels.
    if (!run.begin(curveStage)) return std::nullopt;
    auto adapted = curveFor(volume, shown, samples, otf, progress);
    if (!adapted) return std::nullopt;
    otf.logOpacity = std::move(adapted->logOpacity);
    otf.curve = std::move(adapted->curve);
    otf.trust = adapted->trust;
    otf.message = messageFor(otf);
    if (!run.end()) return std::nullopt;
    return otf;
}

bool findsNoSurface(const AdaptiveOtf& otf) {
    return otf.tubesMeetingVolume > 0 && std::none_of(otf.tubes.begin(), otf.tubes.end(), [](const TubeCore& tube) {
               return tube.status == TubeStatus::surface;
           });
}

}  // namespace

std::optional<AdaptiveOtf> adaptOpacity(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config,
                                        const Progress& progress, const QuietVoxels& shown) {
    requireOneGrid(volume, shown);
    if (const std::string problem = problemOf(config); !problem.empty()) throw std::invalid_argument(problem);
    auto otf = adaptToData(volume, view, config, progress, shown);
    if (!otf || !findsNoSurface(*otf)) return otf;
    Progress silent = progress;  // the first run's progress already stands at the end, and must not fall
    silent.report = nullptr;
    if (const auto halved = halvedLengths(config, volume.geometry())) {
        auto found = adaptToData(volume, view, *halved, silent, shown);
        if (!found) return std::nullopt;
        if (found->tubesWithWeight > 0 && found->tubesWithWeight >= leastShareHalved * found->tubesMeetingVolume) {
            found->config = config;
            found->lengthsHalved = true;
            found->times += otf->times;
            return found;
        }
    }
    if (volume.dataMask().empty()) return otf;
    auto mask = dataMaskWithoutGuess(volume);
    if (mask == volume.dataMask()) return otf;

    AdaptiveOtfConfig surfacesOnly = config;
    surfacesOnly.curve = withoutEveryWall(config.curve);
    auto begun = adaptToData(volume.withDataMask(std::move(mask)), view, surfacesOnly, silent, {});
    if (!begun) return std::nullopt;
    if (begun->tubesWithWeight == 0) return otf;
    begun->config = config;
    begun->surfacesWhereDataBegin = true;
    begun->reduction = otf->reduction;
    begun->speckleLeft = otf->speckleLeft;
    // No fluid of the scan lies before these surfaces, so their intensities make no curve.
    begun->logOpacity = std::move(otf->logOpacity);
    begun->curve = std::move(otf->curve);
    begun->trust = otf->trust;
    begun->everyWall = otf->everyWall;
    begun->fluidIntensity = otf->fluidIntensity;
    begun->message =
        "No surface stands behind fluid: where the data begin is taken for the surface, and the initial function is "
        "used.";
    return begun;
}

}  // namespace echolucent
