#include <gtest/gtest.h>

#include "processing/scene/pose.h"
#include "processing/volume/volume.h"

namespace echolucent {
namespace {

VolumeGeometry grid() {
    VolumeGeometry geometry;
    geometry.size = {20, 12, 10};
    geometry.spacing = {0.5, 1, 2};
    return geometry;
}

Volume withCornersAt(const std::array<std::int64_t, 3>& low, const std::array<std::int64_t, 3>& high) {
    const VolumeGeometry geometry = grid();
    const Volume volume(geometry, std::vector<std::uint8_t>(2400, 50));
    std::vector<std::uint8_t> mask(2400, 0);
    mask[static_cast<std::size_t>(geometry.offset(low[0], high[1], low[2]))] = 1;
    mask[static_cast<std::size_t>(geometry.offset(high[0], low[1], high[2]))] = 1;
    return volume.withDataMask(mask);
}

TEST(DataBox, HoldsTheVoxelsThatAreDataAndNoMore) {
    const DataBox box = withCornersAt({3, 2, 1}, {15, 7, 6}).dataBox();
    EXPECT_EQ(box.lowMm, Vec3(1.25, 1.5, 1.0));
    EXPECT_EQ(box.highMm, Vec3(7.75, 7.5, 13.0));
}

TEST(DataBox, IsTheGridWithoutAMaskAndWithoutData) {
    const Volume volume(grid(), std::vector<std::uint8_t>(2400, 50));
    EXPECT_EQ(volume.dataBox(), DataBox(grid()));
    EXPECT_EQ(volume.withDataMask(std::vector<std::uint8_t>(2400, 0)).dataBox(), DataBox(grid()));
    EXPECT_EQ(withCornersAt({3, 2, 1}, {15, 7, 6}).withDataMask(std::vector<std::uint8_t>{}).dataBox(),
              DataBox(grid()));
    EXPECT_EQ(DataBox(grid()).centreMm(), grid().centreMm());
}

TEST(DataBox, PhasesCanShareOne) {
    const Volume a = withCornersAt({3, 2, 1}, {15, 7, 6}), b = withCornersAt({5, 0, 2}, {19, 3, 3});
    const DataBox both = a.dataBox().joined(b.dataBox());
    EXPECT_EQ(both.lowMm, Vec3(1.25, -0.5, 1.0));
    EXPECT_EQ(both.highMm, Vec3(9.75, 7.5, 13.0));
    EXPECT_EQ(a.withDataBox(both).dataBox(), both);
}

TEST(DataBox, ThePictureIsFittedToIt) {
    const DataBox box = withCornersAt({3, 2, 1}, {15, 7, 6}).dataBox();
    const CameraPose camera = cameraPoseOf(Pose{}, BeamAxis::plusZ, box, Projection::parallel, 1.0);
    EXPECT_EQ(camera.focalPoint, box.centreMm());
    EXPECT_NEAR(camera.heightMm, 1.04 * 6.5, 1e-12) << "the larger extent across the beam and the margin";
    EXPECT_EQ(wholeVolumePose(box, Viewpoint{}, Projection::parallel, 1.0), Pose{});
}

}  // namespace
}  // namespace echolucent
