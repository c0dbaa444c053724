// Steps between two intensities, blurred by a Gaussian, in closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include "processing/volume/volume.h"

namespace echolucent {

struct BlurredStep {
    double low = 0.12, high = 0.83;  ///< normalised intensities of both sides
    double sigma = 2.0;              ///< standard deviation of the blur, units

    [[nodiscard]] double at(double units) const {
        return low + (high - low) * 0.5 * (1.0 + std::erf(units / (sigma * std::numbers::sqrt2)));
    }
    /// The place at which the step has this intensity, units; by bisection.
    [[nodiscard]] double positionOf(double intensity) const {
        double below = -8.0 * sigma, above = 8.0 * sigma;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (below + above);
            (at(middle) < intensity ? below : above) = middle;
        }
        return 0.5 * (below + above);
    }
};

/// Signed distance (units) to a boundary from a place, which is in units from the middle of the grid.
using BoundaryDistance = std::function<double(const Vec3&)>;

inline BoundaryDistance planeAcross(const Vec3& normal) {
    return [unit = normalized(normal)](const Vec3& place) { return unit.dot(place) + 0.13; };
}
inline BoundaryDistance sphereOf(double radius) {
    return [radius](const Vec3& place) { return radius - length(place); };
}

/// The normalised intensity at each voxel as 8 bits, 16 bits or float, of the type's usual white level.
template <typename Voxel>
Volume volumeOf(const VolumeGeometry& geometry, const std::function<double(const Vec3&)>& intensityAt) {
    const double white = std::is_same_v<Voxel, std::uint8_t> ? 255.0 : std::is_same_v<Voxel, float> ? 1.0 : 65535.0;
    const Vec3 middle(0.5 * static_cast<double>(geometry.size[0] - 1), 0.5 * static_cast<double>(geometry.size[1] - 1),
                      0.5 * static_cast<double>(geometry.size[2] - 1));
    std::vector<Voxel> voxels;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const Vec3 voxel(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
                const double value = white * intensityAt((voxel - middle).mul(geometry.spacing) / geometry.unit());
                voxels.push_back(static_cast<Voxel>(std::is_same_v<Voxel, float> ? value : std::round(value)));
            }
    return Volume(geometry, std::move(voxels), white);
}

template <typename Voxel>
Volume steppedVolume(const VolumeGeometry& geometry, const BlurredStep& step, const BoundaryDistance& distance) {
    return volumeOf<Voxel>(geometry, [&](const Vec3& place) { return step.at(distance(place)); });
}

}  // namespace echolucent
