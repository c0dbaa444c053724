// The depth at which a plane across the view opens the fluid.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "processing/near_cut/fluid_stretches.h"

namespace echolucent {

/// A plane across the view, and how much fluid stands behind walls.
struct FlatCut {
    int sample = 0;         ///< depth of the plane, in samples of TubeEcho
    double fluid = 0.0;     ///< share of the samples with data that are fluid behind a wall, mean of the levels
    double contrast = 0.0;  ///< mean FluidStretch::contrast of these stretches, weighted by their lengths
};

/// Where a plane opens the fluid. A stretch weighs its length times its contrast. The worth of a depth is a product:
/// the weight of the stretches at this depth, and the sum of such weights from this depth on. The worth is smoothed
/// over the depth. The cut lies before the depth of greatest worth, as far as the worth stays at nine tenths of the
/// greatest. `levels` holds the stretches of each level; those at the front do not count. If there are no others, the
/// result is FlatCut{}.
[[nodiscard]] FlatCut findFlatCut(const TubeEcho& tubes, std::span<const std::vector<FluidStretch>> levels);

/// How many tube cores are in fluid behind a wall, in one of the levels at least. `depthOf(tube)` is the depth at which
/// a tube core is asked, in samples.
template <typename DepthOfTube>
[[nodiscard]] int tubesInFluid(std::span<const std::vector<FluidStretch>> levels, std::size_t tubes,
                               const DepthOfTube& depthOf) {
    std::vector<bool> inFluid(tubes);
    for (const auto& stretches : levels)
        for (const FluidStretch& stretch : stretches) {
            if (stretch.atFront) continue;
            const double depth = depthOf(stretch.tube);
            if (stretch.begin <= depth && depth < stretch.end) inFluid[static_cast<std::size_t>(stretch.tube)] = true;
        }
    return static_cast<int>(std::count(inFluid.begin(), inFluid.end(), true));
}

}  // namespace echolucent
