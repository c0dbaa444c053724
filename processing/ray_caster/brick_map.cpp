#include "processing/ray_caster/brick_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace echolucent::ray_casting {

namespace {

/// Voxels first ... last - 1 on each axis.
struct VoxelBox {
    std::array<std::int64_t, 3> first, last;
};

/// The voxels of a brick's cells and `reach` more on each side; one more at the far side, because float positions in
/// the kernel may round up to the next cell.
VoxelBox boxOf(const std::array<std::int64_t, 3>& brick, const std::array<std::int64_t, 3>& size,
               const std::array<int, 3>& reach) {
    VoxelBox box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t low = brick[axis] * BrickMap::edge;
        box.first[axis] = std::max<std::int64_t>(0, low - reach[axis]);
        box.last[axis] = std::min(size[axis], low + BrickMap::edge + 2 + reach[axis]);
    }
    return box;
}

/// Calls visit(first voxel of a row, number of voxels) for each row of the box until it returns false.
template <typename Voxel, typename Visit>
void forEachRow(const Voxel* voxels, const VolumeGeometry& geometry, const VoxelBox& box, const Visit& visit) {
    for (std::int64_t z = box.first[2]; z < box.last[2]; ++z)
        for (std::int64_t y = box.first[1]; y < box.last[1]; ++y)
            if (!visit(voxels + geometry.offset(box.first[0], y, z), box.last[0] - box.first[0])) return;
}

template <typename Body>
void forEachBrick(const std::array<std::int64_t, 3>& bricks, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, bricks[1] * bricks[2]),
                      [&](const tbb::blocked_range<std::int64_t>& rows) {
                          for (std::int64_t row = rows.begin(); row < rows.end(); ++row)
                              for (std::int64_t x = 0; x < bricks[0]; ++x)
                                  body(std::array<std::int64_t, 3>{x, row % bricks[1], row / bricks[1]},
                                       static_cast<std::size_t>(row * bricks[0] + x));
                      });
}

/// Whether every intensity between the voxels of a box is fully transparent.
template <typename Voxel>
bool isTransparent(const Voxel* voxels, const VolumeGeometry& geometry, const VoxelBox& box, double whiteLevel,
                   const TransferTable& table) {
    Voxel lowest = std::numeric_limits<Voxel>::max(), highest = std::numeric_limits<Voxel>::lowest();
    const auto position = [&](Voxel value) {
        const double scaled = static_cast<double>(value) / whiteLevel * TransferTable::intervals;
        return static_cast<float>(std::clamp(scaled, 0.0, static_cast<double>(TransferTable::intervals)));
    };
    bool transparent = true;
    forEachRow(voxels, geometry, box, [&](const Voxel* row, std::int64_t count) {
        for (std::int64_t x = 0; x < count; ++x) {
            // A voxel that is not a number changes neither bound: it adds nothing to the picture.
            lowest = row[x] < lowest ? row[x] : lowest;
            highest = row[x] > highest ? row[x] : highest;
        }
        transparent = lowest > highest || table.transparentBetween(position(lowest), position(highest));
        return transparent;
    });
    return transparent;
}

}  // namespace

BrickMap::BrickMap(const Volume& volume, const TransferTable& table, const std::array<int, 3>& reach) {
    const bool masked = !volume.dataMask().empty();
    const bool transparent = table.hasTransparentRange();
    if (!masked && !transparent) return;
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_bricks[axis] = (volume.geometry().size[axis] + edge - 1) / edge;
        count *= static_cast<std::size_t>(m_bricks[axis]);
    }
    m_kinds.assign(count, BrickKind::plain);
    if (masked) findMissingData(volume, reach);
    if (transparent) findTransparency(volume, table);
}

void BrickMap::findMissingData(const Volume& volume, const std::array<int, 3>& reach) {
    const VolumeGeometry& geometry = volume.geometry();
    const std::uint8_t* mask = volume.dataMask().data();
    forEachBrick(m_bricks, [&](const std::array<std::int64_t, 3>& brick, std::size_t index) {
        bool anyData = false;
        forEachRow(mask, geometry, boxOf(brick, geometry.size, {0, 0, 0}), [&](const std::uint8_t* row, auto count) {
            anyData = std::any_of(row, row + count, [](std::uint8_t value) { return value != 0; });
            return !anyData;
        });
        bool anyMissing = false;
        if (anyData)
            forEachRow(mask, geometry, boxOf(brick, geometry.size, reach), [&](const std::uint8_t* row, auto count) {
                unsigned missing = 0;
                for (std::int64_t x = 0; x < count; ++x) missing |= static_cast<unsigned>(row[x] == 0);
                anyMissing = missing != 0;
                return !anyMissing;
            });
        if (!anyData)
            m_kinds[index] = BrickKind::empty;
        else if (anyMissing)
            m_kinds[index] = BrickKind::masked;
    });
}

void BrickMap::findTransparency(const Volume& volume, const TransferTable& table) {
    const VolumeGeometry& geometry = volume.geometry();
    std::visit(
        [&](const auto& voxels) {
            forEachBrick(m_bricks, [&](const std::array<std::int64_t, 3>& brick, std::size_t index) {
                if (m_kinds[index] == BrickKind::empty) return;
                if (isTransparent(voxels.data(), geometry, boxOf(brick, geometry.size, {0, 0, 0}), volume.whiteLevel(),
                                  table))
                    m_kinds[index] = BrickKind::empty;
            });
        },
        volume.voxels());
}

}  // namespace echolucent::ray_casting
