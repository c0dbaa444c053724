// A volume that passes slab by slab comes out as one that passes at once.
#include "processing/speckle_reduction/filter_slabs.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "processing/speckle_reduction/joint_bilateral_filter.h"
#include "processing/speckle_reduction/speckle_law.h"
#include "tests/processing/speckle_reduction/joint_bilateral_passes.h"
#include "tests/processing/speckle_reduction/noisy_volumes.h"

namespace echolucent {
namespace {

TEST(FilterSlabs, FilterEverySliceOnceAndHoldThoseBehind) {
    const VolumeGeometry geometry = gridOf({10, 10, 57});
    // A slab has an eighth of the voxels that may pass at once, but a slice for each thread, and no fewer than are held
    // behind it.
    struct Case {
        std::int64_t reach, threads, mostVoxels, thickness;
    };
    for (const Case& given : {Case{1, 1, 1, 1}, Case{1, 4, 1, 4}, Case{3, 1, 1, 3}, Case{9, 4, 1, 9},
                              Case{1, 1, 4000, 5}, Case{3, 4, 5600, 7}, Case{9, 4, 5600, 9}, Case{80, 1, 5699, 80}}) {
        std::int64_t next = 0;
        for (const FilterSlab& slab : filterSlabs(geometry, given.reach, given.mostVoxels, given.threads)) {
            EXPECT_EQ(slab.first, next);
            EXPECT_EQ(slab.end, std::min<std::int64_t>(57, next + given.thickness));
            EXPECT_EQ(slab.firstHeld, slab.first);
            EXPECT_EQ(slab.endHeld, std::min<std::int64_t>(57, slab.end + given.reach));
            next = slab.end;
        }
        EXPECT_EQ(next, 57);
    }
    EXPECT_EQ(filterSlabs(geometry, 3, 5700, 2).size(), 1U);
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

/// Filters in an arena of two threads. A slab has a slice for each thread, so with as many threads as there are slices
/// there would be one slab only.
std::optional<Volume> filteredByTwo(const Volume& volume, std::span<const JointBilateralPass> passes,
                                    const Progress& progress, std::int64_t mostVoxels) {
    tbb::task_arena two(2);
    return two.execute([&] { return jointBilateralFiltered(volume, passes, progress, mostVoxels); });
}

void expectTheSame(const Volume& volume, std::span<const JointBilateralPass> passes) {
    const Volume whole = *jointBilateralFiltered(volume, passes);
    // The first are as thin as slabs may be, with as many slices as the measurement reaches; others leave a thin one at
    // the end.
    for (const std::int64_t thickness : {1, 9, 11}) {
        const Volume bySlabs = *filteredByTwo(volume, passes, {}, 21 * 18 * 8 * thickness);
        EXPECT_TRUE(whole.voxels() == bySlabs.voxels())
            << volume.geometry().spacing[2] << ' ' << passes.size() << ' ' << thickness;
        EXPECT_EQ(whole.dataMask(), bySlabs.dataMask());
    }
    EXPECT_FALSE(whole.voxels() == volume.voxels());
}

TEST(FilterSlabs, GiveTheVoxelsOfTheWholeVolume) {
    for (const bool masked : {false, true}) {
        expectTheSame(noisyScene<std::uint8_t>({1, 1, 1}, masked), onePass);
        expectTheSame(noisyScene<std::uint8_t>({0.3, 0.5, 0.9}, masked), twoPasses);
        expectTheSame(noisyScene<float>({0.9, 0.9, 0.2}, masked), onePass);
        expectTheSame(noisyScene<std::uint16_t>({0.3, 0.3, 2.5}, masked), twoPasses);
    }
}

TEST(FilterSlabs, MayBeThinnerThanAMeanReachesAndThanTheVolume) {
    // A slab has the three slices that the measurement reaches, and a mean reaches past them.
    const Volume volume = noisyScene<std::uint8_t>({1, 1, 1}, true);
    constexpr std::array far{JointBilateralPass{.radius = 8.0, .sigma = 5.0}};
    expectTheSame(volume, far);
    VolumeGeometry few = volume.geometry();
    few.size[2] = 4;
    few.spacingKnown = false;
    std::vector<std::uint8_t> voxels = std::get<VoxelArray<std::uint8_t>>(volume.voxels()).toVector();
    voxels.resize(static_cast<std::size_t>(few.voxelCount()));
    const Volume thin(few, std::move(voxels));
    EXPECT_TRUE(jointBilateralFiltered(thin, onePass)->voxels() == filteredByTwo(thin, onePass, {}, 1)->voxels());
}

TEST(FilterSlabs, LeaveOffWhereTheRunIsCancelled) {
    const Volume volume = noisyScene<std::uint8_t>({1, 1, 1}, false);
    // Only the caller's thread reports, and others may do all the work.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    // Speckle is measured in a fifth of the time, a slab after the other, and then means are made.
    struct Cancel {
        double at, most;
    };
    for (const Cancel& share : {Cancel{0.05, 0.1}, Cancel{0.3, 0.55}}) {
        std::atomic<bool> cancel{false};
        double last = 0.0;
        const Progress progress{[&](double done) {
                                    last = done;
                                    if (done > share.at) cancel = true;
                                },
                                &cancel};
        EXPECT_FALSE(filteredByTwo(volume, onePass, progress, 21 * 18 * 56));
        EXPECT_GT(last, share.at);
        EXPECT_LT(last, share.most);
    }
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
