// What pictures read where the data ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "processing/volume/filled_volume.h"

namespace echolucent {
namespace {

constexpr std::int64_t cubeEdge = 32;

VolumeGeometry cube() {
    VolumeGeometry geometry;
    geometry.size = {cubeEdge, cubeEdge, cubeEdge};
    return geometry;
}

/// A volume of 100, and 7 where isData(x, y, z) is false, of which the mask says that it is no data.
template <typename IsData>
Volume maskedVolume(const IsData& isData) {
    const VolumeGeometry geometry = cube();
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 7), mask(voxels.size(), 0);
    for (std::int64_t z = 0; z < cubeEdge; ++z)
        for (std::int64_t y = 0; y < cubeEdge; ++y)
            for (std::int64_t x = 0; x < cubeEdge; ++x)
                if (isData(x, y, z)) {
                    const auto at = static_cast<std::size_t>(geometry.offset(x, y, z));
                    voxels[at] = 100;
                    mask[at] = 1;
                }
    return Volume(geometry, std::move(voxels)).withDataMask(std::move(mask));
}

double presenceAt(const FilledVolume& filled, std::int64_t x, std::int64_t y, std::int64_t z) {
    return filled.presence->storedValue(filled.presence->geometry().offset(x, y, z)) / 255.0;
}

TEST(FilledVolume, IsTheVolumeItselfWhereAllVoxelsCarryData) {
    const Volume volume = maskedVolume([](auto...) { return true; });
    const FilledVolume filled = filledVolume(volume);
    EXPECT_FALSE(filled.presence.has_value());
    EXPECT_EQ(&filled.voxels.voxels(), &volume.voxels()) << "not copied";
}

TEST(FilledVolume, VoxelsBesideDataHoldItAndThoseFarAwayNothing) {
    const FilledVolume filled = filledVolume(maskedVolume([](auto x, auto, auto) { return x >= 16; }));
    for (std::int64_t x = 0; x < cubeEdge; ++x) {
        const std::int64_t at = cube().offset(x, 9, 21);
        EXPECT_EQ(filled.voxels.storedValue(at), x >= 16 - FilledVolume::fillReach ? 100.0 : 0.0) << x;
        EXPECT_EQ(filled.voxels.hasData(at), x >= 16 - FilledVolume::fillReach) << x;
    }
}

/// One layer more, by its definition, of what `known` marks; a neighbour beyond a row or slice of the grid is the last
/// one's.
void growByDefinition(const VolumeGeometry& geometry, std::vector<std::uint8_t>& voxels,
                      std::vector<std::uint8_t>& known) {
    const std::vector<std::uint8_t> held = voxels, before = known;
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const auto at = static_cast<std::size_t>(geometry.offset(x, y, z));
                double sum = 0.0;
                int count = 0;
                for (int i = 0; i < 27; ++i) {
                    const std::int64_t column = x + i % 3 - 1;
                    if (column < 0 || column >= geometry.size[0]) continue;
                    const auto there = static_cast<std::size_t>(
                        geometry.offset(column, std::clamp<std::int64_t>(y + i / 3 % 3 - 1, 0, geometry.size[1] - 1),
                                        std::clamp<std::int64_t>(z + i / 9 - 1, 0, geometry.size[2] - 1)));
                    sum += before[there] * held[there];
                    count += before[there];
                }
                if (before[at] != 0 || count == 0) continue;
                voxels[at] = static_cast<std::uint8_t>(std::lround(sum / count));
                known[at] = 1;
            }
}

TEST(FilledVolume, LayersGrowAsDefinedAcrossAnyColumn) {
    VolumeGeometry geometry;
    geometry.size = {131, 12, 11};  // rows of two whole words of 64 bits and three voxels more
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount())), mask(voxels.size(), 0);
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const auto at = static_cast<std::size_t>(geometry.offset(x, y, z));
                voxels[at] = static_cast<std::uint8_t>((37 * x + 11 * y + 5 * z) % 251);
                // Borders lie on both sides of either word's end, and at the row's.
                const bool column = x == 58 + y || x == 122 + y / 2 || (z == 3 && x == 130) || (z == 8 && x == 0);
                mask[at] = column && (y + z) % 3 != 0 ? 1 : 0;
            }
    const FilledVolume filled = filledVolume(Volume(geometry, voxels).withDataMask(mask));
    for (int layer = 0; layer < FilledVolume::fillReach; ++layer) growByDefinition(geometry, voxels, mask);
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        const auto at = static_cast<std::int64_t>(i);
        ASSERT_EQ(filled.voxels.hasData(at), mask[i] != 0) << i % 131;
        ASSERT_EQ(filled.voxels.storedValue(at), mask[i] != 0 ? voxels[i] : 0) << i % 131;
    }
}

