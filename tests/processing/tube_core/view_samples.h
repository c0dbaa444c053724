// The samples of a view's tube cores, for the tests of samples and slabs.
#pragma once

#include <vector>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/tube_core/slabs/tube_samples.h"

namespace echolucent {

/// The samples of every tube core of the config's grid.
inline std::vector<TubeSamples> samplesFor(const Volume& volume, const Viewpoint& view,
                                           const AdaptiveOtfConfig& config) {
    return samplesOf(tubeAxes(volume.geometry(), view, config.grid, config.cells.size), volume.geometry(), view,
                     config.cells.size);
}

}  // namespace echolucent
