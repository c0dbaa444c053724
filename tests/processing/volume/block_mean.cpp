#include "processing/volume/block_mean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace echolucent {
namespace {

using Size = std::array<std::int64_t, 3>;

std::size_t countOf(const Size& size) { return static_cast<std::size_t>(size[0] * size[1] * size[2]); }

template <typename T>
std::vector<T> meansOf(const std::vector<T>& values, const Reduction& reduction) {
    std::vector<T> reduced(countOf(reducedSize(reduction)));
    BlockMean<T> mean(reduction, reduced);
    const auto slice = static_cast<std::size_t>(reduction.storedSize[0] * reduction.storedSize[1]);
    for (std::size_t begin = 0; begin < values.size(); begin += slice)
        mean.add(std::span(values).subspan(begin, slice));
    return reduced;
}

/// The same by its definition, block for block in long double.
template <typename T>
std::vector<T> plainMeansOf(const std::vector<T>& values, const Reduction& reduction) {
    const Size stored = reduction.storedSize, size = reducedSize(reduction);
    std::vector<T> reduced;
    for (std::int64_t bz = 0; bz < size[2]; ++bz)
        for (std::int64_t by = 0; by < size[1]; ++by)
            for (std::int64_t bx = 0; bx < size[0]; ++bx) {
                long double sum = 0;
                int count = 0;
                for (std::int64_t z = bz * reduction.by[2]; z < std::min((bz + 1) * reduction.by[2], stored[2]); ++z)
                    for (std::int64_t y = by * reduction.by[1]; y < std::min((by + 1) * reduction.by[1], stored[1]);
                         ++y)
                        for (std::int64_t x = bx * reduction.by[0]; x < std::min((bx + 1) * reduction.by[0], stored[0]);
                             ++x, ++count)
                            sum += values[static_cast<std::size_t>(x + stored[0] * (y + stored[1] * z))];
                reduced.push_back(static_cast<T>(std::floor(sum / count + 0.5L)));
            }
    return reduced;
}

template <typename T>
class BlockMeanOf : public testing::Test {};
using Types = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t,
                             std::int64_t, std::uint64_t, float, double>;
TYPED_TEST_SUITE(BlockMeanOf, Types);

TYPED_TEST(BlockMeanOf, AConstantStaysConstantAlsoWhereItIsTheLargestValue) {
    for (const TypeParam value :
         {TypeParam{7}, std::numeric_limits<TypeParam>::max(), std::numeric_limits<TypeParam>::lowest()}) {
        const Reduction reduction{{3, 2, 4}, {8, 5, 9}};
        const auto means = meansOf(std::vector<TypeParam>(countOf(reduction.storedSize), value), reduction);
        if (std::is_integral_v<TypeParam> && sizeof(TypeParam) == 8 && value != TypeParam{7}) {
            // Their sums are rounded to the 53 bits of a double or more, and kept voxels have 24.
            for (const TypeParam mean : means)
                EXPECT_NEAR(static_cast<double>(mean) / static_cast<double>(value == 0 ? 1 : value), value == 0 ? 0 : 1,
                            1e-15);
            continue;
        }
        EXPECT_EQ(means, std::vector<TypeParam>(countOf(reducedSize(reduction)), value));
    }
}

TYPED_TEST(BlockMeanOf, ALinearRampIsTheRampAtTheCentresOfBlocks) {
    const Reduction reduction{{3, 3, 3}, {9, 6, 6}};
    std::vector<TypeParam> ramp;
    for (int z = 0; z < 6; ++z)
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 9; ++x) ramp.push_back(static_cast<TypeParam>(2 * x + 3 * y + 5 * z));
    const auto means = meansOf(ramp, reduction);
    std::size_t index = 0;
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 3; ++x)
                EXPECT_EQ(means[index++], static_cast<TypeParam>(2 * (3 * x + 1) + 3 * (3 * y + 1) + 5 * (3 * z + 1)));
}

