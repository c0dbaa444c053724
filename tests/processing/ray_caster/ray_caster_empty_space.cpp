// Where rays jump: distances to the next brick that shows something, and the pictures with and without jumps.
#include "processing/ray_caster/packed/empty_space.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "processing/volume/filled_volume.h"
#include "ray_caster_scenes.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

using namespace ray_casting;

TransferTable tableOf(const OpacityCurve& curve) { return TransferTable(curve, ColourMap::grey, 1.0); }

/// Intensities that change slowly, so that bricks have narrow ranges, and differ widely across the volume.
template <typename Voxel>
Volume hills(const std::array<std::int64_t, 3>& size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> phase(0.0, 6.28), frequency(0.01, 0.09);
    std::array<std::array<double, 4>, 5> waves{};
    for (auto& wave : waves) wave = {frequency(random), frequency(random), frequency(random), phase(random)};
    return volumeOf<Voxel>(size, {1, 1, 1}, [&](auto x, auto y, auto z) {
        double sum = 0.0;
        for (const auto& wave : waves)
            sum += std::sin(wave[0] * static_cast<double>(x) + wave[1] * static_cast<double>(y) +
                            wave[2] * static_cast<double>(z) + wave[3]);
        return 0.5 + 0.1 * sum;
    });
}

/// A curve that shows one or two narrow ranges of intensity, anywhere.
OpacityCurve randomCurve(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const double start = share(random), width = 0.02 + 0.3 * share(random) * share(random);
    std::vector<double> opacities(256, 0.0);
    for (std::size_t i = 0; i < opacities.size(); ++i) {
        const double x = static_cast<double>(i) / 255;
        if (x >= start && x < start + width) opacities[i] = 0.3;
        if (share(random) < 0.002) opacities[i] = 0.5;
    }
    return SampledCurve{opacities};
}

TEST(RayCasterEmptySpace, FollowingACurveGivesWhatAFreshObjectHas) {
    const Volume volume = sectorOf(hills<std::uint8_t>({111, 96, 103}, 3));
    const BrickRanges ranges(filledVoxels(volume), PackedPresence(volume));
    EmptySpace followed(ranges.grid());
    std::mt19937 random(17);
    int partly = 0;
    for (int edit = 0; edit < 200; ++edit) {
        const TransferTable table = tableOf(randomCurve(random));
        followed.update(ranges, table);
        EmptySpace fresh(ranges.grid());
        fresh.update(ranges, table);
        ASSERT_TRUE(followed.distances() == fresh.distances()) << edit;
        ASSERT_EQ(followed.any(), fresh.any()) << edit;
        partly += followed.any() ? 1 : 0;
    }
    EXPECT_GT(partly, 100);
}

TEST(RayCasterEmptySpace, ASmallChangeIsFollowed) {
    // Each of nine bricks far apart has an intensity of its own, from 100 to 180 levels.
    const Volume volume = volumeOf<std::uint8_t>({240, 64, 240}, {1, 1, 1}, [](auto x, auto y, auto z) {
        const bool dot = x % 80 == 44 && y == 36 && z % 80 == 44;
        const auto block = x / 80 + 3 * (z / 80);
        return dot ? static_cast<double>(100 + 10 * block) / 255 : 0.0;
    });
    const BrickRanges ranges(filledVoxels(volume), PackedPresence(volume));
    EmptySpace followed(ranges.grid());
    const auto showOnly = [&](double lowest, double highest) {
        const TransferTable table =
            tableOf(ManualCurve{{{lowest - 2e-3, 0.0}, {lowest, 0.5}, {highest, 0.5}, {highest + 2e-3, 0.0}}});
        followed.update(ranges, table);
        EmptySpace fresh(ranges.grid());
        fresh.update(ranges, table);
        EXPECT_TRUE(followed.distances() == fresh.distances());
        return std::ranges::count(followed.distances(), 0);  // bricks that show something
    };
    EXPECT_EQ(showOnly(99.0 / 255, 1.0), 9) << "the first curve";
    EXPECT_EQ(showOnly(99.0 / 255, 0.9), 9) << "a change that no brick's range sees";
    EXPECT_EQ(showOnly(119.0 / 255, 0.9), 7) << "two bricks are no longer shown";
    EXPECT_EQ(showOnly(119.0 / 255, 0.9), 7) << "the same curve";
    EXPECT_EQ(showOnly(99.0 / 255, 0.9), 9) << "they are shown again";
}

/// A brick shows something where an intensity between its smallest and largest voxel does.
bool showsSomething(const Volume& volume, const OpacityCurve& curve, std::int64_t x, std::int64_t y, std::int64_t z) {
    double lowest = 2.0, highest = -1.0;
    const auto& size = volume.geometry().size;
    const auto first = [](std::int64_t brick) { return std::max<std::int64_t>(0, 8 * brick - 1); };
    for (std::int64_t k = first(z); k < std::min(size[2], 8 * z + 8); ++k)
        for (std::int64_t j = first(y); j < std::min(size[1], 8 * y + 8); ++j)
            for (std::int64_t i = first(x); i < std::min(size[0], 8 * x + 8); ++i) {
                const std::int64_t offset = volume.geometry().offset(i, j, k);
                if (!volume.hasData(offset)) continue;
                lowest = std::min(lowest, volume.normalisedIntensity(offset));
                highest = std::max(highest, volume.normalisedIntensity(offset));
            }
    for (double at = lowest; at <= highest; at += 1e-3)
        if (opacityAt(curve, at) > 1e-6) return true;
    return false;
}

