// The middle of many measurements.
#pragma once

#include <vector>

namespace echolucent {

/// Median of finite values. For an even number of values, the mean of the two in the middle. Throws
/// std::invalid_argument if there is no value.
[[nodiscard]] double medianOf(std::vector<double> values);

}  // namespace echolucent