TEST(FilledVolume, PresenceOfAPlaneIsTheBinomialOfItsDistance) {
    const FilledVolume filled = filledVolume(maskedVolume([](auto x, auto, auto) { return x >= 16; }));
    const double expected[] = {0, 0, 1, 5, 11, 15, 16, 16};
    for (std::int64_t i = 0; i < 8; ++i)
        EXPECT_NEAR(presenceAt(filled, 12 + i, 3, 28), expected[i] / 16, 1.0 / 255) << i;
}

/// How far the place where presence crosses one half strays from its mean distance to the plane x = 10 + z / run.
double strayOf(double run) {
    const auto plane = [&](double z) { return 10.0 + z / run; };
    const FilledVolume filled = filledVolume(
        maskedVolume([&](auto x, auto, auto z) { return static_cast<double>(x) >= plane(static_cast<double>(z)); }));
    std::vector<double> apart;
    for (std::int64_t z = 8; z < cubeEdge - 8; ++z)
        for (std::int64_t x = 4; x < cubeEdge - 4; ++x) {
            const double before = presenceAt(filled, x, 16, z), behind = presenceAt(filled, x + 1, 16, z);
            if (before >= 0.5 || behind < 0.5) continue;
            apart.push_back(static_cast<double>(x) + (0.5 - before) / (behind - before) -
                            plane(static_cast<double>(z)));
        }
    double mean = 0.0, largest = 0.0;
    for (const double here : apart) mean += here / static_cast<double>(apart.size());
    for (const double here : apart) largest = std::max(largest, std::abs(here - mean));
    // The mask begins at the first voxel behind the plane, on average (run - 1) / (2 run) behind it, and half a voxel
    // before that voxel's centre.
    EXPECT_NEAR(mean, -0.5 / run, 0.02) << run;
    return largest;
}

TEST(FilledVolume, AnObliquePlaneHasNoStairs) {
    // Without the wide kernel it would be 0.04, 0.15 and 0.28.
    EXPECT_LT(strayOf(3), 0.03);
    EXPECT_LT(strayOf(5), 0.04);
    EXPECT_LT(strayOf(8), 0.09);
}

TEST(FilledVolume, WhatIsAVoxelThickStays) {
    const auto sheet = filledVolume(maskedVolume([](auto x, auto, auto) { return x == 16; }));
    const auto wire = filledVolume(maskedVolume([](auto x, auto y, auto) { return x == 16 && y == 9; }));
    const auto gap = filledVolume(maskedVolume([](auto x, auto y, auto z) { return x != 16 || y != 9 || z != 3; }));
    EXPECT_GE(presenceAt(sheet, 16, 5, 5), 0.5);
    EXPECT_LT(presenceAt(sheet, 18, 5, 5), 0.25);
    EXPECT_GE(presenceAt(wire, 16, 9, 5), 0.75);
    EXPECT_LT(presenceAt(wire, 18, 9, 5), 0.25);
    EXPECT_LT(presenceAt(gap, 16, 9, 3), 0.25);
    EXPECT_GE(presenceAt(gap, 18, 9, 3), 0.75);
}

TEST(FilledVolume, FloatsThatAreNotFiniteAreFilledWithoutAMask) {
    std::vector<float> voxels(static_cast<std::size_t>(cube().voxelCount()), 2.5f);
    voxels[static_cast<std::size_t>(cube().offset(5, 6, 7))] = std::numeric_limits<float>::quiet_NaN();
    const FilledVolume filled = filledVolume(Volume(cube(), std::move(voxels)));
    EXPECT_EQ(filled.voxels.storedValue(cube().offset(5, 6, 7)), 2.5);
    EXPECT_LT(presenceAt(filled, 5, 6, 7), 0.25);
}

}  // namespace
}  // namespace echolucent
