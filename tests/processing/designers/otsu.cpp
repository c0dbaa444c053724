#include "processing/designers/otsu.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "designer_volumes.h"
#include "processing/intensity/intensity_counts.h"

namespace echolucent {
namespace {

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
double spreadOf(const std::vector<double>& values) {
    double squares = 0.0;
    for (const double value : values) squares += std::pow(value - meanOf(values), 2);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

/// The two classes of a threshold, voxel by voxel.
struct Split {
    std::vector<double> dark, bright;
    Split(const std::vector<double>& data, double threshold) {
        for (const double value : data) (value <= threshold ? dark : bright).push_back(value);
    }
    [[nodiscard]] double betweenVariance() const {
        const auto n = static_cast<double>(dark.size() + bright.size());
        return static_cast<double>(dark.size()) / n * static_cast<double>(bright.size()) / n *
               std::pow(meanOf(bright) - meanOf(dark), 2);
    }
};

TEST(Otsu, IsTheBestOfAllThresholdsVoxelByVoxel) {
    for (const std::uint32_t seed : {1U, 2U, 3U})
        for (const Volume& volume : twoClassVolumes(seed)) {
            const std::vector<double> data = dataOf(volume);
            const auto classes = otsuClasses(intensityCounts(volume));
            ASSERT_TRUE(classes);
            std::vector<double> thresholds = data;
            std::ranges::sort(thresholds);
            const auto end = std::unique(thresholds.begin(), thresholds.end());
            double best = 0.0, threshold = 0.0;
            for (auto at = thresholds.begin(); at + 1 != end; ++at) {
                const double variance = Split(data, *at).betweenVariance();
                if (variance > best * (1 + 1e-12)) {
                    best = variance;
                    threshold = 0.5 * (*at + *(at + 1));
                }
            }
            EXPECT_NEAR(classes->threshold, threshold, 1e-9) << volume.typeName();
            EXPECT_NEAR(classes->betweenVariance, best, 1e-9);
            const Split split(data, threshold);
            EXPECT_NEAR(classes->dark.mean, meanOf(split.dark), 1e-9);
            EXPECT_NEAR(classes->bright.mean, meanOf(split.bright), 1e-9);
            EXPECT_NEAR(classes->dark.spread, spreadOf(split.dark), 1e-9);
            EXPECT_NEAR(classes->bright.spread, spreadOf(split.bright), 1e-9);
            EXPECT_NEAR(classes->dark.share, static_cast<double>(split.dark.size()) / static_cast<double>(data.size()),
                        1e-12);
            EXPECT_NEAR(classes->dark.share + classes->bright.share, 1.0, 1e-12);
        }
}

TEST(Otsu, SplitsBytesAsOpenCvDoes) {
    for (const std::uint32_t seed : {4U, 5U, 6U, 7U}) {
        const Volume volume = twoClassVolumes(seed).front();
        const auto& bytes = std::get<VoxelArray<std::uint8_t>>(volume.voxels());
        const cv::Mat row(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<std::uint8_t*>(bytes.data()));
        cv::Mat binary;
        const double level = cv::threshold(row, binary, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
        const auto classes = otsuClasses(intensityCounts(volume));
        ASSERT_TRUE(classes);
        for (const std::uint8_t byte : bytes) EXPECT_EQ(byte > level, byte / 255.0 > classes->threshold);
    }
}

TEST(Otsu, TheRampReachesEachClassSpreadAndIsClearBelow) {
    const Volume volume = twoClassVolumes(8).front();
    const auto classes = otsuClasses(intensityCounts(volume)).value();
    for (const double spreads : {0.5, 1.0, 1.5}) {
        const Design design = designed(OtsuConfig{.spreads = spreads, .opacity = 0.8}, volume);
        const double begin = classes.threshold - spreads * classes.dark.spread;
        const double end = classes.threshold + spreads * classes.bright.spread;
        ASSERT_TRUE(begin > 0.0 && end < 1.0);
        EXPECT_EQ(opacityAt(design.classification, begin, 0), 0.0);
        EXPECT_EQ(opacityAt(design.classification, 0.0, 0), 0.0);
        EXPECT_NEAR(opacityAt(design.classification, 0.5 * (begin + end), 0), 0.4, 1e-12);
        EXPECT_NEAR(opacityAt(design.classification, end, 0), 0.8, 1e-12);
        EXPECT_NEAR(opacityAt(design.classification, 1.0, 0), 0.8, 1e-12);
        EXPECT_EQ(factOf(design, "ramp_begin"), begin);
        EXPECT_EQ(factOf(design, "ramp_end"), end);
        EXPECT_TRUE(design.message.empty());
    }
    // Wider than the intensities there are: the ramp is cut off at both ends.
    const Design wide = designed(OtsuConfig{.spreads = 4.0}, volume);
    EXPECT_EQ(factOf(wide, "ramp_begin"), std::max(0.0, classes.threshold - 4 * classes.dark.spread));
    EXPECT_LE(factOf(wide, "ramp_end"), 1.0);
}

TEST(Otsu, TwoIntensitiesAreSplitHalfWayByAStep) {
    const Volume volume = bytesOf({20, 20, 20, 20, 200});
    const Design design = designed(OtsuConfig{}, volume);
    EXPECT_NEAR(factOf(design, "threshold"), 110 / 255.0, 1e-12);
    EXPECT_EQ(factOf(design, "dark_spread"), 0.0);
    EXPECT_NEAR(factOf(design, "dark_share"), 0.8, 1e-12);
    EXPECT_EQ(opacityAt(design.classification, 109.9 / 255, 0), 0.0);
    EXPECT_EQ(opacityAt(design.classification, 110.1 / 255, 0), 1.0);
}

TEST(Otsu, OfThresholdsThatAreEquallyGoodTheLowestCounts) {
    const auto classes = otsuClasses(intensityCounts(lineOf(std::vector<std::uint8_t>{0, 1, 2}, 2.0)));
    ASSERT_TRUE(classes);
    EXPECT_EQ(classes->threshold, 0.25);
    EXPECT_EQ(classes->bright.mean, 0.75);
}

/// The plot is the variance of every threshold, its largest value the one that was found.
TEST(Otsu, PlotsTheVarianceBetweenTheClassesOverTheThreshold) {
    const Volume volume = twoClassVolumes(9).front();
    const Design design = designed(OtsuConfig{}, volume);
    const std::vector<double> data = dataOf(volume);
    ASSERT_EQ(design.plots.size(), 1u);
    double largest = 0.0;
    for (std::size_t i = 0; i < design.plots[0].values.size(); ++i) {
        const Split split(data, design.plots[0].intensities[i]);
        if (split.dark.empty() || split.bright.empty()) {
            EXPECT_TRUE(std::isnan(design.plots[0].values[i]));
            continue;
        }
        EXPECT_NEAR(design.plots[0].values[i], split.betweenVariance(), 1e-9);
        largest = std::max(largest, design.plots[0].values[i]);
    }
    EXPECT_NEAR(largest, otsuClasses(intensityCounts(volume))->betweenVariance, 1e-12);
}

TEST(Otsu, WithoutTwoIntensitiesItSaysSoAndShowsTheSquare) {
    for (const Volume& volume : volumesWithoutContrast()) {
        const Design design = designed(OtsuConfig{}, volume);
        EXPECT_EQ(design.classification.curve(), OpacityCurve(PowerCurve{2, 1.0}));
        EXPECT_NE(design.message.find("x^2"), std::string::npos);
        expectSound(design.classification);
    }
    EXPECT_NE(designed(OtsuConfig{}, masked(bytesOf({77}), {0})).message.find("No voxel"), std::string::npos);
}

TEST(Otsu, VoxelsWithoutDataMoveNothing) {
    const Volume data = bytesOf({10, 12, 14, 100, 110, 120});
    const Volume hidden = masked(bytesOf({10, 12, 255, 14, 100, 0, 0, 110, 120, 60}), {1, 1, 0, 1, 1, 0, 0, 1, 1, 0});
    EXPECT_EQ(designed(OtsuConfig{}, hidden).facts, designed(OtsuConfig{}, data).facts);
    EXPECT_EQ(designed(OtsuConfig{}, hidden).classification, designed(OtsuConfig{}, data).classification);
}

TEST(Otsu, HasTheSameBitsOnAnyNumberOfThreadsAndKeepsTheContract) {
    const Volume volume = twoClassVolumes(10).back();
    const Design design = designed(OtsuConfig{}, volume);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(designed(OtsuConfig{}, volume).facts, design.facts);
    expectContract(OtsuConfig{});
}

}  // namespace
}  // namespace echolucent
