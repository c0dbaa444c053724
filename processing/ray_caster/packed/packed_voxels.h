// The voxels of a volume in the kernel's order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "processing/ray_caster/packed/packed_order.h"
#include "processing/volume/volume.h"

namespace echolucent::ray_casting {

/// The table position of a float voxel, kept within bounds: differences of positions, and the squares of gradients,
/// must be finite. `floatsToTable` is TransferTable::intervals / white level.
[[nodiscard]] inline float positionOfFloat(float value, double floatsToTable) {
    return static_cast<float>(std::clamp(static_cast<double>(value) * floatsToTable, -1e15, 1e15));
}

/// Packs a volume in one pass. Floats are stored as table positions (see transfer_table.h), since their white level may
/// be of any magnitude.
template <typename Voxel>
class PackedVoxels {
public:
    /// `filled` is FilledVolume::voxels.
    explicit PackedVoxels(const Volume& filled);

    [[nodiscard]] const Voxel* cubes() const { return m_cubes.get(); }
    /// The factor from a packed value to its table position.
    [[nodiscard]] static float toTable(double whiteLevel);
    [[nodiscard]] std::int64_t rowStride() const { return m_order.rowStride; }      ///< cubes
    [[nodiscard]] std::int64_t sliceStride() const { return m_order.sliceStride; }  ///< cubes

private:
    PackedOrder m_order;
    std::unique_ptr<Voxel[]> m_cubes;
};

}  // namespace echolucent::ray_casting
