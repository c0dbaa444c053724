// What a found surface says: I_L, I_H, the largest prior mean and the slope (Petersch 2005, section 4.1 and eq. 8).
#pragma once

#include <optional>
#include <span>

#include "processing/tube_core/cell_statistics.h"
#include "processing/tube_core/rules/surface_rule.h"
#include "processing/tube_core/tube_core.h"

namespace echolucent {

/// Reads the intensities around the detected cell into the tube: surfaceCell, I_L, I_H, the largest prior mean, the
/// slope (over fewer units at the tube's ends) and the edge to noise. On the ramp itself the mean is halfway between
/// fluid and tissue, and what lies far in front says nothing about this surface: so I_L and I_H are read as far from it
/// as the rule's reach says. Returns false, and leaves the tube as it is, where there is no complete prior cell.
[[nodiscard]] bool readSurface(const CellStatistics& cells, int surfaceCell, const SurfaceRule& rule, int cellSize,
                               TubeCore& tube);

/// How far the cell means scatter by themselves: the standard deviation that the median difference of neighbouring
/// cells that do not overlap would have in normal noise. A wall among the cells, or a slow change, does not count.
/// `apart` counts the places between two cells that do not overlap, which is the cell size. There is no value where
/// there are fewer than 2 `apart` cells.
[[nodiscard]] std::optional<double> scatterOf(std::span<const double> cellMeans, int apart);

}  // namespace echolucent
