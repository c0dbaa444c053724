// Where the probe was, if a file says it.
#pragma once

#include <optional>

#include "processing/volume/geometry.h"

namespace echolucent {

/// What a file says of the probe, in grid mm (ARCHITECTURE.md, "Coordinates and units").
struct StatedProbe {
    Vec3 forward{0, 0, 1};         ///< mean direction of sound, a unit vector
    Vec3 down{0, 1, 0};            ///< points down in the picture seen from the probe; a unit vector, not along forward
    std::optional<Vec3> apexMm{};  ///< where the beams meet, maybe outside the grid; not set if they are parallel
    /// Whether the file says how the planes lay in which the probe scanned: forward and down x forward lie in them.
    bool planesKnown = false;
    friend bool operator==(const StatedProbe&, const StatedProbe&) = default;
};

}  // namespace echolucent
