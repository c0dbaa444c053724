// The simulated volumes: materials, ramps, losses, compression, storage.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "app/measuring/measures/phantom_conditions.h"
#include "processing/phantom/phantom.h"
#include "tests/processing/phantom/bare_phantom.h"

namespace echolucent {
namespace {

/// Edges of `edge` voxels; the ramp between materials is in units.
PhantomConfig bareCube(PhantomScene scene, std::int64_t edge = 120, double ramp = 0) {
    PhantomConfig config = barePhantom(scene, {edge, edge, edge});
    config.ramp = ramp;
    return config;
}

template <typename T = std::uint8_t>
const VoxelArray<T>& voxelsOf(const Volume& volume) {
    return std::get<VoxelArray<T>>(volume.voxels());
}

TEST(Phantom, ShapesFillTheirClosedFormVolumes) {
    const Volume volume = *makePhantom(bareCube(PhantomScene::shapes, 160));
    std::map<int, double> share;
    for (const auto value : voxelsOf(volume)) share[value] += 1.0 / static_cast<double>(volume.geometry().voxelCount());
    EXPECT_EQ(share.size(), 3U);
    // The objects do not touch: an ellipsoid, six spheres, a cylinder less its rounded rims.
    const double pi = std::numbers::pi, ball = 4 * pi / 3;
    double objects = ball * 0.19 * 0.13 * 0.12;
    for (const double r : {0.085, 0.070, 0.045, 0.035, 0.060, 0.055}) objects += ball * r * r * r;
    const double height = std::sqrt(0.26 * 0.26 * 2 + 0.14 * 0.14), rim = 0.015;
    objects += pi * 0.062 * 0.062 * height - 2 * (1 - pi / 4) * rim * rim * 2 * pi * (0.062 - rim * 0.22);
    EXPECT_NEAR(share[170], objects, 0.005 * objects);
    EXPECT_GT(share[14], 0.25);
    EXPECT_GT(share[85], 0.25);
}

TEST(Phantom, SpeckleKeepsTheMeanEchoOfAMaterial) {
    PhantomConfig config = bareCube(PhantomScene::empty, 90);
    config.tissue = 60;
    config.bits = 16;
    for (const double speckle : {0.5, 1.0}) {
        config.speckle = speckle;
        config.speckleSize = 0;
        const Volume volume = *makePhantom(config);
        double sum = 0, squares = 0;
        for (const double value : voxelsOf<std::uint16_t>(volume)) {
            const double echo = value * 255 / 65535;
            sum += echo, squares += echo * echo;
        }
        const double n = static_cast<double>(volume.geometry().voxelCount()), mean = sum / n;
        EXPECT_NEAR(mean, 60, 0.2);
        EXPECT_NEAR(std::sqrt(squares / n - mean * mean) / mean, speckle * 0.5227, 0.004);
    }
}

TEST(Phantom, GainVariesSlowlyWithinItsShare) {
    PhantomConfig config = bareCube(PhantomScene::empty, 64);
    config.bits = 16;
    config.gainVariation = 0.15;
    const Volume volume = *makePhantom(config);
    double least = 1e9, most = 0;
    const auto& voxels = voxelsOf<std::uint16_t>(volume);
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        const double gain = voxels[i] * 255.0 / 65535 / 85;
        least = std::min(least, gain), most = std::max(most, gain);
        if (i % 64) {
            ASSERT_LT(std::abs(gain - voxels[i - 1] * 255.0 / 65535 / 85), 0.006);
        }
    }
    EXPECT_GE(least, 0.85 - 1e-4);
    EXPECT_LE(most, 1.15 + 1e-4);
    EXPECT_GT(most - least, 0.25);
}

TEST(Phantom, RampsHaveTheirWidth) {
    for (const double ramp : {2.0, 4.0, 8.0}) {
        PhantomConfig config = bareCube(PhantomScene::shapes, 201, ramp);
        config.bits = 16;
        const Volume volume = *makePhantom(config);
        // The line runs along the beam through the middle of "sphere 1" (in fluid), whose front is met at a right
        // angle.
        const auto x = static_cast<std::int64_t>(0.66 * 201 - 0.5), y = static_cast<std::int64_t>(0.27 * 201 - 0.5);
        const auto echo = [&](std::int64_t z) {
            return volume.storedValue(volume.geometry().offset(x, y, z)) * 255 / 65535;
        };
        const auto depthOf = [&](double level) {
            for (std::int64_t z = 50; z < 80; ++z)
                if (echo(z + 1) >= level) return z + (level - echo(z)) / (echo(z + 1) - echo(z));
            return 0.0;
        };
        const double tenth = depthOf(14 + 0.1 * 156), half = depthOf(92), nine = depthOf(14 + 0.9 * 156);
        EXPECT_NEAR(nine - tenth, 0.8 * ramp, ramp < 4 ? 0.2 : 0.1) << ramp;  // kinks fall between voxels
        EXPECT_NEAR(half, (0.40 - 0.085) * 201 - 0.5, 0.1) << "the sharp boundary is the middle of the ramp";
    }
}

class PhantomScenes : public testing::TestWithParam<PhantomScene> {};

TEST_P(PhantomScenes, VoxelsAreTheClosedFormEcho) {
    PhantomConfig config = bareCube(GetParam(), 110, 4);
    config.size = {110, 96, 121};
    config.spacing = {0.7, 0.8, 0.6};
    config.bits = 16;
    config.frontWall = GetParam() == PhantomScene::shapes;
    const Volume volume = *makePhantom(config);
    const PhantomTruth truth(config);
    std::mt19937 random(4);
    const VolumeGeometry& geometry = volume.geometry();
    int boundary = 0;
    for (int i = 0; i < 30000; ++i) {
        const std::int64_t x = random() % 110, y = random() % 96, z = random() % 121;
        const double closed = truth.echoAt(geometry.gridMmFromVoxel(Vec3(x, y, z)));
        const double stored = volume.storedValue(geometry.offset(x, y, z)) * 255 / 65535;
        ASSERT_NEAR(stored, closed, 0.01) << x << " " << y << " " << z;
        boundary += closed > 15 && closed < 84;
    }
    EXPECT_GT(boundary, 500);
}
INSTANTIATE_TEST_SUITE_P(All, PhantomScenes, testing::Values(PhantomScene::shapes, PhantomScene::fetus));

TEST_P(PhantomScenes, SameBitsForAnyNumberOfThreads) {
    PhantomConfig config = defaultPhantom(GetParam());
    config.size = {70, 61, 90};
    config.spacing = {1.4, 1.4, 1.1};
    const auto built = [&](std::size_t threads, const PhantomConfig& with) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return voxelsOf(*makePhantom(with));
    };
    const auto one = built(1, config);
    EXPECT_EQ(one, built(2, config));
    EXPECT_EQ(one, built(4, config));
    PhantomConfig other = config;
    other.seed = 2;
    EXPECT_NE(one, built(2, other));
}

