// The distribution of intensities behind the OTF editor.
#pragma once

#include <array>
#include <cstdint>

#include "processing/volume/volume.h"

namespace echolucent {

/// Counts of the voxels with data by normalised intensity. Bin i counts [i/256, (i+1)/256); the last bin counts 1 and
/// above, the first one values below 0 and NaN.
struct IntensityHistogram {
    std::array<std::uint64_t, 256> counts{};
    std::uint64_t total = 0;  ///< sum of the counts
    friend bool operator==(const IntensityHistogram&, const IntensityHistogram&) = default;
};

[[nodiscard]] IntensityHistogram intensityHistogram(const Volume& volume);

}  // namespace echolucent
