#include "processing/ray_caster/packed/packed_presence.h"

#include "processing/volume/presence.h"

namespace echolucent::ray_casting {

PackedPresence::PackedPresence(const Volume& volume) : m_order(volume.geometry().size) {
    if (!lacksData(volume)) return;
    m_cubes = std::make_unique_for_overwrite<std::uint8_t[]>(m_order.stored());
    pack(volume, RowMarks(m_order.size, true));
}

RowMarks PackedPresence::follow(const Volume& volume, const RowMarks& masked) {
    if (!lacksData(volume)) {
        const bool lacked = m_cubes != nullptr;
        m_cubes.reset();
        return RowMarks(m_order.size, lacked);
    }
    if (!m_cubes) {
        m_cubes = std::make_unique_for_overwrite<std::uint8_t[]>(m_order.stored());
        parallelFor(LoopRange<std::size_t>(0, m_order.stored(), 1 << 18), [&](const auto& part) {
            std::fill(m_cubes.get() + part.begin(), m_cubes.get() + part.end(), std::uint8_t{255});
        });
    }
    RowMarks rows = masked.widened({presenceReach, presenceReach, presenceReach});
    pack(volume, rows);
    return rows;
}

void PackedPresence::pack(const Volume& volume, const RowMarks& rows) {
    // A changed row of voxels is also in the row of cubes beside it.
    makePresence(volume, rows.widened({0, 1, 0}), [&](std::int64_t z, const std::uint8_t* voxels) {
        const auto rowOf = [&](std::int64_t y) { return voxels + m_order.size[0] * y; };
        // The outermost slices repeat.
        for (std::int64_t slice = z == 0 ? 0 : z + cubeShift;
             slice < (z + 1 == m_order.size[2] ? m_order.slices : z + cubeShift + 1); ++slice)
            for (std::int64_t row = 0; row < m_order.rows; ++row) {
                const std::int64_t upper = m_order.lower(row, 1), lower = m_order.upper(row, 1);
                const RowPart part = rows.at(upper, z).joined(rows.at(lower, z));
                if (!part.any()) continue;
                packRow(m_order, rowOf(upper), rowOf(lower), part.first, part.last,
                        m_cubes.get() + m_order.first(row, slice), [](std::uint8_t presence) { return presence; });
            }
    });
}

}  // namespace echolucent::ray_casting
