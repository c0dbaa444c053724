#include <gtest/gtest.h>

#include <algorithm>
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
    EXPECT_EQ(of({ordinary(), std::vector<float>(11, 108.0f)}).level, 108.0);
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

TEST(WhiteLevel, HotVoxelsMoveNothing) {
    std::vector<float> voxels = ordinary();
    for (const float hot : {130.0f, 1e7f, 3e38f}) {
        voxels[17] = hot;
        EXPECT_EQ(of({voxels}).level, 100.0) << hot;
        EXPECT_EQ(of({voxels}).above, 1) << hot;
        EXPECT_EQ(of({voxels}).largest, static_cast<double>(hot));
    }
    // Whole numbers of a small part of their range: 158 is held by one voxel of a hundred thousand.
    std::vector<std::uint16_t> words;
    for (int i = 0; i < 100000; ++i) words.push_back(static_cast<std::uint16_t>(i % 140));
    for (int value = 140; value <= 158; ++value) words.push_back(static_cast<std::uint16_t>(value));
    EXPECT_EQ(of({words}).level, 158.0);
    words[5] = 65535;
    EXPECT_EQ(of({words}).level, 158.0);
    EXPECT_EQ(of({std::vector<std::uint16_t>{1, 2, 3}, words}).level, 158.0) << "in whichever phase";
}

TEST(WhiteLevel, StepsOfOneAreNoGap) {
    std::vector<std::uint16_t> words(100000, 1);
    words[7] = 2;
    words[8] = 3;
    EXPECT_EQ(of({words}).level, 3.0);
    words[9] = 5;
    EXPECT_EQ(of({words}).level, 3.0);
}

TEST(WhiteLevel, ManyBrightVoxelsAreNotHot) {
    std::vector<float> voxels(100000, 1.0f);
    std::fill_n(voxels.begin(), 100, 1000.0f);  // one of a thousand: wires 60 dB above the water
    EXPECT_EQ(of({voxels}).level, 1000.0);
    std::fill_n(voxels.begin(), 100, 1e7f);  // 140 dB: no echo
    EXPECT_EQ(of({voxels}).level, 1.0);
    EXPECT_EQ(of({voxels}).above, 100);
}

TEST(WhiteLevel, SaysWhereHalfOfTheVoxelsLie) {
    EXPECT_NEAR(of({ordinary()}).middle, 51.0, 0.51);
    EXPECT_EQ(of({std::vector<float>{0.0f, -1.0f}}).middle, 0.0);
}

TEST(DeclaredWhiteLevel, IsJudgedBesideTheVoxels) {
    const WhiteLevel measured = of({ordinary()});
    for (const double nonsense : {0.0, -5.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(judgeDeclaredWhite(nonsense, measured), DeclaredWhite::notAboveZero) << nonsense;
    for (const double suits : {60.0, 100.0, 800.0})
        EXPECT_EQ(judgeDeclaredWhite(suits, measured), DeclaredWhite::suits) << suits;
    EXPECT_EQ(judgeDeclaredWhite(801.0, measured), DeclaredWhite::tooHigh);
    EXPECT_EQ(judgeDeclaredWhite(40.0, measured), DeclaredWhite::tooLow);
    EXPECT_EQ(judgeDeclaredWhite(7.0, WhiteLevel{}), DeclaredWhite::suits) << "voxels of 0 say nothing";
}

TEST(WhiteLevel, VoxelsOfZeroSayNothing) {
    std::vector<float> lonely(100000, 0.0f);
    lonely[5] = 1e30f;
    EXPECT_EQ(of({lonely}).level, static_cast<double>(1e30f)) << "voxels of 0 say nothing about the others";
}

}  // namespace
}  // namespace echolucent
