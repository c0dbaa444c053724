// A volume that passes slab by slab comes out as one that passes at once.
#include "processing/speckle_reduction/filter_slabs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

#include "processing/speckle_reduction/joint_bilateral_filter.h"
#include "processing/speckle_reduction/speckle_law.h"
#include "tests/processing/speckle_reduction/noisy_volumes.h"

namespace echolucent {
namespace {

constexpr std::array onePass{JointBilateralPass{}};
constexpr std::array twoPasses{JointBilateralPass{}, JointBilateralPass{.guideSigma = 0.7}};

TEST(FilterSlabs, FilterEverySliceOnceAndHoldThoseBehind) {
    const VolumeGeometry geometry = gridOf({10, 10, 57});
    for (const std::int64_t reach : {1, 3, 9, 80})
        for (const std::int64_t mostVoxels : {1, 700, 2500, 5699}) {
            std::int64_t next = 0;
            for (const FilterSlab& slab : filterSlabs(geometry, reach, mostVoxels)) {
                EXPECT_EQ(slab.first, next);
                EXPECT_GT(slab.end, slab.first);
                EXPECT_EQ(slab.firstHeld, slab.first);
                EXPECT_EQ(slab.endHeld, std::min<std::int64_t>(57, slab.end + reach));
                // An eighth of the voxels that may pass at once, or one slice.
                EXPECT_LE(100 * (slab.end - slab.first), std::max<std::int64_t>(100, mostVoxels / 8));
                next = slab.end;
            }
            EXPECT_EQ(next, 57);
        }
    EXPECT_EQ(filterSlabs(geometry, 3, 5700).size(), 1U);
}

/// A step and a gap in noise, and a mask that cuts off a corner where one is asked for.
template <typename Voxel>
Volume noisyScene(const Vec3& spacing, bool masked) {
    const VolumeGeometry geometry = gridOf({21, 18, 60}, spacing);
    const auto scene = [](auto x, auto, auto z) { return z == 30 || z == 31 ? 110.0 : x < 9 ? 40.0 : 90.0; };
    const Volume volume = noisyVolume<Voxel>(geometry, 0.4, scene, 255.0);
    if (!masked) return volume;
    return volume.withDataMask(maskWithout(geometry, [](auto x, auto y, auto z) { return x + y + z / 3 < 20; }));
}

template <typename Voxel>
void expectTheSame(const Vec3& spacing, bool masked, std::span<const JointBilateralPass> passes) {
    const Volume volume = noisyScene<Voxel>(spacing, masked);
    const Volume whole = *jointBilateralFiltered(volume, passes);
    // Slabs of one slice, of fewer than a mean reaches, and of a number that leaves a thin one at the end.
    for (const std::int64_t thickness : {1, 2, 5, 7}) {
        const Volume bySlabs = *jointBilateralFiltered(volume, passes, {}, 21 * 18 * 8 * thickness);
        EXPECT_TRUE(whole.voxels() == bySlabs.voxels())
            << spacing[2] << ' ' << masked << ' ' << passes.size() << ' ' << thickness;
        EXPECT_EQ(whole.dataMask(), bySlabs.dataMask());
    }
    EXPECT_FALSE(whole.voxels() == volume.voxels());
}

TEST(FilterSlabs, GiveTheVoxelsOfTheWholeVolume) {
    for (const bool masked : {false, true}) {
        expectTheSame<std::uint8_t>({1, 1, 1}, masked, onePass);
        expectTheSame<std::uint8_t>({0.3, 0.5, 0.9}, masked, twoPasses);
        expectTheSame<float>({0.9, 0.9, 0.2}, masked, onePass);
        expectTheSame<std::uint16_t>({0.3, 0.3, 2.5}, masked, twoPasses);
    }
}

TEST(FilterSlabs, LeaveOffWhereTheRunIsCancelled) {
    std::atomic<bool> cancel{false};
    int reports = 0;
    const Progress progress{[&](double share) {
                                ++reports;
                                if (share > 0.3) cancel = true;
                            },
                            &cancel};
    const Volume volume = noisyScene<std::uint8_t>({1, 1, 1}, false);
    EXPECT_FALSE(jointBilateralFiltered(volume, onePass, progress, 21 * 18 * 56));
    EXPECT_GT(reports, 1);
}

TEST(SpeckleLaw, IsTheSameHoweverTheVolumeIsCut) {
    const Volume volume = noisyScene<float>({1, 1, 1}, true);
    const SpeckleLaw whole = speckleLawOf(volume);
    SpeckleLawMeasurement measurement(volume.geometry());
    for (std::int64_t first = 0; first < 60; first += 7) {
        measurement.add(volume, {first, std::min<std::int64_t>(60, first + 7), 0, 60});
    }
    const SpeckleLaw cut = measurement.law();
    EXPECT_EQ(cut.factor, whole.factor);
    EXPECT_EQ(cut.exponent, whole.exponent);
}

}  // namespace
}  // namespace echolucent
