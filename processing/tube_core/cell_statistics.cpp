#include "processing/tube_core/cell_statistics.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace echolucent {

namespace {

/// Finds where the tube's data begin and end, and makes room for its cells. countOf(slab) gives the number of samples
/// with data. Returns whether there is a cell.
template <typename CountOf>
bool beginCells(std::size_t slabs, int cellSize, const CountOf& countOf, CellStatistics& cells) {
    const int half = (cellSize * cellSize + 1) / 2;
    const int slabCount = static_cast<int>(slabs);
    const auto isHalfData = [&](int slab) { return static_cast<int>(countOf(static_cast<std::size_t>(slab))) >= half; };
    int first = 0, last = slabCount - 1;
    while (first < slabCount && !isHalfData(first)) ++first;
    while (last >= 0 && !isHalfData(last)) --last;
    cells.anyData = first < slabCount;
    for (std::size_t slab = 0; slab < slabs && !cells.anyData; ++slab) cells.anyData = countOf(slab) > 0;
    cells.firstCell = first;
    cells.lastCell = last - cellSize + 1;
    const auto count = static_cast<std::size_t>(std::max(0, slabCount - cellSize + 1));
    cells.means.assign(count, 0.0);
    cells.variances.assign(count, 0.0);
    cells.complete.assign(count, 0);
    return cells.lastCell >= cells.firstCell;
}

/// Cells with data in less than half of their samples repeat the cell before; the first cell becomes 0. Marks all other
/// cells complete.
template <typename Count>
void holdAcrossHoles(std::span<const Count> counts, int cellSize, CellStatistics& cells) {
    const int samples = cellSize * cellSize * cellSize;
    int count = 0;
    for (int k = 0; k < cellSize - 1; ++k)
        count += static_cast<int>(counts[static_cast<std::size_t>(cells.firstCell + k)]);
    for (int cell = cells.firstCell; cell <= cells.lastCell; ++cell) {
        const auto i = static_cast<std::size_t>(cell), size = static_cast<std::size_t>(cellSize);
        count += static_cast<int>(counts[i + size - 1]);
        if (2 * count >= samples) {
            cells.complete[i] = 1;
        } else if (cell > cells.firstCell) {
            cells.means[i] = cells.means[i - 1];
            cells.variances[i] = cells.variances[i - 1];
        } else {
            cells.means[i] = cells.variances[i] = 0.0;
        }
        count -= static_cast<int>(counts[i]);
    }
}

/// How many cells are computed together, so that their sums stay in registers and the compiler makes vectors of them.
constexpr std::size_t batch = 64;

/// Calls run(first cell, number of cells) for at most `batch` cells at a time.
template <typename Run>
void inBatches(const CellStatistics& cells, const Run& run) {
    if (cells.lastCell < cells.firstCell) return;
    const auto end = static_cast<std::size_t>(cells.lastCell + 1);
    for (auto first = static_cast<std::size_t>(cells.firstCell); first < end; first += batch)
        run(first, std::min(batch, end - first));
}

/// Sums over the cells' slabs: sums[i] = values[first + i] + ... + values[first + i + cellSize - 1].
template <typename Sum, typename Value>
void addSlabs(const Value* values, std::size_t first, std::size_t count, int cellSize, std::array<Sum, batch>& sums) {
    std::fill_n(sums.begin(), count, Sum{});
    for (std::size_t k = 0; k < static_cast<std::size_t>(cellSize); ++k)
        for (std::size_t i = 0; i < count; ++i) sums[i] += static_cast<Sum>(values[first + i + k]);
}

}  // namespace

void cellsFrom(const SlabSums& slabs, int cellSize, double whiteLevel, CellStatistics& cells) {
    if (!beginCells(
            slabs.sums.size(), cellSize, [&](std::size_t k) { return slabs.counts[k]; }, cells))
        return;
    // largestCellSize keeps the sums in 32 bits.
    std::array<std::int32_t, batch> counts, sums;
    std::array<std::uint64_t, batch> squares;
    inBatches(cells, [&](std::size_t first, std::size_t count) {
        addSlabs(slabs.counts.data(), first, count, cellSize, counts);
        addSlabs(slabs.sums.data(), first, count, cellSize, sums);
        for (std::size_t i = 0; i < count; ++i)
            cells.means[first + i] = static_cast<double>(sums[i]) / (std::max(counts[i], 1) * whiteLevel);
        addSlabs(slabs.sumsOfSquares.data(), first, count, cellSize, squares);
        for (std::size_t i = 0; i < count; ++i) {
            const double scale = std::max(counts[i], 1) * whiteLevel;
            const auto exact =
                scaledVariance(static_cast<std::uint64_t>(counts[i]), static_cast<std::uint64_t>(sums[i]), squares[i]);
            cells.variances[first + i] = static_cast<double>(exact) / scale / scale;
        }
    });
    holdAcrossHoles(std::span<const std::int32_t>(slabs.counts), cellSize, cells);
}

