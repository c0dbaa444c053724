#include "processing/tube_core/tube_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "processing/tube_core/cell_statistics.h"

namespace echolucent {
namespace {

Volume noise(std::array<std::int64_t, 3> size, Vec3 spacing = {1, 1, 1}) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    std::mt19937 random(11);
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (auto& voxel : voxels) voxel = static_cast<std::uint8_t>(random());
    return Volume(geometry, std::move(voxels));
}

std::vector<TubeSamples> samplesFor(const Volume& volume, const View& view, const AdaptiveOtfConfig& config) {
    std::vector<TubeSamples> samples;
    for (const TubeAxis& axis : tubeAxes(volume.geometry(), view, config))
        samples.push_back(
            samplesOf(axis, volume.geometry(), view, config.cellSize, tubesLieOnVoxels(volume.geometry(), view)));
    return samples;
}

TEST(TubeSamples, SumsOnVoxelsEqualThePointByPointSampling) {
    // All 6 beam axes with and without roll; some tubes hang over the border; even and odd cells.
    Volume volume = noise({31, 28, 36});
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(volume.geometry().voxelCount()), 1);
    for (std::size_t i = 0; i < mask.size(); i += 7) mask[i] = 0;
    const Volume masked = volume.withDataMask(mask);
    for (const Volume* tested : {static_cast<const Volume*>(&volume), &masked})
        for (int beam = 0; beam < 6; ++beam)
            for (const double roll : {0.0, 90.0})
                for (const int cellSize : {5, 4}) {
                    AdaptiveOtfConfig config;
                    config.cellSize = cellSize;
                    config.tubeColumns = config.tubeRows = 7;
                    const View view{.beamAxis = static_cast<BeamAxis>(beam), .rollDegrees = roll, .nearCutMm = 3.3};
                    const auto samples = samplesFor(*tested, view, config);
                    std::vector<std::vector<SlabSums>> sums(samples.size());
                    sumSlabs(*tested, 255, samples, sums);
                    std::vector<SlabMoments> moments;
                    std::vector<double> scratch;
                    for (std::size_t t = 0; t < samples.size(); ++t) {
                        sampleSlabs(*tested, samples[t], moments, scratch);
                        ASSERT_EQ(moments.size(), sums[t].size());
                        for (std::size_t k = 0; k < moments.size(); ++k) {
                            ASSERT_EQ(moments[k].count, sums[t][k].count);
                            if (moments[k].count == 0) continue;
                            EXPECT_NEAR(moments[k].mean * 255, static_cast<double>(sums[t][k].sum) / sums[t][k].count,
                                        1e-10);
                        }
                    }
                }
}

TEST(TubeSamples, BeginAtTheFirstVoxelCentreBehindTheNearCut) {
    const Volume volume = noise({40, 40, 40});
    AdaptiveOtfConfig config;
    for (const auto& [cut, first, count] :
         {std::tuple{0.0, 0.0, 40}, {0.4, 0.0, 40}, {0.6, 1.0, 39}, {7.5, 7.0, 33}, {39.8, 40.0, 0}}) {
        const View view{.nearCutMm = cut};
        const TubeSamples samples = samplesFor(volume, view, config)[112];
        EXPECT_EQ(samples.slabs, count) << cut;
        if (count > 0) {
            EXPECT_EQ(samples.first[2], first) << cut;
        }
        const View back{.beamAxis = BeamAxis::minusZ, .nearCutMm = cut};
        const TubeSamples backwards = samplesFor(volume, back, config)[112];
        EXPECT_EQ(backwards.slabs, count) << cut;
        if (count > 0) {
            EXPECT_EQ(backwards.first[2], 39.0 - first) << cut;
        }
    }
}

