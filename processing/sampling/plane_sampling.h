// Grey values of a plane through a volume. As the plain sampler (sampler.h), but fast for many places in rows.
#pragma once

#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

/// Places in equal steps: place (column, row) lies at firstMm + perColumnMm * column + perRowMm * row; grid mm.
struct PlaneGrid {
    Vec3 firstMm{0, 0, 0};
    Vec3 perColumnMm{1, 0, 0};
    Vec3 perRowMm{0, 1, 0};
    int columns = 0, rows = 0;  ///< at least 0 each
    friend bool operator==(const PlaneGrid&, const PlaneGrid&) = default;
};

struct PlaneSamples {
    int columns = 0, rows = 0;
    /// Normalised, row by row. NaN outside the volume's box, and where VolumeSampler::intensityAt() is empty.
    std::vector<float> intensity;
};

/// The trilinear values of VolumeSampler at each place, to 1e-6. Works in the calling thread's oneTBB arena.
[[nodiscard]] PlaneSamples sampledPlane(const Volume& volume, const PlaneGrid& grid);

}  // namespace echolucent
