#include "processing/ray_caster/packed/empty_space.h"

#include <algorithm>
#include <limits>

#include "processing/parallel.h"
#include "processing/ray_caster/packed/packed_order.h"

namespace echolucent::ray_casting {

namespace {

template <typename Voxel>
struct RangeOf {
    Voxel lowest = std::numeric_limits<Voxel>::max(), highest = std::numeric_limits<Voxel>::lowest();

    void add(const Voxel* row, std::int64_t count) {
        for (std::int64_t x = 0; x < count; ++x) {
            lowest = std::min(lowest, row[x]);
            highest = std::max(highest, row[x]);
        }
    }
    void addKnown(const Voxel* row, const std::uint8_t* known, std::int64_t count) {
        for (std::int64_t x = 0; x < count; ++x)
            if (known[x] != 0) add(row + x, 1);
    }
};

/// The range of the voxels with a value.
template <typename Voxel>
RangeOf<Voxel> rangeOf(const Volume& volume, const Voxel* voxels, const std::array<std::int64_t, 3>& brick) {
    const std::uint8_t* known = volume.dataMaskOrNull();
    RangeOf<Voxel> range;
    forEachRowOf(volume.geometry(), brick, [&](std::int64_t first, std::int64_t count) {
        if (known == nullptr)
            range.add(voxels + first, count);
        else
            range.addKnown(voxels + first, known + first, count);
    });
    return range;
}

}  // namespace

BrickRanges::BrickRanges(const Volume& filled, const PackedPresence& presence)
    : m_grid(filled.geometry()),
      m_lowestHeld(static_cast<std::size_t>(m_grid.count())),
      m_highestHeld(m_lowestHeld.size()) {
    const double toTable = TransferTable::intervals / filled.whiteLevel();
    const auto position = [&](auto value) {
        return static_cast<float>(
            std::clamp(static_cast<double>(value) * toTable, 0.0, static_cast<double>(TransferTable::intervals)));
    };
    std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& voxels) {
            forEachBrick(m_grid, [&](const std::array<std::int64_t, 3>& at, std::size_t brick) {
                const auto found = rangeOf(filled, voxels.data(), at);
                const bool anyData = found.lowest <= found.highest;
                // Rounding in the kernel may leave the voxels' range by very little.
                m_lowestHeld[brick] = anyData ? std::max(0.0f, position(found.lowest) - 0.125f) : 1.0f;
                m_highestHeld[brick] =
                    anyData ? std::min(static_cast<float>(TransferTable::intervals), position(found.highest) + 0.125f)
                            : 0.0f;
            });
        },
        filled.voxels());
    m_lowest = m_lowestHeld;
    m_highest = m_highestHeld;
    follow(presence, RowMarks(filled.geometry().size, true));
}

void BrickRanges::follow(const PackedPresence& presence, const RowMarks& rows) {
    if (presence.cubes() == nullptr) {
        m_lowest = m_lowestHeld;
        m_highest = m_highestHeld;
        return;
    }
    const std::int64_t lastCube = presence.order().size[0];
    const auto most = [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); };
    presence.foldBricks(BrickGrid::edge, m_grid.size, rows, most, [&](const PackedPresence::FoldedBricks& bricks) {
        for (std::int64_t x = bricks.first; x < bricks.last; ++x) {
            const auto first = bricks.columns.begin() + x * BrickGrid::edge * voxelsPerCube;
            const auto end = bricks.columns.begin() +
                             (std::min(x * BrickGrid::edge + BrickGrid::edge, lastCube) + 1) * voxelsPerCube;
            // A brick shows nothing if no voxel has enough presence.
            const bool shown = std::any_of(first, end, [](auto here) { return here > PresenceUse::noneUpTo; });
            const std::size_t brick = m_grid.offset(x, bricks.y, bricks.z);
            m_lowest[brick] = shown ? m_lowestHeld[brick] : 1.0f;
            m_highest[brick] = shown ? m_highestHeld[brick] : 0.0f;
        }
    });
}

EmptySpace::EmptySpace(const BrickGrid& grid)
    : m_grid(grid), m_empty(static_cast<std::size_t>(grid.count())), m_distances(m_empty.size()) {}

