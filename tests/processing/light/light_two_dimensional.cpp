// Light through two-dimensional OTFs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "processing/light/light_grid.h"
#include "processing/light/light_sweep.h"
#include "processing/volume/filled_volume.h"
#include "tests/processing/light/lit_volumes.h"

namespace echolucent {
namespace {

using namespace light_test;

template <typename Voxel>
std::shared_ptr<const Volume> noise(double white, bool masked) {
    std::mt19937 random(5);
    VolumeGeometry geometry = cubeGeometry(24);
    std::vector<Voxel> voxels(24 * 24 * 24);
    for (Voxel& voxel : voxels) voxel = static_cast<Voxel>(random() % 256 * white / 255);
    const Volume volume(geometry, VoxelArray<Voxel>(std::move(voxels)), white);
    if (!masked) return std::make_shared<const Volume>(volume);
    std::vector<std::uint8_t> mask(24 * 24 * 24);
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i % 24 > 4 ? 1 : 0;
    return std::make_shared<const Volume>(volume.withDataMask(DataMask(std::move(mask))));
}

template <typename Voxel>
void expectLightOfTheCurve(double white) {
    // The opacities lie on the levels that light tells apart, 1/254 of white, so that nothing is interpolated.
    const OpacityCurve curve = ManualCurve{{{0.0, 0.0}, {1.0, 0.3}}};
    const TwoDimensionalOtf otf = tabulated(255, 3, 0.2, [&](double f, double) { return opacityAt(curve, f); });
    for (const bool masked : {false, true})
        for (int coarseness = 1; coarseness <= light::coarsest; ++coarseness) {
            const auto volume = noise<Voxel>(white, masked);
            LightScene scene;
            scene.coarseness = coarseness;
            scene.towardsKey = {-0.4, 0.3, -1};
            const auto light = *LightSweep(volume).lightVolume(curve, scene);
            const auto same = *LightSweep(volume).lightVolume(Classification(otf), scene);
            int worst = 0;
            for (std::size_t i = 0; i < light.reaching.size(); ++i)
                worst = std::max(worst, std::abs(int{light.reaching[i]} - int{same.reaching[i]}));
            EXPECT_LE(worst, 1) << coarseness;
            EXPECT_LT(*std::ranges::min_element(light.reaching), 200);
        }
}
TEST(LightTwoDimensional, WithoutAWordOfTheGradientTheLightOfBytesIsTheCurves) {
    expectLightOfTheCurve<std::uint8_t>(255);
}
TEST(LightTwoDimensional, WithoutAWordOfTheGradientTheLightOfFloatsIsTheCurves) { expectLightOfTheCurve<float>(7.0); }

TEST(LightTwoDimensional, WhatHasNoGradientAttenuatesNothing) {
    // A ramp along x of slope 0.02 a unit in the left half, and flat tissue in the right half.
    VolumeGeometry geometry = cubeGeometry(32);
    std::vector<float> voxels;
    for (int i = 0; i < 32 * 32 * 32; ++i) voxels.push_back(0.2f + 0.02f * static_cast<float>(std::min(i % 32, 16)));
    const auto volume = std::make_shared<const Volume>(geometry, VoxelArray<float>(std::move(voxels)), 1.0);
    const Classification otf(tabulated(2, 2, 0.02, [](double, double g) { return 0.1 * g / 0.02; }));
    const auto light = *LightSweep(volume).lightVolume(otf, keyAlong({0, 0, -1}));
    // Light along z meets 0.1 a unit over 31.25 units, a quarter of the last place among them, or nothing.
    EXPECT_NEAR(keyAt(light, 5, 16, 31), 255 * std::pow(0.9, 31.25), 1.5);
    EXPECT_NEAR(keyAt(light, 25, 16, 31), 255, 0.5);
}

TEST(LightTwoDimensional, GivenGradientsAndOwnOnesAreTheSame) {
    const auto volume = noise<std::uint16_t>(4095, true);
    const Classification otf(tabulated(16, 16, 0.3, [](double f, double g) { return f * g; }));
    const auto levels = *gradientLevels(filledVoxels(*volume), 0.3);
    const LightScene scene;
    const auto own = LightSweep(volume).lightVolume(otf, scene);
    EXPECT_EQ(own, LightSweep(volume).lightVolume({otf, &levels}, scene));
    const auto others = *gradientLevels(filledVoxels(*volume), 0.2);
    EXPECT_THROW((void)LightSweep(volume).lightVolume({otf, &others}, scene), std::invalid_argument);
}

TEST(LightTwoDimensional, AnotherTableIsFollowed) {
    const auto volume = noise<std::uint8_t>(255, false);
    LightSweep sweep(volume);
    const LightScene scene;
    for (const double opacity : {0.2, 0.5, 0.2}) {
        const Classification otf(tabulated(16, 16, 0.3, [&](double f, double g) { return opacity * f * g / 0.3; }));
        EXPECT_EQ(sweep.lightVolume(otf, scene), LightSweep(volume).lightVolume(otf, scene)) << opacity;
        EXPECT_EQ(sweep.lightVolume(rising(opacity), scene), LightSweep(volume).lightVolume(rising(opacity), scene));
    }
}

}  // namespace
}  // namespace echolucent
