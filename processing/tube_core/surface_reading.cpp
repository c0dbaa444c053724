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

std::vector<double> completeMeans(const CellStatistics& cells, const IndexRange& range) {
    std::vector<double> means;
    for (int i = range.first; i <= range.last; ++i)
        if (cells.complete[static_cast<std::size_t>(i)] != 0) means.push_back(cells.means[static_cast<std::size_t>(i)]);
    return means;
}

double sumOf(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum;
}

double meanOver(const CellStatistics& cells, const IndexRange& range) {
    const auto count = static_cast<std::size_t>(range.last - range.first + 1);
    return sumOf(std::span(cells.means).subspan(static_cast<std::size_t>(range.first), count)) /
           static_cast<double>(count);
}

double largestOf(const CellStatistics& cells, const IndexRange& range) {
    return *std::max_element(cells.means.begin() + range.first, cells.means.begin() + range.last + 1);
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

SurfaceCells surfaceCells(const IndexRange& tube, int surfaceCell, const SurfaceRule& rule, int cellSize) {
    const int lastBefore = surfaceCell - cellSize;
    const IndexRange near{std::max(tube.first, lastBefore - rule.lowReach + 1), lastBefore};
    return {.prior = {tube.first, rule.priorCellsMayOverlap ? surfaceCell - 1 : lastBefore},
            .near = rule.lowReach > 0 && !near.empty() ? std::optional(near) : std::nullopt,
            .high = {surfaceCell, std::min(tube.last, surfaceCell + rule.highReach)},
            .slope = {std::max(surfaceCell - rule.slopeHalfStep, tube.first),
                      std::min(surfaceCell + rule.slopeHalfStep, tube.last)}};
}

bool readSurface(const CellStatistics& cells, int surfaceCell, const SurfaceRule& rule, int cellSize, TubeCore& tube) {
    const auto meanOf = [&](int cell) { return cells.means[static_cast<std::size_t>(cell)]; };
    const SurfaceCells read = surfaceCells({cells.firstCell, cells.lastCell}, surfaceCell, rule, cellSize);
    std::vector<double> prior = completeMeans(cells, read.prior);
    if (prior.empty()) return false;
    const int before = read.slope.first, behind = read.slope.last;
    tube.surfaceCell = surfaceCell;
    tube.lowIntensity = read.near ? meanOver(cells, *read.near) : sumOf(prior) / static_cast<double>(prior.size());
    tube.lowIntensityMax = *std::max_element(prior.begin(), prior.end());
    tube.highIntensity = largestOf(cells, read.high);
    tube.slope = behind > before ? (meanOf(behind) - meanOf(before)) / (behind - before) : 0.0;
    if (const auto scatter = scatterOf(prior, cellSize)) {
        // Even without noise, values scatter a little, because stored values are rounded.
        constexpr double leastScatter = 1e-6;
        tube.edgeToNoise = (meanOf(behind) - upperMedianOf(prior)) / std::max(*scatter, leastScatter);
    }
    return true;
}

}  // namespace echolucent
