#include "processing/light/light_sweep.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "processing/light/light_directions.h"
#include "processing/phantom/phantom.h"
#include "processing/viewpoint/cut_surface.h"
#include "processing/volume/row_marks.h"
#include "tests/processing/light/lit_volumes.h"

namespace echolucent {
namespace {

using namespace light_test;

std::shared_ptr<const Volume> phantom(int edge) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    const double extentMm = static_cast<double>(config.size[0]) * config.spacing[0];
    config.size.fill(edge);
    config.spacing = Vec3::all(extentMm / edge);
    return std::make_shared<const Volume>(*makePhantom(config));
}

LightScene obliqueScene() {
    LightScene scene;
    scene.towardsKey = {-0.7, 0.6, -0.5};
    scene.towardsViewer = {0.3, -0.2, -1};
    return scene;
}

TEST(LightSweep, TheBytesAreTheSameForAnyNumberOfThreads) {
    const tbb::global_control enough(tbb::global_control::max_allowed_parallelism, 8);
    const auto volume = phantom(50);
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return LightSweep(volume).lightVolume(PowerCurve{2, 0.5}, obliqueScene()); });
    };
    const auto one = with(1);
    EXPECT_EQ(one, with(2));
    EXPECT_EQ(one, with(8));
    EXPECT_NE(*std::min_element(one->reaching.begin(), one->reaching.end()), 255);
}

/// A sphere's light from a direction is that of a mirrored direction, mirrored.
TEST(LightSweep, LightFromAllOctantsIsTheSameButMirrored) {
    constexpr int edge = 24;
    const auto volume = volumeOf(cubeGeometry(edge),
                                 [](const Vec3& voxel) { return length(voxel - Vec3::all((edge - 1) / 2.0)) < 7.0; });
    LightSweep sweep(volume);
    const OpacityCurve curve = rising(0.4);
    const auto seen = *sweep.lightVolume(curve, keyAlong({1.0, 0.6, 0.3}));
    for (int octant = 1; octant < 8; ++octant) {
        const Vec3 sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
        const auto mirrored = *sweep.lightVolume(curve, keyAlong(Vec3(1.0, 0.6, 0.3).mul(sign)));
        const auto at = [&](int place, int axis) { return sign[axis] < 0 ? edge - 1 - place : place; };
        int worst = 0;
        for (int z = 0; z < edge; ++z)
            for (int y = 0; y < edge; ++y)
                for (int x = 0; x < edge; ++x)
                    worst =
                        std::max(worst, std::abs(keyAt(seen, x, y, z) - keyAt(mirrored, at(x, 0), at(y, 1), at(z, 2))));
        EXPECT_LE(worst, 1) << "octant " << octant;
    }
    for (const int turn : {1, 2}) {
        Vec3 towards;
        for (int axis = 0; axis < 3; ++axis) towards[(axis + turn) % 3] = Vec3(1.0, 0.6, 0.3)[axis];
        const auto turned = *sweep.lightVolume(curve, keyAlong(towards));
        int worst = 0;
        for (int i = 0; i < edge * edge * edge; ++i) {
            const std::array<int, 3> from{i % edge, i / edge % edge, i / edge / edge};
            std::array<int, 3> to{};
            for (std::size_t axis = 0; axis < 3; ++axis) to[(axis + static_cast<std::size_t>(turn)) % 3] = from[axis];
            worst =
                std::max(worst, std::abs(keyAt(seen, from[0], from[1], from[2]) - keyAt(turned, to[0], to[1], to[2])));
        }
        EXPECT_LE(worst, 1) << "axes turned by " << turn;
    }
}

TEST(LightSweep, NoDataAttenuatesNothing) {
    const auto full = volumeOf(cubeGeometry(20), [](const Vec3& voxel) { return voxel[2] < 10.0; });
    std::vector<std::uint8_t> mask(20 * 20 * 20, 1);
    std::fill(mask.begin(), mask.begin() + 20 * 20 * 10, std::uint8_t{0});
    const auto masked = std::make_shared<const Volume>(full->withDataMask(mask));
    LightScene scene = obliqueScene();
    scene.towardsKey = {0, 0, -1};
    EXPECT_EQ(keyAt(*LightSweep(full).lightVolume(rising(0.9), scene), 5, 5, 9), 0);
    const auto light = *LightSweep(masked).lightVolume(rising(0.9), scene);
    EXPECT_TRUE(std::all_of(light.reaching.begin(), light.reaching.end(), [](int byte) { return byte == 255; }));
}

