#include "app/measuring/measures/reference_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/measuring/measures/picture_difference.h"
#include "processing/phantom/phantom.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "tests/processing/light/lit_volumes.h"

namespace echolucent {
namespace {

using namespace light_test;

struct Scene {
    std::shared_ptr<const Volume> volume;
    OpacityCurve curve = PowerCurve{2, 0.5};
    RayCastSettings settings;

    Scene(PhantomScene phantomScene, int edge, int pixels) {
        PhantomConfig config = defaultPhantom(phantomScene);
        const double extentMm = static_cast<double>(config.size[0]) * config.spacing[0];
        config.size.fill(edge);
        config.spacing = Vec3::all(extentMm / edge);
        volume = std::make_shared<const Volume>(*makePhantom(config));
        const Viewpoint view{.azimuthDegrees = 20, .elevationDegrees = -12};
        settings.width = settings.height = pixels;
        settings.camera = defaultCamera(volume->geometry(), view, 1.0);
        settings.shading = Shading{};
    }
    [[nodiscard]] Picture picture(const light::Reaching& reaching, const ReachingLight& strengths = {}) const {
        RayCastSettings lit = settings;
        lit.shading->reaching = strengths;
        return *light::castRaysInLight(*volume, curve, lit, reaching);
    }
};

TEST(ReferenceLight, ASlabAttenuatesByItsSlantPath) {
    const auto volume =
        volumeOf(cubeGeometry(40), [](const Vec3& voxel) { return voxel[2] >= 10.0 && voxel[2] < 14.0; });
    LightScene scene = keyAlong({0.5, 0.2, -1});
    scene.coarseness = 1;
    const OpacityCurve curve = rising(0.3);
    const light::ReferenceLight reference(*volume, curve, scene, 2, 0.05);
    EXPECT_NEAR(reference.at({20, 20, 25}).key, std::pow(0.7, 4.0 * length(scene.towardsKey)), 0.03)
        << "the ramps between voxel centres add to the slab what a concave curve adds";
    scene.rendered.front = CuttingFace{{0, 0, 1}, 15.0};
    EXPECT_EQ(light::ReferenceLight(*volume, curve, scene, 2).at({20, 20, 25}).key, 1.0) << "cut away";
}

/// Where all light reaches all places, a picture is that of gradient light alone.
TEST(ReferenceLight, InAWhiteFurnaceThePictureIsThatOfGradientLight) {
    const Scene scene(PhantomScene::shapes, 32, 24);
    const auto plain = *castRaysPlainly(*scene.volume, scene.curve, scene.settings, {.leastLitOpacity = 1.0 / 2048});
    const auto all = [](const Vec3&) { return ReachingShares{1.0, 1.0}; };
    const auto none = [](const Vec3&) { return ReachingShares{0.0, 0.0}; };
    EXPECT_LT(pictureError(scene.picture(all), plain).largest, 1e-3);
    EXPECT_LT(pictureError(scene.picture(none, {0.0, 0.0, 1.0}), plain).largest, 1e-3) << "strengths of 0";
    EXPECT_GT(pictureError(scene.picture(none), plain).rmse, 10.0);
}

TEST(LongReferenceLight, ThePictureOfTheSweepsIsNearThatOfTheReference) {
    const Scene scene(PhantomScene::fetus, 48, 24);
    LightScene lightScene = lightSceneOf(scene.settings, scene.volume->geometry());
    const light::ReferenceLight reference(*scene.volume, scene.curve, lightScene, 3, 1.0);
    const auto wanted = scene.picture([&](const Vec3& place) { return reference.at(place); });
    lightScene.coarseness = 1;
    const auto light = *LightSweep(scene.volume).lightVolume(scene.curve, lightScene);
    const auto found = scene.picture([&](const Vec3& place) { return reachingAt(light, place); });
    EXPECT_LT(pictureError(found, wanted).rmse, 3.0);
    const auto dark = scene.picture([](const Vec3&) { return ReachingShares{}; });
    EXPECT_GT(pictureError(dark, wanted).rmse, 9.0) << "light is seen at all";
}

TEST(ReachingLight, TheFactorIsWhatItSays) {
    const Shading shading;
    const auto lit = [](const ReachingLight& reaching) { return Shading{.reaching = reaching}; };
    const SurfaceLight surface{0.6, 0.7, 0.4};
    const double direct = shading.diffuse * (0.6 * 0.7 + 0.4 * shading.evenLight) + 0.6 * shading.specular * 0.4;
    const Vec3 full = reachingFactor(lit({1.0, 1.0, 1.0}), 1.0, 1.0, surface);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(full[i], shading.ambient + direct, 1e-12) << "all light is white";
    const Vec3 dark = reachingFactor(lit({1.0, 1.0, 1.0}), 0.0, 0.0, surface);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(dark[i], 0.0) << "nothing glows in the dark";
    const Vec3 some = reachingFactor(lit({0.5, 0.25, 0.4}), 0.25, 0.25, surface);
    EXPECT_NEAR(some[1], shading.ambient * (1.0 - 0.25 * 0.75) + direct * (0.5 + 0.5 * 0.25), 1e-12);
    EXPECT_NEAR(some[0] - some[1], direct * 0.5 * 0.4 * (0.5 - 0.25), 1e-12) << "red goes deeper";
    EXPECT_NEAR(some[1] - some[2], direct * 0.5 * 0.4 * (0.25 - 0.0625), 1e-12) << "blue less deep";
}

}  // namespace
}  // namespace echolucent
