// The border of the data of a scan in pictures: where it is shown, and how smooth it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "processing/ray_caster/ray_caster.h"
#include "processing/ray_caster/ray_geometry.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "processing/volume/filled_volume.h"
#include "tests/processing/ray_caster/ray_caster_scenes.h"
#include "tests/processing/speckle_reduction/noisy_volumes.h"
#include "tests/processing/speckle_reduction/shown_border.h"

namespace echolucent {
namespace {

constexpr double sectorTissue = 120.0, edgeAtTop = 33.0, edgePerSlice = 0.18;

/// A sector whose side is the plane x = edgeAtTop + edgePerSlice z, interpolated onto the grid from voxels twice as
/// large: it fades over two voxels. As the guess does, the mask marks what is not black.
Volume sector() {
    const VolumeGeometry geometry = gridOf({56, 24, 64});
    const Volume volume = noisyVolume<std::uint8_t>(geometry, 0.3, [](auto x, auto, auto z) {
        const double inside = edgeAtTop + edgePerSlice * static_cast<double>(z) - static_cast<double>(x);
        return sectorTissue * std::clamp(0.5 * (inside + 1.0), 0.0, 1.0);
    });
    std::vector<std::uint8_t> mask;
    for (std::int64_t i = 0; i < geometry.voxelCount(); ++i) mask.push_back(volume.storedValue(i) > 0.0 ? 1 : 0);
    return volume.withDataMask(std::move(mask));
}

/// The border of a picture along y, less the plane of the mask's own border, voxels along x.
std::vector<std::optional<double>> shownBeyondMask(const Volume& volume) {
    // The outermost voxel of a row lies up to a voxel before the place where the echo ends, on average half a voxel.
    // Its own end is half a voxel farther.
    constexpr double maskBeyondEcho = 1.0;
    RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusY}, 224, 256);
    settings.step = 0.5;
    const OpacityCurve curve = ManualCurve{{{0.1, 0.0}, {0.2, 0.3}, {1.0, 0.3}}};
    auto border = rightBorder(*castRays(volume, curve, settings));
    const ray_casting::RayGeometry rays(volume.geometry(), settings);
    for (std::size_t row = 0; row < border.size(); ++row) {
        const auto first = rays.rayThrough(0, static_cast<int>(row)), next = rays.rayThrough(1, static_cast<int>(row));
        const double z = first.origin[2];
        if (!border[row] || z < 8.0 || z > 55.0) {
            border[row].reset();
            continue;
        }
        const double x = first.origin[0] + (*border[row] - 0.5) * (next.origin[0] - first.origin[0]);
        border[row] = x - (edgeAtTop + edgePerSlice * z + maskBeyondEcho);
    }
    return border;
}

TEST(ShownBorder, IsAsSmoothAsTheSectorAtEveryReduction) {
    const Volume volume = sector();
    // Rays are half opaque where the coverage of 24 units of tissue lets half of the light through.
    const double coverage = (1.0 - std::pow(0.5, 1.0 / 24.0)) / 0.3;
    const double presence = (coverage + 0.5) / 2.0;
    const double beyond = 0.5 + (5.0 / 16.0 - presence) / 0.25;  // where the binomial of a plane has that presence
    for (const SpeckleReduction reduction : allSpeckleReductions) {
        const auto border = shownBeyondMask(*quietVolume(volume, reduction));
        double sum = 0.0, count = 0.0, squares = 0.0;
        for (const auto& at : border)
            if (at) {
                sum += *at;
                squares += *at * *at;
                ++count;
            }
        ASSERT_GT(count, 150.0);
        const double mean = sum / count, rough = std::sqrt(std::max(0.0, squares / count - mean * mean));
        if (reduction == SpeckleReduction::off) {
            // Raw voxels fade, each with its own speckle: as rough as the mask's stairs are high, and where it ends.
            EXPECT_NEAR(mean, 0.0, 0.15);
            EXPECT_LT(rough, 0.5);
            continue;
        }
        EXPECT_NEAR(mean, beyond, 0.15) << nameOf(reduction);
        EXPECT_LT(rough, 0.05) << nameOf(reduction);
        EXPECT_LT(roughnessOf(border, 22), 0.05) << nameOf(reduction) << ": about the mean of 11 voxels";
    }
}

TEST(ShownBorder, StaysWhereTheDataDoNotFade) {
    // A hard edge has no rim: its quiet voxels are those of the filter alone.
    const VolumeGeometry geometry = gridOf({40, 24, 24});
    const Volume volume = noisyVolume<std::uint8_t>(geometry, 0.3, [](auto x, auto, auto) {
                              return x < 24 ? sectorTissue : 0.0;
                          }).withDataMask(maskWithout(geometry, [](auto x, auto, auto) { return x >= 24; }));
    const Volume quiet = *quietVolume(volume, SpeckleReduction::medium);
    const Volume brighter =
        *quietVolume(noisyVolume<std::uint8_t>(
                         geometry, 0.3, [](auto x, auto, auto) { return x < 23   ? sectorTissue
                                                                        : x < 24 ? 240.0
                                                                                 : 0.0; })
                         .withDataMask(volume.dataMask()),
                     SpeckleReduction::medium);
    EXPECT_GT(brighter.storedValue(geometry.offset(23, 12, 12)), 1.3 * quiet.storedValue(geometry.offset(23, 12, 12)));
}

TEST(ShownBorder, FluidAtTheBorderStaysFluid) {
    // The rim of tissue takes the tissue's value, that of fluid the fluid's, though tissue lies three voxels inside.
    const VolumeGeometry geometry = gridOf({40, 24, 40});
    const auto inside = [](auto x, auto z) {
        const double value = z < 12 && x > 19 ? 8.0 : sectorTissue;
        return value * std::clamp(0.5 * (24.0 - static_cast<double>(x)), 0.0, 1.0);
    };
    const Volume volume = noisyVolume<std::uint8_t>(geometry, 0.1, [&](auto x, auto, auto z) {
                              return inside(x, z);
                          }).withDataMask(maskWithout(geometry, [](auto x, auto, auto) { return x >= 24; }));
    for (const SpeckleReduction reduction : {SpeckleReduction::medium, SpeckleReduction::strong}) {
        const Volume quiet = *quietVolume(volume, reduction);
        EXPECT_GT(quiet.storedValue(geometry.offset(23, 12, 30)), 0.8 * sectorTissue) << nameOf(reduction);
        EXPECT_LT(quiet.storedValue(geometry.offset(23, 12, 5)), 0.2 * sectorTissue) << nameOf(reduction);
    }
}

}  // namespace
}  // namespace echolucent
