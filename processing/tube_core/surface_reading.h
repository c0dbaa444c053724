// Reads I_L, I_H, the largest prior mean and the slope around a surface (Petersch 2005, section 4.1 and eq. 8).
#pragma once

#include <optional>
#include <span>

#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/rules/surface_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

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