std::vector<bool> visibleBricks(const Volume& volume, const OpacityCurve& curve, const BrickGrid& grid) {
    std::vector<bool> visible(static_cast<std::size_t>(grid.count()));
    for (std::int64_t z = 0; z < grid.size[2]; ++z)
        for (std::int64_t y = 0; y < grid.size[1]; ++y)
            for (std::int64_t x = 0; x < grid.size[0]; ++x)
                visible[grid.offset(x, y, z)] = showsSomething(volume, curve, x, y, z);
    return visible;
}

/// By the definition: how far away the next brick is that shows something, in bricks on the axis where that is most.
int distanceByDefinition(const BrickGrid& grid, const std::vector<bool>& visible, std::int64_t x, std::int64_t y,
                         std::int64_t z) {
    for (int distance = 0; distance < EmptySpace::farthest; ++distance)
        for (std::int64_t k = z - distance; k <= z + distance; ++k)
            for (std::int64_t j = y - distance; j <= y + distance; ++j)
                for (std::int64_t i = x - distance; i <= x + distance; ++i) {
                    const bool inside =
                        i >= 0 && j >= 0 && k >= 0 && i < grid.size[0] && j < grid.size[1] && k < grid.size[2];
                    if (inside && visible[grid.offset(i, j, k)]) return distance;
                }
    return EmptySpace::farthest;
}

TEST(RayCasterEmptySpace, DistancesAreThoseOfTheDefinition) {
    for (const bool masked : {false, true}) {
        const Volume hilly = hills<std::uint16_t>({107, 88, 71}, 5);
        const Volume volume = masked ? sectorOf(hilly) : hilly;
        const BrickRanges ranges(filledVoxels(volume), PackedPresence(volume));
        const BrickGrid& grid = ranges.grid();
        for (const OpacityCurve& curve : {onlyBetween(0.8, 0.9, 0.5), onlyBetween(0.2, 0.3, 0.5), everywhere(0.0)}) {
            EmptySpace space(grid);
            space.update(ranges, tableOf(curve));
            const std::vector<bool> visible = visibleBricks(volume, curve, grid);
            std::int64_t jumps = 0, differing = 0;
            for (std::int64_t z = 0; z < grid.size[2]; ++z)
                for (std::int64_t y = 0; y < grid.size[1]; ++y)
                    for (std::int64_t x = 0; x < grid.size[0]; ++x) {
                        const int found = space.distances()[grid.offset(x, y, z)];
                        const int expected = distanceByDefinition(grid, visible, x, y, z);
                        // The table's ranges are wider by a hair: a brick more may count as visible, none less.
                        ASSERT_LE(found, expected);
                        differing += found != expected ? 1 : 0;
                        jumps += found > 0 ? 1 : 0;
                    }
            EXPECT_LT(differing, grid.count() / (masked ? 12 : 20)) << "filled voxels widen ranges at the border";
            EXPECT_GT(jumps, grid.count() / 10) << "rays may jump";
        }
    }
}

TEST(RayCasterEmptySpace, BrickRangesHoldEveryVoxelASampleMayTouch) {
    const Volume volume = randomVolume<float>({17, 8, 25}, {1, 1, 1}, 6);
    const BrickRanges ranges(filledVoxels(volume), PackedPresence(volume));
    const BrickGrid& grid = ranges.grid();
    EXPECT_EQ(grid.size, (std::array<std::int64_t, 3>{3, 2, 4})) << "cubes 0 ... size";
    for (std::int64_t z = 0; z <= 25; ++z)
        for (std::int64_t y = 0; y <= 8; ++y)
            for (std::int64_t x = 0; x <= 17; ++x)
                for (int corner = 0; corner < 8; ++corner) {
                    const auto voxel = [](std::int64_t cube, bool far, std::int64_t size) {
                        return std::clamp<std::int64_t>(cube - 1 + (far ? 1 : 0), 0, size - 1);
                    };
                    const double position =
                        2040.0 * volume.normalisedIntensity(volume.geometry().offset(
                                     voxel(x, corner & 1, 17), voxel(y, corner & 2, 8), voxel(z, corner & 4, 25)));
                    const std::size_t brick = grid.offset(x / 8, y / 8, z / 8);
                    ASSERT_LE(static_cast<double>(ranges.lowest()[brick]), position);
                    ASSERT_GE(static_cast<double>(ranges.highest()[brick]), position - 1e-3);
                }
}

