// The distribution of intensities behind the OTF editor.
#pragma once

#include <array>
#include <cstdint>

#include "processing/volume/volume.h"

namespace echolucent {

/// Counts of data voxels by normalised intensity: bin i holds [i/256, (i+1)/256), the last one 1 too.
struct IntensityHistogram {
    std::array<std::uint64_t, 256> counts{};
    std::uint64_t total = 0;
    friend bool operator==(const IntensityHistogram&, const IntensityHistogram&) = default;
};

[[nodiscard]] IntensityHistogram intensityHistogram(const Volume& volume);

}  // namespace echolucent
