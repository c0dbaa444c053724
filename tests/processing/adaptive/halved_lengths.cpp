// In a coarse volume, cavities are shorter than the default lengths: half of them find the walls behind.
#include "processing/adaptive/halved_lengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "tests/processing/grids.h"

namespace echolucent {
namespace {

constexpr int gapBegins = 24, gapEnds = 29;

/// Tissue with speckle, `depth` voxels deep along z, with a gap of fluid that has a bright wall behind it, or without.
Volume tissue(int depth, bool gap) {
    std::mt19937 random(3);
    std::normal_distribution<double> speckle(1.0, 0.15);
    std::vector<std::uint8_t> voxels;
    for (int z = 0; z < depth; ++z)
        for (int i = 0; i < 56 * 56; ++i) {
            const double level = !gap || z < gapBegins ? 80.0 : z < gapEnds ? 4.0 : 160.0;
            voxels.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(level * speckle(random), 0.0, 255.0))));
        }
    return Volume(gridOf({56, 56, depth}, {3, 3, 3}), std::move(voxels), 255.0);
}

TEST(HalvedLengths, FindTheWallBehindAShortGapOfACoarseVolume) {
    const auto otf = adaptOpacity(tissue(56, true), {}, {});
    ASSERT_TRUE(otf->lengthsHalved);
    EXPECT_EQ(otf->config, AdaptiveOtfConfig{}) << "as asked for";
    EXPECT_EQ(otf->message, "");
    EXPECT_GE(otf->tubesWithWeight, otf->tubesMeetingVolume - 1) << "the last in rank has no weight";
    for (const TubeCore& tube : otf->tubes) {
        if (tube.surfaceVoxel) {
            EXPECT_NEAR((*tube.surfaceVoxel)[2], gapEnds - 0.5, 1.0);
        }
    }
    EXPECT_EQ(otf->curve.opacities[60], 0.0) << "clear up to 0.4 of the way from fluid to wall";
    EXPECT_GT(otf->curve.opacities[160], 0.4);
}

TEST(HalvedLengths, AreLeftAloneInALongVolumeAndWhereALengthWasChosen) {
    EXPECT_FALSE(adaptOpacity(tissue(100, true), {}, {})->lengthsHalved);
    AdaptiveOtfConfig chosen;
    chosen.detection = RatioRule{.leastFluid = 9};
    EXPECT_FALSE(adaptOpacity(tissue(56, true), {}, chosen)->lengthsHalved);
    chosen = {};
    chosen.detection = VarianceRule{};
    EXPECT_FALSE(halvedLengths(chosen, gridOf({56, 56, 56})));
    EXPECT_TRUE(halvedLengths({}, gridOf({99, 99, 99}))) << "also if a view runs along a diagonal of 171 units";
    EXPECT_FALSE(halvedLengths({}, gridOf({99, 101, 99})));
}

TEST(HalvedLengths, FindNothingInSpeckleAlone) {
    const auto otf = adaptOpacity(tissue(56, false), {}, {});
    EXPECT_FALSE(otf->lengthsHalved);
    EXPECT_EQ(otf->tubesWithWeight, 0);
    EXPECT_EQ(otf->message, "No surface found: the initial function is used.");
}

}  // namespace
}  // namespace echolucent