TYPED_TEST(BlockMeanOf, RandomVolumesAgreeWithTheDefinitionAtTheEdgesToo) {
    std::mt19937 random(3);
    for (const Reduction& reduction :
         {Reduction{{2, 2, 2}, {7, 5, 3}}, Reduction{{2, 1, 3}, {64, 4, 4}}, Reduction{{5, 5, 1}, {10, 11, 2}}}) {
        std::vector<TypeParam> values(countOf(reduction.storedSize));
        for (TypeParam& value : values)
            value = static_cast<TypeParam>(static_cast<int>(random() % 120) - (std::is_signed_v<TypeParam> ? 60 : 0));
        auto means = meansOf(values, reduction);
        if (std::is_floating_point_v<TypeParam>)
            for (TypeParam& mean : means) mean = static_cast<TypeParam>(std::floor(mean + TypeParam(0.5)));
        EXPECT_EQ(means, plainMeansOf(values, reduction));
    }
}

TYPED_TEST(BlockMeanOf, BlocksCountedFromTheOtherEndAreThoseOfTheTurnedVolume) {
    std::mt19937 random(5);
    for (const Reduction& reduction : {Reduction{{2, 2, 2}, {7, 5, 3}}, Reduction{{3, 4, 5}, {8, 9, 11}}}) {
        std::vector<TypeParam> values(countOf(reduction.storedSize));
        for (TypeParam& value : values) value = static_cast<TypeParam>(random() % 120);
        // Turned round along all axes at once, the values stand in the reverse order.
        Reduction fromTheOtherEnd = reduction;
        fromTheOtherEnd.smallerFirst = {true, true, true};
        auto means = meansOf(values, fromTheOtherEnd);
        std::ranges::reverse(means);
        std::ranges::reverse(values);
        EXPECT_EQ(means, meansOf(values, reduction));
        EXPECT_EQ(lackingInFirst(reduction), (Size{0, 0, 0}));
    }
    EXPECT_EQ(lackingInFirst(Reduction{{3, 4, 5}, {8, 9, 10}, {true, true, true}}), (Size{1, 3, 0}));
}

TEST(BlockMean, HalvesOfWholeNumbersGoUp) {
    const Reduction reduction{{2, 1, 1}, {4, 1, 1}};
    EXPECT_EQ(meansOf(std::vector<std::uint8_t>{0, 1, 2, 3}, reduction), (std::vector<std::uint8_t>{1, 3}));
    EXPECT_EQ(meansOf(std::vector<std::int16_t>{-1, 0, -3, -2}, reduction), (std::vector<std::int16_t>{0, -2}));
}

TEST(BlockMean, ValuesThatAreNotFiniteDoNotCount) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    const auto means =
        meansOf(std::vector<float>{1, nan, nan, infinite, -infinite, 4}, Reduction{{2, 1, 1}, {6, 1, 1}});
    EXPECT_EQ(means[0], 1.0F);
    EXPECT_TRUE(std::isnan(means[1]));
    EXPECT_EQ(means[2], 4.0F);
}

TEST(BlockMean, SlicesThatNobodyCouldReadDoNotCount) {
    const Reduction reduction{{1, 1, 2}, {1, 1, 5}};
    std::vector<std::uint8_t> reduced(3, 99);
    BlockMean<std::uint8_t> mean(reduction, reduced);
    const std::vector<std::uint8_t> slice{8};
    mean.skip();
    mean.add(slice);
    mean.skip();
    mean.skip();
    mean.add(slice);
    EXPECT_EQ(reduced, (std::vector<std::uint8_t>{8, 0, 8}));
    EXPECT_THROW(mean.skip(), std::invalid_argument);
    EXPECT_THROW(mean.add(slice), std::invalid_argument);
}

TEST(BlockMean, SizesThatDisagreeBreakTheContract) {
    std::vector<std::uint8_t> reduced(2);
    EXPECT_THROW(BlockMean<std::uint8_t>(Reduction{{2, 1, 1}, {5, 1, 1}}, reduced), std::invalid_argument);
    BlockMean<std::uint8_t> mean({{2, 1, 1}, {4, 1, 1}}, reduced);
    EXPECT_THROW(mean.add(reduced), std::invalid_argument);
}

