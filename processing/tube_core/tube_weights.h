// How far each tube core's surface is trusted (Petersch 2005, eqs. 9 to 11).
#pragma once

#include <span>
#include <vector>

#include "processing/tube_core/rules/weight_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// Fills the weights of all tubes with a surface, from exact, inclusive ranks over these tubes. Other tubes stay as
/// they are. N tubes meet the volume. w_I = 1 - #{Imax' <= Imax} / N; w_S = #{0 < S' <= S} / N if S > 0, else 0; d =
/// dMax w_I w_S extraWeight. extraWeight is 0 if I_H <= I_L, or if the edge to noise is not set or below
/// leastEdgeToNoise (0: no such test). If rankBins is above 0, the bins of a histogram are ranked instead: rankBins
/// equal bins from 0 to the largest value. All values of a bin are ties.
void weighTubes(std::span<TubeCore> tubes, double dMax, double leastEdgeToNoise, const WeightRule& rule);

/// The rank of each value among all: how many are at most as large. If `bins` is above 0, all values of a bin are ties,
/// as in weighTubes().
[[nodiscard]] std::vector<int> inclusiveRanks(std::vector<double> values, int bins);

/// T and N: how many tube cores meet data of the volume.
[[nodiscard]] int tubesMeetingVolume(std::span<const TubeCore> tubes);

/// How many tube cores have a weight.
[[nodiscard]] int tubesWithWeight(std::span<const TubeCore> tubes);

}  // namespace echolucent
