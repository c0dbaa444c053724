#include "processing/tube_core/cell_statistics.h"

#include <algorithm>

namespace echolucent {

namespace {

/// Finds where the tube's data begin and end and makes room for its cells. False: there is no cell.
template <typename Slab>
bool beginCells(std::span<const Slab> slabs, int cellSize, CellStatistics& cells) {
    const std::uint32_t half = static_cast<std::uint32_t>((cellSize * cellSize + 1) / 2);
    const int slabCount = static_cast<int>(slabs.size());
    int first = 0, last = slabCount - 1;
    while (first < slabCount && slabs[static_cast<std::size_t>(first)].count < half) ++first;
    while (last >= 0 && slabs[static_cast<std::size_t>(last)].count < half) --last;
    cells.anyData = std::any_of(slabs.begin(), slabs.end(), [](const Slab& slab) { return slab.count > 0; });
    cells.firstCell = first;
    cells.lastCell = last - cellSize + 1;
    const auto count = static_cast<std::size_t>(std::max(0, slabCount - cellSize + 1));
    cells.means.assign(count, 0.0);
    cells.variances.assign(count, 0.0);
    cells.complete.assign(count, 0);
    return cells.lastCell >= cells.firstCell;
}

void hold(CellStatistics& cells, int cell) {
    if (cell == cells.firstCell) return;
    const auto i = static_cast<std::size_t>(cell);
    cells.means[i] = cells.means[i - 1];
    cells.variances[i] = cells.variances[i - 1];
}

void set(CellStatistics& cells, int cell, double mean, double variance) {
    const auto i = static_cast<std::size_t>(cell);
    cells.means[i] = mean;
    cells.variances[i] = variance;
    cells.complete[i] = 1;
}

}  // namespace

void cellsFrom(std::span<const SlabSums> slabs, int cellSize, double whiteLevel, CellStatistics& cells) {
    if (!beginCells(slabs, cellSize, cells)) return;
    const std::uint64_t samples = static_cast<std::uint64_t>(cellSize) * cellSize * cellSize;
    SlabSums cell;
    const auto add = [&](const SlabSums& slab) {
        cell.count += slab.count;
        cell.sum += slab.sum;
        cell.sumOfSquares += slab.sumOfSquares;
    };
    for (int k = cells.firstCell; k < cells.firstCell + cellSize; ++k) add(slabs[static_cast<std::size_t>(k)]);
    for (int i = cells.firstCell; i <= cells.lastCell; ++i) {
        if (i > cells.firstCell) {
            const SlabSums& left = slabs[static_cast<std::size_t>(i - 1)];
            cell.count -= left.count;
            cell.sum -= left.sum;
            cell.sumOfSquares -= left.sumOfSquares;
            add(slabs[static_cast<std::size_t>(i + cellSize - 1)]);
        }
        if (2 * cell.count < samples) {
            hold(cells, i);
            continue;
        }
        const double scale = static_cast<double>(cell.count) * whiteLevel;
        set(cells, i, static_cast<double>(cell.sum) / scale,
            static_cast<double>(scaledVariance(cell.count, cell.sum, cell.sumOfSquares)) / scale / scale);
    }
}

void cellsFrom(std::span<const SlabMoments> slabs, int cellSize, CellStatistics& cells) {
    if (!beginCells(slabs, cellSize, cells)) return;
    const std::uint32_t samples = static_cast<std::uint32_t>(cellSize * cellSize * cellSize);
    for (int i = cells.firstCell; i <= cells.lastCell; ++i) {
        const auto cell = slabs.subspan(static_cast<std::size_t>(i), static_cast<std::size_t>(cellSize));
        // As deviations from one slab's mean, so that equal slabs have that mean to the last bit and no spread.
        const auto first =
            std::find_if(cell.begin(), cell.end(), [](const SlabMoments& slab) { return slab.count > 0; });
        const double near = first == cell.end() ? 0.0 : first->mean;
        std::uint32_t count = 0;
        double sum = 0.0, deviations = 0.0;
        for (const SlabMoments& slab : cell) {
            count += slab.count;
            sum += slab.count * (slab.mean - near);
        }
        if (2 * count < samples) {
            hold(cells, i);
            continue;
        }
        const double mean = near + sum / count;
        for (const SlabMoments& slab : cell)
            deviations += slab.squaredDeviations + slab.count * (slab.mean - mean) * (slab.mean - mean);
        set(cells, i, mean, deviations / count);
    }
}

void cellsFrom(std::span<const float> slabMeans, int first, int cellSize, CellStatistics& cells) {
    const int slabs = static_cast<int>(slabMeans.size());
    cells.anyData = slabs > 0;
    cells.firstCell = first;
    cells.lastCell = first + slabs - cellSize;
    const auto count = static_cast<std::size_t>(std::max(0, cells.lastCell + 1));
    cells.variances.clear();
    cells.means.assign(count, 0.0);
    cells.complete.assign(count, 0);
    for (int cell = 0; cell <= slabs - cellSize; ++cell) {
        double sum = 0.0;
        for (int k = cell; k < cell + cellSize; ++k) sum += slabMeans[static_cast<std::size_t>(k)];
        cells.means[static_cast<std::size_t>(first + cell)] = sum / cellSize;
        cells.complete[static_cast<std::size_t>(first + cell)] = 1;
    }
}

void momentsFrom(std::span<const SlabSums> sums, double whiteLevel, std::vector<SlabMoments>& moments) {
    moments.resize(sums.size());
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const SlabSums& slab = sums[k];
        moments[k] = {slab.count, 0.0, 0.0};
        if (slab.count == 0) continue;
        moments[k].mean = static_cast<double>(slab.sum) / slab.count / whiteLevel;
        moments[k].squaredDeviations = static_cast<double>(scaledVariance(slab.count, slab.sum, slab.sumOfSquares)) /
                                       slab.count / whiteLevel / whiteLevel;
    }
}

}  // namespace echolucent
