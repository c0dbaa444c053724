// Numbers that no file should have.
#pragma once

#include <limits>

namespace echolucent {

inline constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace echolucent
