// Tube cores that see no fluid find the surface where the data begin.
#include <gtest/gtest.h>

#include <algorithm>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/intensity/no_data.h"
#include "processing/near_cut/near_cut.h"
#include "tests/processing/tube_core/plane_volume.h"

namespace echolucent {
namespace {

int surfacesIn(const AdaptiveOtf& otf) {
    return static_cast<int>(std::count_if(otf.tubes.begin(), otf.tubes.end(),
                                          [](const TubeCore& tube) { return tube.status == TubeStatus::surface; }));
}

/// Tissue in the far half, 0 and a few lone echoes before it: tube cores that saw the very same are not weighed.
Volume tissueBehindNothing() {
    PlaneVolume plane;
    auto voxels = plane.voxels<std::uint8_t>();
    const VolumeGeometry geometry = plane.geometry();
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        const std::int64_t z = static_cast<std::int64_t>(i) / (geometry.size[0] * geometry.size[1]);
        if (z < geometry.size[2] / 2) voxels[i] = i * 2654435761 % 1009 == 0 ? 40 : 0;
    }
    return Volume(geometry, voxels);
}

TEST(WhereDataBegin, IsTheSurfaceWhereThereIsNoFluid) {
    const Volume all = tissueBehindNothing();
    const Volume guessed = all.withDataMask(guessDataMask(all));
    ASSERT_FALSE(guessed.dataMask().empty());
    const auto bare = adaptOpacity(all, {}, {}), found = adaptOpacity(guessed, {}, {});
    EXPECT_FALSE(bare->surfacesWhereDataBegin);
    EXPECT_TRUE(found->surfacesWhereDataBegin);
    EXPECT_NE(found->message, "");
    ASSERT_GT(surfacesIn(*bare), 100);
    EXPECT_EQ(surfacesIn(*found), surfacesIn(*bare));
    EXPECT_GT(found->tubesWithWeight, 0);
    EXPECT_EQ(found->tubesWithWeight, bare->tubesWithWeight);
    const auto initial = sampledOpacities(found->config.initial, AdaptiveOtf::sampleCount);
    for (std::size_t i = 0; i < initial.size(); ++i) ASSERT_NEAR(found->curve.opacities[i], initial[i], 1e-12) << i;
    EXPECT_EQ(findNearCut(guessed, {})->answer, NearCutAnswer::noFluid) << "so nothing can stand before it";
}

TEST(WhereDataBegin, NeedsNoQuietVoxelsThere) {
    const Volume all = tissueBehindNothing();
    const Volume guessed = all.withDataMask(guessDataMask(all));
    const auto quiet = quietVolume(guessed, SpeckleReduction::medium);
    ASSERT_TRUE(quiet);
    const auto plain = adaptOpacity(guessed, {}, {});
    const auto found = adaptOpacity(guessed, {}, {}, {}, {&*quiet, SpeckleReduction::medium});
    EXPECT_TRUE(found->surfacesWhereDataBegin);
    EXPECT_EQ(found->reduction, SpeckleReduction::medium);
    EXPECT_EQ(found->tubesWithWeight, plain->tubesWithWeight);
    EXPECT_EQ(found->curve.opacities, plain->curve.opacities);
}

TEST(WhereDataBegin, OtherMasksAreNeverTakenBack) {
    const Volume all = tissueBehindNothing();
    // A mask over echoes, and one over everything.
    std::vector<std::uint8_t> front(static_cast<std::size_t>(all.geometry().voxelCount()), 1);
    for (std::size_t i = 0; i < front.size(); ++i) front[i] = all.storedValue(static_cast<std::int64_t>(i)) == 0;
    EXPECT_FALSE(adaptOpacity(all.withDataMask(front), {}, {})->surfacesWhereDataBegin);
    const auto none = adaptOpacity(all.withDataMask(std::vector<std::uint8_t>(front.size(), 0)), {}, {});
    EXPECT_EQ(none->message, "No tube core meets the volume's data: the initial function is used.");
}

}  // namespace
}  // namespace echolucent