TEST(LightSweep, WhatIsCutAwayCastsNoShadow) {
    const auto volume = volumeOf(cubeGeometry(20), [](const Vec3& voxel) { return voxel[2] < 8.0; });
    LightScene scene = keyAlong({0, 0, -1});
    LightSweep sweep(volume);
    const auto keyBehind = [&] { return keyAt(*sweep.lightVolume(rising(0.9), scene), 10, 10, 15); };
    EXPECT_EQ(keyBehind(), 0);
    scene.rendered.front = CuttingFace{{0, 0, 1}, 7.5};
    EXPECT_EQ(keyBehind(), 255) << "front";
    scene.rendered.front = CuttingFace{{0, 0, 1}, 6.5};
    EXPECT_NEAR(keyBehind(), 25.5, 1.0) << "a layer is left";
    scene.rendered = {};
    scene.rendered.box = RenderBox{{-1, -1, 7.5}, {30, 30, 30}};
    EXPECT_EQ(keyBehind(), 255) << "box";
    scene.rendered.box.reset();
    scene.rendered.clippingPlanes = {{{0, 0, 7.5}, {0, 0, 3}}};
    EXPECT_EQ(keyBehind(), 255) << "clipping plane";
    scene.rendered.clippingPlanes = {{{9.5, 0, 0}, {-1, 0, 0}}};
    EXPECT_EQ(keyBehind(), 255);
    EXPECT_EQ(keyAt(*sweep.lightVolume(rising(0.9), scene), 5, 10, 15), 0) << "the side that is rendered";
}

TEST(LightSweep, AnObliqueCutGivesAnEvenFace) {
    const auto volume = volumeOf(cubeGeometry(60), [](const Vec3&) { return true; });
    LightScene scene = keyAlong({0.2, 0.1, -1});
    scene.coarseness = 2;
    const Vec3 normal = normalized({0.31, 0.17, 1.0}), point(30, 30, 30);
    scene.rendered.clippingPlanes = {{point, normal}};
    const auto light = *LightSweep(volume).lightVolume(rising(0.2), scene);
    double least = 1.0, most = 0.0;
    for (double aside = -12.0; aside < 12.0; aside += 0.37) {
        const Vec3 along = normalized(Vec3(1.0, 0.3, 0.0) - normal * normal.dot(Vec3(1.0, 0.3, 0.0)));
        const double key = reachingAt(light, point + along * aside + normal * 2.0).key;
        least = std::min(least, key);
        most = std::max(most, key);
    }
    EXPECT_LT(most - least, 0.08) << "steps of places would be seen as stripes: " << least << " to " << most;
}

/// A sweep that makes light volumes again and again, to compare each with that of a new sweep.
struct SweepUsedAgain {
    std::shared_ptr<const Volume> volume = phantom(40);
    LightSweep kept{volume};
    LightScene scene = obliqueScene();
    OpacityCurve curve = PowerCurve{2, 0.5};
    bool isAsNew() { return kept.lightVolume(curve, scene) == LightSweep(volume).lightVolume(curve, scene); }
};

TEST(LightSweep, WhatIsKeptChangesNothing) {
    SweepUsedAgain used;
    LightScene& scene = used.scene;
    OpacityCurve& curve = used.curve;
    EXPECT_TRUE(used.isAsNew());
    scene.towardsKey = {1, 0.1, 0.2};
    EXPECT_TRUE(used.isAsNew()) << "the key light moved";
    scene.keyHalfAngleDegrees = 20;
    EXPECT_TRUE(used.isAsNew());
    curve = PowerCurve{4, 1.0};
    EXPECT_TRUE(used.isAsNew()) << "another curve";
    scene.towardsViewer = {0, 1, 0.3};
    EXPECT_TRUE(used.isAsNew()) << "another viewer";
    scene.rendered.front = CuttingFace{{0, 0, 1}, 10};
    EXPECT_TRUE(used.isAsNew()) << "a cut";
    scene.coarseness = 4;
    EXPECT_TRUE(used.isAsNew()) << "coarser";
    const std::atomic<bool> raised = true;
    curve = PowerCurve{2, 0.9};
    EXPECT_EQ(used.kept.lightVolume(curve, scene, Progress{{}, &raised}), std::nullopt);
    EXPECT_TRUE(used.isAsNew()) << "after a cancelled call";
}

