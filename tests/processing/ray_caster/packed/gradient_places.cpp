// Gradients that are stored for light, and the pictures that are lit by them.
#include "processing/ray_caster/packed/gradient_places.h"

#include <gtest/gtest.h>

#include "processing/parallel.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/processing/ray_caster/ray_caster_scenes.h"

namespace echolucent {
namespace {

using namespace ray_casting;

constexpr double usualFloor = 0.01;

/// Voxels of a reach in units.
std::array<double, 3> reachIn(const VolumeGeometry& geometry, double units = 2.0) {
    const double mm = units * geometry.unit();
    return {mm / geometry.spacing[0], mm / geometry.spacing[1], mm / geometry.spacing[2]};
}

/// A component of the gradient at a voxel, in quanta: that of the lower y of a place.
double quantaAt(const GradientPlaces& places, std::int64_t x, std::int64_t y, std::int64_t z, int axis) {
    const std::array<std::int64_t, 3> cube{x + cubeShift, y + cubeShift, z + cubeShift};
    constexpr std::int64_t edge = BrickGrid::edge;
    const std::size_t brick = places.grid().offset(cube[0] / edge, cube[1] / edge, cube[2] / edge);
    const std::int64_t place =
        (cube[2] % edge * GradientPlaces::rows + cube[1] % edge) * GradientPlaces::columns + cube[0] % edge;
    const std::uint8_t* const bytes = places.brick(brick) + place * GradientPlaces::bytesPerPlace;
    return (bytes[2 * axis] - GradientPlaces::zero) * bytes[6] / double{GradientPlaces::scaleOne};
}

/// Noise up to an intensity has differences of at most that, all of which bytes hold if it is at most 127.
void expectDifferences(int brightest, double tolerance) {
    const Volume noise = randomVolume<std::uint8_t>({21, 19, 23}, {1, 1, 1}, 3);
    std::vector<std::uint8_t> voxels;
    for (const std::uint8_t value : std::get<VoxelArray<std::uint8_t>>(noise.voxels()))
        voxels.push_back(static_cast<std::uint8_t>(value * brightest / 255));
    const Volume volume(noise.geometry(), voxels);
    const auto packed = std::make_shared<const PackedVoxels<std::uint8_t>>(volume);
    const auto rule = GradientRule::of(reachIn(volume.geometry()), usualFloor);
    ASSERT_TRUE(rule);
    const GradientPlaces places(packed, volume.geometry(), PackedVoxels<std::uint8_t>::toTable(255.0), *rule);
    EXPECT_NEAR(places.quantum(), 1.0 / (255.0 * 4.0), 1e-9);
    double longest = 0.0;
    for (std::int64_t z = 2; z < 21; ++z)
        for (std::int64_t y = 2; y < 17; ++y)
            for (std::int64_t x = 2; x < 19; ++x) {
                const auto at = [&](std::int64_t dx, std::int64_t dy, std::int64_t dz) {
                    return int{voxels[static_cast<std::size_t>(volume.geometry().offset(x + dx, y + dy, z + dz))]};
                };
                const Vec3 difference(at(2, 0, 0) - at(-2, 0, 0), at(0, 2, 0) - at(0, -2, 0),
                                      at(0, 0, 2) - at(0, 0, -2));
                for (int axis = 0; axis < 3; ++axis) {
                    ASSERT_NEAR(quantaAt(places, x, y, z, axis), difference[axis], tolerance)
                        << x << ' ' << y << ' ' << z;
                    longest = std::max(longest, std::abs(difference[axis]));
                }
            }
    EXPECT_GT(longest, 0.9 * brightest);
}
TEST(GradientPlaces, DifferencesOfBytesAreWholeQuanta) { expectDifferences(127, 0.0); }
TEST(GradientPlaces, BricksOfSteepGradientsHaveCoarserBytes) { expectDifferences(255, 1.02); }

TEST(GradientPlaces, OnlyWholeReachesAreStored) {
    VolumeGeometry geometry;
    geometry.size = {20, 20, 20};
    geometry.spacing = {0.5, 1.0, 0.25};
    const auto rule = GradientRule::of(reachIn(geometry, 4.0), usualFloor);
    ASSERT_TRUE(rule);
    EXPECT_EQ(rule->reach, (std::array<int, 3>{2, 1, 4})) << "four units of 0.25 mm";
    EXPECT_FALSE(GradientRule::of(reachIn(geometry, 2.0), usualFloor)) << "half a voxel along y";
    EXPECT_FALSE(GradientRule::of(reachIn(geometry, 4.0), 0.0)) << "bytes are too coarse for a floor of zero";
    EXPECT_TRUE(GradientRule::of(reachIn(geometry, 4.0), GradientPlaces::leastFloor));
}

TEST(GradientPlaces, BricksAreMadeWhenAskedAndThreadsFindTheSame) {
    const Volume volume = randomVolume<std::uint16_t>({40, 33, 29}, {1, 1, 1}, 5);
    const auto packed = std::make_shared<const PackedVoxels<std::uint16_t>>(volume);
    const auto rule = GradientRule::of(reachIn(volume.geometry()), usualFloor);
    const float toTable = PackedVoxels<std::uint16_t>::toTable(volume.whiteLevel());
    const GradientPlaces alone(packed, volume.geometry(), toTable, *rule),
        many(packed, volume.geometry(), toTable, *rule);
    EXPECT_EQ(alone.bytes(), 0U);
    const auto bricks = static_cast<std::size_t>(alone.grid().count());
    for (std::size_t brick = 0; brick < bricks; ++brick) (void)alone.brick(brick);
    EXPECT_EQ(alone.bytes(), bricks * GradientPlaces::bytesPerBrick);
    // Each brick is asked for eight times, by whichever threads there are.
    parallelFor(LoopRange<std::size_t>(0, 8 * bricks, 1), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) (void)many.brick(i % bricks);
    });
    EXPECT_EQ(many.bytes(), alone.bytes());
    for (std::size_t brick = 0; brick < bricks; ++brick)
        ASSERT_TRUE(
            std::equal(alone.brick(brick), alone.brick(brick) + GradientPlaces::bytesPerBrick, many.brick(brick)));
}