TEST(ReducedGeometry, WholeBlocksStandWhereTheirVoxelsStood) {
    VolumeGeometry stored;
    stored.size = {7, 9, 4};
    stored.spacing = {0.3, 0.4, 0.5};
    stored.origin = {10, -20, 30};
    stored.direction = rotationZ(30) * rotationX(-70);
    stored.probe = StatedProbe{{0, 0, 1}, {0, 1, 0}, Vec3(1, 2, -15)};
    const Reduction reduction{{2, 3, 1}, stored.size};
    const VolumeGeometry reduced = reducedGeometry(stored, reduction);
    EXPECT_EQ(reduced.size, (Size{4, 3, 4}));
    EXPECT_EQ(reduced.reduction, reduction);
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 3; ++x) {
                const Vec3 centre(2 * x + 0.5, 3 * y + 1, z);
                EXPECT_LT(length(reduced.patientFromVoxel(Vec3(x, y, z)) - stored.patientFromVoxel(centre)), 1e-12);
            }
    const auto apexInPatient = [](const VolumeGeometry& geometry) {
        return geometry.origin + geometry.direction * *geometry.probe->apexMm;
    };
    EXPECT_LT(length(apexInPatient(reduced) - apexInPatient(stored)), 1e-12);
    // The first block along x lacks a voxel: its centre lies where that of a whole block would.
    const VolumeGeometry smallerFirst = reducedGeometry(stored, {reduction.by, stored.size, {true, false, false}});
    EXPECT_LT(length(smallerFirst.origin - stored.patientFromVoxel({-0.5, 1, 0})), 1e-12);
}

TEST(Reduction, TheSmallestFactorIsChosenThatKeepsNoMoreThanAsked) {
    const auto factorsFor = [](const Size& size, std::int64_t most) { return reductionTo(size, most)->by; };
    const std::int64_t mebi = std::int64_t{1} << 20;
    EXPECT_EQ(factorsFor({1024, 1024, 1024}, 512 * mebi), (Size{2, 2, 2}));
    EXPECT_EQ(factorsFor({1024, 1024, 1024}, 128 * mebi), (Size{2, 2, 2}));
    EXPECT_EQ(factorsFor({1024, 1024, 1024}, 128 * mebi - 1), (Size{3, 3, 3}));
    for (const Size& size : {Size{100, 80, 60}, Size{1000, 3, 50}, Size{129, 127, 65}}) {
        for (const std::int64_t most : {100'000, 20'000, 3'000}) {
            const auto reduction = reductionTo(size, most);
            ASSERT_TRUE(reduction);
            EXPECT_LE(countOf(reducedSize(*reduction)), static_cast<std::size_t>(most));
            EXPECT_TRUE(canHaveMade(*reduction, reducedSize(*reduction)));
        }
    }
}

TEST(Reduction, AShortAxisIsKept) {
    EXPECT_EQ(reductionTo({1000, 1000, 3}, 1'000'000)->by, (Size{2, 2, 1}));
    EXPECT_EQ(reductionTo({1000, 1000, 4}, 1'000'000)->by, (Size{2, 2, 2}));
    EXPECT_EQ(factorsText(*reductionTo({1000, 1000, 3}, 1'000'000)), "2 x 2 x 1");
}

TEST(Reduction, WhatNoFactorBringsBelowIsNotReduced) {
    EXPECT_FALSE(reductionTo({1, 1, 1}, 0));
    EXPECT_FALSE(reductionTo({100, 100, 100}, 7));
    constexpr std::int64_t huge = std::int64_t{1} << 62;
    EXPECT_FALSE(reductionTo({huge, 1, 1}, std::int64_t{1} << 55));
    EXPECT_FALSE(reductionTo({huge, huge, huge}, huge));
}

TEST(Reduction, FactorsAndSizesThatDisagreeAreToldApart) {
    const Size size{50, 50, 50};
    EXPECT_TRUE(canHaveMade({{2, 2, 2}, {99, 100, 100}}, size));
    EXPECT_FALSE(canHaveMade({{2, 2, 2}, {98, 100, 100}}, size));
    EXPECT_FALSE(canHaveMade({{1, 1, 1}, size}, size));
    EXPECT_FALSE(canHaveMade({{0, 2, 2}, {0, 100, 100}}, size));
    EXPECT_FALSE(canHaveMade({{-2, 2, 2}, {-100, 100, 100}}, size));
    EXPECT_FALSE(canHaveMade({{65, 2, 2}, {3250, 100, 100}}, size));
}

}  // namespace
}  // namespace echolucent
