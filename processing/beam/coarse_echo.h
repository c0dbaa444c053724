// A volume in at most 48 cells along each axis: made fast, and enough for questions about the whole scan.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "processing/progress.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Means over cells of a volume; index order: x fastest, then y, then z.
struct CoarseEcho {
    std::array<int, 3> size{0, 0, 0};  ///< cells along x, y, z; at most CoarseEcho::mostCells
    Vec3 cellMm{1, 1, 1};              ///< edges of a cell, mm
    std::vector<float> dataShare;      ///< share of the sampled voxels of a cell that are data, [0,1]
    std::vector<float> echo;  ///< mean stored value of the cell's sampled data voxels above 0; 0 if there is none

    static constexpr int mostCells = 48;           ///< along an axis
    static constexpr float leastDataShare = 0.5F;  ///< a cell of at least this share counts as data

    /// Distance in the arrays between neighbours along an axis.
    [[nodiscard]] std::size_t stride(int axis) const {
        const auto width = static_cast<std::size_t>(size[0]);
        return axis == 0 ? 1 : axis == 1 ? width : width * static_cast<std::size_t>(size[1]);
    }
};

/// Reads every voxel along x, but at most four rows and four slices of each cell. The result is the same for any number
/// of threads, and empty only if the work was cancelled.
[[nodiscard]] std::optional<CoarseEcho> coarseEchoOf(const Volume& volume, const Progress& progress = {});

}  // namespace echolucent
