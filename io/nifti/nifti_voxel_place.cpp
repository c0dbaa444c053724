#include "io/nifti/nifti_voxel_place.h"

#include <cmath>

#include <fmt/format.h>

#include "io/files/input_problems.h"

namespace echolucent {

namespace {

// Four bytes between a header and voxels tell of extensions.
constexpr std::uint64_t bytesOfExtender = 4;

}  // namespace

NiftiVoxelPlace::NiftiVoxelPlace(const InputFile& file, const NiftiHeader& header, StoredVolume& stored)
    : m_file(file), m_header(header), m_stored(stored) {
    if (const auto counts = countBytes(stored)) m_voxelBytes = static_cast<std::uint64_t>(counts->all);
}

std::uint64_t NiftiVoxelPlace::headerBytes() const {
    return m_header.version == 1 ? shortestNiftiHeader : niftiHeaderBytes;
}

/// vox_offset; no value if it is no whole number of 0 or more.
std::optional<std::uint64_t> NiftiVoxelPlace::statedOffset() const {
    constexpr double largest = 4.5e15;  // up to here doubles hold every whole number
    const double offset = m_header.voxOffset;
    if (!(offset >= 0 && offset <= largest) || offset != std::floor(offset)) return std::nullopt;
    return static_cast<std::uint64_t>(offset);
}

bool NiftiVoxelPlace::fits(const InputFile& file, std::uint64_t offset) const {
    return m_voxelBytes && file.size() >= offset && file.size() - offset == *m_voxelBytes;
}

bool NiftiVoxelPlace::isHeaderAlone() const { return m_voxelBytes && m_file.size() < headerBytes() + *m_voxelBytes; }

/// The only place behind the header from which the voxels fill the file.
std::optional<std::uint64_t> NiftiVoxelPlace::provenOffset() const {
    for (const std::uint64_t offset : {headerBytes() + bytesOfExtender, headerBytes()})
        if (fits(m_file, offset)) return offset;
    return std::nullopt;
}

bool NiftiVoxelPlace::goesOnForItsVoxels() const { return provenOffset().has_value(); }

tl::unexpected<Failure> NiftiVoxelPlace::wrongOffset(std::uint64_t least) const {
    return fail(FailureKind::unreadable, m_stored.path, "vox_offset",
                fmt::format("must be a whole number of {} or more, not {:.9g}", least, m_header.voxOffset),
                correctHeader);
}

Result<void> NiftiVoxelPlace::inHeader() {
    const std::uint64_t least = headerBytes() + bytesOfExtender;
    const auto stated = statedOffset();
    if (!stated) return wrongOffset(least);
    m_stored.data = {{m_stored.path, m_file}};
    m_stored.extent.offset = *stated;
    if (m_header.voxelsApart)
        m_stored.warnings.emplace_back(
            "The magic puts the voxels into a file of their own; there is none, and they are read from behind the "
            "header, which the file's length proves.");
    if (*stated >= least) return {};
    const auto proven = provenOffset();
    if (!proven) return wrongOffset(least);
    m_stored.extent.offset = *proven;
    if (!m_header.voxelsApart)
        m_stored.warnings.push_back(
            fmt::format("vox_offset is {}, within the header: the voxels are read from byte {} on, which the file's "
                        "length proves.",
                        *stated, *proven));
    return {};
}

Result<void> NiftiVoxelPlace::apart(const InputFile& image) {
    const auto stated = statedOffset();
    if (!stated) return wrongOffset(0);
    m_stored.extent.offset = *stated;
    if (m_header.voxelsApart) return {};
    // The magic is that of one file, whose offset counts the header too.
    if (fits(image, 0)) m_stored.extent.offset = 0;
    m_stored.warnings.push_back(fmt::format(
        "The magic puts the voxels behind the header; they are missing there, and read from the .img beside "
        "it, from byte {} on.",
        m_stored.extent.offset));
    return {};
}

}  // namespace echolucent
