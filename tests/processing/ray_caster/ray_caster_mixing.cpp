// Mixed modes and brightness.
#include <gtest/gtest.h>

#include "processing/picture/look.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

const OpacityCurve mixedCurve = LinearCurve{0.2, 0.7, 0.9};

struct Scene {
    Volume volume = speckledShell<std::uint8_t>({41, 37, 45}, {1, 1.2, 0.8}, 5);
    RayCastSettings settings = obliqueSettings(volume, 57, 49);
};

TEST(RayCasterMixing, IsTheLinearMixOfBothPictures) {
    const Scene scene;
    for (const RenderMode mode : {RenderMode::maximum, RenderMode::mean})
        for (const double share : {0.0, 0.3, 1.0}) {
            RayCastSettings direct = scene.settings, other = scene.settings, mixed = scene.settings;
            direct.shading = mixed.shading = Shading{};
            direct.findDepth = mixed.findDepth = true;
            other.mode = mode;
            mixed.mixing = {share, mode};
            const auto a = castRays(scene.volume, mixedCurve, direct), b = castRays(scene.volume, mixedCurve, other),
                       c = castRays(scene.volume, mixedCurve, mixed);
            ASSERT_EQ(c->rgba.size(), a->rgba.size());
            for (std::size_t i = 0; i < c->rgba.size(); ++i)
                ASSERT_NEAR(c->rgba[i],
                            (1 - share) * static_cast<double>(a->rgba[i]) + share * static_cast<double>(b->rgba[i]),
                            1e-6);
            EXPECT_EQ(c->depthMm, a->depthMm);
            if (share == 0.0) {
                EXPECT_EQ(c->rgba, a->rgba);
            }
            const PlainCasting plainly{.leastLitOpacity = 1.0 / 128};
            const Apart difference = apart(*c, *castRaysPlainly(scene.volume, mixedCurve, mixed, plainly));
            EXPECT_LT(difference.rootMeanSquare, 0.2) << nameOf(mode) << share;
        }
}

TEST(RayCasterMixing, KeptSamplesGoOnWorking) {
    Scene scene;
    scene.settings.mixing = {0.4, RenderMode::mean};
    RayCaster caster(std::make_shared<const Volume>(scene.volume));
    for (int round = 0; round < 3; ++round) {
        const OpacityCurve edited = LinearCurve{0.2 + 0.1 * round, 0.7, 0.9};
        const auto kept = caster.cast(edited, scene.settings);
        EXPECT_LT(apart(*kept, *castRays(scene.volume, edited, scene.settings)).rootMeanSquare, 0.03);
        EXPECT_EQ(caster.sampleUse(), round < 2 ? SampleUse::taken : SampleUse::kept);
    }
    // Another share and another brightness are made of the same samples.
    scene.settings.mixing.share = 0.6;
    scene.settings.brightness = 1.5;
    (void)caster.cast(mixedCurve, scene.settings);
    EXPECT_EQ(caster.sampleUse(), SampleUse::kept);
}

TEST(RayCasterMixing, TheLightVolumeStaysIfOnlyTheShareChanges) {
    Scene scene;
    scene.settings.shading = Shading{.reaching = ReachingLight{}};
    scene.settings.mixing = {0.4, RenderMode::mean};
    RayCaster caster(std::make_shared<const Volume>(scene.volume));
    (void)caster.cast(mixedCurve, scene.settings);
    EXPECT_GT(caster.lightMilliseconds(), 0.0);
    scene.settings.mixing.share = 0.6;
    const auto again = caster.cast(mixedCurve, scene.settings);
    EXPECT_EQ(caster.lightMilliseconds(), 0.0);
    EXPECT_LT(apart(*again, *castRays(scene.volume, mixedCurve, scene.settings)).rootMeanSquare, 0.03);
}

TEST(RayCasterMixing, BrightnessIsAFactorThatStaysWithinAlpha) {
    const Scene scene;
    for (const double brightness : {0.25, 1.0, 2.5}) {
        for (const RenderMode mode : {RenderMode::direct, RenderMode::maximum}) {
            RayCastSettings plain = scene.settings, bright = scene.settings;
            plain.mode = bright.mode = mode;
            bright.brightness = brightness;
            const auto a = castRays(scene.volume, mixedCurve, plain), b = castRays(scene.volume, mixedCurve, bright);
            for (std::size_t i = 0; i < a->rgba.size(); ++i) {
                const float alpha = a->rgba[i / 4 * 4 + 3];
                const float factor = i % 4 == 3 ? 1.0F : static_cast<float>(brightness);
                ASSERT_EQ(b->rgba[i], i % 4 == 3 ? alpha : std::min(alpha, factor * a->rgba[i]));
            }
            EXPECT_LT(apart(*b, *castRaysPlainly(scene.volume, mixedCurve, bright)).rootMeanSquare, 0.3);
        }
    }
}

TEST(RayCasterMixing, TheLookCastsOnlyWhatIsSeen) {
    Look look = lookAtStart();
    EXPECT_EQ(rayCastSettings(look).mixing, ModeMixing{});
    EXPECT_EQ(rayCastSettings(look).brightness, 1.0);
    look.mixedMode = RenderMode::mean;
    EXPECT_EQ(rayCastSettings(look), rayCastSettings(lookAtStart())) << "nothing is mixed";
    EXPECT_FALSE(playsAPart(*parameterNamed(lookParameters(), "mixed_mode"), look));
    look.mixing = 0.5;
    EXPECT_EQ(rayCastSettings(look).mixing, (ModeMixing{0.5, RenderMode::mean}));
    EXPECT_TRUE(playsAPart(*parameterNamed(lookParameters(), "mixed_mode"), look));
    EXPECT_TRUE(playsAPart(*parameterNamed(lookParameters(), "shadow"), look));
    look.mixing = 1.0;
    EXPECT_FALSE(playsAPart(*parameterNamed(lookParameters(), "shadow"), look)) << "no light falls on a mean";
    Look alone = lookAtStart();
    alone.mode = RenderMode::mean;
    EXPECT_EQ(rayCastSettings(look), rayCastSettings(alone));
    look.mode = RenderMode::minimum;
    EXPECT_FALSE(playsAPart(*parameterNamed(lookParameters(), "mixing"), look));
    EXPECT_EQ(rayCastSettings(look).mixing, ModeMixing{});
}

TEST(RayCasterMixing, WhatMakesNoSenseIsRefused) {
    Scene scene;
    scene.settings.mixing.share = 1.5;
    EXPECT_THROW((void)castRays(scene.volume, mixedCurve, scene.settings), std::invalid_argument);
    scene.settings.mixing.share = 0.0;
    scene.settings.brightness = 0.0;
    EXPECT_THROW((void)castRays(scene.volume, mixedCurve, scene.settings), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
