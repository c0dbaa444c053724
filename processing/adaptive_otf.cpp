#include "processing/adaptive_otf.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "processing/tube_core/basis_function.h"
#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/ramp.h"
#include "processing/tube_core/ratio_detection.h"
#include "processing/tube_core/scale_space.h"
#include "processing/tube_core/slabs/tube_profiles.h"
#include "processing/tube_core/speckle_scale.h"
#include "processing/tube_core/surface_detection.h"
#include "processing/tube_core/tube_grid.h"
#include "processing/tube_core/tube_quality.h"
#include "processing/tube_core/tube_reader.h"

namespace echolucent {

namespace {

class StopWatch {
public:
    /// Milliseconds since the last lap or the start.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double elapsed = std::chrono::duration<double, std::milli>(now - m_last).count();
        m_last = now;
        return elapsed;
    }

private:
    std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

/// Time the threads spent on one row of tubes.
struct RowTimes {
    double sampling = 0.0, cells = 0.0, detection = 0.0;
};

/// The stages of one row of the grid: samples, cells, surface, in the paper's order. One per row and thread.
class TubeRow {
public:
    TubeRow(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config, const ScaleSpace& scaleSpace)
        : m_config(config), m_smoother(scaleSpace), m_reader(volume, view, config, true) {}

    /// Fills the row's tubes; leaves them half done where cancelled.
    void run(std::span<const TubeAxis> axes, std::span<TubeCore> tubes, const Progress& progress) {
        StopWatch watch;
        m_samples.clear();
        for (const TubeAxis& axis : axes) m_samples.push_back(m_reader.samplesOf(axis));
        m_reader.read(m_samples);
        m_times.sampling += watch.lap();
        for (std::size_t t = 0; t < axes.size(); ++t) {
            if (progress.cancelled()) return;
            m_reader.cells(t, m_cells);
            m_times.cells += watch.lap();
            describe(axes[t], m_samples[t], tubes[t]);
            m_times.detection += watch.lap();
        }
    }

    [[nodiscard]] const RowTimes& times() const { return m_times; }

private:
    void describe(const TubeAxis& axis, const TubeSamples& samples, TubeCore& tube) {
        tube.column = axis.column;
        tube.row = axis.row;
        if (!axis.entryVoxel || !m_cells.anyData) return;
        tube.status = TubeStatus::none;
        tube.entryVoxel = axis.entryVoxel;
        tube.firstSampleVoxel = samples.first;
        tube.firstCell = m_cells.firstCell;
        tube.cellMeans.assign(m_cells.means.begin(), m_cells.means.end());
        tube.interfaceFunction.assign(m_cells.variances.begin(), m_cells.variances.end());
        if (m_cells.lastCell < m_cells.firstCell) return;

        const auto function = std::span<const double>(m_cells.variances)
                                  .subspan(static_cast<std::size_t>(m_cells.firstCell),
                                           static_cast<std::size_t>(m_cells.lastCell - m_cells.firstCell + 1));
        tube.trackedCells = trackSurface(function, m_smoother, trackingRuleOf(m_config), m_scratch);
        if (tube.trackedCells.empty()) return;
        for (int& cell : tube.trackedCells) cell += m_cells.firstCell;
        int surface = tube.trackedCells.back();
        // A cell of too little data repeats the one before it: that one is meant.
        while (surface > m_cells.firstCell && m_cells.complete[static_cast<std::size_t>(surface)] == 0) --surface;
        if (!describeSurface(m_cells, surface, m_config, tube)) return;
        readNeighbourhood(m_cells, m_config, tube);
        tube.status = TubeStatus::surface;
        tube.surfaceVoxel = samples.onAxis(surface + (m_config.cellSize - 1) / 2.0);
    }

