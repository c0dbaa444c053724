// Where the tube cores lie: an equally spaced grid of axes across the view (Petersch 2005, section 4.1).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/geometry.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// How many tube cores there are and how far apart. The ranges of the numbers stand in methodParameters().
struct TubeGrid {
    int columns = 15;      ///< tube cores across the view's right axis (Petersch 2005, 6.1)
    int rows = 15;         ///< tube cores across the view's down axis
    double spacing = 0.0;  ///< units (the volume's smallest spacing) between tube cores; where it is 0, the grid covers
                           ///< the volume, or the view's box (13 in the paper's 199x197x199)
    /// Tube cores that are never placed, by index (row * columns + column): ascending, each once, within the grid
    /// (problemOf()). The method runs as if the grid had not held them; the others keep columns, rows and indices.
    std::vector<int> withoutTubes{};
    friend bool operator==(const TubeGrid&, const TubeGrid&) = default;
};

/// The axis of one tube core.
struct TubeAxis {
    int column = 0;         ///< u: index along the view's right axis
    int row = 0;            ///< v: index along the view's down axis
    Vec3 pointMm{0, 0, 0};  ///< a point of the axis, grid mm: in the plane across the view through the centre (of the
                            ///< view's box, where it has one)
    Vec3 directionMm{0, 0, 1};  ///< unit, grid mm: the view's forward
    /// Where the picture begins on the axis, voxel index space: entry into the volume's box or, if later, into the
    /// view's box, the near cut or the cut surface. It is not set where the axis misses what the picture shows, and of
    /// a tube core that is never placed.
    std::optional<Vec3> entryVoxel;
    /// From there to where it leaves the box or, from behind, the cut surface, units; set where entryVoxel is.
    std::optional<double> lengthUnits;
};

/// Units between tube cores along the view's right and down axes: grid.spacing, or where that is 0 the extent of
/// the volume's box across the unturned view of that beam axis, shared among the tube cores, whole units, at least a
/// cell. It does not change while the view turns. Of a view's box it is the extent of the side that most faces the
/// view.
[[nodiscard]] std::array<double, 2> tubeSpacingUnits(const VolumeGeometry& geometry, const Viewpoint& view,
                                                     const TubeGrid& grid, int cellSize);

/// Whether the tubes' samples can lie on voxel centres, so that nothing is interpolated: the view's axes are grid axes
/// and the spacing is the same along all three (to a millionth).
[[nodiscard]] bool tubesLieOnVoxels(const VolumeGeometry& geometry, const Viewpoint& view);

/// The axes, row-major (index = row * columns + column). They pass through the centre of the volume, or of the view's
/// box where it has one, +
/// (column - (columns - 1) / 2) * spacing * right + (row - (rows - 1) / 2) * spacing * down; where tubesLieOnVoxels()
/// they are moved, by less than a voxel, so that the samples of a cell are voxels.
[[nodiscard]] std::vector<TubeAxis> tubeAxes(const VolumeGeometry& geometry, const Viewpoint& view,
                                             const TubeGrid& grid, int cellSize);

/// Whether the tube core of an index is never placed (TubeGrid::withoutTubes).
[[nodiscard]] bool isNeverPlaced(const TubeGrid& grid, std::size_t tube);

}  // namespace echolucent
