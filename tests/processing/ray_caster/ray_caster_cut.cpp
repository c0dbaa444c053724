// RayCaster::setCut(): pictures of a volume of which a scalpel cut something.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "processing/light/light_sweep.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

std::shared_ptr<const Volume> held(Volume volume) { return std::make_shared<const Volume>(std::move(volume)); }

/// Strokes down to the middle, as seen along z.
std::vector<ScalpelStroke> strokesOn(const Volume& volume) {
    const Camera camera = defaultCamera(volume.geometry(), Viewpoint{.azimuthDegrees = 10}, 1.0);
    const double middle = camera.frame.forward.dot(camera.focalPoint);
    return {{.camera = camera, .places = {{-0.3, -0.3}, {0.1, -0.35}, {0.15, 0.2}, {-0.2, 0.25}}, .depthMm = middle},
            {.tool = ScalpelTool::eraser, .camera = camera, .places = {{0.2, -0.4}, {0.2, 0.4}}, .radius = 0.06},
            {.side = ScalpelSide::outside, .camera = camera, .places = {{-0.4, -0.4}, {0.45, -0.4}, {0, 0.5}}}};
}

template <typename Voxel>
void expectFreshPicturesAfterEveryStroke(bool masked) {
    Volume scan = speckledShell<Voxel>({41, 37, 45}, {1, 1.2, 0.8}, 5);
    if (masked) {
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(scan.geometry().voxelCount()), 1);
        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i % 41 > 5 || i % 7 == 0 ? 1 : 0;
        scan = scan.withDataMask(mask);
    }
    const auto strokes = strokesOn(scan);
    RayCastSettings settings = settingsFor(scan, Viewpoint{BeamAxis::plusZ, 31, -22, 7, 0}, 57, 49);
    settings.findDepth = true;
    std::vector<RayCastSettings> looks(3, settings);
    looks[1].shading = Shading{.reaching = ReachingLight{}};
    looks[2].mode = RenderMode::maximum;
    const OpacityCurve curve = LinearCurve{0.2, 0.7, 0.9};
    for (const RayCastSettings& look : looks) {
        RayCaster caster(held(scan));
        ScalpelCuts cuts(scan.geometry());
        std::vector<Picture> pictures;
        const auto expectFresh = [&](std::size_t count) {
            const auto cut = held(*cuts.cut(scan, std::span(strokes).first(count)));
            caster.setCut(cut);
            // Twice, the second from kept samples' place: what was kept of the volume before must be gone.
            Picture picture = *caster.cast(curve, look);
            const Picture fresh = *RayCaster(cut).cast(curve, look);
            EXPECT_EQ(picture.rgba, fresh.rgba) << count;
            EXPECT_EQ(picture.depthMm, fresh.depthMm) << count;
            (void)caster.cast(curve, look);
            return picture;
        };
        for (std::size_t count = 0; count <= strokes.size(); ++count) {
            pictures.push_back(expectFresh(count));
            if (count > 0) {
                EXPECT_NE(pictures[count].rgba, pictures[count - 1].rgba) << "a stroke shows";
            }
        }
        for (std::size_t count = strokes.size(); count-- > 0;)
            EXPECT_EQ(expectFresh(count).rgba, pictures[count].rgba) << "taken back, bit for bit";
    }
}

TEST(RayCasterCut, PicturesAreThoseOfAFreshRayCaster) {
    expectFreshPicturesAfterEveryStroke<std::uint8_t>(false);
    expectFreshPicturesAfterEveryStroke<std::uint8_t>(true);
    expectFreshPicturesAfterEveryStroke<std::uint16_t>(true);
    expectFreshPicturesAfterEveryStroke<float>(false);
}

TEST(RayCasterCut, AgreesWithThePlainRoute) {
    const Volume scan = speckledShell<std::uint8_t>({41, 37, 45}, {1, 1.2, 0.8}, 5);
    const Volume cut = *ScalpelCuts(scan.geometry()).cut(scan, strokesOn(scan));
    RayCastSettings settings = settingsFor(scan, Viewpoint{BeamAxis::plusZ, 31, -22, 7, 0}, 57, 49);
    const OpacityCurve curve = LinearCurve{0.2, 0.7, 0.9};
    const Apart difference = apart(*castRays(cut, curve, settings), *castRaysPlainly(cut, curve, settings));
    std::printf("cut: RMSE %.4f, largest %.3f levels\n", difference.rootMeanSquare, difference.largest);
    EXPECT_LT(difference.rootMeanSquare, 0.1);
    EXPECT_LT(difference.largest, 1.0);
}

TEST(RayCasterCut, WhatWasCutHoldsBackNoLight) {
    VolumeGeometry geometry;
    geometry.size = {32, 32, 32};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 0);
    for (std::int64_t y = 0; y < 32; ++y)
        for (std::int64_t x = 0; x < 32; ++x) voxels[static_cast<std::size_t>(geometry.offset(x, y, 8))] = 255;
    const Volume scan(geometry, voxels);
    const Camera camera = defaultCamera(geometry, Viewpoint{}, 1.0);
    const ScalpelStroke above{.camera = camera, .places = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, .depthMm = 10};
    LightScene scene;
    const auto keyIn = [&](const Volume& volume) {
        return reachingAt(*LightSweep(held(volume)).lightVolume(LinearCurve{0.2, 0.8, 1.0}, scene), {16, 16, 20}).key;
    };
    EXPECT_LT(keyIn(scan), 0.7);
    EXPECT_GT(keyIn(*ScalpelCuts(geometry).cut(scan, {&above, 1})), 0.99);
}

TEST(RayCasterCut, AnotherScanIsRefused) {
    const Volume scan = speckledShell<std::uint8_t>({20, 20, 20}, {1, 1, 1}, 5);
    RayCaster caster(held(scan));
    EXPECT_THROW(caster.setCut(held(speckledShell<std::uint8_t>({20, 20, 20}, {1, 1, 1}, 5))), std::invalid_argument);
    EXPECT_THROW(caster.setCut(held(scan.withDataMask(std::vector<std::uint8_t>(8000, 1)))), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
