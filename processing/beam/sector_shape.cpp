#include "processing/beam/sector_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace echolucent {

namespace {

/// This share of a slice's cells lies outside each of its edges, so that a stray cell is no edge.
constexpr double edgeQuantile = 0.03;
/// A slice of this share of the largest width is nearly as wide as the sector gets.
constexpr double nearlyWidest = 0.97;
constexpr double leastWideningDepth = 0.4;  ///< share of the depth
constexpr double leastSlope = 0.05;         ///< of each edge against the axis
constexpr double leastBalance = 0.2;        ///< slope of one edge as a share of the other's
constexpr double fullGrowth = 0.3;          ///< a sector that widens by this share of its width has the full score
constexpr double largestBend = 0.05;        ///< root mean square distance of the edges from lines, share of the width
constexpr double largestShrinking = 0.15;   ///< of the sector across its fan, share of the width
constexpr int fewestSectorSlices = 10;

/// The two edges of a slice across the depth, mm.
struct Edges {
    double low = 0.0, high = 0.0;
    [[nodiscard]] double width() const { return high - low; }
};

/// The place below which `below` of the counted cells lie, mm; each cell counts as filled evenly.
double quantile(const std::vector<std::int32_t>& counts, double below, double cellMm) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (below <= counts[i] && counts[i] > 0) return (static_cast<double>(i) + below / counts[i]) * cellMm;
        below -= counts[i];
    }
    return static_cast<double>(counts.size()) * cellMm;
}

/// How many cells with data of each slice along `depth` lie at each place along `across`.
std::vector<std::vector<std::int32_t>> countsOf(const CoarseEcho& coarse, int depth, int across) {
    const int other = 3 - depth - across;
    const auto sizeOf = [&](int axis) { return static_cast<std::size_t>(coarse.size[static_cast<std::size_t>(axis)]); };
    std::vector counts(sizeOf(depth), std::vector<std::int32_t>(sizeOf(across), 0));
    for (std::size_t s = 0; s < sizeOf(depth); ++s)
        for (std::size_t t = 0; t < sizeOf(across); ++t)
            for (std::size_t o = 0; o < sizeOf(other); ++o)
                if (coarse.dataShare[s * coarse.stride(depth) + t * coarse.stride(across) + o * coarse.stride(other)] >=
                    CoarseEcho::leastDataShare)
                    ++counts[s][t];
    return counts;
}

/// The edges of all slices that hold enough data, in order.
std::vector<Edges> edgesOf(const CoarseEcho& coarse, int depth, int across) {
    constexpr double leastOfLargest = 0.02;
    const auto counts = countsOf(coarse, depth, across);
    std::vector<double> totals;
    for (const auto& slice : counts) {
        double total = 0.0;
        for (const std::int32_t count : slice) total += count;
        totals.push_back(total);
    }
    const double least = std::max(4.0, leastOfLargest * *std::max_element(totals.begin(), totals.end()));
    std::vector<Edges> edges;
    const double cellMm = coarse.cellMm[across];
    for (std::size_t s = 0; s < counts.size(); ++s)
        if (totals[s] >= least)
            edges.push_back({quantile(counts[s], edgeQuantile * totals[s], cellMm),
                             quantile(counts[s], (1.0 - edgeQuantile) * totals[s], cellMm)});
    return edges;
}

/// A straight line through the values at 0, 1, 2, … by least squares; squaredResidual is a mean.
struct Line {
    double start = 0.0, slope = 0.0, squaredResidual = 0.0;
};

template <typename Value>
Line lineThrough(std::size_t count, const Value& valueAt) {
    const auto n = static_cast<double>(count);
    double sum = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += valueAt(i);
        moment += (static_cast<double>(i) - (n - 1) / 2) * valueAt(i);
    }
    Line line;
    line.slope = moment / (n * (n * n - 1) / 12);
    line.start = sum / n - line.slope * (n - 1) / 2;
    for (std::size_t i = 0; i < count; ++i) {
        const double off = valueAt(i) - line.start - line.slope * static_cast<double>(i);
        line.squaredResidual += off * off / n;
    }
    return line;
}

/// How many slices it takes until the sector is nearly as wide as it gets.
std::size_t wideningSlices(const std::vector<Edges>& edges) {
    double widest = 0.0;
    for (const Edges& slice : edges) widest = std::max(widest, slice.width());
    const auto reached = std::find_if(edges.begin(), edges.end(),
                                      [widest](const Edges& slice) { return slice.width() >= nearlyWidest * widest; });
    return static_cast<std::size_t>(reached - edges.begin()) + 1;
}

/// The score of one fan, seen from its first slice.
double fanScore(const std::vector<Edges>& edges, double sliceMm) {
    if (edges.size() < fewestSectorSlices) return 0.0;
    const std::size_t widening = wideningSlices(edges);
    const double share = static_cast<double>(widening) / static_cast<double>(edges.size());
    if (share < leastWideningDepth) return 0.0;
    const Line low = lineThrough(widening, [&](std::size_t i) { return edges[i].low; });
    const Line high = lineThrough(widening, [&](std::size_t i) { return edges[i].high; });
    const auto [narrow, wide] = std::minmax({-low.slope / sliceMm, high.slope / sliceMm});
    if (narrow < leastSlope || narrow < leastBalance * wide) return 0.0;
    const double first = high.start - low.start;
    const double last = first + (high.slope - low.slope) * static_cast<double>(widening - 1);
    const double bend = std::sqrt((low.squaredResidual + high.squaredResidual) / 2) / last;
    const double straight = std::max(0.0, 1.0 - bend / largestBend);
    return share * straight * std::min(1.0, (last - first) / last / fullGrowth);
}

/// Whether the sector, seen from its first slice, gets clearly narrower across the fan. True if there are too few
/// slices to tell.
bool shrinks(const std::vector<Edges>& edges) {
    if (edges.size() < fewestSectorSlices) return true;
    const Line width = lineThrough(edges.size(), [&](std::size_t i) { return edges[i].width(); });
    const double last = width.start + width.slope * static_cast<double>(edges.size() - 1);
    return last < (1.0 - largestShrinking) * width.start;
}

/// The score of the better of the two fans of a beam along `depth`. A fan counts only if the sector does not shrink
/// across it.
double scoreAlong(const CoarseEcho& coarse, int depth, bool reversed) {
    std::array<std::vector<Edges>, 2> fans;
    for (int i = 0; i < 2; ++i) {
        auto& edges = fans[static_cast<std::size_t>(i)];
        edges = edgesOf(coarse, depth, (depth + 1 + i) % 3);
        if (reversed) std::reverse(edges.begin(), edges.end());
    }
    double best = 0.0;
    for (std::size_t i = 0; i < 2; ++i)
        if (!shrinks(fans[1 - i])) best = std::max(best, fanScore(fans[i], coarse.cellMm[depth]));
    return best;
}

}  // namespace

std::array<double, 6> sectorScores(const CoarseEcho& coarse) {
    std::array<double, 6> scores{};
    for (int axis = 0; axis < 3; ++axis) {
        const double along = scoreAlong(coarse, axis, false), against = scoreAlong(coarse, axis, true);
        scores[static_cast<std::size_t>(2 * axis)] = std::max(0.0, along - against);
        scores[static_cast<std::size_t>(2 * axis + 1)] = std::max(0.0, against - along);
    }
    return scores;
}

}  // namespace echolucent
