// RayCaster::setCut(): pictures of a volume of which a scalpel cut something.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <limits>
#include <random>
#include <utility>

#include "processing/light/light_sweep.h"
#include "processing/picture/picture_place.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "ray_caster_scenes.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

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
    RayCastSettings settings = obliqueSettings(scan, 57, 49);
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

/// A stroke anywhere, of any tool, as somebody draws it who looks from anywhere.
ScalpelStroke randomStroke(const Volume& volume, std::mt19937& random) {
    std::uniform_real_distribution<double> place(-0.6, 0.6), angle(-180, 180), share(0, 1);
    Camera camera = defaultCamera(
        volume.geometry(), Viewpoint{.azimuthDegrees = angle(random), .elevationDegrees = angle(random) / 2}, 1.0);
    if (share(random) < 0.5) camera.projection = Projection::perspective;
    ScalpelStroke stroke{.camera = camera};
    const double size = share(random) < 0.7 ? 0.15 : 0.8;  // most are small
    const PicturePlace middle{place(random), place(random)};
    for (int i = 0; i < 5; ++i)
        stroke.places.push_back({middle[0] + size * place(random), middle[1] + size * place(random)});
    if (share(random) < 0.4) {
        stroke.tool = ScalpelTool::eraser;
        stroke.radius = 0.005 + 0.1 * share(random);
    } else if (share(random) < 0.15) {
        stroke.side = ScalpelSide::outside;
    }
    if (share(random) < 0.4) stroke.depthMm = camera.frame.forward.dot(camera.focalPoint) + 20 * place(random);
    return stroke;
}

/// Strokes come, go from the end or the midst, and come again; masks and pictures are those of all done anew.
template <typename Voxel>
void expectAllAnewAfterAnyEdit(const Volume& scan, unsigned seed) {
    std::mt19937 random(seed);
    RayCastSettings settings = obliqueSettings(scan, 41, 37);
    settings.findDepth = true;
    std::vector<RayCastSettings> looks(4, settings);
    looks[1].shading = looks[2].shading = Shading{.reaching = ReachingLight{}};
    looks[1].lightCoarseness = 3;
    looks[2].lightCoarseness = 5;
    looks[3].mode = RenderMode::mean;
    const OpacityCurve curves[] = {LinearCurve{0.2, 0.7, 0.9}, onlyBetween(0.3, 0.9, 0.4)};
    RayCaster caster(held(scan));
    ScalpelCuts cuts(scan.geometry());
    std::vector<ScalpelStroke> strokes, takenBack;
    int changed = 0;
    Picture before;
    constexpr int edits = takesSomeInputs ? 10 : 50;
    for (int edit = 0; edit < edits; ++edit) {
        const auto dice = random() % 10;
        if (dice < 4 || strokes.empty()) {
            if (dice == 0 && !takenBack.empty())
                strokes = takenBack;
            else
                strokes.push_back(randomStroke(scan, random));
        } else if (dice < 8) {
            takenBack = strokes;
            strokes.pop_back();
        } else if (dice < 9) {
            takenBack = strokes;
            strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(random() % strokes.size()));
        } else {
            takenBack = std::exchange(strokes, {});
        }
        const auto cut = held(*cuts.cut(scan, strokes));
        ASSERT_EQ(cut->dataMask(), ScalpelCuts(scan.geometry()).cut(scan, strokes)->dataMask()) << edit;
        caster.setCut(cut);
        const RayCastSettings& look = looks[random() % looks.size()];
        const OpacityCurve& curve = curves[random() % 8 == 0 ? 1 : 0];
        const Picture picture = *caster.cast(curve, look), fresh = *RayCaster(cut).cast(curve, look);
        ASSERT_EQ(picture.rgba, fresh.rgba) << edit;
        ASSERT_EQ(picture.depthMm, fresh.depthMm) << edit;
        changed += picture.rgba != before.rgba ? 1 : 0;
        before = picture;
    }
    EXPECT_GT(changed, edits * 2 / 5) << "strokes show";
}

TEST(RayCasterCut, AnyEditOfStrokesIsAsAllDoneAnew) {
    // No size is a whole number of bricks or places of light.
    const std::array<std::int64_t, 3> size{67, 45, 53};
    const Volume bytes = speckledShell<std::uint8_t>(size, {1, 1.2, 0.8}, 5);
    expectAllAnewAfterAnyEdit<std::uint8_t>(bytes, 1);
    expectAllAnewAfterAnyEdit<std::uint8_t>(sectorOf(bytes), 2);
    expectAllAnewAfterAnyEdit<std::uint16_t>(sectorOf(speckledShell<std::uint16_t>(size, {1, 1, 1}, 5)), 3);
    const Volume floats = speckledShell<float>(size, {1, 1, 1}, 5);
    auto voxels = std::get<VoxelArray<float>>(floats.voxels()).toVector();
    for (std::size_t i = 20'000; i < 21'000; ++i) voxels[i] = std::numeric_limits<float>::quiet_NaN();
    expectAllAnewAfterAnyEdit<float>(Volume(floats.geometry(), std::move(voxels), floats.whiteLevel()), 4);
}

TEST(RayCasterCut, AgreesWithThePlainRoute) {
    const Volume scan = speckledShell<std::uint8_t>({41, 37, 45}, {1, 1.2, 0.8}, 5);
    const Volume cut = *ScalpelCuts(scan.geometry()).cut(scan, strokesOn(scan));
    RayCastSettings settings = obliqueSettings(scan, 57, 49);
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
