// Bricks of cubes. A brick tells about many samples at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "processing/parallel.h"
#include "processing/ray_caster/packed/packed_order.h"
#include "processing/volume/volume.h"

namespace echolucent::ray_casting {

/// A grid of bricks of 8 x 8 x 8 cubes (see packed_order.h). Brick b holds cubes 8b ... 8b+7 on each axis.
struct BrickGrid {
    static constexpr int edge = 8, shift = 3;
    std::array<std::int64_t, 3> size{};

    explicit BrickGrid(const VolumeGeometry& geometry) {
        // Samples lie in cubes 0 ... size.
        for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = geometry.size[axis] / edge + 1;
    }
    [[nodiscard]] std::int64_t count() const { return size[0] * size[1] * size[2]; }
    [[nodiscard]] std::size_t offset(std::int64_t x, std::int64_t y, std::int64_t z) const {
        return static_cast<std::size_t>(x + size[0] * (y + size[1] * z));
    }
};

/// The voxels around the cubes of a brick, on one axis: [first, second).
inline std::pair<std::int64_t, std::int64_t> voxelsOf(std::int64_t brick, std::int64_t size) {
    const std::int64_t first = brick * BrickGrid::edge - cubeShift;
    return {std::clamp<std::int64_t>(first, 0, size - 1), std::min(size, first + BrickGrid::edge + 1)};
}

/// Calls visit(offset of the first voxel, count) for each row of voxels around the cubes of a brick.
template <typename Visit>
void forEachRowOf(const VolumeGeometry& geometry, const std::array<std::int64_t, 3>& brick, const Visit& visit) {
    const auto [x, endX] = voxelsOf(brick[0], geometry.size[0]);
    const auto [y, endY] = voxelsOf(brick[1], geometry.size[1]);
    const auto [z, endZ] = voxelsOf(brick[2], geometry.size[2]);
    for (std::int64_t slice = z; slice < endZ; ++slice)
        for (std::int64_t row = y; row < endY; ++row) visit(geometry.offset(x, row, slice), endX - x);
}

/// Calls visit(brick, its offset) for all bricks.
template <typename Visit>
void forEachBrick(const BrickGrid& grid, const Visit& visit) {
    const std::int64_t columns = grid.size[0], rows = grid.size[1];
    parallelFor(LoopRange<std::int64_t>(0, rows * grid.size[2]), [&](const auto& range) {
        for (std::int64_t row = range.begin(); row < range.end(); ++row)
            for (std::int64_t x = 0; x < columns; ++x)
                visit(std::array<std::int64_t, 3>{x, row % rows, row / rows},
                      static_cast<std::size_t>(row * columns + x));
    });
}

}  // namespace echolucent::ray_casting