TEST(TubeSamples, ReproduceALinearFieldAtAnyAngleAndSpacing) {
    VolumeGeometry geometry;
    geometry.size = {40, 30, 25};
    geometry.spacing = {0.5, 0.7, 0.9};
    std::vector<float> voxels;
    const Vec3 gradient{0.011, -0.007, 0.013};  // per mm
    const auto field = [&](const Vec3& mm) { return 0.4 + gradient.dot(mm); };
    for (int z = 0; z < 25; ++z)
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x)
                voxels.push_back(static_cast<float>(field(geometry.gridMmFromVoxel(Vec3(x, y, z)))));
    const Volume volume(geometry, voxels, 1.0);
    const View view{.azimuthDegrees = 33, .elevationDegrees = -21, .rollDegrees = 12};
    AdaptiveOtfConfig config;
    config.tubeSpacing = 4;
    const TubeSamples centre = samplesFor(volume, view, config)[112];
    ASSERT_GT(centre.slabs, 30);
    std::vector<SlabMoments> slabs;
    std::vector<double> scratch;
    sampleSlabs(volume, centre, slabs, scratch);
    const ViewFrame frame = frameOf(view);
    for (int k = 8; k < centre.slabs - 8; ++k) {
        const SlabMoments& slab = slabs[static_cast<std::size_t>(k)];
        const Vec3 axisMm = geometry.gridMmFromVoxel(centre.onAxis(k));
        EXPECT_EQ(slab.count, 25u);
        EXPECT_NEAR(slab.mean, field(axisMm), 1e-6);
        // 5 x 5 points one unit (0.5 mm) apart: variance 2 units^2 along right and along down.
        const double right = gradient.dot(frame.right) * 0.5, down = gradient.dot(frame.down) * 0.5;
        EXPECT_NEAR(slab.squaredDeviations, 25 * 2 * (right * right + down * down), 1e-6);
    }
    EXPECT_NEAR(length(geometry.gridMmFromVoxel(centre.along)), 0.5, 1e-12) << "one unit is the smallest spacing";
}

TEST(TubeSamples, ANoDataNeighbourLeavesTheNearestToDecide) {
    VolumeGeometry geometry;
    geometry.size = {3, 1, 1};
    Volume volume(geometry, std::vector<std::uint8_t>{51, 102, 255});
    const Volume masked = volume.withDataMask({1, 1, 0});
    EXPECT_NEAR(intensityAt(volume, {1.25, 0, 0}), 0.4 + 0.25 * 0.6, 1e-12);
    EXPECT_NEAR(intensityAt(masked, {1.25, 0, 0}), 0.4, 1e-12);
    EXPECT_TRUE(std::isnan(intensityAt(masked, {1.75, 0, 0})));
    EXPECT_NEAR(intensityAt(masked, {1.0, 0, 0}), 0.4, 1e-12) << "exactly on a voxel no neighbour has a share";
    EXPECT_NEAR(intensityAt(masked, {0.5, 0, 0}), 0.3, 1e-12);
    EXPECT_NEAR(intensityAt(volume, {-0.4, 0, 0}), 0.2, 1e-12) << "the box reaches half a voxel out";
    EXPECT_TRUE(std::isnan(intensityAt(volume, {-0.6, 0, 0})));
    EXPECT_TRUE(std::isnan(intensityAt(volume, {0, 0.6, 0})));
}

TEST(TubeSamples, NotFiniteVoxelsAreLeftOut) {
    VolumeGeometry geometry;
    geometry.size = {3, 1, 1};
    const float infinite = std::numeric_limits<float>::infinity();
    const Volume volume(geometry, std::vector<float>{0.25f, std::nanf(""), infinite}, 1.0);
    EXPECT_EQ(intensityAt(volume, {0.4, 0, 0}), 0.25);
    EXPECT_TRUE(std::isnan(intensityAt(volume, {0.6, 0, 0})));
    EXPECT_TRUE(std::isnan(intensityAt(volume, {2, 0, 0})));
}

TEST(TubeSamples, StoredSumsAreExactOnlyForIntegersWithAnIntegerWhiteLevel) {
    VolumeGeometry geometry;
    geometry.size = {2, 1, 1};
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<std::uint8_t>{1, 2})), 255u);
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<std::uint16_t>{1, 4095})), 4095u);
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<std::uint16_t>{1, 4095}, 1000.5)), std::nullopt);
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<std::uint16_t>{1, 4095}, 1e6)), 65535u);
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<float>{1, 2})), std::nullopt);
}

}  // namespace
}  // namespace echolucent
