// Volumes with one flat interface between fluid and tissue, for tests that know where the surface is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "processing/volume/volume.h"

namespace echolucent {

/// A volume with fluid before the plane, tissue behind it, a linear ramp between and mild noise.
struct PlaneVolume {
    std::array<std::int64_t, 3> size{100, 100, 100};
    Vec3 spacing{1, 1, 1};
    Vec3 normal{0, 0, 1};    ///< unit, grid mm, from fluid to tissue
    double distanceMm = 50;  ///< plane: normal . x = distanceMm
    double fluid = 14, tissue = 120;
    double rampMm = 3;
    double noise = 2;  ///< standard deviation
    std::uint32_t seed = 5;

    [[nodiscard]] VolumeGeometry geometry() const {
        VolumeGeometry made;
        made.size = size;
        made.spacing = spacing;
        return made;
    }
    /// Distance in mm from a point to the plane along a direction.
    [[nodiscard]] double toPlane(const Vec3& fromMm, const Vec3& direction) const {
        return (distanceMm - normal.dot(fromMm)) / normal.dot(direction);
    }
    /// The volume in any voxel type; its values 0 to 255 are multiplied by the scale.
    template <typename Stored>
    [[nodiscard]] std::vector<Stored> voxels(double scale = 1.0) const {
        std::mt19937 random(seed);
        std::normal_distribution<double> disturbance(0.0, 1.0);
        std::vector<Stored> made;
        for (std::int64_t z = 0; z < size[2]; ++z)
            for (std::int64_t y = 0; y < size[1]; ++y)
                for (std::int64_t x = 0; x < size[0]; ++x) {
                    const Vec3 mm =
                        Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)).mul(spacing);
                    const double share = std::clamp((normal.dot(mm) - distanceMm) / rampMm + 0.5, 0.0, 1.0);
                    const double echo = fluid + share * (tissue - fluid) + noise * disturbance(random);
                    made.push_back(static_cast<Stored>(std::round(std::clamp(echo, 0.0, 255.0) * scale)));
                }
        return made;
    }
    [[nodiscard]] Volume make() const { return Volume(geometry(), voxels<std::uint8_t>()); }
};

}  // namespace echolucent
