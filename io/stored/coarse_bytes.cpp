#include "io/stored/coarse_bytes.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

// Several rows of the grid are read at once, with the rows between them, up to this size. That takes fewer calls, and
// little memory.
constexpr std::int64_t rowsPieceBytes = std::int64_t{1} << 20;
constexpr std::int64_t mostRowBytes = std::int64_t{1} << 22;

/// Takes every n-th voxel of a row. A voxel has `voxelBytes` bytes.
template <typename Count>
void takeVoxels(const std::uint8_t* row, const CoarseGrid& grid, Count voxelBytes, std::uint8_t* to) {
    for (std::int64_t x = 0; x < grid.geometry.size[0]; ++x, to += voxelBytes)
        std::memcpy(to, row + static_cast<std::size_t>(grid.voxelOf(0, x)) * voxelBytes, voxelBytes);
}

/// As takeVoxels(), but much faster, because the compiler knows the common numbers of bytes.
void takeRow(const std::uint8_t* row, const CoarseGrid& grid, std::size_t voxelBytes, std::uint8_t* to) {
    switch (voxelBytes) {
        case 1: return takeVoxels(row, grid, std::integral_constant<std::size_t, 1>{}, to);
        case 2: return takeVoxels(row, grid, std::integral_constant<std::size_t, 2>{}, to);
        case 4: return takeVoxels(row, grid, std::integral_constant<std::size_t, 4>{}, to);
        default: return takeVoxels(row, grid, voxelBytes, to);
    }
}

}  // namespace

std::optional<CoarseGrid> coarseGridOf(const StoredVolume& stored) {
    if (stored.extent.encoding != VoxelEncoding::raw || stored.phasesFastest || stored.polar) return std::nullopt;
    // A volume that the full reading will refuse gets no coarse picture.
    const bool sensible = isSensibleSpacing(stored.geometry.spacing) &&
                          stored.geometry.size[0] * bytesOf(stored.type) * stored.channels <= mostRowBytes;
    return sensible ? coarseGridOf(stored.geometry) : std::nullopt;
}

Result<VoxelBytes> readCoarseBytes(const StoredVolume& stored, StoredBytes& source, const CoarseGrid& grid,
                                   const Progress& progress) {
    const std::int64_t voxelBytes = bytesOf(stored.type) * stored.channels;
    const std::int64_t rowBytes = grid.full.size[0] * voxelBytes;
    const std::int64_t rows = grid.geometry.size[1];
    const std::int64_t rowsAtOnce = std::clamp<std::int64_t>(rowsPieceBytes / (rowBytes * grid.stride[1]), 1, rows);
    VoxelBytes bytes(static_cast<std::size_t>(grid.geometry.voxelCount() * voxelBytes));
    std::vector<std::uint8_t> piece(static_cast<std::size_t>(((rowsAtOnce - 1) * grid.stride[1] + 1) * rowBytes));
    std::uint8_t* to = bytes.data();
    for (std::int64_t z = 0; z < grid.geometry.size[2]; ++z) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, stored.path, "", "was not read: cancelled");
        for (std::int64_t y = 0; y < rows; y += rowsAtOnce) {
            const std::int64_t count = std::min(rowsAtOnce, rows - y);
            const auto length = static_cast<std::size_t>(((count - 1) * grid.stride[1] + 1) * rowBytes);
            const std::int64_t first = grid.full.offset(0, grid.voxelOf(1, y), grid.voxelOf(2, z)) * voxelBytes;
            const auto read = source.readRaw(static_cast<std::uint64_t>(first), {piece.data(), length});
            if (!read) return tl::unexpected(read.error());
            for (std::int64_t row = 0; row < count; ++row, to += grid.geometry.size[0] * voxelBytes)
                takeRow(piece.data() + row * grid.stride[1] * rowBytes, grid, static_cast<std::size_t>(voxelBytes), to);
        }
    }
    return bytes;
}

}  // namespace echolucent