void cellsFrom(const SlabMeans& slabs, int cellSize, double whiteLevel, CellStatistics& cells) {
    if (!beginCells(
            slabs.means.size(), cellSize, [&](std::size_t k) { return slabs.counts[k]; }, cells))
        return;
    // Counts have 11 bits and means 24: their products are exact in double, and so are the sums of equal products.
    std::array<double, batch> counts, sums, deviations;
    const float* count = slabs.counts.data();
    const float* mean = slabs.means.data();
    inBatches(cells, [&](std::size_t first, std::size_t cellCount) {
        addSlabs(count, first, cellCount, cellSize, counts);
        std::fill_n(sums.begin(), cellCount, 0.0);
        const auto size = static_cast<std::size_t>(cellSize);
        for (std::size_t k = first; k < first + size; ++k)
            for (std::size_t i = 0; i < cellCount; ++i)
                sums[i] += static_cast<double>(count[k + i]) * static_cast<double>(mean[k + i]);
        for (std::size_t i = 0; i < cellCount; ++i) {
            counts[i] = std::max(counts[i], 1.0);
            sums[i] /= counts[i];
            cells.means[first + i] = sums[i] / whiteLevel;
        }
        addSlabs(slabs.squaredDeviations.data(), first, cellCount, cellSize, deviations);
        for (std::size_t k = first; k < first + size; ++k)
            for (std::size_t i = 0; i < cellCount; ++i) {
                const double apart = static_cast<double>(mean[k + i]) - sums[i];
                deviations[i] += static_cast<double>(count[k + i]) * apart * apart;
            }
        for (std::size_t i = 0; i < cellCount; ++i)
            cells.variances[first + i] = deviations[i] / counts[i] / whiteLevel / whiteLevel;
    });
    holdAcrossHoles(std::span<const float>(slabs.counts), cellSize, cells);
}

void cellsFrom(std::span<const SlabMoments> slabs, int cellSize, CellStatistics& cells) {
    if (!beginCells(
            slabs.size(), cellSize, [&](std::size_t k) { return slabs[k].count; }, cells))
        return;
    const std::uint32_t samples = static_cast<std::uint32_t>(cellSize * cellSize * cellSize);
    for (int cell = cells.firstCell; cell <= cells.lastCell; ++cell) {
        const auto i = static_cast<std::size_t>(cell);
        const auto ofCell = slabs.subspan(i, static_cast<std::size_t>(cellSize));
        // Deviations are taken from one slab's mean, so that equal slabs have that mean to the last bit and no spread.
        const auto filled =
            std::find_if(ofCell.begin(), ofCell.end(), [](const SlabMoments& slab) { return slab.count > 0; });
        const double near = filled == ofCell.end() ? 0.0 : filled->mean;
        std::uint32_t count = 0;
        double sum = 0.0, deviations = 0.0;
        for (const SlabMoments& slab : ofCell) {
            count += slab.count;
            sum += slab.count * (slab.mean - near);
        }
        if (2 * count < samples) {
            if (cell > cells.firstCell) {
                cells.means[i] = cells.means[i - 1];
                cells.variances[i] = cells.variances[i - 1];
            }
            continue;
        }
        const double mean = near + sum / count;
        for (const SlabMoments& slab : ofCell)
            deviations += slab.squaredDeviations + slab.count * (slab.mean - mean) * (slab.mean - mean);
        cells.means[i] = mean;
        cells.variances[i] = deviations / count;
        cells.complete[i] = 1;
    }
}

void cellsFrom(const TubeSlabs& tube, int cellSize, CellStatistics& cells) {
    std::visit(
        [&](const auto& slabs) {
            if constexpr (std::is_same_v<std::decay_t<decltype(slabs)>, std::vector<SlabMoments>>)
                cellsFrom(std::span<const SlabMoments>(slabs), cellSize, cells);
            else
                cellsFrom(slabs, cellSize, tube.whiteLevel, cells);
        },
        tube.slabs);
}

void cellsFrom(std::span<const float> slabMeans, int first, int cellSize, CellStatistics& cells) {
    const int slabs = static_cast<int>(slabMeans.size());
    cells.anyData = slabs > 0;
    cells.firstCell = first;
    cells.lastCell = first + slabs - cellSize;
    const auto count = static_cast<std::size_t>(std::max(0, cells.lastCell + 1));
    cells.variances.clear();
    cells.means.assign(count, 0.0);
    cells.complete.assign(count, 1);
    std::fill_n(cells.complete.begin(), std::min(count, static_cast<std::size_t>(first)), std::uint8_t{0});
    std::array<double, batch> sums;
    inBatches(cells, [&](std::size_t begin, std::size_t cellCount) {
        addSlabs(slabMeans.data(), begin - static_cast<std::size_t>(first), cellCount, cellSize, sums);
        for (std::size_t i = 0; i < cellCount; ++i) cells.means[begin + i] = sums[i] / cellSize;
    });
}

}  // namespace echolucent
