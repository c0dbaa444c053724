// The order in which the kernel reads what belongs to voxels.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace echolucent::ray_casting {

/// Cube (x,y,z) of the packed order is the space between voxels x-1 and x, y-1 and y, z-1 and z; voxels beyond the grid
/// repeat its outermost ones. So a position p in voxels lies in cube floor(p) + 1, for all p in the volume's box. Each
/// axis has size + 2 cubes; the last one only ends the cube before it.
inline constexpr int cubeShift = 1;
inline constexpr int extraCubes = 2;

/// Of each cube the two voxels at its lower x and z are stored, that of lower y first: twice the volume's memory. So
/// one load of four bytes (8 bits) or eight bytes (16 bits) brings the four voxels of a cube in one slice, of floats
/// two.
inline constexpr int voxelsPerCube = 2;

/// Rows of cubes are filled up to a multiple of this, so that strides of rows and slices fit words when divided by it.
inline constexpr int rowAlignment = 16;

/// Rows and slices of cubes over a grid of voxels.
struct PackedOrder {
    std::array<std::int64_t, 3> size;                   ///< voxels
    std::int64_t rowStride, rows, sliceStride, slices;  ///< cubes

    explicit PackedOrder(const std::array<std::int64_t, 3>& voxels)
        : size(voxels),
          rowStride((voxels[0] + extraCubes + rowAlignment - 1) / rowAlignment * rowAlignment),
          rows(voxels[1] + extraCubes),
          sliceStride(rowStride * rows),
          slices(voxels[2] + extraCubes + 1) {}  // the last is read with weight 0 by what is rounded up

    [[nodiscard]] std::size_t stored() const { return static_cast<std::size_t>(sliceStride * slices * voxelsPerCube); }
    /// Where the first cube of a row is stored.
    [[nodiscard]] std::size_t first(std::int64_t row, std::int64_t slice) const {
        return static_cast<std::size_t>((slice * sliceStride + row * rowStride) * voxelsPerCube);
    }
    /// The rows (axis 1) or slices (axis 2) of voxels at the lower and the upper side of a row or slice of cubes.
    [[nodiscard]] std::int64_t lower(std::int64_t cube, std::size_t axis) const {
        return std::clamp<std::int64_t>(cube - cubeShift, 0, size[axis] - 1);
    }
    [[nodiscard]] std::int64_t upper(std::int64_t cube, std::size_t axis) const { return lower(cube + 1, axis); }
};

/// Writes what holds voxels [first, last) of one row of cubes, from the two rows of voxels whose voxels each cube
/// holds.
template <typename Out, typename Voxel, typename Convert>
void packRow(const PackedOrder& order, const Voxel* upper, const Voxel* lower, std::int64_t first, std::int64_t last,
             Out* __restrict out, const Convert& convert) {
    const std::int64_t size = order.size[0];
    const auto write = [&](std::int64_t cube, std::int64_t x) {
        out[cube * voxelsPerCube] = convert(upper[x]);
        out[cube * voxelsPerCube + 1] = convert(lower[x]);
    };
    if (first == 0) write(0, 0);
    for (std::int64_t x = first; x < last; ++x) {
        out[(x + cubeShift) * voxelsPerCube] = convert(upper[x]);
        out[(x + cubeShift) * voxelsPerCube + 1] = convert(lower[x]);
    }
    // The row's rest is read by no sample.
    for (std::int64_t cube = size + 1; cube < order.rowStride && last == size; ++cube) write(cube, size - 1);
}

}  // namespace echolucent::ray_casting