TEST_P(PhantomScenes, SpacingDoesNotChangeTheAnatomy) {
    // The same box of 120 mm has other spacings; the unit stays 1 mm so that ramps stay as wide.
    PhantomConfig cubic = bareCube(GetParam(), 120, 4), flat = cubic;
    cubic.spacing = {1, 1, 1};
    flat.size = {120, 80, 48};
    flat.spacing = {1, 1.5, 2.5};
    const PhantomTruth one(cubic), two(flat);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> within(0, 120);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 fromCorner(within(random), within(random), within(random));
        ASSERT_NEAR(one.echoAt(fromCorner - cubic.spacing * 0.5), two.echoAt(fromCorner - flat.spacing * 0.5), 1e-6);
    }
    const Volume coarse = *makePhantom(flat);
    const auto& voxels = voxelsOf(coarse);
    for (std::int64_t z = 0; z < 48; ++z)
        for (std::int64_t x = 0; x < 120; x += 7) {
            const Vec3 fromCorner((x + 0.5) * 1, 40.5 * 1.5, (z + 0.5) * 2.5);
            const double expected = one.echoAt(fromCorner - cubic.spacing * 0.5);
            ASSERT_NEAR(voxels[static_cast<std::size_t>(coarse.geometry().offset(x, 40, z))], expected, 0.51);
        }
}

TEST_P(PhantomScenes, FinerVoxelsShowTheSameScene) {
    const PhantomTruth coarse(bareCube(GetParam(), 60)), fine(bareCube(GetParam(), 180));
    int different = 0;
    for (int i = 0; i < 4000; ++i) {
        const int column = i % 20, row = i / 20 % 20, slice = i / 400;
        const Vec3 share((column + 0.387) / 20, (row + 0.631) / 20, (slice + 0.517) / 10);
        different +=
            coarse.echoAt(share * 30 - Vec3(0.25, 0.25, 0.25)) != fine.echoAt(share * 90 - Vec3(0.25, 0.25, 0.25));
    }
    EXPECT_EQ(different, 0);
}