TEST(LightSweep, WhatIsKeptOfACuttingSurfaceChangesNothing) {
    SweepUsedAgain used;
    LightScene& scene = used.scene;
    OpacityCurve& curve = used.curve;
    // Across the middle of the volume of 100 mm an edge, seen along z.
    CutSurface bowed{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0.0, 0.0, 50.0, 3, 3, {}};
    bowed.depthMm = std::vector<float>{29, 35, 29, 35, 55, 35, 29, 35, 29};
    scene.rendered.cutSurface = bowed;
    EXPECT_TRUE(used.isAsNew());
    const auto before = used.kept.lightVolume(curve, scene);
    curve = PowerCurve{4, 1.0};
    EXPECT_TRUE(used.isAsNew()) << "another curve";
    EXPECT_NE(used.kept.lightVolume(curve, scene), before);
    scene.rendered.front = CuttingFace{{0, 1, 0}, 10};
    EXPECT_TRUE(used.isAsNew()) << "a face besides";
    scene.coarseness = 4;
    EXPECT_TRUE(used.isAsNew()) << "coarser";
    bowed.depthMm = std::vector<float>{29, 35, 29, 35, 35, 35, 29, 35, 29};
    scene.rendered.cutSurface = bowed;
    EXPECT_TRUE(used.isAsNew()) << "another surface";
    scene.coarseness = 2;
    EXPECT_TRUE(used.isAsNew()) << "another surface, finer";
}

TEST(LightSweep, ReadsEveryTypeOfVoxelAlike) {
    const auto bytes = phantom(30);
    std::vector<std::uint16_t> words;
    std::vector<float> floats;
    for (const std::uint8_t byte : std::get<VoxelArray<std::uint8_t>>(bytes->voxels())) {
        words.push_back(static_cast<std::uint16_t>(byte * 16));
        floats.push_back(static_cast<float>(byte) * 0.01f);
    }
    const Volume asWords(bytes->geometry(), std::move(words), 255.0 * 16.0),
        asFloats(bytes->geometry(), std::move(floats), 2.55);
    const auto lightOf = [](const Volume& volume) {
        return *LightSweep(std::make_shared<const Volume>(volume)).lightVolume(PowerCurve{2, 0.5}, obliqueScene());
    };
    EXPECT_EQ(lightOf(*bytes), lightOf(asWords));
    const auto one = lightOf(*bytes), other = lightOf(asFloats);
    for (std::size_t i = 0; i < one.reaching.size(); ++i) EXPECT_NEAR(one.reaching[i], other.reaching[i], 1);
}

TEST(LightSweep, FollowsCutsOfBytes) {
    const auto whole = phantom(30);
    const auto cutAt = [&](int edge) {
        std::vector<std::uint8_t> mask(27000, 1);
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (static_cast<int>(i % 30) < edge) mask[i] = 0;
        return std::make_shared<const Volume>(whole->withCut(std::make_shared<const DataMask>(std::move(mask))));
    };
    LightSweep kept(whole);
    auto shown = whole;
    for (const auto& next :
         {whole, cutAt(9), cutAt(15), std::make_shared<const Volume>(whole->withCut(nullptr)), cutAt(4)}) {
        kept.setCut(next, rowsMaskedOtherwise(*shown, *next));
        shown = next;
        EXPECT_EQ(kept.lightVolume(PowerCurve{2, 0.5}, obliqueScene()),
                  LightSweep(next).lightVolume(PowerCurve{2, 0.5}, obliqueScene()));
    }
    EXPECT_NE(LightSweep(whole).lightVolume(PowerCurve{2, 0.5}, obliqueScene()),
              LightSweep(shown).lightVolume(PowerCurve{2, 0.5}, obliqueScene()));
}

TEST(LightSweep, RefusesAScene) {
    const auto volume = volumeOf(cubeGeometry(4), [](const Vec3&) { return true; });
    LightSweep sweep(volume);
    const auto refuses = [&](const auto& change) {
        LightScene scene;
        change(scene);
        EXPECT_THROW((void)sweep.lightVolume(rising(0.5), scene), std::invalid_argument);
    };
    refuses([](LightScene& scene) { scene.towardsKey = {0, 0, 0}; });
    refuses([](LightScene& scene) { scene.towardsViewer = {std::nan(""), 0, 1}; });
    refuses([](LightScene& scene) { scene.keyHalfAngleDegrees = 46; });
    refuses([](LightScene& scene) { scene.coarseness = 0; });
}