/// The largest difference of pictures with stored gradients from those whose reach is no whole number of voxels by so
/// little that nobody sees it, so that none is stored.
template <typename Voxel>
void expectStoredAsDifferences(const Vec3& spacing) {
    const auto volume = held(speckledShell<Voxel>({45, 41, 43}, spacing, 9));
    RayCastSettings settings = obliqueSettings(*volume, 60, 50);
    settings.shading = Shading{};
    const OpacityCurve curve = PowerCurve{2, 0.9};
    RayCaster caster(volume);
    const auto stored = caster.cast(curve, settings);
    EXPECT_GT(caster.storedGradientBytes(), 0U);
    settings.shading->gradientReach += 1e-4;
    RayCaster other(volume);
    const Apart difference = apart(*stored, *other.cast(curve, settings));
    EXPECT_EQ(other.storedGradientBytes(), 0U);
    EXPECT_LT(difference.rootMeanSquare, 0.12);
    EXPECT_LT(difference.largest, 1.5);
    EXPECT_GT(difference.largest, 0.0) << "they are two ways";
}
TEST(GradientPlaces, PicturesOfBytesAreThoseOfDifferences) { expectStoredAsDifferences<std::uint8_t>({1, 1, 1}); }
TEST(GradientPlaces, PicturesOfWordsAreThoseOfDifferences) { expectStoredAsDifferences<std::uint16_t>({1, 1, 1}); }
TEST(GradientPlaces, PicturesOfFloatsAreThoseOfDifferences) { expectStoredAsDifferences<float>({0.5, 1, 0.5}); }

TEST(GradientPlaces, WithoutLightNothingIsStoredAndHiddenBricksAreNotMade) {
    const auto volume = held(constantVolume<std::uint8_t>({64, 64, 64}, 0.5));
    RayCastSettings settings = settingsFor(*volume, Viewpoint{}, 40, 40);
    RayCaster caster(volume);
    (void)caster.cast(PowerCurve{1, 1}, settings);
    EXPECT_EQ(caster.storedGradientBytes(), 0U);
    settings.shading = Shading{};
    (void)caster.cast(ManualCurve{{{0, 0.999}, {1, 0.999}}}, settings);
    const std::size_t all =
        static_cast<std::size_t>(BrickGrid(volume->geometry()).count()) * GradientPlaces::bytesPerBrick;
    EXPECT_GT(caster.storedGradientBytes(), 0U);
    EXPECT_LT(caster.storedGradientBytes(), all / 4) << "rays end in the first bricks";
    // Another caster of the volume shares them.
    EXPECT_EQ(caster.sharing().storedGradientBytes(), caster.storedGradientBytes());
}

}  // namespace
}  // namespace echolucent
