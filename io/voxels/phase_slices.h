// The slices of one phase on their way into memory: as they are stored, or as means of blocks.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "io/voxels/voxel_bytes.h"
#include "io/voxels/voxel_types.h"
#include "processing/volume/reduction.h"

namespace echolucent {

/// Takes the slices of a volume one after the other, along z. Where the volume is reduced, memory is taken for the
/// means and for one slice only.
class PhaseSlices {
public:
    /// `size` counts the voxels of the stored volume, each at least 1; it is the reduction's storedSize where there is
    /// one.
    PhaseSlices(StoredType type, const std::array<std::int64_t, 3>& size, const std::optional<Reduction>& reduction);
    PhaseSlices(PhaseSlices&&) noexcept;
    PhaseSlices& operator=(PhaseSlices&&) noexcept;
    ~PhaseSlices();

    /// The place for the bytes of the next slice, in this machine's byte order; it is good until endSlice().
    [[nodiscard]] std::span<std::uint8_t> nextSlice();
    /// The place that nextSlice() gave holds the slice now.
    void endSlice();
    /// Passes over the next slice, which nobody could read: its voxels are 0, and do not count in means.
    void skipSlice();

    /// What was gathered, when every slice has come: the bytes of the volume, or of its means, of the same type.
    [[nodiscard]] VoxelBytes take() { return std::move(m_bytes); }

private:
    struct Means;
    std::size_t m_sliceBytes;
    std::size_t m_slice = 0;         // slices that came by
    VoxelBytes m_bytes;              // what is kept
    VoxelBytes m_stored;             // one slice, where the volume is reduced
    std::unique_ptr<Means> m_means;  // null where it is not
};

}  // namespace echolucent