    const AdaptiveOtfConfig& m_config;
    ScaleSmoother m_smoother;
    TubeReader m_reader;
    std::vector<TubeSamples> m_samples;
    CellStatistics m_cells;
    DetectionScratch m_scratch;
    RowTimes m_times;
};

/// Samples, cells and detection of all tubes. False where cancelled.
bool analyseTubes(const Volume& volume, AdaptiveOtf& result, const Progress& progress) {
    StopWatch watch;
    const AdaptiveOtfConfig& config = result.config;
    const ScaleSpace scaleSpace(config);
    const std::vector<TubeAxis> axes = tubeAxes(volume.geometry(), result.view, config);
    const auto columns = static_cast<std::size_t>(config.tubeColumns);
    std::vector<RowTimes> rowTimes(static_cast<std::size_t>(config.tubeRows));
    std::atomic<int> rowsDone = 0;
    result.tubes.resize(axes.size());
    tbb::parallel_for(tbb::blocked_range<int>(0, config.tubeRows, 1), [&](const tbb::blocked_range<int>& rows) {
        TubeRow stages(volume, result.view, config, scaleSpace);
        for (int row = rows.begin(); row < rows.end() && !progress.cancelled(); ++row) {
            const auto first = static_cast<std::size_t>(row) * columns;
            stages.run(std::span(axes).subspan(first, columns), std::span(result.tubes).subspan(first, columns),
                       progress);
            progress.at(0.95 * ++rowsDone / config.tubeRows);
        }
        rowTimes[static_cast<std::size_t>(rows.begin())] = stages.times();
    });
    RowTimes spent;
    for (const RowTimes& row : rowTimes) {
        spent.sampling += row.sampling;
        spent.cells += row.cells;
        spent.detection += row.detection;
    }
    const double all = spent.sampling + spent.cells + spent.detection;
    const double wallPerSpent = all > 0.0 ? watch.lap() / all : 0.0;
    result.times.sampling = spent.sampling * wallPerSpent;
    result.times.cells = spent.cells * wallPerSpent;
    result.times.detection = spent.detection * wallPerSpent;
    return !progress.cancelled();
}

/// The contrast at the middle of every cell; 0 where there is none.
std::vector<float> contrastOfCells(std::span<const float> contrasts, std::size_t cells, int firstCell,
                                   const RatioRule& rule, int cellSize) {
    std::vector<float> ofCells(cells, 0.0f);
    // Contrast 0 belongs to the boundary behind the first leastFluid slabs.
    const auto shift = static_cast<std::size_t>(firstCell + std::max(0, rule.leastFluid - cellSize / 2));
    for (std::size_t i = 0; i < contrasts.size() && i + shift < cells; ++i) ofCells[i + shift] = contrasts[i];
    return ofCells;
}

/// Detection by ratio: all tubes are read before one is judged, because they say together how strong speckle is and
/// where fluid ends. False where cancelled.
bool analyseTubesByRatio(const Volume& volume, AdaptiveOtf& result, const Progress& progress) {
    StopWatch watch;
    const AdaptiveOtfConfig& config = result.config;
    const std::vector<TubeAxis> axes = tubeAxes(volume.geometry(), result.view, config);
    std::vector<TubeSamples> samples(axes.size());
    int longest = 0;
    const TubeReader placing(volume, result.view, config, true);
    for (std::size_t t = 0; t < axes.size(); ++t) {
        samples[t] = placing.samplesOf(axes[t]);
        longest = std::max(longest, samples[t].slabs);
    }
    TubeProfiles profiles(axes.size(), longest);
    result.tubes.resize(axes.size());
    const auto columns = static_cast<std::size_t>(config.tubeColumns);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, static_cast<std::size_t>(config.tubeRows)),
                      [&](const tbb::blocked_range<std::size_t>& rows) {
                          TubeReader reader(volume, result.view, config, true);
                          for (std::size_t row = rows.begin(); row < rows.end() && !progress.cancelled(); ++row) {
                              reader.read(std::span(samples).subspan(row * columns, columns));
                              for (std::size_t column = 0; column < columns; ++column)
                                  reader.profile(column, profiles, row * columns + column);
                          }
                      });
    result.times.sampling = watch.lap();
    if (progress.cancelled()) return false;
    const SpeckleScale scale(profiles);
    RatioRule rule;
    rule.falseAlarm = config.falseAlarm;
    const TubeContrasts contrasts(profiles, scale, rule);
    RatioThresholds thresholds = ratioThresholds(contrasts, rule);
    thresholds.step = rule.leastStep * scale.brightMean();
    if (thresholds.anyBoundary && !mayBeFluid(thresholds, scale, rule)) thresholds.anyBoundary = false;
    result.leastContrast = thresholds.contrast;
    if (thresholds.anyBoundary) result.fluidIntensity = scale.intensityAt(thresholds.fluidLevel);
    result.times.cells = watch.lap();
    tbb::enumerable_thread_specific<CellStatistics> scratch;
    tbb::parallel_for(std::size_t{0}, axes.size(), [&](std::size_t t) {
        TubeCore& tube = result.tubes[t];
        tube.column = axes[t].column;
        tube.row = axes[t].row;
        const auto means = profiles.means(t);
        if (!axes[t].entryVoxel || !profiles.anyData(t)) return;
        tube.status = TubeStatus::none;
        tube.entryVoxel = axes[t].entryVoxel;
        if (means.empty()) return;
        tube.firstSampleVoxel = samples[t].first;
        tube.firstCell = profiles.firstSlab(t);
        CellStatistics& cells = scratch.local();
        cellsFrom(means, tube.firstCell, config.cellSize, cells);
        tube.cellMeans.assign(cells.means.begin(), cells.means.end());
        tube.interfaceFunction =
            contrastOfCells(contrasts.contrasts(t), tube.cellMeans.size(), tube.firstCell, rule, config.cellSize);
        const auto surface =
            firstFluidToTissue(means, contrasts.scaled(t), contrasts.contrasts(t), thresholds, rule, config.cellSize);
        if (!surface) return;
        const int cell = surface->cell + tube.firstCell;
        if (!describeSurface(cells, cell, config, tube)) return;
        readNeighbourhood(cells, config, tube);
        tube.fluidSpread = scale.spreadAt(*tube.lowIntensity);
        tube.contrast = surface->contrast;
        tube.status = TubeStatus::surface;
        tube.surfaceVoxel = samples[t].onAxis(cell + (config.cellSize - 1) / 2.0);
    });
    result.times.detection = watch.lap();
    return !progress.cancelled();
}

