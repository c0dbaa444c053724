// The curve as the mean of the tubes' ramps: what each tube core says about which intensities are fluid and which are
// surface, side by side with the paper's product of basis functions.
#pragma once

#include <span>
#include <vector>

#include "processing/adaptive_otf.h"
#include "processing/tube_core/cell_statistics.h"

namespace echolucent {

/// Reads a surface's intensities from its neighbourhood: I_L over the last lowReach prior cells (i <= s - cellSize; 0:
/// all of them, left as it is), I_H as the largest cell mean from the surface to highReach cells behind it (0: the
/// surface cell's, left as it is). On the ramp itself the mean is halfway between fluid and tissue, and what lies far
/// in front says nothing about this surface.
void readNeighbourhood(const CellStatistics& cells, const AdaptiveOtfConfig& config, TubeCore& tube);

/// The ramp of one tube core: 0 up to I_L + max(begin (I_H - I_L), clearSpreads times the fluid's spread), so that
/// neither haze nor the speckle of the fluid is seen; 1 from I_L + end (I_H - I_L) on, linear between, over at least
/// leastRampWidth of the way.
[[nodiscard]] double rampAt(double intensity, const TubeCore& tube, const AdaptiveOtfConfig& config);
inline constexpr double leastRampWidth = 0.3;

/// The tubes' ramps at `count` equidistant intensities 0 ... 1, their mean weighted by d: how surely an intensity is
/// surface, [0,1]; empty: no tube has a weight. The same bits for any number of threads.
[[nodiscard]] std::vector<double> meanRamp(std::span<const TubeCore> tubes, const AdaptiveOtfConfig& config, int count);

}  // namespace echolucent
