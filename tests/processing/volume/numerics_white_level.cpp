#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "processing/volume/white_level.h"

namespace echolucent {
namespace {

WhiteLevel of(std::vector<Voxels> phases) { return whiteLevelOf(phases); }

/// The values are 1 to 100, each ten times.
std::vector<float> ordinary() {
    std::vector<float> voxels;
    for (int i = 0; i < 1000; ++i) voxels.push_back(static_cast<float>(1 + i % 100));
    return voxels;
}

TEST(WhiteLevel, IsTheLargestFiniteValueOfAllPhases) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(of({std::vector<float>{0.5f, infinity, std::nanf(""), -7.0f}}).level, 0.5);
    EXPECT_EQ(of({ordinary(), std::vector<float>{3000.0f}}).level, 3000.0);
    EXPECT_EQ(of({std::vector<std::uint16_t>{3, 65535}, std::vector<std::uint16_t>{9}}).level, 65535.0);
    EXPECT_EQ(of({std::vector<float>{0.0f, -3.0f}}).level, 0.0);
    EXPECT_EQ(of({std::vector<float>{}}).level, 0.0);
    EXPECT_EQ(of({std::vector<float>{3e38f}}).level, static_cast<double>(3e38f));
    EXPECT_EQ(of({std::vector<float>(1000, 1e-42f)}).level, static_cast<double>(1e-42f));
}

TEST(WhiteLevel, LeavesOutWhatNoEchoHas) {
    std::vector<float> voxels = ordinary();
    voxels[17] = 3.2e38f;
    voxels[501] = 5e8f;
    voxels[733] = 900.0f;
    const WhiteLevel white = of({voxels});
    EXPECT_EQ(white.level, 100.0);
    EXPECT_EQ(white.largest, static_cast<double>(3.2e38f));
    EXPECT_EQ(white.above, 3);
}

TEST(WhiteLevel, KeepsAWideRangeAndLonelyBrightVoxels) {
    std::vector<float> voxels = ordinary();
    voxels[17] = 1e7f;  // 100 dB above the others: a raw echo may be
    EXPECT_EQ(of({voxels}).level, 1e7);
    EXPECT_EQ(of({voxels}).above, 0);
    std::vector<float> lonely(100000, 0.0f);
    lonely[5] = 1e30f;
    EXPECT_EQ(of({lonely}).level, static_cast<double>(1e30f)) << "voxels of 0 say nothing about the others";
}

}  // namespace
}  // namespace echolucent
