// Scans that show what there is to see from one side alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "tests/processing/grids.h"

namespace echolucent {

inline constexpr double dark = 14, bright = 85;  // stored values
inline constexpr std::int64_t voxelsOfEdge = 64;
inline constexpr double voxelMm = 0.75, middleMm = (voxelsOfEdge - 1) * voxelMm / 2;

/// A cube of 48 mm, of a stored value for each place.
inline Volume cubeOf(const std::function<double(const Vec3& mm)>& value) {
    const VolumeGeometry geometry = gridOf({voxelsOfEdge, voxelsOfEdge, voxelsOfEdge}, {voxelMm, voxelMm, voxelMm});
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::int64_t z = 0; z < voxelsOfEdge; ++z)
        for (std::int64_t y = 0; y < voxelsOfEdge; ++y)
            for (std::int64_t x = 0; x < voxelsOfEdge; ++x)
                voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] = static_cast<std::uint8_t>(
                    value(Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)) * voxelMm));
    return {geometry, std::move(voxels)};
}

/// A cavity in tissue. Seen along `forward`, a flat wall of 14 mm stands before it, and on its floor a hill, which
/// nearly reaches the wall. Only from there a flat front lays the whole hill bare: from behind, the front would have to
/// pass through it.
inline Volume hillSeenAlong(const Vec3& forward, double radiusMm = 18) {
    return cubeOf([&](const Vec3& mm) {
        const Vec3 fromMiddle = mm - Vec3(middleMm, middleMm, middleMm);
        const double depth = fromMiddle.dot(forward) + middleMm;
        const double aside =
            std::sqrt(std::max(0.0, fromMiddle.dot(fromMiddle) - std::pow(fromMiddle.dot(forward), 2)));
        const double floor = 32 - 14 * std::exp(-std::pow(aside / radiusMm * 18 / 13, 4));
        return aside < radiusMm && depth >= 14 && depth < floor ? dark : bright;
    });
}

}  // namespace echolucent
