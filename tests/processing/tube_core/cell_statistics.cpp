#include "processing/tube_core/cell_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <span>

namespace echolucent {
namespace {

struct Slab {
    std::int32_t count, sum;
    std::uint64_t sumOfSquares;
};

void append(SlabSums& slabs, const Slab& slab) {
    slabs.counts.push_back(slab.count);
    slabs.sums.push_back(slab.sum);
    slabs.sumsOfSquares.push_back(slab.sumOfSquares);
}

SlabSums slabsOf(const std::vector<std::vector<std::uint16_t>>& values) {
    SlabSums slabs;
    for (const auto& slab : values) {
        Slab sums{};
        for (const std::uint64_t value : slab) {
            ++sums.count;
            sums.sum += static_cast<std::int32_t>(value);
            sums.sumOfSquares += value * value;
        }
        append(slabs, sums);
    }
    return slabs;
}

SlabSums slabsOf(const std::vector<Slab>& values) {
    SlabSums slabs;
    for (const Slab& slab : values) append(slabs, slab);
    return slabs;
}

/// By the definition, n sum (x - mean)^2 * n = sum over pairs (x_i - x_j)^2, in integers.
std::uint64_t scaledVarianceByPairs(const std::vector<std::uint16_t>& values) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::int64_t difference = static_cast<std::int64_t>(values[i]) - values[j];
            sum += static_cast<std::uint64_t>(difference * difference);
        }
    return sum;
}

TEST(CellStatistics, VarianceOf16BitVoxelsOfMean65000IsExact) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> around(64990, 65010);
    std::vector<std::vector<std::uint16_t>> values(30, std::vector<std::uint16_t>(25));
    for (auto& slab : values)
        for (auto& value : slab) value = static_cast<std::uint16_t>(around(random));
    values[20].assign(25, 65535);
    CellStatistics cells;
    cellsFrom(slabsOf(values), 5, 1.0, cells);
    EXPECT_EQ(cells.firstCell, 0);
    ASSERT_EQ(cells.lastCell, 25);
    for (std::size_t i = 0; i < 26; ++i) {
        std::vector<std::uint16_t> all;
        std::uint64_t sum = 0, squares = 0;
        for (std::size_t k = i; k < i + 5; ++k)
            for (const std::uint64_t value : values[k]) {
                all.push_back(static_cast<std::uint16_t>(value));
                sum += value;
                squares += value * value;
            }
        const std::uint64_t exact = scaledVarianceByPairs(all);
        ASSERT_EQ(scaledVariance(125, sum, squares), exact);
        EXPECT_DOUBLE_EQ(cells.variances[i], static_cast<double>(exact) / (125.0 * 125.0));
        EXPECT_DOUBLE_EQ(cells.means[i], static_cast<double>(sum) / 125.0);
    }
}

TEST(CellStatistics, TheLargestCellOfTheLargestVoxelsDoesNotOverflow) {
    const std::uint64_t samples = std::uint64_t{largestCellSize} * largestCellSize * largestCellSize;
    const std::uint64_t half = samples / 2, high = 65535;
    // Half of the samples are 0 and half are 65535, so the variance is (65535 / 2)^2.
    EXPECT_EQ(scaledVariance(samples, half * high, half * high * high), half * half * high * high);
    EXPECT_EQ(scaledVariance(samples, samples * high, samples * high * high), 0u);
}

TEST(CellStatistics, MomentsAgreeWithSumsAndSurviveALargeMean) {
    std::mt19937 random(3);
    std::normal_distribution<double> around(0.9, 1e-9);
    std::vector<SlabMoments> slabs;
    std::vector<std::vector<double>> values(12, std::vector<double>(9));
    for (auto& slab : values) {
        SlabMoments moments;
        for (double& value : slab) moments.mean += (value = around(random)) / 9;
        for (const double value : slab) moments.squaredDeviations += (value - moments.mean) * (value - moments.mean);
        moments.count = 9;
        slabs.push_back(moments);
    }
    CellStatistics cells;
    cellsFrom(std::span<const SlabMoments>(slabs), 3, cells);
    ASSERT_EQ(cells.lastCell, 9);
    for (std::size_t i = 0; i < 10; ++i) {
        long double mean = 0, variance = 0;
        for (std::size_t k = i; k < i + 3; ++k)
            for (const double value : values[k]) mean += value / 27.0L;
        for (std::size_t k = i; k < i + 3; ++k)
            for (const double value : values[k]) variance += (value - mean) * (value - mean) / 27.0L;
        EXPECT_NEAR(cells.variances[i] / static_cast<double>(variance), 1.0, 1e-6);
    }
}

