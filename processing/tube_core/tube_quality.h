// What a detected surface says (I_L, I_H, largest prior mean, slope) and how far it is trusted (Petersch 2005, eqs. 8
// to 11).
#pragma once

#include <optional>
#include <span>

#include "processing/adaptive_otf.h"
#include "processing/tube_core/cell_statistics.h"

namespace echolucent {

/// Reads the intensities around the detected cell into the tube: I_L and the largest mean over the prior cells, I_H,
/// the slope by a central difference of cell means over +-config.slopeHalfStep cells, fewer at the tube's ends, and the
/// edge to noise. Prior cells end before the surface cell (i <= s - cellSize) or, where they may overlap it, only begin
/// before it (i < s). With a cellStride only every cellStride-th cell from the first on is looked at: prior cells are
/// those, and the slope's half step is the nearest whole number of strides. False, and the tube unchanged: no complete
/// prior cell.
[[nodiscard]] bool describeSurface(const CellStatistics& cells, int surfaceCell, const AdaptiveOtfConfig& config,
                                   TubeCore& tube);

/// How far the cell means scatter by themselves: the standard deviation that the median difference of neighbouring
/// cells that do not overlap would have in normal noise. A wall among the cells, or a slow change, does not count.
/// apart: places between two cells that do not overlap (the cell size, where all cells are looked at). None: fewer than
/// 2 apart cells.
[[nodiscard]] std::optional<double> scatterOf(std::span<const double> cellMeans, int apart);

/// Fills the weights of all tubes by exact, inclusive ranks over the tubes with a surface, relative to all that meet
/// the volume: w_I = 1 - #{Imax' <= Imax} / N, w_S = #{0 < S' <= S} / N where S > 0 and else 0, extraWeight = 0 where
/// I_H <= I_L or the edge to noise is below leastEdgeToNoise (0: not asked), d = dMax w_I w_S extraWeight.
/// rankBins above 0: the ranks are those of a histogram's bins instead, rankBins equal bins from 0 to the largest
/// value; all values of a bin count as ties.
void weighTubes(std::span<TubeCore> tubes, int tubesMeetingVolume, double dMax, double leastEdgeToNoise,
                int rankBins = 0);

}  // namespace echolucent
