#include "processing/tube_core/surface_reading.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <hwy/contrib/sort/vqsort.h>

namespace echolucent {

namespace {

/// The median of finite values, at least one; of an even number the upper of the middle two. Sorts the values. A
/// vectorised sort takes half the time of std::nth_element, because a processor cannot foresee the branches of
/// std::nth_element.
double upperMedianOf(std::vector<double>& values) {
    thread_local hwy::Sorter sort;
    sort(values.data(), values.size(), hwy::SortAscending());
    return values[values.size() / 2];
}

std::vector<double> completeMeans(const CellStatistics& cells, int first, int last) {
    std::vector<double> means;
    for (int i = first; i <= last; ++i)
        if (cells.complete[static_cast<std::size_t>(i)] != 0) means.push_back(cells.means[static_cast<std::size_t>(i)]);
    return means;
}

double sumOf(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum;
}

/// I_L over the last `reach` cells that end before the surface cell; no value if there is no such cell.
std::optional<double> meanBefore(const CellStatistics& cells, int surfaceCell, int reach, int cellSize) {
    const int last = surfaceCell - cellSize;
    const int first = std::max(cells.firstCell, last - reach + 1);
    if (last < first) return std::nullopt;
    const auto count = static_cast<std::size_t>(last - first + 1);
    return sumOf(std::span(cells.means).subspan(static_cast<std::size_t>(first), count)) / static_cast<double>(count);
}

double largestBehind(const CellStatistics& cells, int surfaceCell, int reach) {
    const auto first = cells.means.begin() + surfaceCell;
    return *std::max_element(first, cells.means.begin() + std::min(cells.lastCell, surfaceCell + reach) + 1);
}

}  // namespace

std::optional<double> scatterOf(std::span<const double> cellMeans, int apart) {
    const auto step = static_cast<std::size_t>(apart);
    if (cellMeans.size() < 2 * step) return std::nullopt;
    std::vector<double> differences;
    for (std::size_t i = step; i < cellMeans.size(); ++i)
        differences.push_back(std::abs(cellMeans[i] - cellMeans[i - step]));
    // The median of |a - b| is 0.6745 sqrt(2) standard deviations of a in normal noise.
    return upperMedianOf(differences) / 0.9539;
}

bool readSurface(const CellStatistics& cells, int surfaceCell, const SurfaceRule& rule, int cellSize, TubeCore& tube) {
    const auto meanOf = [&](int cell) { return cells.means[static_cast<std::size_t>(cell)]; };
    const int lastPrior = surfaceCell - (rule.priorCellsMayOverlap ? 1 : cellSize);
    std::vector<double> prior = completeMeans(cells, cells.firstCell, lastPrior);
    if (prior.empty()) return false;
    const int before = std::max(surfaceCell - rule.slopeHalfStep, cells.firstCell);
    const int behind = std::min(surfaceCell + rule.slopeHalfStep, cells.lastCell);
    tube.surfaceCell = surfaceCell;
    tube.lowIntensity = sumOf(prior) / static_cast<double>(prior.size());
    if (rule.lowReach > 0)
        if (const auto near = meanBefore(cells, surfaceCell, rule.lowReach, cellSize)) tube.lowIntensity = near;
    tube.lowIntensityMax = *std::max_element(prior.begin(), prior.end());
    tube.highIntensity = largestBehind(cells, surfaceCell, rule.highReach);
    tube.slope = behind > before ? (meanOf(behind) - meanOf(before)) / (behind - before) : 0.0;
    if (const auto scatter = scatterOf(prior, cellSize)) {
        // Even without noise, values scatter a little, because stored values are rounded.
        constexpr double leastScatter = 1e-6;
        tube.edgeToNoise = (meanOf(behind) - upperMedianOf(prior)) / std::max(*scatter, leastScatter);
    }
    return true;
}

}  // namespace echolucent