TEST(CellStatistics, BeginsAtTheFirstSlabAndEndsAtTheLastThatIsHalfData) {
    std::vector<Slab> slabs(20, Slab{0, 0, 0});
    for (std::size_t k = 4; k <= 15; ++k) slabs[k] = {25, 250, 2500};
    slabs[3] = {12, 120, 1200};
    slabs[16] = {13, 130, 1300};
    CellStatistics cells;
    cellsFrom(slabsOf(slabs), 5, 255, cells);
    EXPECT_EQ(cells.firstCell, 4);
    EXPECT_EQ(cells.lastCell, 12);
    for (int i = cells.firstCell; i <= cells.lastCell; ++i)
        EXPECT_EQ(cells.variances[static_cast<std::size_t>(i)], 0.0);
}

TEST(CellStatistics, HoldsItsValuesAcrossAHole) {
    std::vector<Slab> slabs;
    for (int k = 0; k < 30; ++k) slabs.push_back({25, 25 * k, static_cast<std::uint64_t>(25 * k * k)});
    for (std::size_t k = 10; k < 18; ++k) slabs[k] = {0, 0, 0};
    CellStatistics cells;
    cellsFrom(slabsOf(slabs), 5, 1, cells);
    EXPECT_EQ(cells.lastCell, 25);
    EXPECT_EQ(cells.complete[7], 1);
    for (std::size_t i = 8; i <= 15; ++i) {  // cell 8 holds samples 8 and 9, cell 15 samples 18 and 19: less than half
        EXPECT_EQ(cells.complete[i], 0);
        EXPECT_EQ(cells.means[i], cells.means[7]);
        EXPECT_EQ(cells.variances[i], cells.variances[7]);
    }
    EXPECT_EQ(cells.complete[16], 1);
    EXPECT_EQ(cells.means[7], 8.0) << "of the samples 7, 8 and 9";
    EXPECT_EQ(cells.means[16], 19.0) << "of the samples 18, 19 and 20";
}

TEST(CellStatistics, SaysSoWhereThereIsNoCell) {
    CellStatistics cells;
    cellsFrom(slabsOf(std::vector<Slab>(4, Slab{25, 25, 25})), 5, 255, cells);
    EXPECT_LT(cells.lastCell, cells.firstCell);
    EXPECT_TRUE(cells.anyData);
    cellsFrom(SlabSums{}, 5, 255, cells);
    EXPECT_LT(cells.lastCell, cells.firstCell);
    EXPECT_FALSE(cells.anyData);
}

TEST(CellStatistics, SinglePrecisionAgreesWithMomentsAndKeepsConstantsExact) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> value(0.0f, 4000.0f);
    SlabMeans single;
    std::vector<SlabMoments> moments;
    const double white = 4095;
    for (int k = 0; k < 200; ++k) {
        const int count = k % 17 == 3 ? 9 : k > 90 && k < 97 ? 0 : 25;
        const float mean = count == 0 ? 0.0f : value(random), deviations = count == 0 ? 0.0f : 100 * value(random);
        single.counts.push_back(static_cast<float>(count));
        single.means.push_back(mean);
        single.squaredDeviations.push_back(deviations);
        moments.push_back({static_cast<std::uint32_t>(count), mean / white, deviations / white / white});
    }
    CellStatistics got, expected;
    cellsFrom(single, 5, white, got);
    cellsFrom(std::span<const SlabMoments>(moments), 5, expected);
    EXPECT_EQ(got.firstCell, expected.firstCell);
    EXPECT_EQ(got.lastCell, expected.lastCell);
    EXPECT_EQ(got.complete, expected.complete);
    ASSERT_EQ(got.means.size(), expected.means.size());
    for (std::size_t i = 0; i < got.means.size(); ++i) {
        EXPECT_NEAR(got.means[i], expected.means[i], 1e-14);
        EXPECT_NEAR(got.variances[i], expected.variances[i], 1e-14);
    }
    for (std::size_t k = 0; k < single.means.size(); ++k) {
        single.means[k] = 0.1f;
        single.squaredDeviations[k] = 0.0f;
    }
    cellsFrom(single, 5, white, got);
    for (int i = got.firstCell; i <= got.lastCell; ++i) {
        EXPECT_EQ(got.variances[static_cast<std::size_t>(i)], 0.0);
        EXPECT_EQ(got.means[static_cast<std::size_t>(i)], static_cast<double>(0.1f) / white);
    }
}

}  // namespace
}  // namespace echolucent
