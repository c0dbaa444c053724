// Distances to the next brick where data may end. Only there a sample must read the presence of data.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/ray_caster/packed/packed_presence.h"
#include "processing/volume/bit_grid.h"
#include "processing/volume/filled_volume.h"
#include "processing/volume/row_marks.h"

namespace echolucent::ray_casting {

/// A grid of bricks of 4 x 4 x 4 cubes (see packed_order.h). Brick b holds cubes 4b ... 4b+3 on each axis. The bricks
/// are smaller than those of empty space, so that few samples read the presence of data.
class BorderSpace {
public:
    static constexpr int edge = 4, shift = 2;
    /// The largest distance; farther bricks have it too.
    static constexpr std::uint8_t farthest = 16;

    explicit BorderSpace(const PackedPresence& presence);
    /// Follows a changed presence. Only the marked rows of voxels may have changed.
    void follow(const PackedPresence& presence, const RowMarks& rows);

    [[nodiscard]] const std::array<std::int64_t, 3>& size() const { return m_size; }
    /// One number a brick, x fastest: 0 if the presence around the brick's cubes is below PresenceUse::allFrom
    /// anywhere. Else d, if no brick less than d away on every axis has distance 0. Empty if all voxels carry data.
    [[nodiscard]] const std::vector<std::uint8_t>& distances() const { return m_distances; }

private:
    bool findBorders(const PackedPresence& presence, const RowMarks& rows);
    void findDistances();

    std::array<std::int64_t, 3> m_size{};
    BitGrid m_borders;  ///< bricks of distance 0
    std::vector<std::uint8_t> m_distances;
};

}  // namespace echolucent::ray_casting
