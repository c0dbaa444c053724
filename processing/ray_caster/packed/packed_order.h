// The kernel's order for values of voxels.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace echolucent::ray_casting {

/// Cube (x,y,z) of the packed order is the space between voxels x-1 and x, y-1 and y, z-1 and z. Beyond the grid its
/// outermost voxels repeat. So a position p in voxels lies in cube floor(p) + 1, for all p in the volume's box. Each
/// axis has size + 2 cubes. The last cube only ends the cube before it.
inline constexpr int cubeShift = 1;
inline constexpr int extraCubes = 2;

/// A cube stores the two voxels at its lower x and z, the one of lower y first. That is twice the volume's memory. So
/// one load of four bytes (8 bits) or eight bytes (16 bits) gives the four voxels of a cube in one slice. Floats need
/// two loads.
inline constexpr int voxelsPerCube = 2;

/// Rows of cubes are padded to a multiple of this. Divided by it, strides of rows and slices fit into words.
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
          slices(voxels[2] + extraCubes + 1) {}  // places that are rounded up read the last slice, with weight 0

    [[nodiscard]] std::size_t stored() const { return static_cast<std::size_t>(sliceStride * slices * voxelsPerCube); }
    /// The index of a row's first stored value.
    [[nodiscard]] std::size_t first(std::int64_t row, std::int64_t slice) const {
        return static_cast<std::size_t>((slice * sliceStride + row * rowStride) * voxelsPerCube);
    }
    /// The row (axis 1) or slice (axis 2) of voxels on the lower or the upper side of a row or slice of cubes.
    [[nodiscard]] std::int64_t lower(std::int64_t cube, std::size_t axis) const {
        return std::clamp<std::int64_t>(cube - cubeShift, 0, size[axis] - 1);
    }
    [[nodiscard]] std::int64_t upper(std::int64_t cube, std::size_t axis) const { return lower(cube + 1, axis); }
};

/// Writes the cubes of voxels [first, last) into one row of cubes, from the two rows of voxels that the cubes store.
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
    // The last voxel repeats. Samples read one cube of it, and the padding behind never.
    for (std::int64_t cube = size + 1; cube < order.rowStride && last == size; ++cube) write(cube, size - 1);
}

}  // namespace echolucent::ray_casting
