#include "processing/tube_core/slabs/tube_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/sampling/sampler.h"
#include "tests/processing/grids.h"
#include "tests/processing/tube_core/view_samples.h"

namespace echolucent {
namespace {

/// Bytes of which every value is as likely.
Volume randomBytes(const std::array<std::int64_t, 3>& size, const Vec3& spacing = {1, 1, 1}) {
    const VolumeGeometry geometry = gridOf(size, spacing);
    std::mt19937 random(11);
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (auto& voxel : voxels) voxel = static_cast<std::uint8_t>(random());
    return Volume(geometry, std::move(voxels));
}

TEST(TubeSamples, BeginAtTheFirstVoxelCentreBehindTheNearCut) {
    const Volume volume = randomBytes({40, 40, 40});
    AdaptiveOtfConfig config;
    for (const auto& [cut, first, count] :
         {std::tuple{0.0, 0.0, 40}, {0.4, 0.0, 40}, {0.6, 1.0, 39}, {7.5, 7.0, 33}, {39.8, 40.0, 0}}) {
        const Viewpoint view = withFrontAcross({}, cut);
        const TubeSamples samples = samplesFor(volume, view, config)[112];
        EXPECT_EQ(samples.slabs, count) << cut;
        if (count > 0) {
            EXPECT_EQ(samples.first[2], first) << cut;
        }
        const Viewpoint back = withFrontAcross({.beamAxis = BeamAxis::minusZ}, cut);
        const TubeSamples backwards = samplesFor(volume, back, config)[112];
        EXPECT_EQ(backwards.slabs, count) << cut;
        if (count > 0) {
            EXPECT_EQ(backwards.first[2], 39.0 - first) << cut;
        }
    }
}

// Seen from behind, the front ends tube cores before the volume does.
TEST(TubeSamples, LieBehindTheFrontFromWhereverItIsSeen) {
    const Volume volume = randomBytes({40, 40, 40});
    const AdaptiveOtfConfig config;
    for (const Viewpoint& made : {Viewpoint{}, Viewpoint{.azimuthDegrees = 20, .elevationDegrees = -35}}) {
        const Viewpoint across = withFrontAcross(made, 17.3);
        const CuttingFace face = cuttingFaceOf(*across.frontPlane, volume.geometry());
        for (const BeamAxis axis :
             {BeamAxis::plusX, BeamAxis::minusX, BeamAxis::plusY, BeamAxis::minusY, BeamAxis::plusZ, BeamAxis::minusZ})
            for (const double azimuth : {0.0, 12.0}) {
                Viewpoint view{.beamAxis = axis, .azimuthDegrees = azimuth};
                view.frontPlane = across.frontPlane;
                int read = 0;
                for (const TubeSamples& samples : samplesFor(volume, view, config)) {
                    read += samples.slabs;
                    for (int slab = 0; slab < samples.slabs; ++slab) {
                        const Vec3 place = volume.geometry().gridMmFromVoxel(samples.first + samples.along * slab);
                        ASSERT_GE(face.inwards.dot(place), face.depthMm - 1e-6) << nameOf(axis) << azimuth;
                    }
                }
                EXPECT_GT(read, 1000) << nameOf(axis) << azimuth;
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
    const Viewpoint view{.azimuthDegrees = 33, .elevationDegrees = -21, .rollDegrees = 12};
    AdaptiveOtfConfig config;
    config.grid.spacing = 4;
    const TubeSamples centre = samplesFor(volume, view, config)[112];
    ASSERT_GT(centre.slabs, 30);
    std::vector<SlabMoments> slabs;
    std::vector<double> scratch;
    sampleSlabs(volume, Interpolation::trilinear, centre, slabs, scratch);
    const ViewFrame frame = frameOf(view);
    for (int k = 8; k < centre.slabs - 8; ++k) {
        const SlabMoments& slab = slabs[static_cast<std::size_t>(k)];
        const Vec3 axisMm = geometry.gridMmFromVoxel(centre.onAxis(k));
        EXPECT_EQ(slab.count, 25u);
        EXPECT_NEAR(slab.mean, field(axisMm), 1e-6);
        // There are 5 x 5 points one unit (0.5 mm) apart: their variance is 2 units^2 along right and along down.
        const double right = gradient.dot(frame.right) * 0.5, down = gradient.dot(frame.down) * 0.5;
        EXPECT_NEAR(slab.squaredDeviations, 25 * 2 * (right * right + down * down), 1e-6);
    }
    EXPECT_NEAR(length(geometry.gridMmFromVoxel(centre.along)), 0.5, 1e-12) << "one unit is the smallest spacing";
}

/// The mean of a slab of one sample; NaN where the sample is left out.
double meanAt(const Volume& volume, const Vec3& voxel, Interpolation sampling = Interpolation::trilinear) {
    TubeSamples one{};
    one.first = voxel;
    one.slabs = 1;
    one.cellSize = 1;
    std::vector<SlabMoments> slabs;
    std::vector<double> scratch;
    sampleSlabs(volume, sampling, one, slabs, scratch);
    return slabs.front().count == 1 ? slabs.front().mean : std::nan("");
}

TEST(TubeSamples, ReadWhatThePlainSamplerReads) {
    VolumeGeometry geometry;
    geometry.size = {9, 7, 8};
    std::mt19937 random(5);
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::uint8_t& voxel : voxels) voxel = static_cast<std::uint8_t>(random());
    const Volume volume(geometry, voxels);
    std::uniform_real_distribution<double> share(-0.49, 1.0);
    for (int i = 0; i < 500; ++i) {
        const Vec3 place{share(random) * 8.4, share(random) * 6.4, share(random) * 7.4};
        const bool inside = inBox(geometry, place);
        for (const Interpolation sampling : {Interpolation::trilinear, Interpolation::nearest}) {
            const VolumeSampler sampler(volume, sampling);
            const double mean = meanAt(volume, place, sampling);
            ASSERT_EQ(std::isnan(mean), !inside);
            if (inside) {
                ASSERT_NEAR(mean, *sampler.intensityAt(place), 1e-12);
            }
        }
    }
}

TEST(TubeSamples, ANoDataNeighbourLeavesTheNearestToDecide) {
    VolumeGeometry geometry;
    geometry.size = {3, 1, 1};
    Volume volume(geometry, std::vector<std::uint8_t>{51, 102, 255});
    const Volume masked = volume.withDataMask({1, 1, 0});
    EXPECT_NEAR(meanAt(volume, {1.25, 0, 0}), 0.4 + 0.25 * 0.6, 1e-12);
    EXPECT_NEAR(meanAt(masked, {1.25, 0, 0}), 0.4, 1e-12);
    EXPECT_TRUE(std::isnan(meanAt(masked, {1.75, 0, 0})));
    EXPECT_NEAR(meanAt(masked, {1.0, 0, 0}), 0.4, 1e-12) << "exactly on a voxel no neighbour has a share";
    EXPECT_NEAR(meanAt(masked, {0.5, 0, 0}), 0.3, 1e-12);
    EXPECT_NEAR(meanAt(volume, {-0.4, 0, 0}), 0.2, 1e-12) << "the box reaches half a voxel out";
    EXPECT_TRUE(std::isnan(meanAt(volume, {-0.6, 0, 0})));
    EXPECT_TRUE(std::isnan(meanAt(volume, {0, 0.6, 0})));
}

TEST(TubeSamples, NotFiniteVoxelsAreLeftOut) {
    VolumeGeometry geometry;
    geometry.size = {3, 1, 1};
    const float infinite = std::numeric_limits<float>::infinity();
    const Volume volume(geometry, std::vector<float>{0.25f, std::nanf(""), infinite}, 1.0);
    EXPECT_EQ(meanAt(volume, {0.4, 0, 0}), 0.25);
    EXPECT_TRUE(std::isnan(meanAt(volume, {0.6, 0, 0})));
    EXPECT_TRUE(std::isnan(meanAt(volume, {2, 0, 0})));
}

}  // namespace
}  // namespace echolucent
