#include "processing/ray_caster/packed/border_space.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>

namespace echolucent::ray_casting {

namespace {

/// Samples lie in cubes 0 ... size.
std::array<std::int64_t, 3> bricksOver(const std::array<std::int64_t, 3>& size) {
    return {size[0] / BorderSpace::edge + 1, size[1] / BorderSpace::edge + 1, size[2] / BorderSpace::edge + 1};
}

}  // namespace

BorderSpace::BorderSpace(const PackedPresence& presence)
    : m_size(bricksOver(presence.order().size)), m_borders(m_size) {
    follow(presence, RowMarks(presence.order().size, true));
}

void BorderSpace::follow(const PackedPresence& presence, const RowMarks& rows) {
    if (presence.cubes() == nullptr) {
        m_distances.clear();
        m_borders = BitGrid(m_size);
        return;
    }
    if (findBorders(presence, rows) || m_distances.empty()) findDistances();
}

/// Whether any brick became a border or stopped being one.
bool BorderSpace::findBorders(const PackedPresence& presence, const RowMarks& rows) {
    const std::int64_t lastCube = presence.order().size[0];
    std::atomic<bool> changed = false;
    const auto least = [](std::uint8_t a, std::uint8_t b) { return std::min(a, b); };
    presence.foldBricks(edge, m_size, rows, least, [&](const PackedPresence::FoldedBricks& bricks) {
        std::uint64_t* row = m_borders.row(bricks.y, bricks.z);
        for (std::int64_t x = bricks.first; x < bricks.last; ++x) {
            const auto first = bricks.columns.begin() + x * edge * voxelsPerCube;
            const auto end = bricks.columns.begin() + (std::min(x * edge + edge, lastCube) + 1) * voxelsPerCube;
            const bool borders = std::any_of(first, end, [](auto here) { return here < PresenceUse::allFrom; });
            const std::uint64_t bit = std::uint64_t{1} << (x % 64), before = row[x / 64];
            row[x / 64] = borders ? before | bit : before & ~bit;
            if (row[x / 64] != before) changed = true;
        }
    });
    return changed;
}

namespace {

/// Sets the bits beside each set bit of a row.
void widenAlongRow(std::uint64_t* row, std::int64_t words) {
    std::uint64_t before = 0;
    for (std::int64_t i = 0; i < words; ++i) {
        const std::uint64_t here = row[i], after = i + 1 < words ? row[i + 1] : 0;
        row[i] = here | here << 1 | here >> 1 | before >> 63 | after << 63;
        before = here;
    }
}

/// Adds to each row the rows beside it along y or z. Rows beyond the grid are empty.
BitGrid widenedAcross(const BitGrid& grid, std::int64_t downwards, std::int64_t behind) {
    BitGrid wider = grid;
    const auto& size = grid.size();
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (const std::int64_t side : {-1, 1}) {
                const std::int64_t otherY = y + side * downwards, otherZ = z + side * behind;
                if (otherY < 0 || otherY >= size[1] || otherZ < 0 || otherZ >= size[2]) continue;
                const std::uint64_t* other = grid.row(otherY, otherZ);
                std::uint64_t* row = wider.row(y, z);
                for (std::int64_t i = 0; i < grid.words(); ++i) row[i] |= other[i];
            }
    return wider;
}

}  // namespace

/// The borders grow by one brick on every axis in each round. A brick's distance is the round that reaches it.
void BorderSpace::findDistances() {
    BitGrid reached = m_borders;
    m_distances.assign(static_cast<std::size_t>(m_size[0] * m_size[1] * m_size[2]), farthest);
    const auto distance = [&](std::int64_t x, std::int64_t y, std::int64_t z) -> std::uint8_t& {
        return m_distances[static_cast<std::size_t>(x + m_size[0] * (y + m_size[1] * z))];
    };
    for (std::int64_t z = 0; z < m_size[2]; ++z)
        for (std::int64_t y = 0; y < m_size[1]; ++y)
            for (std::int64_t x = 0; x < m_size[0]; ++x)
                if (reached.at(x, y, z)) distance(x, y, z) = 0;
    for (std::uint8_t round = 1; round < farthest; ++round) {
        BitGrid wider = reached;
        for (std::int64_t z = 0; z < m_size[2]; ++z)
            for (std::int64_t y = 0; y < m_size[1]; ++y) widenAlongRow(wider.row(y, z), wider.words());
        wider = widenedAcross(widenedAcross(wider, 1, 0), 0, 1);
        bool any = false;
        for (std::int64_t z = 0; z < m_size[2]; ++z)
            for (std::int64_t y = 0; y < m_size[1]; ++y)
                for (std::int64_t i = 0; i < wider.words(); ++i) {
                    std::uint64_t added = wider.row(y, z)[i] & ~reached.row(y, z)[i];
                    for (; added != 0; added &= added - 1) {
                        const std::int64_t x = i * 64 + std::countr_zero(added);
                        if (x >= m_size[0]) break;  // beyond the row's end
                        distance(x, y, z) = round;
                        any = true;
                    }
                }
        if (!any) return;
        reached = std::move(wider);
    }
}

}  // namespace echolucent::ray_casting
