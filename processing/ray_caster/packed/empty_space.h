// Regions that the curve makes transparent. Rays may jump over them.
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

/// The smallest and largest intensity that the cubes of each brick may show, found in one pass over the volume.
class BrickRanges {
public:
    /// `filled` is FilledVolume::voxels.
    BrickRanges(const Volume& filled, const PackedPresence& presence);
    /// Follows a changed presence. Only the marked rows of voxels may have changed.
    void follow(const PackedPresence& presence, const RowMarks& rows);

    [[nodiscard]] const BrickGrid& grid() const { return m_grid; }
    /// Table positions. If a brick shows no data, its lowest is above its highest.
    [[nodiscard]] const std::vector<float>& lowest() const { return m_lowest; }
    [[nodiscard]] const std::vector<float>& highest() const { return m_highest; }

private:
    BrickGrid m_grid;
    std::vector<float> m_lowestHeld, m_highestHeld;  ///< of all voxels with a value, for any presence
    std::vector<float> m_lowest, m_highest;
};

/// The distance from each brick to the next one that shows something.
class EmptySpace {
public:
    /// The largest distance; farther bricks have it too.
    static constexpr int farthest = 8;

    explicit EmptySpace(const BrickGrid& grid);

    /// Follows a curve. It computes distances again only around bricks that became visible or invisible. The result is
    /// that of a fresh object.
    void update(const BrickRanges& ranges, const TransferTable& table);
    /// Follows a two-dimensional OTF with these visible nodes.
    void update(const BrickRanges& ranges, const PackedGradients& gradients, const VisibleNodes& visible);

    [[nodiscard]] const BrickGrid& grid() const { return m_grid; }
    /// Whether any brick shows nothing.
    [[nodiscard]] bool any() const { return m_emptyBricks > 0; }
    /// One number a brick: 0 if the brick shows something. Else d, if no brick less than d away on every axis shows
    /// anything.
    [[nodiscard]] const std::vector<std::uint8_t>& distances() const { return m_distances; }

private:
    struct Box {
        std::array<std::int64_t, 3> first, last;  ///< `last` is one beyond the last
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
