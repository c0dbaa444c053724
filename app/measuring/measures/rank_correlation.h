// Whether two measures put things in the same order.
#pragma once

#include <optional>
#include <span>

namespace echolucent {

/// Spearman's rank correlation of two measures of the same things, [-1,1]: 1 if both put them in the same order, -1 in
/// the reverse one. Equal values share the mean of their ranks. Empty if there are fewer than two things, or if a
/// measure is the same of all. Throws std::invalid_argument if the measures are not equally many.
[[nodiscard]] std::optional<double> rankCorrelation(std::span<const double> one, std::span<const double> other);

}  // namespace echolucent
