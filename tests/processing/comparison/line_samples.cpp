#include "processing/comparison/line_samples.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace echolucent {
namespace {

TEST(LineSamples, AreTrilinearBetweenVoxelsWithData) {
    VolumeGeometry geometry;
    geometry.size = {2, 1, 1};
    const Volume volume(geometry, std::vector<float>{0.25f, 0.75f}, 1.0);
    std::array<double, 6> samples{};
    sampleLine(volume, {-0.75, 0, 0}, {0.5, 0, 0}, samples);
    EXPECT_TRUE(std::isnan(samples[0]));  // -0.75: outside
    EXPECT_DOUBLE_EQ(samples[1], 0.25);   // -0.25: clamped
    EXPECT_DOUBLE_EQ(samples[2], 0.375);
    EXPECT_DOUBLE_EQ(samples[3], 0.625);
    EXPECT_DOUBLE_EQ(samples[4], 0.75);
    EXPECT_TRUE(std::isnan(samples[5]));
    const Volume half(geometry, std::vector<float>{NAN, 0.75f}, 1.0);
    std::array<double, 2> near{};
    sampleLine(half, {0.4, 0, 0}, {0.2, 0, 0}, near);
    EXPECT_TRUE(std::isnan(near[0]));
    EXPECT_DOUBLE_EQ(near[1], 0.75);
}

TEST(OpacityTable, IsTheCurveAtItsSamplesAndTheTableBetweenItsNodes) {
    const OpacityTable curve{Classification(PowerCurve{2, 1.0})};
    EXPECT_FALSE(curve.isTwoDimensional());
    for (const int i : {0, 1, 100, 255}) EXPECT_DOUBLE_EQ(curve.at(i / 255.0, 7.0), (i / 255.0) * (i / 255.0));
    const OpacityTable table{Classification(TwoDimensionalOtf{2, 2, 0.5, {0.0f, 1.0f, 0.5f, 0.5f}})};
    EXPECT_TRUE(table.isTwoDimensional());
    EXPECT_DOUBLE_EQ(table.at(0.25, 0.0), 0.25);
    EXPECT_DOUBLE_EQ(table.at(0.25, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(table.at(0.25, 0.25), 0.375);
    EXPECT_DOUBLE_EQ(table.at(0.25, 9.0), 0.5) << "larger gradients count as the largest";
}

TEST(CompositeAlong, GivesWhatComesThroughAndSkipsWhatHasNoData) {
    const OpacityTable half{Classification(ManualCurve{{{0.0, 0.5}}})};
    const RaySamples ray{{0.4, NAN, 0.8, 1.0}, {}};
    std::vector<std::size_t> places;
    std::vector<double> lights;
    const auto note = [&](std::size_t i, double light) {
        places.push_back(i);
        lights.push_back(light);
    };
    EXPECT_DOUBLE_EQ(compositeAlong(ray, half, 0.0, note), 0.125);
    EXPECT_EQ(places, (std::vector<std::size_t>{0, 2, 3}));
    EXPECT_DOUBLE_EQ(lights[0], 0.2);
    EXPECT_DOUBLE_EQ(lights[1], 0.2);
    EXPECT_DOUBLE_EQ(lights[2], 0.125);
    EXPECT_DOUBLE_EQ(compositeAlong(ray, half, 0.3, [](auto, auto) {}), 0.25) << "the rest is not looked at";
}

TEST(RaySampler, TakesGradientsOnlyWhereTheyAreAskedFor) {
    VolumeGeometry geometry;
    geometry.size = {4, 1, 1};
    const Volume volume(geometry, std::vector<float>{0.0f, 0.25f, 0.5f, 0.75f}, 1.0);
    EXPECT_TRUE(RaySampler(volume, false).along({0, 0, 0}, {1, 0, 0}, 4).gradients.empty());
    const RaySamples ray = RaySampler(volume, true).along({0, 0, 0}, {1, 0, 0}, 5);
    ASSERT_EQ(ray.gradients.size(), 5u);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(ray.gradients[static_cast<std::size_t>(i)], 0.25, 1e-7);
    EXPECT_TRUE(std::isnan(ray.intensities[4]));
    EXPECT_EQ(ray.gradients[4], 0.0);
}

}  // namespace
}  // namespace echolucent
