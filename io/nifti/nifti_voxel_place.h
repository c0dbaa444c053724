// At which byte the voxels of a NIfTI begin. Where the header is wrong about it, the length of the file may prove
// better.
#pragma once

#include <cstdint>
#include <optional>

#include "io/files/input_file.h"
#include "io/nifti/nifti_header.h"
#include "io/stored/stored_volume.h"

namespace echolucent {

/// Finds the first voxel, and sets it in a stored volume, whose size and type are set.
class NiftiVoxelPlace {
public:
    /// All must outlive this. `file` is the one that begins with the header.
    NiftiVoxelPlace(const InputFile& file, const NiftiHeader& header, StoredVolume& stored);

    /// Whether the header's file cannot hold the voxels.
    [[nodiscard]] bool isHeaderAlone() const;
    /// Whether the header's file goes on for exactly its voxels behind a header.
    [[nodiscard]] bool goesOnForItsVoxels() const;
    /// The voxels follow their header: sets data and extent. A vox_offset within the header is put right, with a note,
    /// if the length of the file leaves no doubt. Fails (unreadable) if vox_offset is no place for voxels.
    [[nodiscard]] Result<void> inHeader();
    /// The voxels lie in `image`: sets the extent. Fails (unreadable) if vox_offset is no place for voxels.
    [[nodiscard]] Result<void> apart(const InputFile& image);

private:
    [[nodiscard]] std::uint64_t headerBytes() const;
    [[nodiscard]] std::optional<std::uint64_t> statedOffset() const;
    [[nodiscard]] bool fits(const InputFile& file, std::uint64_t offset) const;
    [[nodiscard]] std::optional<std::uint64_t> provenOffset() const;
    [[nodiscard]] tl::unexpected<Failure> wrongOffset(std::uint64_t least) const;

    const InputFile& m_file;
    const NiftiHeader& m_header;
    StoredVolume& m_stored;
    std::optional<std::uint64_t> m_voxelBytes;  // of all phases; no value if no file can hold them
};

}  // namespace echolucent
