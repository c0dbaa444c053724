// A grid of few voxels out of a large volume's, for a picture that is there before the volume is.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "processing/volume/volume.h"

namespace echolucent {

/// Volumes of fewer voxels have no coarse grid: they are read and looked through at once.
constexpr std::int64_t leastVoxelsForCoarse = std::int64_t{1} << 25;
/// A coarse grid has no more voxels along an axis.
constexpr std::int64_t mostCoarseVoxels = 128;

/// Every n-th voxel of a volume along each axis, where they are: nothing is averaged.
struct CoarseGrid {
    std::array<std::int64_t, 3> stride{1, 1, 1};  ///< n of each axis, at least 1
    std::array<std::int64_t, 3> first{0, 0, 0};   ///< the voxel of the volume that is the grid's first: in the middle
                                                  ///< of the first n, or one before it
    VolumeGeometry full;                          ///< of the volume
    VolumeGeometry geometry;                      ///< of the grid

    /// The voxel of the volume that stands at place (0 to geometry.size - 1) of the grid along an axis.
    [[nodiscard]] std::int64_t voxelOf(int axis, std::int64_t place) const {
        const auto of = static_cast<std::size_t>(axis);
        return first[of] + place * stride[of];
    }
    /// The whole volume's box, in grid mm of the coarse grid.
    [[nodiscard]] DataBox boxOfVolume() const;
};

/// What is seen of a volume on its coarse grid: a volume that stands for the whole one until that is there.
struct CoarseVolume {
    /// Pictures are fitted to its data box, which ends where the volume's ends wherever data reach the border of the
    /// grid. It is not null.
    std::shared_ptr<const Volume> voxels;
    /// How many units of the volume one unit of the grid is long, at least 1: opacities are given per unit.
    double units = 1.0;
};

/// The coarse grid of a volume: its voxels are as near to cubes as those of the volume allow, and it fits into
/// mostCoarseVoxels along each axis. No value for volumes of fewer than leastVoxelsForCoarse.
[[nodiscard]] std::optional<CoarseGrid> coarseGridOf(const VolumeGeometry& volume);

/// Voxels on a coarse grid, fitted to the box of the whole volume.
[[nodiscard]] CoarseVolume coarseVolumeOf(const CoarseGrid& grid, const Volume& voxels);

/// What a coarse grid shows of a volume that is there: its voxels, its white level, and its mask. No value where there
/// is no coarse grid.
[[nodiscard]] std::optional<CoarseVolume> coarseVolumeOf(const Volume& volume);

}  // namespace echolucent
