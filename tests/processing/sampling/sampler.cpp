// The one plain sampler against values by hand.
#include "processing/sampling/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace echolucent {
namespace {

Volume line() {
    VolumeGeometry geometry;
    geometry.size = {3, 1, 1};
    return Volume(geometry, std::vector<std::uint8_t>{51, 102, 255});
}

TEST(VolumeSampler, TrilinearMeansAreClampedToTheOutermostCentres) {
    const Volume volume = line();
    const VolumeSampler sampler(volume);
    EXPECT_NEAR(*sampler.intensityAt({0.25, 0, 0}), 0.2 + 0.25 * 0.2, 1e-12);
    EXPECT_NEAR(*sampler.intensityAt({1.75, 0, 0}), 0.4 + 0.75 * 0.6, 1e-12);
    EXPECT_NEAR(*sampler.intensityAt({-0.5, 0.5, -0.5}), 0.2, 1e-12);
    EXPECT_NEAR(*sampler.intensityAt({2.4, 0, 0}), 1.0, 1e-12);
}

TEST(VolumeSampler, VoxelsWithoutDataAreLeftOutOfTheMean) {
    const Volume masked = line().withDataMask({1, 1, 0});
    const VolumeSampler sampler(masked), nearest(masked, Interpolation::nearest);
    EXPECT_NEAR(*sampler.intensityAt({1.25, 0, 0}), 0.4, 1e-12);
    EXPECT_NEAR(*sampler.intensityAt({1.5, 0, 0}), 0.4, 1e-12) << "half the weight is enough";
    EXPECT_FALSE(sampler.intensityAt({1.51, 0, 0}));
    EXPECT_NEAR(*nearest.intensityAt({1.49, 0, 0}), 0.4, 1e-12);
    EXPECT_FALSE(nearest.intensityAt({1.5, 0, 0})) << "half way it is the next voxel";
    EXPECT_EQ(sampler.gradientAt({1, 0, 0}, 1.0), Vec3(0, 0, 0)) << "a difference that lacks data is none";
    const Volume whole = line();
    EXPECT_NEAR(VolumeSampler(whole).gradientAt({1, 0, 0}, 1.0)[0], 0.4, 1e-12);
}

TEST(VolumeSampler, VoxelsThatAreNotFiniteCarryNoData) {
    VolumeGeometry geometry;
    geometry.size = {3, 1, 1};
    const Volume volume(geometry, std::vector<float>{0.25f, std::nanf(""), std::numeric_limits<float>::infinity()},
                        1.0);
    const VolumeSampler sampler(volume);
    EXPECT_EQ(sampler.intensityAt({0.4, 0, 0}), 0.25);
    EXPECT_FALSE(sampler.intensityAt({0.6, 0, 0}));
    EXPECT_FALSE(sampler.intensityAt({2, 0, 0}));
}

TEST(VolumeSampler, TheBoxReachesHalfAVoxelOut) {
    const VolumeGeometry geometry = line().geometry();
    EXPECT_TRUE(inBox(geometry, {-0.5, 0.5, 0}));
    EXPECT_TRUE(inBox(geometry, {2.5, 0, 0}));
    EXPECT_FALSE(inBox(geometry, {2.51, 0, 0}));
    EXPECT_FALSE(inBox(geometry, {0, -0.51, 0}));
    EXPECT_FALSE(inBox(geometry, {std::nan(""), 0, 0}));
}

}  // namespace
}  // namespace echolucent