TEST(LightSweep, TheSceneOfAPictureTurnsWithItsCamera) {
    RayCastSettings settings;
    settings.camera.frame = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    settings.shading = Shading{};
    settings.shading->towardsLight = {0.1, 0.2, -0.3};
    settings.front = CuttingFace{settings.camera.frame.forward, 4};
    settings.shading->keyHalfAngleDegrees = 21;
    settings.lightCoarseness = 3;
    const LightScene scene = lightSceneOf(settings, cubeGeometry(100));
    EXPECT_EQ(scene.towardsKey, Vec3(-0.3, 0.1, 0.2));
    EXPECT_EQ(scene.towardsViewer, Vec3(-1, 0, 0));
    EXPECT_TRUE(scene.rendered.front == (CuttingFace{{1, 0, 0}, 4}));
    EXPECT_EQ(scene.keyHalfAngleDegrees, 21);
    EXPECT_EQ(scene.coarseness, 2) << "light of a small volume is finer";
    EXPECT_EQ(lightSceneOf(settings, cubeGeometry(usualVolumeEdge)).coarseness, 3);
    EXPECT_EQ(lightSceneOf(settings, cubeGeometry(2 * usualVolumeEdge)).coarseness, 6)
        << "light of a large volume costs no more than that of a usual one";
}

TEST(LightSweep, CoarsenessKeepsToANumberOfPlaces) {
    EXPECT_EQ(coarsenessWithin(cubeGeometry(100), 125000), 2);
    EXPECT_EQ(coarsenessWithin(cubeGeometry(100), 124999), 3);
    EXPECT_EQ(coarsenessWithin(cubeGeometry(100), 1), 16);
}

TEST(LightVolume, IsReadTrilinearlyAndClamped) {
    LightVolume light;
    light.size = {2, 1, 2};
    light.firstMm = {1, 5, 2};
    light.spacingMm = {2, 1, 4};
    light.reaching = {0, 255, 100, 55, 200, 155, 255, 0};
    EXPECT_DOUBLE_EQ(reachingAt(light, {2, 5, 2}).key, 50 / 255.0);
    EXPECT_DOUBLE_EQ(reachingAt(light, {2, 9, 2}).around, 155 / 255.0);
    EXPECT_DOUBLE_EQ(reachingAt(light, {-7, 5, 3}).key, 50 / 255.0);
    EXPECT_DOUBLE_EQ(reachingAt(light, {9, 5, 99}).key, 1.0);
}

/// Rules of directions have the moments of a disc: means of x^2 and of x^4.
TEST(LightDirections, StandForTheCosineOfAHemisphere) {
    const Vec3 axis = normalized({0.3, -0.5, 0.8}), across = normalized(axis.cross({0, 0, 1}));
    for (const auto rule : {light::DirectionRule::four, light::DirectionRule::seven, light::DirectionRule::twelve}) {
        double all = 0.0, second = 0.0, fourth = 0.0;
        for (const auto& [towards, weight] : light::directionsWithin(axis * 3.0, 90.0, rule)) {
            EXPECT_NEAR(length(towards), 1.0, 1e-12);
            EXPECT_GT(towards.dot(axis), 0.0);
            const double x = towards.dot(across);
            all += weight;
            second += weight * x * x;
            fourth += weight * x * x * x * x;
        }
        EXPECT_NEAR(all, 1.0, 1e-12);
        EXPECT_NEAR(second, 0.25, 1e-12);
        if (rule != light::DirectionRule::four) {
            EXPECT_NEAR(fourth, 0.125, 1e-12);
        }
    }
    const auto cone = light::directionsWithin(axis, 10.0, light::DirectionRule::seven);
    for (const auto& direction : cone) EXPECT_GT(direction.towards.dot(axis), std::cos(10.0 * 3.1416 / 180.0));
    EXPECT_EQ(light::directionsWithin(axis, 0.0, light::DirectionRule::seven).size(), 1U);
    EXPECT_EQ(light::denseDirectionsWithin(axis, 90.0, 4).size(), 48U);
}

}  // namespace
}  // namespace echolucent