template <typename Voxel>
void expectSamePictureWithoutSkipping() {
    for (const bool masked : {false, true}) {
        const Volume hilly = hills<Voxel>({110, 104, 100}, 8);
        const Volume volume = masked ? sectorOf(hilly) : hilly;
        int which = 0;
        for (const OpacityCurve& curve :
             {onlyBetween(0.66, 0.82, 0.3), onlyBetween(0.2, 0.3, 0.03), OpacityCurve{LinearCurve{0.7, 0.5, 1.0}}}) {
            ++which;
            for (const Projection projection : {Projection::parallel, Projection::perspective})
                for (const bool fine : {false, true}) {
                    if (takesSomeInputs && (fine || !masked)) continue;
                    RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 37, 19, 0}, 90, 80);
                    settings.camera.projection = projection;
                    settings.step = fine ? 0.4 : 1.0;
                    const auto skipping = castRays(volume, curve, settings);
                    settings.skipEmptySpace = false;
                    const auto whole = castRays(volume, curve, settings);
                    const Apart difference = apart(*skipping, *whole);
                    EXPECT_LT(difference.largest, 1.0 / 16)
                        << (masked ? "masked" : "whole") << (fine ? ", step 0.4" : "") << ", curve " << which
                        << (projection == Projection::parallel ? "" : ", perspective") << ", RMSE "
                        << difference.rootMeanSquare;
                    EXPECT_GT(largestAlpha(*whole), 0.01f);
                }
        }
    }
}
TEST(RayCasterEmptySpace, SkippingLeavesThePictureOfBytes) { expectSamePictureWithoutSkipping<std::uint8_t>(); }
TEST(RayCasterEmptySpace, SkippingLeavesThePictureOfWords) { expectSamePictureWithoutSkipping<std::uint16_t>(); }
TEST(RayCasterEmptySpace, SkippingLeavesThePictureOfFloats) { expectSamePictureWithoutSkipping<float>(); }

TEST(RayCasterEmptySpace, RaysDoJump) {
    // Opacities that count as none: whoever samples them adds them up, and whoever jumps does not.
    const Volume volume = constantVolume<std::uint8_t>({40, 40, 300}, 0.5);
    const OpacityCurve faint = everywhere(0.9 * TransferTable::negligible);
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{BeamAxis::plusX, 12, 30, 0}})
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            RayCastSettings settings = settingsFor(volume, view, 30, 30);
            settings.camera.projection = projection;
            const auto twoCutSteps = static_cast<float>(2 * TransferTable::negligible);
            EXPECT_LE(largestAlpha(*castRays(volume, faint, settings)), twoCutSteps) << "sampled at a ray's ends alone";
            settings.skipEmptySpace = false;
            const float most = largestAlpha(*castRays(volume, faint, settings));
            EXPECT_GT(most, 10 * twoCutSteps);
            EXPECT_LT(most, 1.0f / 16 / 255) << "and it is as little as is said";
        }
}

/// The bound is in levels, between the pictures. Where runs of samples begin depends on the jumps, and so does the last
/// bit of a position: of words that is a thousandth of a level, of bytes a step in their shares of 7 bits.
template <typename Voxel>
void expectJumpsToStop(double levels) {
    // The bright voxel is found wherever it is: in brick corners, at borders, alone in the dark.
    std::mt19937 dice(5);
    for (int i = 0; i < (takesSomeInputs ? 12 : 60); ++i) {
        const std::int64_t at[3] = {static_cast<std::int64_t>(dice() % 90), static_cast<std::int64_t>(dice() % 70),
                                    static_cast<std::int64_t>(dice() % 110)};
        const Volume volume = volumeOf<Voxel>({90, 70, 110}, {1, 1, 1}, [&](auto x, auto y, auto z) {
            return x == at[0] && y == at[1] && z == at[2] ? 1.0 : 0.0;
        });
        Viewpoint view{static_cast<BeamAxis>(i % 6), 50.0 * (i % 3 - 1), 20.0 * (i % 2), 0};
        RayCastSettings settings = settingsFor(volume, view, 40, 40);
        settings.camera.focalPoint =
            Vec3(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]));
        settings.camera.heightMm = 4.0;
        settings.step = 0.6;
        if (i % 4 == 0) settings.camera.projection = Projection::perspective;
        settings.camera.distanceMm = 300.0;
        settings.camera.viewAngleDegrees = 0.8;
        const auto skipping = castRays(volume, LinearCurve{0.05, 0.5, 1.0}, settings);
        settings.skipEmptySpace = false;
        const auto whole = castRays(volume, LinearCurve{0.05, 0.5, 1.0}, settings);
        EXPECT_LT(apart(*skipping, *whole).largest, levels) << i;
        EXPECT_GT(largestAlpha(*whole), 0.2f) << i;
    }
}
TEST(RayCasterEmptySpace, JumpsStopBeforeASingleVisibleVoxel) {
    expectJumpsToStop<std::uint16_t>(1.0 / 16);
    expectJumpsToStop<std::uint8_t>(1.0);
}

}  // namespace
}  // namespace echolucent
