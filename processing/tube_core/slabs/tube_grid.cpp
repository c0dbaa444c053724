#include "processing/tube_core/slabs/tube_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "processing/viewpoint/shown_stretch.h"

namespace echolucent {

namespace {

/// Tolerance for positions that are whole numbers but for rounding.
constexpr double gridRounding = 1e-9;

bool isGridAxis(const Vec3& direction) {
    return std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]) == 1.0;
}

/// Moves the components across `forward`, so that a cell of `cellSize` samples around them lies on voxel centres.
Vec3 onVoxelCentres(const Vec3& voxel, const Vec3& forward, int cellSize) {
    const double half = cellSize % 2 == 1 ? 0.0 : 0.5;
    Vec3 moved = voxel;
    for (int axis = 0; axis < 3; ++axis)
        if (forward[axis] == 0.0) moved[axis] = std::floor(voxel[axis] - half + 0.5 + gridRounding) + half;
    return moved;
}

/// The box that the tube cores cover: the view's box or, if it has none, the volume's.
OrientedBox coveredBox(const VolumeGeometry& geometry, const Viewpoint& view) {
    return view.box.value_or(orientedBoxOf(DataBox(geometry)));
}

/// The box's axes in the order of the frame's axes to which they are nearest. Their forward is across the side that
/// faces the view, whichever way it points.
ViewFrame straightOnto(const OrientedBox& box, const ViewFrame& frame) {
    std::vector<Vec3> left{box.axes.right, box.axes.down, box.axes.forward};
    const auto takeNearest = [&](const Vec3& direction) {
        const auto nearest =
            std::ranges::max_element(left, {}, [&](const Vec3& axis) { return std::abs(axis.dot(direction)); });
        const Vec3 taken = *nearest;
        left.erase(nearest);
        return taken;
    };
    const Vec3 forward = takeNearest(frame.forward), right = takeNearest(frame.right);
    return {right, left.front(), forward};
}

}  // namespace

std::array<double, 2> tubeSpacingUnits(const VolumeGeometry& geometry, const Viewpoint& view, const TubeGrid& grid,
                                       int cellSize) {
    if (grid.spacing > 0.0) return {grid.spacing, grid.spacing};
    const OrientedBox box = coveredBox(geometry, view);
    const ViewFrame straight =
        view.box ? straightOnto(*view.box, frameOf(view)) : frameOf(Viewpoint{.beamAxis = view.beamAxis});
    const auto shared = [&](const Vec3& lateral, int count) {
        const double extent = box.extentAlong(lateral) / geometry.unit();
        return std::max(static_cast<double>(cellSize), std::floor(extent / count + gridRounding));
    };
    return {shared(straight.right, grid.columns), shared(straight.down, grid.rows)};
}

bool tubesLieOnVoxels(const VolumeGeometry& geometry, const Viewpoint& view) {
    const double unit = geometry.unit();
    for (int axis = 0; axis < 3; ++axis)
        if (geometry.spacing[axis] > unit * (1.0 + 1e-6)) return false;
    const ViewFrame frame = frameOf(view);
    return isGridAxis(frame.right) && isGridAxis(frame.down) && isGridAxis(frame.forward);
}

std::vector<TubeAxis> tubeAxes(const VolumeGeometry& geometry, const Viewpoint& view, const TubeGrid& grid,
                               int cellSize) {
    const ViewFrame frame = frameOf(view);
    const auto [acrossUnits, downUnits] = tubeSpacingUnits(geometry, view, grid, cellSize);
    const double unit = geometry.unit();
    const ShownStretches shown(view, geometry);
    const bool onVoxels = tubesLieOnVoxels(geometry, view);
    const Vec3 centre = view.box ? view.box->centreMm : geometry.centreMm();

    std::vector<TubeAxis> axes;
    axes.reserve(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            TubeAxis axis{column, row, {}, frame.forward, {}, {}};
            const double across = (column - (grid.columns - 1) / 2.0) * acrossUnits * unit;
            const double down = (row - (grid.rows - 1) / 2.0) * downUnits * unit;
            axis.pointMm = centre + frame.right * across + frame.down * down;
            if (onVoxels)
                axis.pointMm = geometry.gridMmFromVoxel(
                    onVoxelCentres(geometry.voxelFromGridMm(axis.pointMm), frame.forward, cellSize));
            const auto stretch = isNeverPlaced(grid, axes.size()) ? std::nullopt : shown.of(axis.pointMm);
            if (stretch) {
                axis.entryVoxel = geometry.voxelFromGridMm(axis.pointMm + axis.directionMm * stretch->begin);
                axis.lengthUnits = (stretch->end - stretch->begin) / unit;
            }
            axes.push_back(axis);
        }
    return axes;
}

bool isNeverPlaced(const TubeGrid& grid, std::size_t tube) {
    return std::ranges::binary_search(grid.withoutTubes, static_cast<std::int64_t>(tube));
}

}  // namespace echolucent
