// How far each tube core's surface is trusted (Petersch 2005, eqs. 9 to 11).
#pragma once

#include <span>

#include "processing/tube_core/rules/weight_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// Fills the weights of all tubes by exact, inclusive ranks over the tubes with a surface, relative to all N that meet
/// the volume: w_I = 1 - #{Imax' <= Imax} / N, w_S = #{0 < S' <= S} / N where S > 0 and else 0, extraWeight = 0 where
/// I_H <= I_L or the edge to noise is below leastEdgeToNoise (where that is 0, there is no such test), d = dMax w_I w_S
/// extraWeight. With rankBins above 0 the ranks are those of a histogram's bins instead, rankBins equal bins from 0 to
/// the largest value; all values of a bin count as ties.
void weighTubes(std::span<TubeCore> tubes, double dMax, double leastEdgeToNoise, const WeightRule& rule);

/// T and N: how many tube cores meet the volume's data.
[[nodiscard]] int tubesMeetingVolume(std::span<const TubeCore> tubes);

/// How many tube cores have a weight.
[[nodiscard]] int tubesWithWeight(std::span<const TubeCore> tubes);

}  // namespace echolucent
