// What a tube's slabs become in its profile: where it begins and ends, and what stands for a slab of too little data.
#include "processing/tube_core/slabs/tube_profiles.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace echolucent {
namespace {

TEST(TubeProfiles, BeginAndEndWithHalfFullSlabsAndRepeatWhereDataIsMissing) {
    constexpr int cellSize = 5;  // 25 samples: 13 are half of them.
    const std::vector<SlabMoments> slabs{{12, 0.9, 1.0}, {13, 0.1, 13 * 0.04}, {25, 0.2, 25 * 0.09}, {12, 0.9, 1.0},
                                         {0, 0.0, 0.0},  {20, 0.4, 20 * 0.01}, {5, 0.9, 1.0}};
    TubeProfiles profiles(std::array{0, 7, 7});
    profiles.set(1, slabs, cellSize);
    EXPECT_EQ(profiles.tubes(), 3u);
    EXPECT_EQ(profiles.firstSlab(1), 1);
    const auto means = profiles.means(1), spreads = profiles.spreads(1);
    ASSERT_EQ(means.size(), 5u);
    ASSERT_EQ(spreads.size(), 5u);
    const std::vector<float> expectedMeans{0.1f, 0.2f, 0.2f, 0.2f, 0.4f}, expectedSpreads{0.2f, 0.3f, 0.3f, 0.3f, 0.1f};
    for (std::size_t k = 0; k < means.size(); ++k) {
        EXPECT_FLOAT_EQ(means[k], expectedMeans[k]);
        EXPECT_FLOAT_EQ(spreads[k], expectedSpreads[k]);
    }
    EXPECT_TRUE(profiles.means(0).empty());
    profiles.set(2, std::vector<SlabMoments>(7, {12, 0.5, 1.0}), cellSize);
    EXPECT_TRUE(profiles.means(2).empty()) << "nowhere half full";
}

TEST(TubeProfiles, AreTheSameFromStoredSumsMeansAndMoments) {
    constexpr int cellSize = 3;
    constexpr double white = 4095;
    // There are nine stored values each; the middle slab holds too few.
    const std::vector<std::vector<std::int32_t>> stored{
        {0, 10, 20, 30, 40, 50, 60, 70, 80}, {7, 9}, {4095, 4000, 4095, 3990, 4095, 4001, 4095, 4002, 17}};
    SlabSums sums;
    SlabMeans means;
    std::vector<SlabMoments> moments;
    for (const auto& values : stored) {
        std::int64_t sum = 0, squares = 0;
        for (const std::int64_t value : values) {
            sum += value;
            squares += value * value;
        }
        const double count = static_cast<double>(values.size()), mean = static_cast<double>(sum) / count;
        double deviations = 0.0;
        for (const double value : values) deviations += (value - mean) * (value - mean);
        sums.counts.push_back(static_cast<std::int32_t>(values.size()));
        sums.sums.push_back(static_cast<std::int32_t>(sum));
        sums.sumsOfSquares.push_back(static_cast<std::uint64_t>(squares));
        means.counts.push_back(static_cast<float>(count));
        means.means.push_back(static_cast<float>(mean));
        means.squaredDeviations.push_back(static_cast<float>(deviations));
        moments.push_back({static_cast<std::uint32_t>(values.size()), mean / white, deviations / white / white});
    }
    TubeProfiles profiles(std::array{3, 3, 3});
    profiles.set(0, moments, cellSize);
    profiles.set(1, sums, cellSize, white);
    profiles.set(2, means, cellSize, white);
    ASSERT_EQ(profiles.means(0).size(), 3u);
    EXPECT_EQ(profiles.means(0)[1], profiles.means(0)[0]);
    for (const std::size_t t : {1u, 2u}) {
        ASSERT_EQ(profiles.means(t).size(), 3u);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(profiles.means(t)[k], profiles.means(0)[k], 2e-7 * profiles.means(0)[k]);
            EXPECT_NEAR(profiles.spreads(t)[k], profiles.spreads(0)[k], 1e-6 * profiles.spreads(0)[k]);
        }
    }
}

}  // namespace
}  // namespace echolucent
