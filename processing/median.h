// The middle of many measurements.
#pragma once

#include <vector>

namespace echolucent {

/// Median of finite values; of an even number of values the mean of the two in the middle. Throws std::invalid_argument
/// where there is no value.
[[nodiscard]] double medianOf(std::vector<double> values);

}  // namespace echolucent
