// The shape of the scanned sector: it widens away from the probe between straight edges.
#pragma once

#include <array>

#include "processing/beam/coarse_echo.h"

namespace echolucent {

/// How much the shape of the data speaks for each beam axis, in the order of BeamAxis, [0,1]: how far the data widen
/// along it between two straight edges, over what share of the depth, less the same for the opposite way. A box, an
/// ellipsoid and a slanted box have 0 everywhere.
[[nodiscard]] std::array<double, 6> sectorScores(const CoarseEcho& coarse);

}  // namespace echolucent
