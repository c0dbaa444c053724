// Brings the slices of one phase into memory: as they are stored, or as means of blocks.
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

/// Takes the slices of a volume one after another, along z. If the volume is reduced, memory holds only the means and
/// one slice.
class PhaseSlices {
public:
    /// `size` is the size of the stored volume in voxels, each at least 1. If there is a reduction, its storedSize must
    /// equal `size`.
    PhaseSlices(StoredType type, const std::array<std::int64_t, 3>& size, const std::optional<Reduction>& reduction);
    PhaseSlices(PhaseSlices&&) noexcept;
    PhaseSlices& operator=(PhaseSlices&&) noexcept;
    ~PhaseSlices();

    /// Room for the bytes of the next slice, in this machine's byte order. It is valid until endSlice().
    [[nodiscard]] std::span<std::uint8_t> nextSlice();
    /// Takes the slice with which the caller has filled the room of nextSlice().
    void endSlice();
    /// Passes over the next slice, which could not be read. Its voxels are 0 and do not count in means.
    void skipSlice();

    /// The bytes of the volume, or of its means if it is reduced; both are of the stored type. Call it after the last
    /// slice.
    [[nodiscard]] VoxelBytes take() { return std::move(m_bytes); }

private:
    struct Means;
    std::size_t m_sliceBytes;
    std::size_t m_slice = 0;         // slices so far
    VoxelBytes m_bytes;              // what is kept
    VoxelBytes m_stored;             // one slice, if the volume is reduced
    std::unique_ptr<Means> m_means;  // null if the volume is not reduced
};

}  // namespace echolucent
