// Volumes, curves and measures that the tests of the ray caster share.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "processing/opacity_curve.h"
#include "processing/picture/picture.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"
#include "ray_caster_reference.h"

namespace echolucent {

/// A curve that is transparent except in a range of intensities, as adaptive curves are.
inline OpacityCurve onlyBetween(double lowest, double highest, double opacity) {
    const double middle = 0.5 * (lowest + highest);
    return ManualCurve{{{0.0, 0.0}, {lowest, 0.0}, {middle, opacity}, {highest, 0.0}, {1.0, 0.0}}};
}

/// A volume as a ray caster keeps it.
inline std::shared_ptr<const Volume> held(Volume volume) { return std::make_shared<const Volume>(std::move(volume)); }

/// An oblique view of the shell. Rays do not end before all light is absorbed.
inline RayCastSettings obliqueSettings(const Volume& volume, int width, int height) {
    return settingsFor(volume, Viewpoint{BeamAxis::plusZ, 31, -22, 7}, width, height);
}

/// The value of normalised intensity 1 for a voxel type in the tests.
template <typename Voxel>
constexpr double whiteOf = std::is_same_v<Voxel, std::uint8_t>    ? 255.0
                           : std::is_same_v<Voxel, std::uint16_t> ? 4095.0
                                                                  : 3.5;

/// A volume whose voxels have the normalised intensity(x, y, z).
template <typename Voxel, typename Intensity>
Volume volumeOf(const std::array<std::int64_t, 3>& size, const Vec3& spacing, const Intensity& intensity) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    std::vector<Voxel> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x) {
                const double value = intensity(x, y, z) * whiteOf<Voxel>;
                voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] =
                    static_cast<Voxel>(std::is_same_v<Voxel, float> ? value : std::round(value));
            }
    return Volume(geometry, std::move(voxels), whiteOf<Voxel>);
}

template <typename Voxel>
Volume constantVolume(const std::array<std::int64_t, 3>& size, double intensity, const Vec3& spacing = {1, 1, 1}) {
    return volumeOf<Voxel>(size, spacing, [&](auto...) { return intensity; });
}

/// A dark volume with a bright shell and a dim core in the middle, and speckle on all of it.
template <typename Voxel>
Volume speckledShell(const std::array<std::int64_t, 3>& size, const Vec3& spacing, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(0.0, 0.12);
    const Vec3 centre{0.5 * static_cast<double>(size[0] - 1), 0.5 * static_cast<double>(size[1] - 1),
                      0.5 * static_cast<double>(size[2] - 1)};
    return volumeOf<Voxel>(size, spacing, [&](auto x, auto y, auto z) {
        const Vec3 at{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        Vec3 away = at - centre;
        for (int axis = 0; axis < 3; ++axis) away[axis] /= centre[axis] + 1.0;
        const double radius = length(away);
        const double shape = 0.75 * std::exp(-std::pow((radius - 0.6) / 0.12, 2)) + (radius < 0.5 ? 0.25 : 0.0);
        return std::min(1.0, shape + noise(random));
    });
}

/// The same volume with data in a sector only, and with a few holes.
inline Volume sectorOf(const Volume& volume) {
    const auto& size = volume.geometry().size;
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(volume.geometry().voxelCount()), 1);
    std::mt19937 dice(3);
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x) {
                const double across = std::abs(static_cast<double>(2 * x - size[0]));
                if (across > 0.3 * static_cast<double>(size[0]) + 1.1 * static_cast<double>(z) || dice() % 200 == 0)
                    mask[static_cast<std::size_t>(volume.geometry().offset(x, y, z))] = 0;
            }
    return volume.withDataMask(std::move(mask));
}

/// How far two pictures are apart, in 8-bit levels.
struct Apart {
    double rootMeanSquare = 0.0, largest = 0.0;
};
inline Apart apart(const Picture& a, const Picture& b) {
    Apart result;
    if (a.rgba.size() != b.rgba.size()) return {1e30, 1e30};
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const double difference = 255.0 * std::abs(static_cast<double>(a.rgba[i]) - static_cast<double>(b.rgba[i]));
        // A NaN counts as the worst.
        result.largest = difference <= result.largest ? result.largest : std::isnan(difference) ? 1e30 : difference;
        result.rootMeanSquare += difference * difference;
    }
    result.rootMeanSquare = std::sqrt(result.rootMeanSquare / static_cast<double>(a.rgba.size()));
    return result;
}

/// Expects that every value is a number in [0,1] and that no colour exceeds its alpha.
inline void expectSound(const Picture& picture, const std::string& what) {
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        ASSERT_TRUE(picture.rgba[i] >= 0.0f && picture.rgba[i] <= 1.0f) << what << ": " << picture.rgba[i];
        ASSERT_LE(picture.rgba[i], picture.rgba[i / 4 * 4 + 3] + 1e-5f) << what << ": brighter than opaque";
    }
}

inline float largestAlpha(const Picture& picture) {
    float largest = 0.0f;
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) largest = std::max(largest, picture.rgba[i]);
    return largest;
}

}  // namespace echolucent
