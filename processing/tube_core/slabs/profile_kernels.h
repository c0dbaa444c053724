// What is done to every slab of every tube, as vectors. The same bits on every instruction set.
#pragma once

#include <cstdint>
#include <span>

namespace echolucent {

/// Mean and standard deviation from exact sums over `counts` values of at most 65535, 1 to 1024 of them (0 counts as
/// 1), divided by `white`. All spans are equally long.
void momentsFromSums(std::span<const std::int32_t> counts, std::span<const std::int32_t> sums,
                     std::span<const std::uint64_t> sumsOfSquares, double white, std::span<float> means,
                     std::span<float> spreads);

/// Values in a table of equidistant samples over [0,1], linear between them; positions are clamped into [0,1].
void lookUp(std::span<const double> table, std::span<const float> positions, std::span<float> values);

/// values[i]: mean of profile[i + before ... i + before + behind - 1] less mean of profile[i ... i + before - 1]; as
/// many as fit, profile.size() - before - behind + 1 at most.
void differencesOfMeans(std::span<const float> profile, int before, int behind, std::span<float> values);

/// Convolution with a symmetric kernel: results[i] = weights[0] f(i) + sum over d of weights[d] (f(i - d) + f(i + d)),
/// in this order, f(i) = function[i]; what lies weights.size() - 1 before and behind must be there. The number of
/// results is a multiple of 8.
void convolve(const double* function, std::span<const double> weights, std::span<double> results);

}  // namespace echolucent
