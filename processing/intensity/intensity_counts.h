// How often each intensity occurs in a volume, and its percentiles.
#pragma once

#include <cstdint>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

/// The intensities of the voxels with data, and how often each occurs. Bytes and words count at their own intensity.
/// Float voxels count at the nearest of 65536 equidistant intensities from 0 to 1. Values below 0 count as 0, values
/// above the white level as 1.
struct IntensityCounts {
    std::vector<double> intensities;    ///< normalised, [0,1], ascending, each once
    std::vector<std::uint64_t> counts;  ///< one an intensity, each above 0
    std::uint64_t total = 0;            ///< sum of the counts: voxels with data
    friend bool operator==(const IntensityCounts&, const IntensityCounts&) = default;
};

/// Float voxels that are not finite never count, whatever the mask says.
[[nodiscard]] IntensityCounts intensityCounts(const Volume& volume);

/// The least intensity that at least `percent` % of the voxels do not exceed (the nearest rank); for 0 % the smallest
/// intensity. Throws std::invalid_argument if no voxel was counted or the percentage is not within 0 and 100.
[[nodiscard]] double percentileOf(const IntensityCounts& counts, double percent);

}  // namespace echolucent
