// The bytes of a volume's voxels, read in order from a file, stored as they are or compressed with zlib or gzip.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "io/input_file.h"

namespace echolucent {

/// Where in a file the voxels lie.
struct VoxelExtent {
    std::uint64_t offset = 0;     ///< first byte in the file
    std::uint64_t length = 0;     ///< bytes from there that belong to the voxels, before they are decompressed
    bool compressed = false;      ///< whether the bytes are compressed with zlib or gzip
    std::uint64_t skipBytes = 0;  ///< bytes to skip after decompression
};

/// Gives the bytes of an extent in their order.
class VoxelSource {
public:
    VoxelSource(InputFile file, const VoxelExtent& extent);
    ~VoxelSource();
    VoxelSource(const VoxelSource&) = delete;
    VoxelSource& operator=(const VoxelSource&) = delete;

    /// Fills `bytes` with what comes next, polls progress.cancel every few MB and reports shares from `from` to `to`.
    /// Fails (unreadable, with both numbers) where there are fewer bytes than asked for.
    [[nodiscard]] Result<void> read(std::span<std::uint8_t> bytes, const Progress& progress, double from, double to);

    /// How many bytes there are to be read, counted up to `limit` without keeping them. To be called before the first
    /// read().
    [[nodiscard]] Result<std::uint64_t> countBytes(std::uint64_t limit, const Progress& progress);

private:
    struct Inflater;
    [[nodiscard]] Result<std::size_t> readSome(std::span<std::uint8_t> bytes);
    [[nodiscard]] Result<std::size_t> inflateSome(std::span<std::uint8_t> bytes);
    void rewind();

    InputFile m_file;
    VoxelExtent m_extent;
    std::uint64_t m_position = 0;  // bytes taken from the file so far
    std::uint64_t m_given = 0;     // bytes given out so far
    std::unique_ptr<Inflater> m_inflater;
};

}  // namespace echolucent
