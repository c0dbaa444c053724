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

/// How many tube cores there are and how far apart. methodParameters() holds the ranges.
struct TubeGrid {
    int columns = 15;      ///< tube cores across the view's right axis (Petersch 2005, 6.1)
    int rows = 15;         ///< tube cores across the view's down axis
    double spacing = 0.0;  ///< units (the volume's smallest spacing) between tube cores; if 0, the grid covers the
                           ///< volume or the view's box (13 in the paper's 199x197x199)
    /// Tube cores that are never placed: indices row * columns + column, ascending, each once, within the grid
    /// (problemOf()). The method runs as if the grid did not hold them. The other tube cores keep their columns, rows
    /// and indices.
    std::vector<int> withoutTubes{};
    friend bool operator==(const TubeGrid&, const TubeGrid&) = default;
};

/// The axis of one tube core.
struct TubeAxis {
    int column = 0;         ///< u: index along the view's right axis
    int row = 0;            ///< v: index along the view's down axis
    Vec3 pointMm{0, 0, 0};  ///< a point of the axis, grid mm: in the plane across the view through the centre of the
                            ///< view's box, if it has one, else of the volume
    Vec3 directionMm{0, 0, 1};  ///< unit, grid mm: the view's forward
    /// Where the picture begins on the axis, voxel index space: the entry into the volume's box or, if later, into the
    /// view's box, or behind the flat front or the cut surface. Not set if the axis misses the picture, or if the tube
    /// core is never placed.
    std::optional<Vec3> entryVoxel;
    /// Units from entryVoxel to the place where the picture ends on the axis: where the axis leaves the volume's box or
    /// the view's box, or comes out of the front again. Set if entryVoxel is set.
    std::optional<double> lengthUnits;
};

/// Units between tube cores along the view's right and down axes: grid.spacing or, if that is 0, an equal share of the
/// volume box's extent in whole units, at least a cell. The extent is taken across the unturned view along the view's
/// beam axis, so it stays while the view turns. If the view has a box, the extent is that of the box's side that most
/// faces the view.
[[nodiscard]] std::array<double, 2> tubeSpacingUnits(const VolumeGeometry& geometry, const Viewpoint& view,
                                                     const TubeGrid& grid, int cellSize);

/// Whether samples can lie on voxel centres, so that nothing is interpolated. The view's axes must be grid axes, and
/// the spacing the same along all three (to a millionth).
[[nodiscard]] bool tubesLieOnVoxels(const VolumeGeometry& geometry, const Viewpoint& view);

/// The axes, row-major (index = row * columns + column). They pass through centre + (column - (columns - 1) / 2) *
/// spacing * right + (row - (rows - 1) / 2) * spacing * down. The centre is that of the view's box, if it has one, else
/// of the volume. If tubesLieOnVoxels(), the axes are moved by less than a voxel, so that the samples of a cell are
/// voxels.
[[nodiscard]] std::vector<TubeAxis> tubeAxes(const VolumeGeometry& geometry, const Viewpoint& view,
                                             const TubeGrid& grid, int cellSize);

/// Whether the tube core of this index is never placed (TubeGrid::withoutTubes).
[[nodiscard]] bool isNeverPlaced(const TubeGrid& grid, std::size_t tube);

}  // namespace echolucent