/// Why the curve is the initial function, as a sentence; empty: it is not.
std::string messageFor(const AdaptiveOtf& result) {
    const std::string consequence = ": the initial function is used.";
    if (result.tubesWithSurface > 0) return {};
    if (result.tubesMeetingVolume == 0) return "No tube core meets the volume's data" + consequence;
    int found = 0, usable = 0;
    for (const TubeCore& tube : result.tubes) {
        if (tube.status != TubeStatus::surface) continue;
        ++found;
        if (tube.extraWeight > 0.0) ++usable;
    }
    if (found == 0) return "No surface found" + consequence;
    if (usable == 0) return "No surface found that stands out from the speckle" + consequence;
    if (result.dMax == 0.0) return "The strength is 0" + consequence;
    // Ranks compare tubes with each other: one tube, or tubes that are all equal, weigh nothing.
    return "The surfaces found do not differ enough to weigh them (" + std::to_string(usable) + " found)" + consequence;
}

/// The ramp form's curve; sets the trust in it.
std::vector<double> rampLogOpacity(AdaptiveOtf& result) {
    const AdaptiveOtfConfig& config = result.config;
    std::vector<double> curve = meanRamp(result.tubes, config, AdaptiveOtf::sampleCount);
    const double needed = config.trustedShare * result.tubesMeetingVolume;
    result.trust = curve.empty() ? 0.0 : std::min(1.0, needed > 0.0 ? result.tubesWithSurface / needed : 1.0);
    curve.resize(AdaptiveOtf::sampleCount, 0.0);
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double x = static_cast<double>(i) / (AdaptiveOtf::sampleCount - 1);
        if (result.trust == 0.0)
            curve[i] = logOpacityAt(config.initial, x);
        else
            curve[i] = std::log(result.trust * config.rampOpacity * curve[i] +
                                (1.0 - result.trust) * opacityAt(config.initial, x));
    }
    return curve;
}

}  // namespace

