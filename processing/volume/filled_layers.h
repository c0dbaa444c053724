// Fills voxels beside known ones with means of their neighbours, layer by layer.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "processing/volume/bit_grid.h"
#include "processing/volume/geometry.h"
#include "processing/volume/grid_rows.h"

namespace echolucent {

namespace filled_layers {

constexpr std::int64_t rowsOfLayer = 64;  ///< rows that one thread takes at a time

/// Offsets of the row (y, z) and of the rows around it. Where a row would lie outside the grid, the nearest row of the
/// grid stands for it.
struct RowsAround {
    const VolumeGeometry& geometry;
    std::int64_t y, z;
    [[nodiscard]] std::int64_t offset(std::int64_t downwards, std::int64_t behind) const {
        return geometry.offset(0, std::clamp<std::int64_t>(y + downwards, 0, geometry.size[1] - 1),
                               std::clamp<std::int64_t>(z + behind, 0, geometry.size[2] - 1));
    }
};

/// A row and the eight around it: their voxels, and bits that mark the known ones.
template <typename Voxel>
struct NineRows {
    std::array<const Voxel*, 9> voxels{};
    std::array<const std::uint64_t*, 9> known{};
    std::int64_t columns, words;

    NineRows(const VolumeGeometry& geometry, std::span<const Voxel> from, const BitGrid& bits, std::int64_t y,
             std::int64_t z)
        : columns(geometry.size[0]), words(bits.words()) {
        const RowsAround around{geometry, y, z};
        std::size_t row = 0;
        for (std::int64_t behind = -1; behind <= 1; ++behind)
            for (std::int64_t downwards = -1; downwards <= 1; ++downwards) {
                const std::int64_t first = around.offset(downwards, behind);
                voxels[row] = from.data() + first;
                known[row++] = bits.row(first / columns % geometry.size[1], first / columns / geometry.size[1]);
            }
    }

    /// Visits each unknown voxel of the middle row with a known voxel among the 26 around it.
    /// `within` marks the voxels that are visited at all; null: any.
    template <typename Visit>
    void forEachBesideKnown(const std::uint64_t* within, const Visit& visit) const {
        const std::uint64_t* own = known[4];
        const auto any = [&](std::int64_t word) {
            std::uint64_t bits = 0;
            for (const std::uint64_t* row : known) bits |= row[word];
            return bits;
        };
        std::uint64_t before = 0, here = any(0);
        for (std::int64_t word = 0; word < words; ++word) {
            const std::uint64_t after = word + 1 < words ? any(word + 1) : 0;
            std::uint64_t beside = (here | here << 1 | here >> 1 | before >> 63 | after << 63) & ~own[word];
            if (within != nullptr) beside &= within[word];
            for (; beside != 0; beside &= beside - 1) {
                const std::int64_t x = word * 64 + std::countr_zero(beside);
                if (x < columns) visit(x);
            }
            before = here;
            here = after;
        }
    }

    /// The mean of the known voxels among the 27 around place `x`; whole numbers are rounded. At least one must be
    /// known.
    [[nodiscard]] Voxel meanAround(std::int64_t x) const {
        double sum = 0.0;
        int count = 0;
        const std::int64_t first = std::max<std::int64_t>(x - 1, 0), last = std::min(x + 1, columns - 1);
        for (std::size_t row = 0; row < voxels.size(); ++row)
            for (std::int64_t i = first; i <= last; ++i) {
                if ((known[row][i / 64] >> (i % 64) & 1) == 0) continue;
                sum += static_cast<double>(voxels[row][i]);
                ++count;
            }
        const double mean = sum / count;
        if constexpr (std::is_same_v<Voxel, float>) return static_cast<float>(mean);
        return static_cast<Voxel>(std::lround(mean));
    }
};

}  // namespace filled_layers

/// Fills `layers` layers of voxels around the known ones, each with means of the 26 neighbours that are known by then,
/// and makes them known. Whole numbers are rounded. `within` marks the voxels that may be filled; null: all. Calls
/// taken(offset) for each voxel that was filled, in several threads.
template <typename Voxel, typename Taken>
void fillLayers(const VolumeGeometry& geometry, std::span<Voxel> voxels, BitGrid& known, int layers, const Taken& taken,
                const BitGrid* within = nullptr) {
    for (int layer = 0; layer < layers; ++layer) {
        BitGrid grown = known;
        forEachRow(geometry.size, filled_layers::rowsOfLayer, [&](std::int64_t y, std::int64_t z) {
            const filled_layers::NineRows<Voxel> rows(geometry, voxels, known, y, z);
            const std::int64_t first = geometry.offset(0, y, z);
            rows.forEachBesideKnown(within == nullptr ? nullptr : within->row(y, z), [&](std::int64_t x) {
                voxels[static_cast<std::size_t>(first + x)] = rows.meanAround(x);
                taken(first + x);
                grown.set(x, y, z);
            });
        });
        known = std::move(grown);
    }
}

}  // namespace echolucent
