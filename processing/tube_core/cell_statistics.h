// Mean and variance of the cells of a tube core (Petersch 2005, section 4.1). A cell is cellSize^3 samples; cells slide
// by one slab.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "processing/tube_core/slabs/tube_samples.h"
#include "processing/tube_core/slabs/tube_slabs.h"

namespace echolucent {

/// The largest cell edge, units: the sums of 32^3 voxels of 16 bits stay below 2^31.
inline constexpr int largestCellSize = 32;

/// The cells of one tube. Cell i holds the samples i ... i + cellSize - 1 along the tube.
struct CellStatistics {
    std::vector<double> means;           ///< normalised intensity
    std::vector<double> variances;       ///< of normalised intensity, divided by n: the interface indicating function;
                                         ///< empty if only means were asked for
    std::vector<std::uint8_t> complete;  ///< 1 if at least half of the samples are data; else 0, and the values repeat
                                         ///< the cell before (0 in the first cell)
    int firstCell = 0;                   ///< the first slab that is at least half data
    int lastCell = -1;  ///< the last cell that ends at such a slab; below firstCell if there is no cell
    bool anyData = false;
};

/// n^2 times the variance of n stored values, n sum(x^2) - sum(x)^2, without rounding.
[[nodiscard]] constexpr std::uint64_t scaledVariance(std::uint64_t count, std::uint64_t sum,
                                                     std::uint64_t sumOfSquares) {
    return count * sumOfSquares - sum * sum;
}

/// Cells from exact sums. `whiteLevel` is the stored value of normalised intensity 1.
void cellsFrom(const SlabSums& slabs, int cellSize, double whiteLevel, CellStatistics& cells);

/// Cells from single-precision moments. `whiteLevel` is the volume's white level times slabScale(), because the moments
/// are multiplied by slabScale() too. If all slabs are equal, the cells are equal to the last bit.
void cellsFrom(const SlabMeans& slabs, int cellSize, double whiteLevel, CellStatistics& cells);

/// Cells from slabs of any of these kinds.
void cellsFrom(const TubeSlabs& tube, int cellSize, CellStatistics& cells);

/// The cells' means alone. Every slab is complete; `first` is the index of the first one.
void cellsFrom(std::span<const float> slabMeans, int first, int cellSize, CellStatistics& cells);

/// Cells from moments: the deviations within slabs plus those of the slabs' means. No difference loses digits.
void cellsFrom(std::span<const SlabMoments> slabs, int cellSize, CellStatistics& cells);

}  // namespace echolucent
