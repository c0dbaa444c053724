#include "processing/adaptive/quiet_reading.h"

#include <algorithm>

#include "processing/adaptive/read_tube_cores.h"
#include "processing/detection/choose_detection.h"
#include "processing/tube_core/stage_runner.h"
#include "processing/tube_core/surface_reading.h"

namespace echolucent {

namespace {

/// How far the ends of a ramp move if no speckle is left, as shares of the way from I_L to I_H. Chosen on phantoms and
/// checked on real volumes (docs/speckle.md).
constexpr double beginRises = 0.16;
constexpr double endFalls = 0.5;

/// A tube core read in the quiet voxels; unchanged if it has no weight or the quiet voxels show no rise.
TubeCore readAnew(const TubeCore& found, const CellStatistics& cells, const AdaptiveOtfConfig& config,
                  const Detection& detection) {
    TubeCore quiet = found;
    if (found.status != TubeStatus::surface || !(found.d > 0.0)) return quiet;
    if (!readSurface(cells, found.surfaceCell, config.surface, config.cells.size, quiet)) return found;
    if (!(*quiet.highIntensity > *quiet.lowIntensity)) return found;
    if (const auto spread = detection.spreadAt(*quiet.lowIntensity))
        quiet.fluidSpread = std::min(*spread, found.fluidSpread.value_or(*spread));
    return quiet;
}

std::optional<double> speckleLeft(std::span<const TubeCore> found, std::span<const TubeCore> quiet) {
    double before = 0.0, after = 0.0;
    for (std::size_t t = 0; t < found.size(); ++t) {
        if (!(found[t].d > 0.0) || !found[t].fluidSpread || !quiet[t].fluidSpread) continue;
        before += found[t].d * *found[t].fluidSpread;
        after += found[t].d * *quiet[t].fluidSpread;
    }
    if (!(before > 0.0)) return std::nullopt;
    return std::min(1.0, after / before);
}

}  // namespace

CurveRule quieterRule(const CurveRule& rule, double speckleLeft) {
    const auto* ramp = std::get_if<RampRule>(&rule);
    if (ramp == nullptr) return rule;
    RampRule quieter = *ramp;
    const double gone = 1.0 - speckleLeft;
    quieter.begin += beginRises * gone;
    quieter.end = std::max(quieter.begin, quieter.end - endFalls * gone);
    return quieter;
}

std::optional<QuietReading> readQuiet(const Volume& quiet, const AdaptiveOtfConfig& config,
                                      std::span<const TubeSamples> samples, std::span<const TubeCore> tubes,
                                      const Progress& progress) {
    // This reading is too short a part of its stage to report progress.
    const Progress silent{{}, progress.cancel};
    StageTimes times;
    StageRunner run(silent, times);
    const auto detection = detectionOf(config.detection, samples, config.cells.size);
    readTubeCores(quiet, samples, config.grid.columns, config.cells, *detection, run);
    if (progress.cancelled()) return std::nullopt;
    detection->computeInterfaceFunction(run);
    QuietReading reading{{tubes.begin(), tubes.end()}, config.curve, {}};
    run.forEach(
        tubes.size(), [] { return CellStatistics(); },
        [&](std::size_t t, CellStatistics& scratch) {
            reading.tubes[t] = readAnew(tubes[t], detection->cellsOf(t, scratch), config, *detection);
        });
    if (progress.cancelled()) return std::nullopt;
    reading.speckleLeft = speckleLeft(tubes, reading.tubes);
    reading.curve = quieterRule(config.curve, reading.speckleLeft.value_or(1.0));
    return reading;
}

}  // namespace echolucent
