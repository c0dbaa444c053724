#include "processing/ray_caster/packed/packed_voxels.h"

#include <algorithm>
#include <type_traits>
#include <variant>

#include "processing/parallel.h"
#include "processing/ray_caster/packed/transfer_table.h"

namespace echolucent::ray_casting {

namespace {

/// A voxel as the kernel interpolates it: a float becomes its table position.
template <typename Voxel>
struct Packing {
    double floatsToTable;

    Voxel operator()(Voxel value) const {
        if constexpr (std::is_same_v<Voxel, float>) return positionOfFloat(value, floatsToTable);
        return value;
    }
};

}  // namespace

template <typename Voxel>
float PackedVoxels<Voxel>::toTable(double whiteLevel) {
    if constexpr (std::is_same_v<Voxel, float>) return 1.0f;
    // With a factor beyond 1e12 the smallest stored value is white already. With one below 1e-12 the largest is black.
    // The factor and its inverse must be finite.
    return static_cast<float>(std::clamp(TransferTable::intervals / whiteLevel, 1e-12, 1e12));
}

template <typename Voxel>
PackedVoxels<Voxel>::PackedVoxels(const Volume& filled) : m_order(filled.geometry().size) {
    const Packing<Voxel> packing{TransferTable::intervals / filled.whiteLevel()};
    const Voxel* voxels = std::get<VoxelArray<Voxel>>(filled.voxels()).data();
    m_cubes = std::make_unique_for_overwrite<Voxel[]>(m_order.stored());
    parallelFor(LoopRange<std::int64_t>(0, m_order.rows * m_order.slices, 64), [&](const auto& range) {
        for (std::int64_t each = range.begin(); each < range.end(); ++each) {
            const std::int64_t row = each % m_order.rows, slice = each / m_order.rows;
            const auto rowOf = [&](std::int64_t y) {
                return voxels + m_order.size[0] * (y + m_order.size[1] * m_order.lower(slice, 2));
            };
            packRow(m_order, rowOf(m_order.lower(row, 1)), rowOf(m_order.upper(row, 1)), 0, m_order.size[0],
                    m_cubes.get() + m_order.first(row, slice), packing);
        }
    });
}

template class PackedVoxels<std::uint8_t>;
template class PackedVoxels<std::uint16_t>;
template class PackedVoxels<float>;

}  // namespace echolucent::ray_casting
