// Passes of the joint bilateral filter for its tests.
#pragma once

#include <array>

#include "processing/speckle_reduction/joint_bilateral_filter.h"

namespace echolucent {

inline constexpr std::array onePass{JointBilateralPass{}};
inline constexpr std::array twoPasses{JointBilateralPass{}, JointBilateralPass{.guideSigma = 0.7}};

}  // namespace echolucent
