// What a detected surface says (I_L, I_H, largest prior mean, slope) and how far it is trusted (Petersch 2005, eqs. 8 to
// 11).
#pragma once

#include <span>

#include "processing/adaptive_otf.h"
#include "processing/tube_core/cell_statistics.h"

namespace echolucent {

/// Reads the intensities around the detected cell into the tube: I_L and the largest mean over the cells that end before
/// it (i <= s - cellSize), I_H, and the slope by a central difference of cell means over +-slopeHalfStep cells, fewer at
/// the tube's ends. False, and the tube unchanged: no complete cell lies before it.
[[nodiscard]] bool describeSurface(const CellStatistics& cells, int surfaceCell, int cellSize, int slopeHalfStep,
                                   TubeCore& tube);

/// Fills the weights of all tubes by exact, inclusive ranks over the tubes with a surface, relative to all that meet the
/// volume: w_I = 1 - #{Imax' <= Imax} / N, w_S = #{0 < S' <= S} / N where S > 0 and else 0, extraWeight = 0 where
/// I_H <= I_L, d = dMax w_I w_S extraWeight.
void weighTubes(std::span<TubeCore> tubes, int tubesMeetingVolume, double dMax);

}  // namespace echolucent
