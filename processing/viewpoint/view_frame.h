// The directions of a view.
#pragma once

#include <string>

#include "processing/volume/geometry.h"

namespace echolucent {

/// The orthonormal frame of a view in grid mm. Rays travel along `forward` (from the probe into the volume). `right`
/// and `down` span the picture; right x down = forward.
struct ViewFrame {
    Vec3 right;
    Vec3 down;
    Vec3 forward;
    friend bool operator==(const ViewFrame&, const ViewFrame&) = default;
};

/// What is wrong with a frame read from a file, lower case, no full stop. Empty if nothing is wrong.
[[nodiscard]] std::string problemOf(const ViewFrame& frame);

}  // namespace echolucent
