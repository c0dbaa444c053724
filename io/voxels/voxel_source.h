// Reads the bytes of voxels, or of a file packed as a whole, in order from one file, raw or encoded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "io/files/input_file.h"
#include "io/voxels/voxel_encoding.h"

namespace echolucent {

/// Where the voxels lie in a file.
struct VoxelExtent {
    std::uint64_t offset = 0;  ///< first byte in the file
    std::uint64_t length = 0;  ///< bytes of the encoded voxels from there
    VoxelEncoding encoding = VoxelEncoding::raw;
    std::uint64_t skipBytes = 0;  ///< decoded bytes before the voxels; who reads the source must skip them
    bool decimalCommas = false;   ///< in text, commas stand for points and separate no numbers
};

/// Gives the bytes of an extent in order.
class VoxelSource {
public:
    /// `type` is the type of the values; only text needs it.
    VoxelSource(InputFile file, const VoxelExtent& extent, StoredType type);
    ~VoxelSource();
    VoxelSource(const VoxelSource&) = delete;
    VoxelSource& operator=(const VoxelSource&) = delete;

    /// Fills `bytes`, which holds whole values, with the next bytes. Polls progress.cancel every few MB and reports
    /// shares from `from` to `to`. Fails (unreadable) if the bytes are damaged or if there are fewer; the sentence then
    /// says how many there are and how many are declared. Fails (cancelled) if the person ended it.
    [[nodiscard]] Result<void> read(std::span<std::uint8_t> bytes, const Progress& progress, double from, double to);

    /// Fills `bytes`, which holds whole values, as far as it can, and returns how many bytes came; 0 at the end. Fails
    /// (unreadable) if the bytes are damaged.
    [[nodiscard]] Result<std::size_t> readSome(std::span<std::uint8_t> bytes);
    /// Whether the encoding's own end was reached. Compressed bytes that are cut off never reach it; raw bytes have
    /// none.
    [[nodiscard]] bool ended() const { return m_ended; }
    /// The share of the extent that was read from the file, in [0,1].
    [[nodiscard]] double shareTaken() const;

    /// Reads on and drops the bytes, to the end or until more than `most` have come. Returns how many came, up to 1 MiB
    /// above `most`. If ended() is true afterwards, the checksums of compressed bytes are verified. Fails (unreadable)
    /// if the following bytes are damaged or no voxels.
    [[nodiscard]] Result<std::uint64_t> skipRest(std::uint64_t most, const Progress& progress);

    /// How many bytes can be read. Counting ends soon after `limit`, as in skipRest(). Call it before the first read(),
    /// because the source begins anew afterwards.
    [[nodiscard]] Result<std::uint64_t> countBytes(std::uint64_t limit, const Progress& progress);

private:
    [[nodiscard]] Result<std::size_t> decodeSome(std::span<std::uint8_t> bytes);
    [[nodiscard]] Result<void> refill();
    void rewind();

    InputFile m_file;
    VoxelExtent m_extent;
    StoredType m_type;
    std::uint64_t m_position = 0;  // bytes taken from the file so far
    std::uint64_t m_given = 0;     // bytes that read() has given so far
    std::unique_ptr<VoxelDecoder> m_decoder;
    std::vector<std::uint8_t> m_input;        // encoded bytes that are not decoded yet
    std::span<const std::uint8_t> m_waiting;  // the part of m_input that is left
    bool m_ended = false;
};

}  // namespace echolucent
