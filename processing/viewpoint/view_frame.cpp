#include "processing/viewpoint/view_frame.h"

#include <cmath>

namespace echolucent {

std::string problemOf(const ViewFrame& frame) {
    constexpr double rounding = 1e-6;
    const bool orthonormal = std::abs(length(frame.right) - 1.0) <= rounding &&
                             std::abs(length(frame.down) - 1.0) <= rounding &&
                             length(frame.right.cross(frame.down) - frame.forward) <= rounding &&
                             std::abs(length(frame.forward) - 1.0) <= rounding;
    return orthonormal ? "" : "has a frame that is not right-handed and orthonormal";
}

}  // namespace echolucent