TEST(Phantom, AttenuationIsExponentialInDepth) {
    PhantomConfig config = bareCube(PhantomScene::empty, 100);
    config.spacing = {0.5, 0.5, 1.0};  // a voxel is two units deep
    config.bits = 16;
    config.attenuation = 0.003;
    const Volume volume = *makePhantom(config);
    for (const std::int64_t z : {0, 10, 99}) {
        const double echo = volume.storedValue(volume.geometry().offset(40, 60, z)) * 255 / 65535;
        EXPECT_NEAR(echo, 85 * std::exp(-0.003 * 2 * static_cast<double>(z)), 0.005);
    }
}

TEST(Phantom, ObjectsCastShadowsOfTheirThickness) {
    PhantomConfig config = bareCube(PhantomScene::shapes, 200);
    config.bits = 16;
    const Volume plain = *makePhantom(config);
    config.shadow = 0.02;
    const Volume shadowed = *makePhantom(config);
    // The place lies behind the middle of "sphere 6", which lies in tissue: it has two radii of object.
    const auto x = static_cast<std::int64_t>(0.91 * 200 - 0.5), y = static_cast<std::int64_t>(0.72 * 200 - 0.5);
    const auto ratio = [&](std::int64_t z) {
        const auto offset = plain.geometry().offset(x, y, z);
        return shadowed.storedValue(offset) / plain.storedValue(offset);
    };
    EXPECT_DOUBLE_EQ(ratio(60), 1.0) << "in front";
    EXPECT_NEAR(ratio(150), std::exp(-0.02 * 2 * 0.055 * 200), 0.02);
    EXPECT_NEAR(ratio(199), ratio(150), 1e-3);
}

TEST(Phantom, SpecularBrightensOnlyWhatFacesTheProbe) {
    PhantomConfig config = bareCube(PhantomScene::shapes, 200, 4);
    config.bits = 16;
    const Volume plain = *makePhantom(config);
    config.specular = 0.5;
    const Volume glossy = *makePhantom(config);
    const auto x = static_cast<std::int64_t>(0.66 * 200 - 0.5), y = static_cast<std::int64_t>(0.27 * 200 - 0.5);
    const auto ratioAt = [&](double z) {
        const auto offset = plain.geometry().offset(x, y, static_cast<std::int64_t>(std::lround(z)));
        return glossy.storedValue(offset) / plain.storedValue(offset);
    };
    const double front = (0.40 - 0.085) * 200 - 0.5, back = (0.40 + 0.085) * 200 - 0.5;
    EXPECT_NEAR(ratioAt(front + 1), 1.5, 0.12);
    EXPECT_NEAR(ratioAt(front + 8), 1.0, 1e-6);
    for (double z = back - 5; z < back + 5; ++z) EXPECT_NEAR(ratioAt(z), 1.0, 1e-6);
    for (std::int64_t i = 0; i < plain.geometry().voxelCount(); ++i)
        ASSERT_GE(glossy.storedValue(i) + 0.5, plain.storedValue(i));
}

TEST(Phantom, LogCompressionInClosedForm) {
    PhantomConfig config = bareCube(PhantomScene::shapes, 64);
    config.bits = 16;
    config.fluid = 0.4;
    config.logCompressDecibel = 50;
    const Volume volume = *makePhantom(config);
    std::map<int, int> seen;
    for (const auto value : voxelsOf<std::uint16_t>(volume)) ++seen[value];
    ASSERT_EQ(seen.size(), 3U);
    const auto closed = [](double echo) { return std::max(0.0, 1 + 20 * std::log10(echo / 255) / 50) * 65535; };
    auto entry = seen.begin();
    EXPECT_EQ(entry->first, 0) << "0.4 of 255 is 56 dB down: clamped";
    EXPECT_NEAR((++entry)->first, closed(85), 1);
    EXPECT_NEAR((++entry)->first, closed(170), 1);
}

TEST(Phantom, BitsScaleToTheirWhiteLevel) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {48, 40, 44};
    const Volume eight = *makePhantom(config);
    EXPECT_EQ(eight.typeName(), "uint8");
    EXPECT_EQ(eight.whiteLevel(), 255);
    for (const auto& [bits, white] : {std::pair{12, 4095.0}, std::pair{16, 65535.0}}) {
        config.bits = bits;
        const Volume deep = *makePhantom(config);
        EXPECT_EQ(deep.typeName(), "uint16");
        EXPECT_EQ(deep.whiteLevel(), white);
        for (std::int64_t i = 0; i < deep.geometry().voxelCount(); ++i)
            ASSERT_NEAR(deep.normalisedIntensity(i), eight.normalisedIntensity(i), 0.502 / 255 + 0.5 / white);
    }
}

