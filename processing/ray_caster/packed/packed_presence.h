// The presence of data in the kernel's order.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "processing/parallel.h"
#include "processing/ray_caster/packed/packed_order.h"
#include "processing/volume/row_marks.h"
#include "processing/volume/volume.h"

namespace echolucent::ray_casting {

/// FilledVolume::presence, packed like bytes.
class PackedPresence {
public:
    explicit PackedPresence(const Volume& volume);

    /// Follows another cut of the same scan. `masked` are the rows that the new cut marks otherwise
    /// (rowsMaskedOtherwise()). Returns the rows whose presence may have changed.
    RowMarks follow(const Volume& volume, const RowMarks& masked);

    [[nodiscard]] const PackedOrder& order() const { return m_order; }
    /// Null if all voxels carry data.
    [[nodiscard]] const std::uint8_t* cubes() const { return m_cubes.get(); }

    /// Bricks [first, last) of a row of bricks along x, with their folded presence.
    struct FoldedBricks {
        std::int64_t first, last, y, z;
        /// Two bytes for each x of cubes. Both folded together are the fold of all voxels at the cubes' lower x that
        /// samples in the row of bricks read.
        const std::vector<std::uint8_t>& columns;
    };
    /// Folds the presence that samples read, in each brick with samples that may read a marked voxel. It visits rows of
    /// bricks in parallel. cubes() must not be null.
    template <typename Fold, typename Visit>
    void foldBricks(std::int64_t edge, const std::array<std::int64_t, 3>& bricks, const RowMarks& rows,
                    const Fold& fold, const Visit& visit) const;

private:
    void pack(const Volume& volume, const RowMarks& rows);

    PackedOrder m_order;
    std::unique_ptr<std::uint8_t[]> m_cubes;
};

template <typename Fold, typename Visit>
void PackedPresence::foldBricks(std::int64_t edge, const std::array<std::int64_t, 3>& bricks, const RowMarks& rows,
                                const Fold& fold, const Visit& visit) const {
    const std::int64_t bytes = (m_order.size[0] + 1) * voxelsPerCube;
    parallelFor(LoopRange<std::int64_t>(0, bricks[1] * bricks[2]), [&](const auto& range) {
        std::vector<std::uint8_t> columns(static_cast<std::size_t>(bytes));
        for (std::int64_t brick = range.begin(); brick < range.end(); ++brick) {
            const std::int64_t y = brick % bricks[1] * edge, z = brick / bricks[1] * edge;
            // The brick's cubes read voxels from one before its first to its last.
            const RowPart part = rows.partWithin({y - cubeShift, y + edge}, {z - cubeShift, z + edge});
            if (!part.any()) continue;
            const FoldedBricks folded{part.first / edge, std::min(part.last / edge + 1, bricks[0]), brick % bricks[1],
                                      brick / bricks[1], columns};
            const std::int64_t begin = folded.first * edge * voxelsPerCube,
                               end = std::min(folded.last * edge * voxelsPerCube + voxelsPerCube, bytes);
            const std::int64_t endRow = std::min(y + edge, m_order.size[1] + 1);
            const std::int64_t endSlice = std::min(z + edge + 1, m_order.size[2] + 1);
            const auto from = [&](std::int64_t row, std::int64_t slice) {
                return m_cubes.get() + m_order.first(row, slice);
            };
            std::copy(from(y, z) + begin, from(y, z) + end, columns.begin() + begin);
            const auto add = [&](std::int64_t row, std::int64_t slice) {
                const std::uint8_t* bytesOfRow = from(row, slice);
                std::uint8_t* __restrict to = columns.data();
                for (std::int64_t i = begin; i < end; ++i) to[i] = fold(to[i], bytesOfRow[i]);
            };
            for (std::int64_t slice = z; slice < endSlice; ++slice) {
                // A row of cubes holds two rows of voxels. So every other row of cubes, and the last, hold all.
                for (std::int64_t row = y; row < endRow - 1; row += 2) add(row, slice);
                add(endRow - 1, slice);
            }
            visit(folded);
        }
    });
}

}  // namespace echolucent::ray_casting
