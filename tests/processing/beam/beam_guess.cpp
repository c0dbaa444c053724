#include "processing/beam/beam_guess.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>

#include "app/measuring/measures/phantom_conditions.h"
#include "processing/phantom/phantom.h"
#include "tests/inputs.h"
#include "tests/processing/beam/turned_volume.h"

namespace echolucent {
namespace {

/// Half as fine as the default scans, and as deep in units of attenuation.
Volume scanOf(PhantomConfig config, std::int64_t edge = 99) {
    const double coarser = static_cast<double>(config.size[0]) / static_cast<double>(edge);
    config.size = {edge, edge - 2, edge};
    config.spacing = Vec3::all(1);
    config.attenuation *= coarser;
    config.shadow *= coarser;
    return *makePhantom(config);
}

PhantomConfig conditionOf(PhantomScene scene, const std::string& name, std::uint64_t seed) {
    PhantomConfig base = defaultPhantom(scene);
    base.seed = seed;
    for (const auto& conditions : {ordinaryConditions(base), hardConditions(base), frontWallConditions(base)})
        for (const NamedPhantom& condition : conditions)
            if (condition.name == name) return condition.config;
    return base;
}

TEST(BeamGuess, TheShapeOfASectorTellsAllSixAxes) {
    for (const PhantomScene scene : {PhantomScene::shapes, PhantomScene::fetus}) {
        if (takesSomeInputs && scene != PhantomScene::fetus) continue;
        const Volume scan = scanOf(conditionOf(scene, "base", 3));
        for (const Sector sector : {Sector::cone, Sector::pyramid, Sector::convexFan}) {
            const auto mask = sectorMask(sector, scan.geometry().size);
            for (const BeamAxis axis : allBeamAxes) {
                const auto guess = guessBeamAxis(turnedTo(scan, mask, axis));
                ASSERT_TRUE(guess->sure) << nameOf(scene) << static_cast<int>(sector) << nameOf(axis);
                EXPECT_EQ(guess->axis, axis);
                EXPECT_EQ(guess->evidence, BeamEvidence::sectorShape);
                EXPECT_NE(guess->sentence.find(nameOf(axis)), std::string::npos);
            }
        }
    }
}

TEST(BeamGuess, AttenuationAndShadowsTellAllSixAxesOfAFullBox) {
    for (const PhantomScene scene : {PhantomScene::shapes, PhantomScene::fetus})
        for (const std::uint64_t seed : {3, 4}) {
            if (takesSomeInputs && seed != 3) continue;
            const Volume scan = scanOf(conditionOf(scene, "attenuation_shadow", seed));
            for (const BeamAxis axis : allBeamAxes) {
                const auto guess = guessBeamAxis(turnedTo(scan, {}, axis));
                ASSERT_TRUE(guess->sure) << nameOf(scene) << seed << nameOf(axis) << guess->confidence;
                EXPECT_EQ(guess->axis, axis);
                EXPECT_EQ(guess->evidence, BeamEvidence::echo);
            }
        }
}

TEST(BeamGuess, NeverWrongWhereTheEchoHoldsNoTraceOfTheBeam) {
    for (const PhantomScene scene : {PhantomScene::shapes, PhantomScene::fetus, PhantomScene::empty})
        for (const char* name : {"base", "little_speckle", "hard_full_speckle", "hard_ramp8", "hard_low_contrast",
                                 "hard_log_compressed", "front_wall"}) {
            const Volume scan = scanOf(conditionOf(scene, name, 3));
            const auto guess = guessBeamAxis(turnedTo(scan, {}, BeamAxis::minusY));
            EXPECT_FALSE(guess->sure && guess->axis != BeamAxis::minusY) << nameOf(scene) << name;
        }
}

TEST(BeamGuess, UnsureWithoutAnyFeature) {
    VolumeGeometry geometry;
    geometry.size = {96, 80, 88};
    const auto count = static_cast<std::size_t>(geometry.voxelCount());
    std::mt19937 random(7);
    std::vector<std::uint8_t> noise(count);
    for (auto& voxel : noise) voxel = static_cast<std::uint8_t>(random() >> 24);
    PhantomConfig empty = conditionOf(PhantomScene::empty, "base", 3);
    empty.gainVariation = 0;
    for (const Volume& volume :
         {Volume(geometry, std::vector<std::uint8_t>(count, 90)), Volume(geometry, std::vector<std::uint8_t>(count, 0)),
          Volume(geometry, noise), scanOf(empty)}) {
        const auto guess = guessBeamAxis(volume);
        EXPECT_FALSE(guess->sure);
        EXPECT_EQ(guess->axis, BeamAxis::plusZ);
        EXPECT_EQ(guess->evidence, BeamEvidence::none);
        EXPECT_NE(guess->sentence, "");
    }
}

TEST(BeamGuess, AMaskThatIsNoSectorSaysNothing) {
    const Volume scan = scanOf(conditionOf(PhantomScene::empty, "base", 3));
    const auto& size = scan.geometry().size;
    std::vector<std::uint8_t> ball, slanted;
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x) {
                ball.push_back(std::hypot(x - 49, y - 48, z - 49) < 45 ? 1 : 0);
                slanted.push_back(x > z / 3 && x < 60 + z / 3 ? 1 : 0);
            }
    EXPECT_FALSE(guessBeamAxis(scan.withDataMask(ball))->sure);
    EXPECT_FALSE(guessBeamAxis(scan.withDataMask(slanted))->sure);
    EXPECT_FALSE(guessBeamAxis(scan.withDataMask(std::vector<std::uint8_t>(ball.size(), 0)))->sure);
}

TEST(BeamGuess, FewOrStretchedVoxelsAreNoTrouble) {
    for (const std::array<std::int64_t, 3>& size :
         {std::array<std::int64_t, 3>{1, 1, 1}, {3, 200, 2}, {49, 50, 1}, {97, 5, 193}}) {
        VolumeGeometry geometry;
        geometry.size = size;
        geometry.spacing = {0.1, 1, 7};
        const Volume volume(geometry, std::vector<float>(static_cast<std::size_t>(geometry.voxelCount()), 0.5F));
        EXPECT_FALSE(guessBeamAxis(volume)->sure);
    }
}

TEST(BeamGuess, ACancelledRunGivesNothing) {
    const std::atomic<bool> cancel{true};
    EXPECT_FALSE(guessBeamAxis(scanOf(conditionOf(PhantomScene::empty, "base", 3)), {{}, &cancel}));
}

}  // namespace
}  // namespace echolucent
