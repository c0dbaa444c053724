#include "app/measuring/measures/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace echolucent {

namespace {

/// The ranks of values, from 0 on.
std::vector<double> ranksOf(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    std::vector<double> ranks(values.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t next = first;
        while (next < order.size() && values[order[next]] == values[order[first]]) ++next;
        for (std::size_t i = first; i < next; ++i) ranks[order[i]] = 0.5 * static_cast<double>(first + next - 1);
        first = next;
    }
    return ranks;
}

}  // namespace

std::optional<double> rankCorrelation(std::span<const double> one, std::span<const double> other) {
    if (one.size() != other.size()) throw std::invalid_argument("rankCorrelation: the measures are not equally many");
    if (one.size() < 2) return std::nullopt;
    const std::vector<double> a = ranksOf(one), b = ranksOf(other);
    const double mean = 0.5 * static_cast<double>(one.size() - 1);
    double together = 0.0, ofOne = 0.0, ofOther = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        together += (a[i] - mean) * (b[i] - mean);
        ofOne += (a[i] - mean) * (a[i] - mean);
        ofOther += (b[i] - mean) * (b[i] - mean);
    }
    if (ofOne == 0.0 || ofOther == 0.0) return std::nullopt;
    return together / std::sqrt(ofOne * ofOther);
}

}  // namespace echolucent
