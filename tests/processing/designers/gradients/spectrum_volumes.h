// Volumes whose isosurfaces are known, for the tests of the contour spectrum.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

inline Volume floatVolume(const VolumeGeometry& geometry, const auto& intensityAt) {
    std::vector<float> voxels;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                voxels.push_back(static_cast<float>(intensityAt(geometry.gridMmFromVoxel(
                    {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}))));
    return {geometry, std::move(voxels), 1.0};
}

/// The intensity falls with the distance from the centre of a cube, by 1 over `reachMm`, down to 0.
struct Ball {
    Vec3 centreMm;
    double reachMm;

    [[nodiscard]] Volume volume(const VolumeGeometry& geometry) const {
        return floatVolume(geometry, [this](const Vec3& mm) { return 1.0 - cv::norm(mm - centreMm) / reachMm; });
    }
    [[nodiscard]] double radius(double isovalue) const { return (1.0 - isovalue) * reachMm; }
    [[nodiscard]] double area(double isovalue) const {
        return 4.0 * std::numbers::pi * radius(isovalue) * radius(isovalue);
    }
    [[nodiscard]] double content(double isovalue) const { return area(isovalue) * radius(isovalue) / 3.0; }
};

/// Bytes that depend on a seed alone.
inline std::vector<std::uint8_t> scatteredBytes(std::int64_t count, std::uint32_t seed) {
    std::vector<std::uint8_t> bytes;
    std::uint32_t state = seed;
    for (std::int64_t i = 0; i < count; ++i) {
        state = state * 1664525U + 1013904223U;
        bytes.push_back(static_cast<std::uint8_t>(state >> 24));
    }
    return bytes;
}

}  // namespace echolucent
