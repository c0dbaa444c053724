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
    bool atFront = false;    ///< it begins where the tube core's data begin: no wall stands before it
    double contrast = 0.0;   ///< ln of the lower wall's intensity over the stretch's mean
    [[nodiscard]] int length() const { return end - begin; }
};

/// The stretches below an intensity that belong to a cavity: side by side in neighbouring tube cores, and together at
/// least as large as a cube of `leastEdge` samples an edge. They are sorted by tube core and depth.
[[nodiscard]] std::vector<FluidStretch> fluidStretches(const TubeEcho& tubes, float level, double leastEdge);

}  // namespace echolucent
