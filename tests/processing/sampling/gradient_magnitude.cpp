// Gradient magnitudes of ramps that are known, and of speckle by a plain route.
#include "processing/sampling/gradient_magnitude.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "processing/sampling/gradient_levels.h"
#include "tests/processing/grids.h"
#include "tests/processing/sampling/gradient_rows.h"

namespace echolucent {
namespace {

TEST(GradientMagnitude, ARampHasItsSlopeEverywhereAtTheBorderToo) {
    // A plane wave of slope (0.01, -0.02, 0.03) a mm, sampled by an anisotropic grid; the unit is 0.5 mm.
    const VolumeGeometry geometry = gridOf({9, 8, 7}, {0.5, 1.0, 1.5});
    std::vector<float> voxels;
    for (std::int64_t z = 0; z < 7; ++z)
        for (std::int64_t y = 0; y < 8; ++y)
            for (std::int64_t x = 0; x < 9; ++x) {
                const Vec3 mm =
                    geometry.gridMmFromVoxel({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
                voxels.push_back(static_cast<float>(100 * (0.4 + mm.dot(Vec3(0.01, -0.02, 0.03)))));
            }
    const Volume volume(geometry, VoxelArray<float>(std::move(voxels)), 100.0);
    const double expected = 0.5 * std::sqrt(0.01 * 0.01 + 0.02 * 0.02 + 0.03 * 0.03);
    for (const float magnitude : magnitudesOf(volume)) EXPECT_NEAR(magnitude, expected, 2e-7);
}

template <typename Voxel>
void expectPlainMagnitudes(double white) {
    const VolumeGeometry geometry = gridOf({11, 6, 5}, {1.0, 0.7, 2.0});
    std::mt19937 random(4);
    std::vector<Voxel> voxels(11 * 6 * 5);
    for (Voxel& voxel : voxels) voxel = static_cast<Voxel>(random() % 256);
    const Volume volume(geometry, VoxelArray<Voxel>(std::vector(voxels)), white);
    const auto at = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
        return volume.normalisedIntensity(geometry.offset(x, y, z));
    };
    const std::vector<float> magnitudes = magnitudesOf(volume);
    for (std::int64_t z = 0; z < 5; ++z)
        for (std::int64_t y = 0; y < 6; ++y)
            for (std::int64_t x = 0; x < 11; ++x) {
                const std::array<std::int64_t, 3> here{x, y, z};
                double square = 0.0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    std::array<std::int64_t, 3> low = here, high = here;
                    low[axis] = std::max<std::int64_t>(0, here[axis] - 1);
                    high[axis] = std::min(geometry.size[axis] - 1, here[axis] + 1);
                    const double units =
                        static_cast<double>(high[axis] - low[axis]) * geometry.spacing[static_cast<int>(axis)] / 0.7;
                    square += std::pow((at(high[0], high[1], high[2]) - at(low[0], low[1], low[2])) / units, 2);
                }
                EXPECT_NEAR(magnitudes[static_cast<std::size_t>(geometry.offset(x, y, z))], std::sqrt(square), 1e-6);
            }
}
TEST(GradientMagnitude, BytesHaveTheMagnitudesOfThePlainRoute) { expectPlainMagnitudes<std::uint8_t>(255); }
TEST(GradientMagnitude, WhatIsAboveWhiteCountsAsWhite) { expectPlainMagnitudes<std::uint8_t>(100); }
TEST(GradientMagnitude, WordsHaveTheMagnitudesOfThePlainRoute) { expectPlainMagnitudes<std::uint16_t>(200); }
TEST(GradientMagnitude, FloatsHaveTheMagnitudesOfThePlainRoute) { expectPlainMagnitudes<float>(300); }

TEST(GradientMagnitude, AnAxisOfOneVoxelHasNoSlope) {
    const Volume single(gridOf({1, 1, 1}), VoxelArray<std::uint8_t>{200});
    EXPECT_EQ(magnitudesOf(single), std::vector<float>{0.0f});
    const Volume pair(gridOf({1, 2, 1}), VoxelArray<std::uint8_t>{0, 51});
    EXPECT_NEAR(magnitudesOf(pair)[0], 0.2, 1e-6);
    EXPECT_NEAR(magnitudesOf(pair)[1], 0.2, 1e-6);
}

TEST(GradientMagnitude, NoNumberAndInfinityGiveFiniteMagnitudes) {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const Volume volume(gridOf({4, 2, 2}),
                        VoxelArray<float>{nan, 1, inf, -inf, 0, 1, nan, 1, 1e38f, 0, -1e38f, 1, 0, 0, 0, 0}, 1.0);
    for (const float magnitude : magnitudesOf(volume)) {
        EXPECT_GE(magnitude, 0.0f);
        EXPECT_LE(magnitude, std::sqrt(3.0f) + 1e-6f);
    }
}

TEST(GradientRange, OnlyVoxelsWithDataCount) {
    // A steep step stands where the mask marks nothing.
    std::vector<std::uint8_t> voxels, mask;
    for (int i = 0; i < 10 * 10 * 10; ++i) {
        const int x = i % 10;
        voxels.push_back(static_cast<std::uint8_t>(x < 7 ? 2 * x : 255));
        mask.push_back(x < 5 ? 1 : 0);
    }
    const Volume volume = Volume(gridOf({10, 10, 10}), VoxelArray<std::uint8_t>(voxels))
                              .withDataMask(DataMask(std::vector<std::uint8_t>(mask)));
    const auto range = gradientRange(volume, volume);
    EXPECT_NEAR(range->largest, 2.0 / 255, 1e-6);
    EXPECT_NEAR(range->quantile99, 2.0 / 255, 3e-5);
    std::atomic<bool> cancel = true;
    EXPECT_FALSE(gradientRange(volume, volume, Progress{{}, &cancel}));
}

TEST(GradientRange, TheQuantileLeavesOneInAHundredAbove) {
    // Every 50th pair of voxels is a step; central differences make three voxels of each.
    std::vector<std::uint8_t> voxels(10000, 10);
    for (std::size_t i = 0; i < 20; ++i) voxels[500 * i + 250] = 110;
    const Volume few(gridOf({10000, 1, 1}), VoxelArray<std::uint8_t>(voxels));
    const auto range = gradientRange(few, few);
    EXPECT_NEAR(range->largest, 50.0 / 255, 1e-6);
    EXPECT_LT(range->quantile99, 1e-4);
}

TEST(GradientLevels, AreTheMagnitudesToHalfAStep) {
    std::mt19937 random(9);
    std::vector<std::uint8_t> voxels(12 * 7 * 6);
    for (auto& voxel : voxels) voxel = static_cast<std::uint8_t>(random() % 100);
    const Volume volume(gridOf({12, 7, 6}), VoxelArray<std::uint8_t>(std::move(voxels)));
    const std::vector<float> magnitudes = magnitudesOf(volume);
    constexpr double largest = 0.25;
    const auto levels = gradientLevels(volume, largest);
    ASSERT_EQ(levels->bytes.size(), magnitudes.size());
    int saturated = 0;
    for (std::size_t i = 0; i < magnitudes.size(); ++i) {
        const double expected = std::min(static_cast<double>(magnitudes[i]), largest);
        EXPECT_NEAR(levels->bytes[i] / 255.0 * largest, expected, largest / 510 + 1e-6);
        saturated += levels->bytes[i] == 255 ? 1 : 0;
    }
    EXPECT_GT(saturated, 0);
    EXPECT_THROW((void)gradientLevels(volume, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
