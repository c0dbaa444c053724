#include "processing/ray_caster/border_space.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "processing/parallel.h"
#include "processing/ray_caster/packed_voxels.h"
#include "processing/volume/bit_grid.h"

namespace echolucent::ray_casting {

BorderSpace::BorderSpace(const VolumeGeometry& geometry, const std::optional<Volume>& presence) {
    // Samples lie in cubes 0 ... size.
    for (std::size_t axis = 0; axis < 3; ++axis) m_size[axis] = geometry.size[axis] / edge + 1;
    if (!presence) return;
    m_distances.assign(static_cast<std::size_t>(m_size[0] * m_size[1] * m_size[2]), farthest);
    findBorders(*presence);
    findDistances();
}

void BorderSpace::findBorders(const Volume& presence) {
    const VolumeGeometry& geometry = presence.geometry();
    const auto& bytes = std::get<std::vector<std::uint8_t>>(presence.voxels());
    // Each thread has slices of bricks of its own. The voxels of brick b are 4b - 1 ... 4b + 3.
    parallelFor(std::int64_t{0}, m_size[2], [&](std::int64_t brickZ) {
        const auto first = [](std::int64_t brick, std::int64_t size) {
            return std::clamp<std::int64_t>(brick * edge - cubeShift, 0, size - 1);
        };
        const auto last = [](std::int64_t brick, std::int64_t size) {
            return std::min<std::int64_t>(brick * edge + edge - cubeShift, size - 1);
        };
        // First what is least in each column of voxels of the bricks, whole rows at once.
        std::vector<std::uint8_t> least(static_cast<std::size_t>(geometry.size[0]));
        for (std::int64_t brickY = 0; brickY < m_size[1]; ++brickY) {
            std::ranges::fill(least, std::uint8_t{255});
            for (std::int64_t z = first(brickZ, geometry.size[2]); z <= last(brickZ, geometry.size[2]); ++z)
                for (std::int64_t y = first(brickY, geometry.size[1]); y <= last(brickY, geometry.size[1]); ++y) {
                    const std::uint8_t* row = bytes.data() + geometry.offset(0, y, z);
                    std::uint8_t* to = least.data();
                    for (std::int64_t x = 0; x < geometry.size[0]; ++x) to[x] = std::min(to[x], row[x]);
                }
            for (std::int64_t brickX = 0; brickX < m_size[0]; ++brickX) {
                const bool borders = std::any_of(least.begin() + first(brickX, geometry.size[0]),
                                                 least.begin() + last(brickX, geometry.size[0]) + 1,
                                                 [](std::uint8_t here) { return here < PresenceUse::allFrom; });
                if (borders)
                    m_distances[static_cast<std::size_t>(brickX + m_size[0] * (brickY + m_size[1] * brickZ))] = 0;
            }
        }
    });
}

namespace {

/// Adds what lies beside the bits of a row on it.
void widenAlongRow(std::uint64_t* row, std::int64_t words) {
    std::uint64_t before = 0;
    for (std::int64_t i = 0; i < words; ++i) {
        const std::uint64_t here = row[i], after = i + 1 < words ? row[i + 1] : 0;
        row[i] = here | here << 1 | here >> 1 | before >> 63 | after << 63;
        before = here;
    }
}

/// Adds the rows beside each row along y or z; rows beyond the grid hold nothing.
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

/// The borders grow by one brick on every axis, again and again; the round that reaches a brick is its distance.
void BorderSpace::findDistances() {
    BitGrid reached(m_size);
    const auto distance = [&](std::int64_t x, std::int64_t y, std::int64_t z) -> std::uint8_t& {
        return m_distances[static_cast<std::size_t>(x + m_size[0] * (y + m_size[1] * z))];
    };
    for (std::int64_t z = 0; z < m_size[2]; ++z)
        for (std::int64_t y = 0; y < m_size[1]; ++y)
            for (std::int64_t x = 0; x < m_size[0]; ++x)
                if (distance(x, y, z) == 0) reached.set(x, y, z);
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
