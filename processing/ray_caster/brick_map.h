// Where a ray may jump, and where it must look at each voxel for data.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "processing/ray_caster/transfer_table.h"
#include "processing/volume.h"

namespace echolucent::ray_casting {

/// What a ray finds in a brick of cells (a cell: the space between eight voxel centres).
enum class BrickKind : std::uint8_t {
    plain,   ///< every voxel that a sample or a gradient there needs carries data
    empty,   ///< every sample is fully transparent
    masked,  ///< voxels with and without data
};

/// Kinds of the bricks of 8 x 8 x 8 cells of a volume under a transfer table. Cost: one pass over the voxels or the
/// mask, and none where all bricks are plain.
class BrickMap {
public:
    static constexpr int edge = 8;

    /// reach: voxels along each axis that a gradient reads beyond its sample's cell; 0 without shading.
    BrickMap(const Volume& volume, const TransferTable& table, const std::array<int, 3>& reach);

    /// True where all bricks are plain: nothing to look up.
    [[nodiscard]] bool allPlain() const { return m_kinds.empty(); }
    [[nodiscard]] BrickKind kindOf(const std::array<std::int64_t, 3>& brick) const {
        return m_kinds[static_cast<std::size_t>(brick[0] + m_bricks[0] * (brick[1] + m_bricks[1] * brick[2]))];
    }

private:
    void findMissingData(const Volume& volume, const std::array<int, 3>& reach);
    void findTransparency(const Volume& volume, const TransferTable& table);

    std::array<std::int64_t, 3> m_bricks{};
    std::vector<BrickKind> m_kinds;
};

}  // namespace echolucent::ray_casting
