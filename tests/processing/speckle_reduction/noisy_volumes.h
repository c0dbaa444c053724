// Small volumes for the tests of speckle reduction.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "processing/speckle_reduction/speckle_law.h"
#include "processing/volume/volume.h"
#include "tests/processing/grids.h"

namespace echolucent {

/// The value of a voxel, 0 or more, depends on its place, times 1 + noise * (a uniform number in [-1,1]).
template <typename Voxel>
Volume noisyVolume(const VolumeGeometry& geometry, double noise,
                   const std::function<double(std::int64_t, std::int64_t, std::int64_t)>& valueAt,
                   std::optional<double> white = std::nullopt) {
    std::mt19937 random(7);
    std::vector<Voxel> voxels;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const double uniform = static_cast<double>(random()) / 2147483648.0 - 1.0;
                const double value = valueAt(x, y, z) * (1.0 + noise * uniform);
                voxels.push_back(static_cast<Voxel>(std::min<double>(value, std::numeric_limits<Voxel>::max())));
            }
    return Volume(geometry, std::move(voxels), white);
}

/// A mask without the voxels for which `outside` is true.
inline std::vector<std::uint8_t> maskWithout(
    const VolumeGeometry& geometry, const std::function<bool(std::int64_t, std::int64_t, std::int64_t)>& outside) {
    std::vector<std::uint8_t> mask;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) mask.push_back(outside(x, y, z) ? 0 : 1);
    return mask;
}

struct Moments {
    double mean = 0.0, deviation = 0.0;
};

/// Moments of the voxels for which `counts` is true.
inline Moments momentsOf(const Volume& volume,
                         const std::function<bool(std::int64_t, std::int64_t, std::int64_t)>& counts) {
    const VolumeGeometry& geometry = volume.geometry();
    double n = 0, sum = 0, squares = 0;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                if (!counts(x, y, z)) continue;
                const double value = volume.storedValue(geometry.offset(x, y, z));
                n += 1;
                sum += value;
                squares += value * value;
            }
    return {sum / n, std::sqrt(std::max(0.0, squares / n - sum / n * sum / n))};
}

/// The law of a volume in one go.
inline SpeckleLaw speckleLawOf(const Volume& volume) {
    const std::int64_t slices = volume.geometry().size[2];
    SpeckleLawMeasurement measurement(volume.geometry());
    measurement.add(volume, {0, slices, 0, slices});
    return measurement.law();
}

}  // namespace echolucent
