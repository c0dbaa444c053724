// A grid of few voxels out of a large volume, for a picture before the whole volume is read.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "processing/volume/volume.h"

namespace echolucent {

/// Volumes of fewer voxels have no coarse grid, because reading them takes little time.
constexpr std::int64_t leastVoxelsForCoarse = std::int64_t{1} << 25;
/// The most voxels of a coarse grid along an axis.
constexpr std::int64_t mostCoarseVoxels = 128;

/// Every n-th voxel of a volume along each axis. Nothing is averaged.
struct CoarseGrid {
    std::array<std::int64_t, 3> stride{1, 1, 1};  ///< n of each axis, at least 1
    std::array<std::int64_t, 3> first{0, 0, 0};  ///< the volume's voxel that is the grid's first: the middle one of the
                                                 ///< first n; the lower of the two middle ones if n is even
    VolumeGeometry full;                         ///< of the volume
    VolumeGeometry geometry;                     ///< of the grid

    /// The index along `axis` of the volume's voxel at `place` (0 to geometry.size - 1) of the grid.
    [[nodiscard]] std::int64_t voxelOf(int axis, std::int64_t place) const {
        const auto of = static_cast<std::size_t>(axis);
        return first[of] + place * stride[of];
    }
    /// The whole volume's box, in grid mm of the coarse grid.
    [[nodiscard]] DataBox boxOfVolume() const;
};

/// A volume on its coarse grid. It stands for the whole volume until the whole volume is read.
struct CoarseVolume {
    /// Not null. Pictures are fitted to its data box. If data reach the border of the grid, the box ends where the
    /// whole volume's box ends.
    std::shared_ptr<const Volume> voxels;
    /// The length of the grid's unit in units of the volume, at least 1. Opacities are given per unit.
    double units = 1.0;
};

/// The coarse grid of a volume: its voxels are as near to cubes as the volume's voxels allow, at most mostCoarseVoxels
/// along each axis. No value for volumes of fewer than leastVoxelsForCoarse.
[[nodiscard]] std::optional<CoarseGrid> coarseGridOf(const VolumeGeometry& volume);

/// The coarse volume of `voxels`, which lie on `grid`. Its data box is the one of `voxels`, kept within the whole
/// volume's box and extended to that box where data reach the border of the grid.
[[nodiscard]] CoarseVolume coarseVolumeOf(const CoarseGrid& grid, const Volume& voxels);

/// The coarse volume of a volume that is already read: its voxels, white level and mask. No value if there is no coarse
/// grid.
[[nodiscard]] std::optional<CoarseVolume> coarseVolumeOf(const Volume& volume);

}  // namespace echolucent
