// The shape of the scanned sector: it widens away from the probe between straight edges.
#pragma once

#include <array>

#include "processing/beam/coarse_echo.h"

namespace echolucent {

/// How strongly the shape of the data points to each beam axis, in the order of BeamAxis, [0,1]. A score combines how
/// far the data widen along the axis between two straight edges, and over what share of the depth. The score of the
/// opposite way is taken off. A box, an ellipsoid and a slanted box have 0 everywhere.
[[nodiscard]] std::array<double, 6> sectorScores(const CoarseEcho& coarse);

}  // namespace echolucent
