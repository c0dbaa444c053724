// What holds for every reduction: type, geometry, data, constants, threads, cancelling.
#include "processing/speckle_reduction/speckle_reduction.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "tests/processing/speckle_reduction/noisy_volumes.h"

namespace echolucent {
namespace {

constexpr std::array reductions{SpeckleReduction::light, SpeckleReduction::medium, SpeckleReduction::strong};

double slope(std::int64_t x, std::int64_t y, std::int64_t z) {
    return 40.0 + 3.0 * static_cast<double>(x) + static_cast<double>(y) + static_cast<double>(z % 3);
}

TEST(SpeckleReduction, OffSharesTheVoxels) {
    const Volume volume = noisyVolume<std::uint8_t>(gridOf({5, 4, 3}), 0.2, slope);
    EXPECT_EQ(&quietVolume(volume, SpeckleReduction::off)->voxels(), &volume.voxels());
}

TEST(SpeckleReduction, KeepsAllButTheVoxels) {
    VolumeGeometry geometry = gridOf({20, 12, 9}, {0.3, 0.4, 0.9});
    geometry.origin = {1, 2, 3};
    geometry.spacingKnown = false;
    Volume volume = noisyVolume<std::uint16_t>(geometry, 0.3, slope, 158.0);
    volume = volume.withDataMask(maskWithout(geometry, [](auto x, auto y, auto) { return x + y < 4; }));
    for (const SpeckleReduction reduction : reductions) {
        const Volume quiet = *quietVolume(volume, reduction);
        EXPECT_EQ(quiet.typeName(), "uint16");
        EXPECT_EQ(quiet.whiteLevel(), 158.0);
        EXPECT_EQ(quiet.dataMask(), volume.dataMask());
        EXPECT_EQ(quiet.geometry().size, geometry.size);
        EXPECT_EQ(quiet.geometry().spacing, geometry.spacing);
        EXPECT_EQ(quiet.geometry().origin, geometry.origin);
        EXPECT_FALSE(quiet.geometry().spacingKnown);
    }
}

TEST(SpeckleReduction, TakesSpeckleAndKeepsTheMean) {
    const Volume volume = noisyVolume<std::uint8_t>(gridOf({40, 40, 40}), 0.5, [](auto, auto, auto) { return 100.0; });
    const auto inside = [](auto x, auto y, auto z) { return std::min({x, y, z}) > 4 && std::max({x, y, z}) < 35; };
    const Moments before = momentsOf(volume, inside);
    for (const SpeckleReduction reduction : reductions) {
        const Moments after = momentsOf(*quietVolume(volume, reduction), inside);
        EXPECT_NEAR(after.mean, before.mean, 1.0) << nameOf(reduction);
        EXPECT_LT(after.deviation, before.deviation / 4.0) << nameOf(reduction);
    }
}

TEST(SpeckleReduction, NoDataNeitherChangesNorMatters) {
    const VolumeGeometry geometry = gridOf({24, 20, 18});
    const auto mask = maskWithout(geometry, [](auto x, auto y, auto z) { return x + z < 12 || (x == 15 && y == 9); });
    for (const SpeckleReduction reduction : reductions) {
        std::vector<Volume> results;
        for (const float outside :
             {0.0F, 250.0F, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -3e38F}) {
            auto voxels = std::get<VoxelArray<float>>(noisyVolume<float>(geometry, 0.4, slope).voxels()).toVector();
            for (std::size_t i = 0; i < voxels.size(); ++i)
                if (mask[i] == 0) voxels[i] = outside;
            const Volume volume = Volume(geometry, voxels, 200.0).withDataMask(mask);
            results.push_back(*quietVolume(volume, reduction));
            const auto& quiet = std::get<VoxelArray<float>>(results.back().voxels());
            const auto& first = std::get<VoxelArray<float>>(results.front().voxels());
            for (std::size_t i = 0; i < voxels.size(); ++i) {
                if (mask[i] != 0)
                    ASSERT_EQ(quiet[i], first[i]) << nameOf(reduction) << " with " << outside << " outside";
                else if (std::isnan(outside))
                    ASSERT_TRUE(std::isnan(quiet[i]));
                else
                    ASSERT_EQ(quiet[i], outside);
            }
        }
    }
}

TEST(SpeckleReduction, AConstantStaysExactlyBesideOtherValuesWithoutData) {
    const VolumeGeometry geometry = gridOf({19, 17, 13}, {0.5, 0.6, 1.7});
    const auto mask = maskWithout(geometry, [](auto x, auto y, auto z) { return x * x + y * z < 60; });
    for (const SpeckleReduction reduction : reductions)
        for (const float value : {0.1F, 255.0F, 1e-40F, 3.3e38F, -7.7F}) {
            std::vector<float> voxels(static_cast<std::size_t>(geometry.voxelCount()), 99.0F);
            for (std::size_t i = 0; i < voxels.size(); ++i)
                if (mask[i] != 0) voxels[i] = value;
            const Volume quiet = *quietVolume(Volume(geometry, voxels).withDataMask(mask), reduction);
            EXPECT_EQ(std::get<VoxelArray<float>>(quiet.voxels()), voxels) << nameOf(reduction) << " " << value;
        }
    for (const SpeckleReduction reduction : reductions)
        for (const int value : {0, 1, 200, 65535}) {
            const Volume volume(geometry, std::vector<std::uint16_t>(static_cast<std::size_t>(geometry.voxelCount()),
                                                                     static_cast<std::uint16_t>(value)));
            EXPECT_EQ(quietVolume(volume, reduction)->voxels(), volume.voxels()) << nameOf(reduction) << " " << value;
        }
}

TEST(SpeckleReduction, AnAbsurdVoxelShinesNoFartherThanAWhiteOne) {
    const VolumeGeometry geometry = gridOf({15, 15, 15});
    const auto middle = static_cast<std::size_t>(geometry.offset(7, 7, 7));
    for (const SpeckleReduction reduction : reductions) {
        std::vector<Volume> results;
        for (const float hot : {200.0F, 1e30F}) {
            auto voxels = std::get<VoxelArray<float>>(noisyVolume<float>(geometry, 0.4, slope).voxels()).toVector();
            voxels[middle] = hot;
            results.push_back(*quietVolume(Volume(geometry, voxels, 200.0), reduction));
        }
        EXPECT_EQ(results[0].voxels(), results[1].voxels()) << nameOf(reduction);
        EXPECT_LT(results[0].storedValue(geometry.offset(7, 7, 5)), 120.0);
    }
}

TEST(SpeckleReduction, TakesAnySizeAndExtremes) {
    for (const std::array<std::int64_t, 3> size :
         {std::array<std::int64_t, 3>{1, 1, 1}, {1, 9, 1}, {70, 1, 2}, {2, 2, 2}})
        for (const SpeckleReduction reduction : reductions) {
            const Volume volume = noisyVolume<float>(
                gridOf(size, {0.01, 1, 100}), 0.0, [](auto x, auto, auto z) { return x % 2 == z % 2 ? 3e38 : -3e38; });
            const Volume quiet = *quietVolume(volume, reduction);
            for (const float value : std::get<VoxelArray<float>>(quiet.voxels())) EXPECT_TRUE(std::isfinite(value));
        }
    const Volume nothing =
        Volume(gridOf({3, 3, 3}), std::vector<std::uint8_t>(27, 9)).withDataMask(std::vector<std::uint8_t>(27, 0));
    for (const SpeckleReduction reduction : reductions)
        EXPECT_EQ(quietVolume(nothing, reduction)->voxels(), nothing.voxels());
}

TEST(SpeckleReduction, HasTheSameBitsForAnyNumberOfThreads) {
    Volume volume = noisyVolume<std::uint8_t>(gridOf({70, 31, 23}), 0.6, slope);
    volume = volume.withDataMask(maskWithout(volume.geometry(), [](auto x, auto, auto z) { return x < z; }));
    for (const SpeckleReduction reduction : reductions) {
        std::vector<Volume> results;
        for (const std::size_t threads : {1, 2, 5}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            results.push_back(*quietVolume(volume, reduction));
        }
        EXPECT_EQ(results[0].voxels(), results[1].voxels());
        EXPECT_EQ(results[0].voxels(), results[2].voxels());
    }
}

TEST(SpeckleReduction, ReportsProgressThatNeverFallsAndEnds) {
    const Volume volume = noisyVolume<std::uint8_t>(gridOf({20, 20, 20}), 0.3, slope);
    for (const SpeckleReduction reduction : reductions) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
        std::vector<double> shares;
        const Progress progress{[&](double share) { shares.push_back(share); }, nullptr};
        ASSERT_TRUE(quietVolume(volume, reduction, progress));
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_GT(shares.size(), 2U) << "a thread that another program keeps busy may leave parts to others";
        EXPECT_EQ(shares.back(), 1.0);
    }
}

TEST(SpeckleReduction, IsCancelledBeforeAndWhileItRuns) {
    const Volume volume = noisyVolume<std::uint8_t>(gridOf({20, 20, 20}), 0.3, slope);
    for (const SpeckleReduction reduction : allSpeckleReductions) {
        const std::atomic<bool> cancel = true;
        EXPECT_FALSE(quietVolume(volume, reduction, {{}, &cancel})) << nameOf(reduction);
    }
    // Only the caller's thread reports, and others may do all the work.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    for (const SpeckleReduction reduction : reductions) {
        std::atomic<bool> cancel = false;
        const Progress progress{[&](double share) { cancel = cancel || share > 0.4; }, &cancel};
        EXPECT_FALSE(quietVolume(volume, reduction, progress)) << nameOf(reduction);
    }
}

}  // namespace
}  // namespace echolucent