TEST(Phantom, ConfigsWithoutSenseAreRefused) {
    const auto with = [](auto change) {
        PhantomConfig config = bareCube(PhantomScene::empty, 8);
        change(config);
        return config;
    };
    EXPECT_THROW((void)makePhantom(with([](auto& c) { c.size[1] = 0; })), std::invalid_argument);
    EXPECT_THROW((void)makePhantom(with([](auto& c) { c.spacing[2] = -1; })), std::invalid_argument);
    EXPECT_THROW((void)makePhantom(with([](auto& c) { c.bits = 10; })), std::invalid_argument);
    EXPECT_THROW((void)makePhantom(with([](auto& c) { c.ramp = -1; })), std::invalid_argument);
    EXPECT_THROW((void)PhantomTruth(with([](auto& c) { c.bits = 1; })), std::invalid_argument);
}

TEST(Phantom, CancelledEndsWithoutAVolume) {
    std::atomic<bool> cancel = true;
    EXPECT_FALSE(makePhantom(bareCube(PhantomScene::fetus, 60), Progress{{}, &cancel}));
}

TEST(Phantom, SceneNamesRoundTrip) {
    for (const auto scene : {PhantomScene::shapes, PhantomScene::fetus, PhantomScene::empty})
        EXPECT_EQ(phantomSceneFromName(nameOf(scene)), scene);
    EXPECT_FALSE(phantomSceneFromName("Fetus"));
}

TEST(PhantomConditions, AreThoseOfTheStudies) {
    PhantomConfig given = defaultPhantom(PhantomScene::fetus);
    given.size = {90, 91, 92};
    given.seed = 77;
    std::map<std::string, PhantomConfig> all;
    for (const auto& list :
         {ordinaryConditions(given), hardConditions(given), frontWallConditions(given), emptyConditions(given)})
        for (const NamedPhantom& named : list) {
            EXPECT_TRUE(all.emplace(named.name, named.config).second) << named.name;
            EXPECT_EQ(named.config.size, given.size);
            EXPECT_EQ(named.config.seed, 77U);
        }
    ASSERT_EQ(all.size(), 12U);
    const PhantomConfig& base = all.at("base");
    EXPECT_EQ(base.fluid, 14);
    EXPECT_EQ(base.tissue, 85);
    EXPECT_EQ(base.object, 170);
    EXPECT_EQ(base.ramp, 4);
    EXPECT_EQ(base.gainVariation, 0.15);
    EXPECT_EQ(base.speckle, 0.5);
    EXPECT_EQ(base.speckleSize, 2);
    EXPECT_EQ(base.attenuation + base.shadow + base.specular + base.logCompressDecibel, 0);
    // Each other condition differs from the base in what its name says and in nothing else.
    const auto changed = [&](auto change) {
        PhantomConfig config = base;
        change(config);
        return config;
    };
    EXPECT_EQ(all.at("ramp2"), changed([](auto& c) { c.ramp = 2; }));
    EXPECT_EQ(all.at("little_speckle"), changed([](auto& c) { c.speckle = 0.2, c.speckleSize = 0; }));
    EXPECT_EQ(all.at("attenuation_shadow"), changed([](auto& c) { c.attenuation = 0.003, c.shadow = 0.02; }));
    EXPECT_EQ(all.at("specular"), changed([](auto& c) { c.specular = 0.5; }));
    EXPECT_EQ(all.at("hard_full_speckle"), changed([](auto& c) { c.speckle = 1; }));
    EXPECT_EQ(all.at("hard_uncorrelated"), changed([](auto& c) { c.speckle = 1, c.speckleSize = 0; }));
    EXPECT_EQ(all.at("hard_ramp8"), changed([](auto& c) { c.ramp = 8; }));
    EXPECT_EQ(all.at("hard_low_contrast"), changed([](auto& c) { c.fluid = 30, c.tissue = 80, c.object = 120; }));
    EXPECT_EQ(all.at("hard_log_compressed"), changed([](auto& c) { c.speckle = 1, c.logCompressDecibel = 50; }));
    EXPECT_EQ(all.at("front_wall"), changed([](auto& c) { c.frontWall = true; }));
    EXPECT_EQ(all.at("empty"), changed([](auto& c) { c.scene = PhantomScene::empty; }));
}

}  // namespace
}  // namespace echolucent
