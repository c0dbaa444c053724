// The bytes of a stored volume's voxels, from one data file or several, one after another.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/stored/stored_volume.h"

namespace echolucent {

/// Where the extent of `stored` begins in a data file, behind the lines to skip. Fails (unreadable) if there are fewer
/// lines.
[[nodiscard]] Result<std::uint64_t> offsetAfterLines(const StoredVolume& stored, const InputFile& file);

/// Gives the bytes of all data files in order. One file is open at a time.
class StoredBytes {
public:
    /// The volume must outlive this. Each of its data files holds an equal part of `counts`.
    StoredBytes(const StoredVolume& stored, const ByteCounts& counts);

    /// Checks, before memory is taken, that every data file can hold its part. Fails (unreadable) if one holds less, or
    /// if reading would take far more memory than such files may (requireReadingMemory()). Text is searched for commas
    /// and, if it has some, read once: it fails too if there are more numbers than voxels and commas within them that
    /// may be decimal ones. If compressed bytes claim to unpack to more than 32 times as many, they are unpacked once
    /// to count them.
    [[nodiscard]] Result<void> check(const Progress& progress);
    /// Sentences of check() and read() about ignored bytes, decimal commas, and a last number that may have been cut.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }

    /// Fills `bytes` with the next bytes, as VoxelSource::read(). At the end of a data file, compressed voxels are
    /// decoded to their own end, which verifies their checksums.
    [[nodiscard]] Result<void> read(std::span<std::uint8_t> bytes, const Progress& progress, double from, double to);
    /// Fills `bytes` from byte `position` of the voxels on. It does not depend on read() and does not move it. Call it
    /// after check(), and only for voxels stored raw. Fails (unreadable) if a file cannot be read.
    [[nodiscard]] Result<void> readRaw(std::uint64_t position, std::span<std::uint8_t> bytes);

private:
    /// Where the voxels lie in an opened data file.
    [[nodiscard]] Result<VoxelExtent> extentIn(const InputFile& file) const;
    [[nodiscard]] Result<VoxelExtent> extentOfRaw(const InputFile& file, VoxelExtent extent) const;
    [[nodiscard]] Result<VoxelExtent> extentOfEncoded(const InputFile& file, VoxelExtent extent) const;
    [[nodiscard]] Result<void> checkDecoded(const InputFile& file, const VoxelExtent& extent,
                                            const Progress& progress) const;
    /// Calls visit(file, extent) for each data file, until it fails.
    template <typename Visit>
    [[nodiscard]] Result<void> forEachFile(const Visit& visit) const;
    /// Finds out whether commas in text are decimal ones. Fails (unreadable) if they may be either.
    [[nodiscard]] Result<void> settleCommas(const Progress& progress);
    /// Whether an extent ends in a number written as text. Digits of that number may be missing.
    [[nodiscard]] Result<bool> endsWithinNumber(const InputFile& file, const VoxelExtent& extent) const;
    void noteRest(const InputFile& file, const VoxelExtent& extent);
    [[nodiscard]] Result<void> beginNext(const Progress& progress);
    [[nodiscard]] Result<void> endFile(const Progress& progress);
    [[nodiscard]] tl::unexpected<Failure> tooShort(const std::string& held) const;

    const StoredVolume& m_stored;
    ByteCounts m_counts;
    std::uint64_t m_part;          // bytes of voxels in each data file
    std::size_t m_begun = 0;       // how many data files were begun
    std::string m_file;            // path of the present data file
    std::uint64_t m_left = 0;      // bytes that the present file has still to give
    bool m_mayBeCut = false;       // whether the present file ends within a number written as text
    bool m_decimalCommas = false;  // commas in text are decimal ones, as check() found
    std::unique_ptr<VoxelSource> m_source;
    std::vector<std::string> m_warnings;
    /// The data file that readRaw() keeps open.
    struct OpenPart {
        std::size_t number = 0;
        InputFile file;
        std::uint64_t offset = 0;  // of its first voxel
    };
    std::optional<OpenPart> m_openPart;
};

}  // namespace echolucent
