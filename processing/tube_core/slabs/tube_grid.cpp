#include "processing/tube_core/slabs/tube_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

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

/// A part of an axis, in mm from the axis's point.
using Chord = CutSurface::Stretch;

/// The box that the tube cores cover: the view's box or, if it has none, the volume's.
OrientedBox coveredBox(const VolumeGeometry& geometry, const Viewpoint& view) {
    return view.box.value_or(orientedBoxOf(DataBox(geometry)));
}

/// The part of a chord behind all faces; no value if nothing is left.
std::optional<Chord> chordWithin(const std::vector<CuttingFace>& faces, const Vec3& point, const Vec3& direction,
                                 Chord chord) {
    for (const CuttingFace& face : faces) {
        const double behind = face.inwards.dot(point) - face.depthMm, slope = face.inwards.dot(direction);
        if (std::abs(slope) < gridRounding) {
            if (behind < 0.0) return std::nullopt;
            continue;
        }
        const double crossing = -behind / slope;
        if (slope > 0.0)
            chord.begin = std::max(chord.begin, crossing);
        else
            chord.end = std::min(chord.end, crossing);
    }
    if (!(chord.end > chord.begin)) return std::nullopt;
    return chord;
}

/// The part of a line inside the volume's box and behind a depth along the line; no value if there is none.
std::optional<Chord> chordInBox(const VolumeGeometry& geometry, const Vec3& point, const Vec3& direction,
                                double nearDepth) {
    Chord chord{nearDepth - direction.dot(point), std::numeric_limits<double>::infinity()};
    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (point[axis] < low[axis] || point[axis] > high[axis]) return std::nullopt;
            continue;
        }
        const double atLow = (low[axis] - point[axis]) / direction[axis];
        const double atHigh = (high[axis] - point[axis]) / direction[axis];
        chord.begin = std::max(chord.begin, std::min(atLow, atHigh));
        chord.end = std::min(chord.end, std::max(atLow, atHigh));
    }
    if (!(chord.end > chord.begin)) return std::nullopt;
    return chord;
}

/// The part of chordInBox() that is also behind the cutting faces and the cut surface; no value if there is none.
std::optional<Chord> chordOf(const VolumeGeometry& geometry, const std::vector<CuttingFace>& faces, const Vec3& point,
                             const Viewpoint& view, double nearDepth) {
    const Vec3 direction = frameOf(view).forward;
    auto chord = chordInBox(geometry, point, direction, nearDepth);
    if (chord) chord = chordWithin(faces, point, direction, *chord);
    return chord && view.cutSurface ? view.cutSurface->firstLeft(point, direction, *chord) : chord;
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
    const double nearDepth = nearPlaneDepthMm(view, geometry);
    const bool onVoxels = tubesLieOnVoxels(geometry, view);
    const Vec3 centre = view.box ? view.box->centreMm : geometry.centreMm();
    auto faces = view.box ? facesThatCut(*view.box, geometry) : std::vector<CuttingFace>{};
    if (hasObliqueFront(view)) faces.push_back(cuttingFaceOf(*view.frontPlane, geometry));

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
            const auto chord = isNeverPlaced(grid, axes.size())
                                   ? std::nullopt
                                   : chordOf(geometry, faces, axis.pointMm, view, nearDepth);
            if (chord) {
                axis.entryVoxel = geometry.voxelFromGridMm(axis.pointMm + axis.directionMm * chord->begin);
                axis.lengthUnits = (chord->end - chord->begin) / unit;
            }
            axes.push_back(axis);
        }
    return axes;
}

bool isNeverPlaced(const TubeGrid& grid, std::size_t tube) {
    return std::ranges::binary_search(grid.withoutTubes, static_cast<std::int64_t>(tube));
}

}  // namespace echolucent