template <typename IsEmpty>
void EmptySpace::follow(const IsEmpty& isEmpty) {
    Box changed{m_grid.size, {0, 0, 0}};
    for (std::int64_t z = 0; z < m_grid.size[2]; ++z)
        for (std::int64_t y = 0; y < m_grid.size[1]; ++y)
            for (std::int64_t x = 0; x < m_grid.size[0]; ++x) {
                const std::size_t brick = m_grid.offset(x, y, z);
                const bool empty = isEmpty(brick);
                if (empty == (m_empty[brick] != 0)) continue;
                m_empty[brick] = empty ? 1 : 0;
                m_emptyBricks += empty ? 1 : -1;
                const std::array<std::int64_t, 3> at{x, y, z};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    changed.first[axis] = std::min(changed.first[axis], at[axis]);
                    changed.last[axis] = std::max(changed.last[axis], at[axis] + 1);
                }
            }
    if (changed.last[0] == 0) return;
    // Bricks farther away from all changed ones keep their distance.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        changed.first[axis] = std::max<std::int64_t>(0, changed.first[axis] - farthest);
        changed.last[axis] = std::min(m_grid.size[axis], changed.last[axis] + farthest);
    }
    findDistances(changed);
}

void EmptySpace::update(const BrickRanges& ranges, const TransferTable& table) {
    follow([&](std::size_t brick) {
        const float lowest = ranges.lowest()[brick], highest = ranges.highest()[brick];
        return lowest > highest || table.transparentBetween(lowest, highest);
    });
}

void EmptySpace::update(const BrickRanges& ranges, const PackedGradients& gradients, const VisibleNodes& visible) {
    follow([&](std::size_t brick) {
        const float lowest = ranges.lowest()[brick], highest = ranges.highest()[brick];
        return lowest > highest ||
               visible.transparentBetween(lowest, highest, gradients.lowest()[brick], gradients.highest()[brick]);
    });
}

bool EmptySpace::relax(std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint8_t& distance = m_distances[m_grid.offset(x, y, z)];
    if (distance == 0) return false;
    int nearest = distance - 1;
    for (std::int64_t k = std::max<std::int64_t>(0, z - 1); k < std::min(m_grid.size[2], z + 2); ++k)
        for (std::int64_t j = std::max<std::int64_t>(0, y - 1); j < std::min(m_grid.size[1], y + 2); ++j)
            for (std::int64_t i = std::max<std::int64_t>(0, x - 1); i < std::min(m_grid.size[0], x + 2); ++i)
                nearest = std::min<int>(nearest, m_distances[m_grid.offset(i, j, k)]);
    if (nearest + 1 == distance) return false;
    distance = static_cast<std::uint8_t>(nearest + 1);
    return true;
}

void EmptySpace::findDistances(const Box& box) {
    const auto forEach = [&](const auto& visit) {
        for (std::int64_t z = box.first[2]; z < box.last[2]; ++z)
            for (std::int64_t y = box.first[1]; y < box.last[1]; ++y)
                for (std::int64_t x = box.first[0]; x < box.last[0]; ++x) visit(x, y, z);
    };
    forEach([&](std::int64_t x, std::int64_t y, std::int64_t z) {
        const std::size_t brick = m_grid.offset(x, y, z);
        m_distances[brick] = m_empty[brick] != 0 ? farthest : 0;
    });
    // Two sweeps settle the whole grid. A box may need more, for distances from beyond its border.
    for (bool anyChanged = true; anyChanged;) {
        anyChanged = false;
        forEach([&](std::int64_t x, std::int64_t y, std::int64_t z) { anyChanged = relax(x, y, z) || anyChanged; });
        if (!anyChanged) break;
        for (std::int64_t z = box.last[2] - 1; z >= box.first[2]; --z)
            for (std::int64_t y = box.last[1] - 1; y >= box.first[1]; --y)
                for (std::int64_t x = box.last[0] - 1; x >= box.first[0]; --x)
                    anyChanged = relax(x, y, z) || anyChanged;
    }
}

}  // namespace echolucent::ray_casting
