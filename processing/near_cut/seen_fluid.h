// What the tube cores of a view see of fluid.
#pragma once

#include <optional>
#include <vector>

#include "processing/near_cut/fluid_stretches.h"
#include "processing/near_cut/smooth_echo.h"
#include "processing/near_cut/tube_echo.h"
#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What is read of a volume before it is looked along, the same for all views: they share one pass over the voxels.
struct SearchedEcho {
    SmoothEcho smooth;
    std::optional<double> tissue{};  ///< tissueLevel(); empty if there is no echo
};
/// The result is empty only if progress.cancel was raised.
[[nodiscard]] std::optional<SearchedEcho> searchedEchoOf(const Volume& volume, const Progress& progress = {});

/// What the tube cores of a view saw. Without echo there is no tube core.
struct SeenFluid {
    TubeEcho tubes{};
    /// The stretches of fluid below 0.35, 0.45 and 0.55 of the level of tissue, sorted by tube core.
    std::vector<std::vector<FluidStretch>> levels{};
    double tissue = 0.0;                ///< tissueLevel()
    int meetData = 0;                   ///< tube cores that meet data
    int front = 0;                      ///< the least sample at which any tube core meets data
    std::vector<bool> beginsInFluid{};  ///< of each tube core
    int beginInFluid = 0, meetFluid = 0;
    double frontContrast = 0.0;  ///< mean FluidStretch::contrast of the stretches at the front
};

/// Looks along a view through the cells of a volume with `geometry`. The view's cuts and box are ignored. The result
/// has the same bits for any number of threads.
[[nodiscard]] SeenFluid seenFluid(const SearchedEcho& echo, const VolumeGeometry& geometry, const Viewpoint& view);

}  // namespace echolucent
