// Stretches of fluid along tube cores, joined to cavities.
#pragma once

#include <vector>

#include "processing/near_cut/tube_echo.h"

namespace echolucent {

/// A dark stretch of a tube core with a wall behind it, and in front of it unless the data begin there. Depths are
/// samples of TubeEcho.
struct FluidStretch {
    int tube = 0;
    int begin = 0, end = 0;  ///< samples; `end` is the first behind it
    bool atFront = false;  ///< it begins with the tube core's first or second sample of data: no wall stands before it
    /// ln of the wall's intensity over the stretch's mean. Of two walls the darker one counts.
    double contrast = 0.0;
    [[nodiscard]] int length() const { return end - begin; }
};

/// The stretches below the intensity `level` that belong to a cavity. The stretches of a cavity lie side by side in
/// neighbouring tube cores. Together they hold at least as many samples as a cube with an edge of `leastEdge` samples.
/// They are sorted by tube core and depth.
[[nodiscard]] std::vector<FluidStretch> fluidStretches(const TubeEcho& tubes, float level, double leastEdge);

}  // namespace echolucent
