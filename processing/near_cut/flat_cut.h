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
    int sample = 0;         ///< of TubeEcho
    double fluid = 0.0;     ///< share of the samples with data that are fluid behind a wall, mean of the levels
    double contrast = 0.0;  ///< mean of the stretches', as FluidStretch::contrast
};

/// Where a plane opens the fluid: each depth is worth the tube cores in fluid there, counted by how long and how clear
/// their stretches are, times the share of all fluid that is left behind; the cut is the least depth before the best
/// one from which on every depth is worth nearly as much. `levels` holds the stretches of each level, of which those at
/// the front play no part.
[[nodiscard]] FlatCut findFlatCut(const TubeEcho& tubes, std::span<const std::vector<FluidStretch>> levels);

/// How many tube cores are in fluid at a depth each, in samples: at one of the levels at least, behind a wall.
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
