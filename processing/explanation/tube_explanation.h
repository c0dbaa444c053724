// What one tube core found, how surely, and what it does to the curve: Figs. 2 to 5 of Petersch et al. 2005 for a tube
// core of one's own choice, as values.
//
// A number is a tube core's index in the grid, row * columns + column, as in TubeGrid::withoutTubes. A cell is given by
// its index in TubeCore::cellMeans. Cell i holds the samples i ... i + cell size - 1 of the axis. Intensities are
// normalised, lengths are in units (the volume's smallest spacing).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/detection/tracked_scale.h"
#include "processing/explanation/tube_factors.h"
#include "processing/opacity_curve.h"
#include "processing/progress.h"
#include "processing/tube_core/index_range.h"
#include "processing/tube_core/ramp.h"
#include "processing/tube_core/tube_core.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What a tube core is in its run; nameOf() gives its word.
enum class TubeState {
    weighs,         ///< a surface, d > 0
    weighsNothing,  ///< a surface, d is 0
    noSurface,      ///< it meets data, and no surface was found
    outside,        ///< its axis misses the volume or meets no data
    neverPlaced,    ///< TubeGrid::withoutTubes names it
};

/// "weighs", "no weight", "no surface", "outside", "never placed": the words of window, page and JSON.
[[nodiscard]] std::string_view nameOf(TubeState state);

/// Intensities along a tube core (Fig. 2). Element k of each list lies at TubeCore::firstSampleVoxel + k units along
/// the view. NaN without data.
struct AxisIntensities {
    /// On the axis, trilinear, in the voxels in which surfaces are found.
    std::vector<double> read;
    /// The same in the quiet voxels for which the curve is meant; empty if the curve is meant for the voxels read.
    std::vector<double> shown;
    /// Means of the slabs, cell size x cell size samples, in the voxels in which surfaces are found.
    std::vector<double> slabMeans;
};

/// Which cells a tube core's intensities were read from. All ranges include both ends; a range without a cell has
/// last < first.
struct CellsRead {
    IndexRange tube;      ///< from TubeCore::firstCell to the last cell that ends at data
    IndexRange prior;     ///< prior cells: the largest mean (eq. 8) is among them
    IndexRange low;       ///< cells of I_L
    IndexRange high;      ///< cells among which I_H is the largest mean
    IndexRange slope;     ///< S is the difference of its two ends' means over their distance
    int lowMaxCell = -1;  ///< the prior cell with the largest mean; -1 without a surface
    int highCell = -1;    ///< the cell whose mean is I_H; -1 without a surface
};

/// One weight as a place in a histogram (eqs. 9 and 10).
struct WeightRank {
    /// Of all tube cores with a surface, ascending: the largest prior mean (eq. 8), or the slope S.
    std::vector<double> values;
    std::optional<double> value;  ///< this tube core's; empty without a surface
    /// How many of the values that count are at most this tube core's. If WeightRule::rankBins is above 0, values of
    /// one bin are ties. Slopes of 0 and below count for nothing, and their rank is 0.
    int rank = 0;
    int total = 0;        ///< N: tube cores that meet the volume's data
    double weight = 0.0;  ///< w_I = 1 - rank / N, or w_S = rank / N; 0 without a surface
};

/// A curve of the explanation.
struct ExplainedCurve {
    SampledCurve curve;
    int tubesWithWeight = 0;  ///< of how many tube cores it is made
    double trust = 1.0;       ///< AdaptiveOtf::trust
    std::string message;      ///< AdaptiveOtf::message
};

/// All that explainTube() tells. Values that belong to a surface are empty or 0 without one.
struct TubeExplanation {
    int number = 0;
    AdaptiveOtfConfig config;  ///< as the method ran: configUsed()
    TubeState state = TubeState::outside;
    TubeCore tube;                        ///< as in the run
    std::optional<QuietInterface> quiet;  ///< AdaptiveOtf::quiet of this tube core
    bool lengthsHalved = false;           ///< AdaptiveOtf::lengthsHalved
    bool surfacesWhereDataBegin = false;  ///< AdaptiveOtf::surfacesWhereDataBegin: the curve stays the initial function
    SpeckleReduction reduction = SpeckleReduction::off;  ///< AdaptiveOtf::reduction
    int tubesMeetingVolume = 0;                          ///< T and N
    double dMax = 0.0;
    double sumOfD = 0.0;                                  ///< of all tube cores of the run
    std::optional<double> leastContrast, fluidIntensity;  ///< with RatioRule: AdaptiveOtf's

    AxisIntensities axis;
    CellsRead cells;
    /// With VarianceRule: the scales that were looked at, coarsest first (Fig. 4); the unsmoothed function is the last
    /// one, also if tracking had ended before. Element i of a function belongs to cell CellsRead::tube.first + i. With
    /// RatioRule empty: TubeCore::interfaceFunction holds the contrasts.
    std::vector<TrackedScale> scales;
    /// With RatioRule: the cells whose interface function is the contrast of a boundary. At the others it is 0, because
    /// too few slabs lie before or behind.
    IndexRange contrastCells;
    /// With RatioRule: the cell of a surface that was found, but could not be read, because no complete cell lies
    /// before it. Then the state is noSurface.
    std::optional<int> unreadSurface;

    WeightRank intensityRank;  ///< w_I, by the largest prior mean
    WeightRank slopeRank;      ///< w_S, by the slope

    std::optional<TubeFactor> factor;  ///< empty without a weight, and if surfacesWhereDataBegin
    std::optional<RampEnds> ramp;      ///< with RampRule and a factor: where the ramp begins and is full

    std::vector<double> initial;  ///< the initial function's opacities at AdaptiveOtf::sampleCount intensities
    ExplainedCurve full;          ///< the run's
    /// Of a run that never places this tube core: ranks, T, d_max, thresholds and the ramp for every wall are made
    /// again. To the bit what `--without-tube` gives. The run's own if the tube core is never placed.
    ExplainedCurve without;
    /// What the curve rule makes of this tube core alone, with its d of the full run. Ranks among one would be 0.
    ///
    /// With ProductRule min(1, initial(x) (1 + d)^g(x)). With RampRule the ramp, and with RampRule::aim the ramp for
    /// every wall that this one surface asks for, found along its own axis. Trust is full, because all of the tube
    /// cores, one, have a weight. d plays no part then: the mean of one ramp is that ramp.
    ///
    /// In quiet voxels I_L, I_H and the fluid's spread are those of `quiet`. The rule is quieterRule() with the run's
    /// AdaptiveOtf::speckleLeft: that belongs to the voxels, not to a tube core. Without a weight, and if
    /// surfacesWhereDataBegin, it is the initial function.
    ExplainedCurve alone;
};

/// Explains the tube core `number` of a run: of adaptOpacity(volume, otf.view, otf.config, ..., shown), whose result is
/// `otf`. Empty only if the work was cancelled. Takes about as long as one run of the method. Throws
/// std::invalid_argument if the grid does not hold the number, or the volume has another grid than the shown voxels.
[[nodiscard]] std::optional<TubeExplanation> explainTube(const Volume& volume, const QuietVoxels& shown,
                                                         const AdaptiveOtf& otf, int number,
                                                         const Progress& progress = {});

/// The config that never places this tube core too, as `--without-tube` does. If the grid does not hold the number, the
/// config is no valid one.
[[nodiscard]] AdaptiveOtfConfig configWithout(AdaptiveOtfConfig config, int number);

/// The state of a tube core of a run; throws std::invalid_argument if the grid does not hold the number.
[[nodiscard]] TubeState stateOf(const AdaptiveOtf& otf, int number);

}  // namespace echolucent
