// The bytes of a stored volume's voxels, out of one data file or out of several, one after the other.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/stored/stored_volume.h"

namespace echolucent {

/// Gives the bytes of all data files in their order. One file is open at a time.
class StoredBytes {
public:
    /// The volume must outlive this. Each of its data files holds an equal part of `counts`.
    StoredBytes(const StoredVolume& stored, const ByteCounts& counts);

    /// Checks of every data file, before memory is taken, that it can hold its part. Fails (unreadable) where it holds
    /// less, and where reading would take far more memory than the files' bytes are worth (requireReadingMemory());
    /// compressed bytes that claim to be many times more are counted.
    [[nodiscard]] Result<void> check(const Progress& progress);
    /// Sentences of check() and read() on bytes that play no part, and on a last number that may have been cut.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }

    /// Fills `bytes` with what comes next, as VoxelSource::read(). At the end of a data file compressed voxels are
    /// decoded to their own end and their checksums verified.
    [[nodiscard]] Result<void> read(std::span<std::uint8_t> bytes, const Progress& progress, double from, double to);
    /// Fills `bytes` with those of the voxels from byte `position` on, wherever read() is. To be asked after check(),
    /// and only where the voxels are stored raw. Fails (unreadable) where a file cannot be read.
    [[nodiscard]] Result<void> readRaw(std::uint64_t position, std::span<std::uint8_t> bytes);

private:
    /// Where the voxels lie in an opened data file.
    [[nodiscard]] Result<VoxelExtent> extentIn(const InputFile& file) const;
    [[nodiscard]] Result<VoxelExtent> extentOfRaw(const InputFile& file, VoxelExtent extent) const;
    [[nodiscard]] Result<VoxelExtent> extentOfEncoded(const InputFile& file, VoxelExtent extent) const;
    [[nodiscard]] Result<std::uint64_t> skippedLines(const InputFile& file) const;
    [[nodiscard]] Result<void> checkDecoded(const InputFile& file, const VoxelExtent& extent,
                                            const Progress& progress) const;
    /// Whether an extent ends in a number that is written as text, of which some digits may be missing.
    [[nodiscard]] Result<bool> endsWithinNumber(const InputFile& file, const VoxelExtent& extent) const;
    void noteRest(const InputFile& file, const VoxelExtent& extent);
    [[nodiscard]] Result<void> beginNext(const Progress& progress);
    [[nodiscard]] Result<void> endFile(const Progress& progress);
    [[nodiscard]] tl::unexpected<Failure> tooShort(const std::string& held) const;

    const StoredVolume& m_stored;
    ByteCounts m_counts;
    std::uint64_t m_part;      // bytes of voxels in each data file
    std::size_t m_begun = 0;   // data files that were begun
    std::string m_file;        // path of the one begun last
    std::uint64_t m_left = 0;  // bytes that the one begun last has still to give
    bool m_mayBeCut = false;   // whether the one begun last ends within a number that is written as text
    std::unique_ptr<VoxelSource> m_source;
    std::vector<std::string> m_warnings;
    /// A data file that readRaw() has open.
    struct OpenPart {
        std::size_t number = 0;
        InputFile file;
        std::uint64_t offset = 0;  // of its first voxel
    };
    std::optional<OpenPart> m_openPart;
};

}  // namespace echolucent