std::string problemOf(const AdaptiveOtfConfig& config) {
    const auto between = [](auto value, auto low, auto high) { return value >= low && value <= high; };
    if (!between(config.tubeColumns, 1, 4096) || !between(config.tubeRows, 1, 4096))
        return "the tube grid must have 1 to 4096 columns and rows";
    if (config.tubeColumns * config.tubeRows > 262144) return "the tube grid must have at most 262144 tube cores";
    if (!between(config.tubeSpacing, 0.0, 1e6))
        return "the tube spacing must be 0 (automatic) or above, at most 1e6 units";
    if (!between(config.cellSize, 2, largestCellSize))
        return "the cell size must be 2 to " + std::to_string(largestCellSize);
    if (!between(config.finestScale, 0, 10) || !between(config.coarsestScale, config.finestScale, 10))
        return "the scales must be 0 to 10, the coarsest not below the finest";
    if (!between(config.sigmaPerKernelSize, 0.01, 4.0)) return "sigma must be 0.01 to 4 kernel sizes";
    if (!between(config.kernelCut, 0.5, 10.0)) return "the kernels must be cut at 0.5 to 10 sigma";
    if (!between(config.significance, 0.0, 1.0)) return "the significance must be 0 to 1";
    if (!between(config.floorQuantile, 0.0, 1.0)) return "the floor quantile must be 0 to 1";
    if (!between(config.trackingRangeSigmas, 0.0, 1000.0))
        return "the tracking range must be 0 (from valley to valley) or above, at most 1000 sigma";
    if (!between(config.cellStride, 1, 1000)) return "the cell stride must be 1 to 1000 units";
    if (!between(config.rankBins, 0, 1 << 20)) return "the bins of the ranks must be 0 (exact ranks) to 1048576";
    if (!between(config.slopeHalfStep, 1, 1000)) return "the slope's half step must be 1 to 1000 units";
    if (!between(config.leastEdgeToNoise, 0.0, 1e6)) return "the least edge to noise must be 0 to 1000000";
    if (!between(config.lowReach, 0, 1000) || !between(config.highReach, 0, 1000))
        return "the reach of I_L and I_H must be 0 to 1000 units";
    if (!between(config.falseAlarm, 0.0, 1e6)) return "the false alarm threshold must be 0 to 1000000";
    if (!between(config.rampBegin, -10.0, 10.0) || !between(config.rampEnd, config.rampBegin + 1e-3, 20.0))
        return "the ramp must begin at -10 to 10 and end behind that, at most at 20";
    if (!between(config.clearSpreads, 0.0, 1000.0)) return "the clear spreads must be 0 to 1000";
    if (!between(config.rampOpacity, 1e-6, 1.0)) return "the ramp's opacity must be above 0, at most 1";
    if (!between(config.trustedShare, 0.0, 1.0)) return "the trusted share must be 0 to 1";
    if (!between(config.strength, 0.0, 1e12)) return "the strength must be 0 to 1e12";
    return {};
}

std::optional<AdaptiveOtf> adaptOpacity(const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config,
                                        const Progress& progress) {
    if (const std::string problem = problemOf(config); !problem.empty()) throw std::invalid_argument(problem);
    StopWatch total, stage;
    AdaptiveOtf result;
    result.config = config;
    result.view = view;
    result.tubeSpacingUnits = tubeSpacingUnits(volume.geometry(), view, config);
    result.directionVoxel = directionInVoxels(view, volume.geometry());
    result.tubeLengthUnit = volume.geometry().unit();
    const bool byRatio = config.interfaceFunction == InterfaceFunction::ratio;
    if (!(byRatio ? analyseTubesByRatio : analyseTubes)(volume, result, progress)) return std::nullopt;

    stage.lap();
    result.tubesMeetingVolume =
        static_cast<int>(std::count_if(result.tubes.begin(), result.tubes.end(),
                                       [](const TubeCore& tube) { return tube.status != TubeStatus::outside; }));
    if (result.tubesMeetingVolume > 0) result.dMax = config.strength / result.tubesMeetingVolume;
    // The ratio's own threshold is the absolute test.
    weighTubes(result.tubes, result.tubesMeetingVolume, result.dMax, byRatio ? 0.0 : config.leastEdgeToNoise,
               config.rankBins);
    result.tubesWithSurface = static_cast<int>(
        std::count_if(result.tubes.begin(), result.tubes.end(), [](const TubeCore& tube) { return tube.d > 0.0; }));
    result.times.weights = stage.lap();

    result.logOpacity = config.form == CurveForm::ramp
                            ? rampLogOpacity(result)
                            : adaptedLogOpacity(config.initial, result.tubes, AdaptiveOtf::sampleCount);
    result.curve = curveFromLogOpacity(result.logOpacity);
    if (result.tubesWithSurface == 0) {
        // Exactly the initial function, not what a logarithm and back leave of it.
        result.curve.opacities = sampledOpacities(config.initial, AdaptiveOtf::sampleCount);
    }
    result.message = messageFor(result);
    result.times.curve = stage.lap();
    result.times.total = total.lap();
    if (progress.cancelled()) return std::nullopt;
    progress.at(1.0);
    return result;
}

}  // namespace echolucent
