// Where rays may jump: regions that the curve makes transparent.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/ray_caster/packed/brick_grid.h"
#include "processing/ray_caster/packed/packed_gradients.h"
#include "processing/ray_caster/packed/packed_presence.h"
#include "processing/ray_caster/packed/transfer_table.h"
#include "processing/volume/filled_volume.h"
#include "processing/volume/row_marks.h"

namespace echolucent::ray_casting {

/// The smallest and largest intensity that the cubes of each brick may show. One pass over the volume finds them.
class BrickRanges {
public:
    /// `filled` is FilledVolume::voxels.
    BrickRanges(const Volume& filled, const PackedPresence& presence);
    /// Follows a presence of which the marked rows of voxels may be others than before.
    void follow(const PackedPresence& presence, const RowMarks& rows);

    [[nodiscard]] const BrickGrid& grid() const { return m_grid; }
    /// Table positions. In a brick without any data the lowest is above the highest.
    [[nodiscard]] const std::vector<float>& lowest() const { return m_lowest; }
    [[nodiscard]] const std::vector<float>& highest() const { return m_highest; }

private:
    BrickGrid m_grid;
    std::vector<float> m_lowestHeld, m_highestHeld;  ///< of the voxels that hold a value, whatever is present
    std::vector<float> m_lowest, m_highest;
};

/// How far away the next brick is that shows something.
class EmptySpace {
public:
    /// Distances beyond this one are not told apart.
    static constexpr int farthest = 8;

    explicit EmptySpace(const BrickGrid& grid);

    /// Follows a curve. Distances are computed anew only around the bricks that became visible or invisible; the result
    /// is that of a fresh object.
    void update(const BrickRanges& ranges, const TransferTable& table);
    /// Follows a two-dimensional OTF, of whose nodes `visible` tells.
    void update(const BrickRanges& ranges, const PackedGradients& gradients, const VisibleNodes& visible);

    [[nodiscard]] const BrickGrid& grid() const { return m_grid; }
    /// Whether any brick shows nothing.
    [[nodiscard]] bool any() const { return m_emptyBricks > 0; }
    /// One number a brick: 0 where the brick shows something, else d where all bricks less than d away on every axis
    /// show nothing.
    [[nodiscard]] const std::vector<std::uint8_t>& distances() const { return m_distances; }

private:
    struct Box {
        std::array<std::int64_t, 3> first, last;  ///< `last` is one beyond
    };
    /// isEmpty(brick) says whether a brick shows nothing.
    template <typename IsEmpty>
    void follow(const IsEmpty& isEmpty);
    void findDistances(const Box& box);
    bool relax(std::int64_t x, std::int64_t y, std::int64_t z);

    BrickGrid m_grid;
    std::vector<std::uint8_t> m_empty, m_distances;
    std::int64_t m_emptyBricks = 0;
};

}  // namespace echolucent::ray_casting
