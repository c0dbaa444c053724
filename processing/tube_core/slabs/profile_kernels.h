// Vector code for every slab of every tube. The bits are the same on every instruction set.
#pragma once

#include <cstdint>
#include <span>

namespace echolucent {

/// Mean and standard deviation from exact sums over `counts` values, divided by `white`. The values are at most 65535;
/// a count is 1 to 1024 (0 counts as 1). All spans are equally long.
void momentsFromSums(std::span<const std::int32_t> counts, std::span<const std::int32_t> sums,
                     std::span<const std::uint64_t> sumsOfSquares, double white, std::span<float> means,
                     std::span<float> spreads);

/// Values in a table of equidistant samples over [0,1], linear between them. Positions are clamped into [0,1].
void lookUp(std::span<const double> table, std::span<const float> positions, std::span<float> values);

/// values[i] = mean of profile[i + before ... i + before + behind - 1] - mean of profile[i ... i + before - 1]. At most
/// profile.size() - before - behind + 1 values fit.
void differencesOfMeans(std::span<const float> profile, int before, int behind, std::span<float> values);

/// Convolution with a symmetric kernel: results[i] = weights[0] f(i) + sum over d of weights[d] (f(i - d) + f(i + d)),
/// in this order, with f(i) = function[i]. weights.size() - 1 values before and behind must exist. The number of
/// results is a multiple of 8.
void convolve(const double* function, std::span<const double> weights, std::span<double> results);

}  // namespace echolucent
