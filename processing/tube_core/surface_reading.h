// Reads I_L, I_H, the largest prior mean and the slope around a surface (Petersch 2005, section 4.1 and eq. 8).
#pragma once

#include <optional>
#include <span>

#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/index_range.h"
#include "processing/tube_core/rules/surface_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// The cells that readSurface() reads. Of the prior cells only complete ones count.
struct SurfaceCells {
    IndexRange prior;                ///< the largest mean of eq. 8 is among them
    std::optional<IndexRange> near;  ///< cells of I_L; if empty, I_L is the mean of the prior cells
    IndexRange high;                 ///< I_H is the largest mean among them
    IndexRange slope;                ///< the slope is the difference of the ends' means over their distance
};
/// The cells for a surface at `surfaceCell` of a tube with the cells `tube`.
[[nodiscard]] SurfaceCells surfaceCells(const IndexRange& tube, int surfaceCell, const SurfaceRule& rule, int cellSize);

/// Reads the surface's intensities into the tube: surfaceCell, I_L, I_H, the largest prior mean, the slope (over fewer
/// units at the tube's ends) and the edge to noise. Cells at the surface mix fluid and tissue, and cells far in front
/// tell nothing of this surface. So `rule` says how far from the surface I_L and I_H are read. If there is no complete
/// prior cell, returns false and leaves `tube` as it is.
[[nodiscard]] bool readSurface(const CellStatistics& cells, int surfaceCell, const SurfaceRule& rule, int cellSize,
                               TubeCore& tube);

/// How far the cell means scatter, as a standard deviation. It is found from the median difference of neighbouring
/// cells that do not overlap, as if the noise were normal. So a wall among the cells, or a slow change, does not count.
/// `apart` is the distance of such cells, the cell size. No value for fewer than 2 `apart` cells.
[[nodiscard]] std::optional<double> scatterOf(std::span<const double> cellMeans, int apart);

}  // namespace echolucent
