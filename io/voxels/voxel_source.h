// The bytes of voxels, or of a file that was packed as a whole, read in order from one file, stored as they are or
// encoded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "io/files/input_file.h"
#include "io/voxels/voxel_encoding.h"

namespace echolucent {

/// Where in a file the voxels lie.
struct VoxelExtent {
    std::uint64_t offset = 0;  ///< first byte in the file
    std::uint64_t length = 0;  ///< bytes from there that belong to the voxels, as they are encoded
    VoxelEncoding encoding = VoxelEncoding::raw;
    std::uint64_t skipBytes = 0;  ///< bytes to skip after decoding
};

/// Gives the bytes of an extent in their order.
class VoxelSource {
public:
    /// `type` is that of the values, which text needs to know.
    VoxelSource(InputFile file, const VoxelExtent& extent, StoredType type);
    ~VoxelSource();
    VoxelSource(const VoxelSource&) = delete;
    VoxelSource& operator=(const VoxelSource&) = delete;

    /// Fills `bytes`, which holds whole values, with what comes next, polls progress.cancel every few MB and reports
    /// shares from `from` to `to`. Fails (unreadable, with both numbers) where there are fewer bytes than asked for.
    [[nodiscard]] Result<void> read(std::span<std::uint8_t> bytes, const Progress& progress, double from, double to);

    /// Fills `bytes`, which holds whole values, as far as there are more, and returns how many bytes that were; 0 at
    /// the end. Fails (unreadable) where the bytes are damaged.
    [[nodiscard]] Result<std::size_t> readSome(std::span<std::uint8_t> bytes);
    /// Whether an encoding that says where it ends has said so: compressed bytes that are cut off never do.
    [[nodiscard]] bool ended() const { return m_ended; }
    /// The share of the extent that was taken from the file, in [0,1].
    [[nodiscard]] double shareTaken() const;

    /// Reads on without keeping what comes, to the end or until `most` bytes have come, and returns how many did (where
    /// there are more than `most`, up to 1 MiB more than that). Where ended() is true then, the checksums of compressed
    /// bytes have been verified. Fails (unreadable) where what follows is damaged or no voxels.
    [[nodiscard]] Result<std::uint64_t> skipRest(std::uint64_t most, const Progress& progress);

    /// How many bytes there are to be read, counted up to `limit` without keeping them. To be called before the first
    /// read().
    [[nodiscard]] Result<std::uint64_t> countBytes(std::uint64_t limit, const Progress& progress);

private:
    [[nodiscard]] Result<std::size_t> decodeSome(std::span<std::uint8_t> bytes);
    [[nodiscard]] Result<void> refill();
    void rewind();

    InputFile m_file;
    VoxelExtent m_extent;
    StoredType m_type;
    std::uint64_t m_position = 0;  // bytes taken from the file so far
    std::uint64_t m_given = 0;     // bytes given out so far
    std::unique_ptr<VoxelDecoder> m_decoder;
    std::vector<std::uint8_t> m_input;        // encoded bytes that are not decoded yet
    std::span<const std::uint8_t> m_waiting;  // the part of m_input that is left
    bool m_ended = false;
};

}  // namespace echolucent
