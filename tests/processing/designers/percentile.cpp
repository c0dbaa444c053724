#include "processing/designers/percentile.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <numeric>

#include "designer_volumes.h"
#include "processing/intensity/intensity_counts.h"

namespace echolucent {
namespace {

/// Where the ramp begins and ends.
std::array<double, 2> rampOf(const Design& design) { return {design.facts.at(0).value, design.facts.at(1).value}; }

TEST(Percentile, OfAHundredLevelsItIsTheLevelOfThatNumber) {
    std::vector<std::uint8_t> levels(100);
    std::iota(levels.begin(), levels.end(), std::uint8_t{1});
    const Design design = designed(PercentileConfig{}, bytesOf(levels));
    EXPECT_NEAR(rampOf(design)[0], 60 / 255.0, 1e-12);
    EXPECT_NEAR(rampOf(design)[1], 95 / 255.0, 1e-12);
    EXPECT_EQ(opacityAt(design.classification, 60 / 255.0, 0), 0.0);
    EXPECT_GT(opacityAt(design.classification, 61 / 255.0, 0), 0.0);
    EXPECT_NEAR(opacityAt(design.classification, 77.5 / 255.0, 0), 0.5, 1e-12);
    EXPECT_LT(opacityAt(design.classification, 94 / 255.0, 0), 1.0);
    EXPECT_EQ(opacityAt(design.classification, 95 / 255.0, 0), 1.0);
    EXPECT_TRUE(design.message.empty());
}

/// The definition, by sorting.
TEST(Percentile, IsTheNearestRankOfTheSortedVoxels) {
    for (const std::uint32_t seed : {1U, 2U})
        for (const Volume& volume : twoClassVolumes(seed)) {
            std::vector<double> data = dataOf(volume);
            std::ranges::sort(data);
            const auto rank = [&](double percent) {
                const auto count = static_cast<double>(data.size());
                return data[static_cast<std::size_t>(std::max(1.0, std::ceil(percent * count / 100 - 1e-9))) - 1];
            };
            const IntensityCounts counts = intensityCounts(volume);
            for (const double percent : {0.0, 0.3, 12.5, 50.0, 60.0, 95.0, 99.9, 100.0})
                EXPECT_NEAR(percentileOf(counts, percent), rank(percent), 1e-9) << volume.typeName() << " " << percent;
            const auto ramp = rampOf(designed(PercentileConfig{.clear = 40, .full = 80}, volume));
            EXPECT_NEAR(ramp[0], rank(40), 1e-9);
            EXPECT_NEAR(ramp[1], rank(80), 1e-9);
        }
}

TEST(Percentile, ThatSixtyOfAHundredVoxelsAreClearHoldsForAnyVolume) {
    for (const Volume& volume : twoClassVolumes(3)) {
        const Design design = designed(PercentileConfig{.opacity = 0.7}, volume);
        const std::vector<double> data = dataOf(volume);
        const auto clear = std::ranges::count_if(data, [&](double f) {
            // Floats are counted in steps of 1/65535.
            return opacityAt(design.classification, f - 1e-9, 0) == 0.0;
        });
        const auto full = std::ranges::count_if(
            data, [&](double f) { return opacityAt(design.classification, f + 1e-9, 0) >= 0.7 - 1e-12; });
        EXPECT_GE(static_cast<double>(clear), 0.6 * static_cast<double>(data.size()));
        EXPECT_GE(static_cast<double>(full), 0.05 * static_cast<double>(data.size()));
    }
}

TEST(Percentile, WhereManyVoxelsShareOneIntensityTheOthersGiveTheRamp) {
    // Of 100 voxels 97 are 0: above them lie 10, 20 and 30, of which 30 is the 95th percentile.
    std::vector<std::uint8_t> dark(97, 0);
    dark.insert(dark.end(), {10, 20, 30});
    const Design above = designed(PercentileConfig{}, bytesOf(dark));
    EXPECT_EQ(rampOf(above), (std::array{0.0, 30 / 255.0}));
    EXPECT_NE(above.message.find("above"), std::string::npos);
    // Of 100 voxels 90 are white: below them the 60th percentile of 10 to 100 is 60.
    std::vector<std::uint8_t> bright(90, 255);
    bright.insert(bright.end(), {10, 20, 30, 40, 50, 60, 70, 80, 90, 100});
    const Design below = designed(PercentileConfig{}, bytesOf(bright));
    EXPECT_EQ(rampOf(below), (std::array{60 / 255.0, 1.0}));
    EXPECT_NE(below.message.find("below"), std::string::npos);
    for (const Design& design : {above, below}) expectSound(design.classification);
}

TEST(Percentile, IsAStepWhereFullIsNotAboveClear) {
    for (const double full : {60.0, 20.0}) {
        const Design design =
            designed(PercentileConfig{.full = full}, bytesOf({10, 20, 30, 40, 50, 60, 70, 80, 90, 100}));
        EXPECT_EQ(opacityAt(design.classification, 59.9 / 255, 0), 0.0);
        EXPECT_EQ(opacityAt(design.classification, 60.1 / 255, 0), 1.0);
    }
}

TEST(Percentile, TheEndsOfTheRangeSpanAllIntensities) {
    const Design design = designed(PercentileConfig{.clear = 0, .full = 100}, bytesOf({30, 40, 50, 210}));
    EXPECT_EQ(rampOf(design), (std::array{30 / 255.0, 210 / 255.0}));
    // Clear up to the largest voxel, and full from there: the brightest voxel alone is seen.
    const Design last = designed(PercentileConfig{.clear = 100, .full = 100}, bytesOf({30, 40, 50, 210}));
    EXPECT_EQ(opacityAt(last.classification, 50 / 255.0, 0), 0.0);
    EXPECT_EQ(opacityAt(last.classification, 210 / 255.0, 0), 1.0);
}

TEST(Percentile, PlotsTheShareUpToEachIntensity) {
    const Volume volume = twoClassVolumes(4).front();
    const std::vector<double> data = dataOf(volume);
    const DesignPlot plot = designed(PercentileConfig{}, volume).plots.at(0);
    ASSERT_EQ(plot.values.size(), 256u);
    for (std::size_t i = 0; i < 256; ++i) {
        const auto upTo = std::ranges::count_if(data, [&](double f) { return f <= plot.intensities[i]; });
        EXPECT_NEAR(plot.values[i], static_cast<double>(upTo) / static_cast<double>(data.size()), 1e-12);
    }
    EXPECT_EQ(plot.values.back(), 1.0);
}

TEST(Percentile, WithoutTwoIntensitiesItSaysSoAndShowsTheSquare) {
    for (const Volume& volume : volumesWithoutContrast()) {
        const Design design = designed(PercentileConfig{}, volume);
        EXPECT_EQ(design.classification.curve(), OpacityCurve(PowerCurve{2, 1.0}));
        EXPECT_NE(design.message.find("x^2"), std::string::npos);
    }
    EXPECT_THROW((void)percentileOf(IntensityCounts{}, 50), std::invalid_argument);
    EXPECT_THROW((void)percentileOf(intensityCounts(bytesOf({1, 2})), 100.5), std::invalid_argument);
    EXPECT_THROW((void)percentileOf(intensityCounts(bytesOf({1, 2})), std::nan("")), std::invalid_argument);
}

TEST(Percentile, VoxelsWithoutDataMoveNothing) {
    const Volume data = bytesOf({10, 12, 14, 100, 110, 120});
    const Volume hidden = masked(bytesOf({10, 12, 255, 14, 100, 0, 0, 110, 120}), {1, 1, 0, 1, 1, 0, 0, 1, 1});
    EXPECT_EQ(designed(PercentileConfig{}, hidden).classification, designed(PercentileConfig{}, data).classification);
}

TEST(Percentile, HasTheSameBitsOnAnyNumberOfThreadsAndKeepsTheContract) {
    const Volume volume = twoClassVolumes(5).back();
    const Design design = designed(PercentileConfig{}, volume);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(designed(PercentileConfig{}, volume).facts, design.facts);
    expectContract(PercentileConfig{});
}

}  // namespace
}  // namespace echolucent
