// Tests of processing/pane_picture/coarse_picture.h: what is seen of a few voxels is what is seen of all.
#include "processing/pane_picture/coarse_picture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <vector>

#include "processing/document/opening_finds.h"
#include "processing/pane_picture/pane_picture.h"
#include "processing/phantom/phantom.h"

namespace echolucent {
namespace {

/// Every n-th voxel of a volume, as coarseVolumeOf() takes them of a large one.
CoarseVolume everyNth(const Volume& volume, std::int64_t n) {
    const VolumeGeometry& full = volume.geometry();
    CoarseGrid grid{
        .stride = {n, n, n}, .first = {(n - 1) / 2, (n - 1) / 2, (n - 1) / 2}, .full = full, .geometry = full};
    for (std::size_t axis = 0; axis < 3; ++axis) grid.geometry.size[axis] = full.size[axis] / n;
    grid.geometry.spacing *= static_cast<double>(n);
    const auto& size = grid.geometry.size;
    std::vector<std::uint8_t> values;
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x)
                values.push_back(static_cast<std::uint8_t>(
                    volume.storedValue(full.offset(grid.voxelOf(0, x), grid.voxelOf(1, y), grid.voxelOf(2, z)))));
    return coarseVolumeOf(grid, Volume(grid.geometry, values, volume.whiteLevel()));
}

/// Alpha in the middle of a picture.
double alphaInTheMiddle(const Picture& picture) {
    const int pixel = picture.height / 2 * picture.width + picture.width / 2;
    return static_cast<double>(picture.rgba[static_cast<std::size_t>(4 * pixel + 3)]);
}

TEST(CoarsePicture, IsAsOpaqueAsTheWholeVolume) {
    VolumeGeometry geometry;
    geometry.size = {64, 64, 64};
    const Volume volume(geometry, std::vector<std::uint8_t>(64 * 64 * 64, 51), 255.0);
    Document document;
    document.panes.at(firstPane).curve = CurveKind::linear;
    document.curves.linear = {0.0, 0.05, 1.0};  // opacity 0.01 per unit
    document.scene.look = Look{};
    const auto picture = coarsePicture(document, firstPane, everyNth(volume, 4), 96, 96);
    ASSERT_TRUE(picture);
    // 64 units of the volume, which the coarse grid's 16 units have to stand for.
    EXPECT_NEAR(alphaInTheMiddle(*picture), 1.0 - std::pow(0.99, 64.0), 0.005);
}

TEST(CoarsePicture, ShowsWhatTheStudysOwnPictureShowsInTheSameFrame) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    config.size = {160, 160, 160};
    config.spacing = Vec3(0.6, 0.6, 0.6);
    const auto volume = std::make_shared<const Volume>(*makePhantom(config));
    Document before;
    before.scene.look.reduction = SpeckleReduction::off;
    constexpr int width = 160, height = 120;
    const auto coarse = coarsePicture(before, firstPane, everyNth(*volume, 2), width, height);
    ASSERT_TRUE(coarse);
    ASSERT_EQ(coarse->width, width);

    const auto finds = findOnOpening(*volume);
    Document document = withFinds(openedDocument(before, {}), *finds);
    document.scene.pose = wholeVolumePose(volume->dataBox(), viewAlongBeam(document.beam),
                                          document.scene.look.projection, static_cast<double>(width) / height);
    const std::vector phases{volume};
    const auto whole = panePicture(document, firstPane, phases, width, height);
    ASSERT_TRUE(whole);
    const auto meanDifferenceAt = [&](int shift) {
        double sum = 0.0;
        int count = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 8; x < width - 8; ++x)
                for (int channel = 0; channel < 3; ++channel, ++count)
                    sum += std::abs(static_cast<double>(
                                        coarse->rgba[static_cast<std::size_t>(4 * (y * width + x + shift) + channel)]) -
                                    static_cast<double>(
                                        whole->picture.rgba[static_cast<std::size_t>(4 * (y * width + x) + channel)]));
        return 255.0 * sum / count;
    };
    const double difference = meanDifferenceAt(0);
    EXPECT_LT(difference, 8.0) << "grey levels";
    for (const int shift : {-3, 3}) EXPECT_LT(difference, meanDifferenceAt(shift)) << "it would jump by " << shift;
}

TEST(CoarsePicture, HasTheShapeAskedForAndNoMoreRaysThanItNeeds) {
    VolumeGeometry geometry;
    geometry.size = {32, 32, 32};
    const Volume volume(geometry, std::vector<std::uint8_t>(32 * 32 * 32, 100), 255.0);
    const auto picture = coarsePicture(Document{}, firstPane, everyNth(volume, 2), 2000, 1000);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->height, 192);
    EXPECT_EQ(picture->width, 384);
}

TEST(CoarsePicture, IsEmptyWhereItWasCancelled) {
    VolumeGeometry geometry;
    geometry.size = {32, 32, 32};
    const Volume volume(geometry, std::vector<std::uint8_t>(32 * 32 * 32, 100), 255.0);
    const std::atomic<bool> cancel = true;
    EXPECT_FALSE(coarsePicture(Document{}, firstPane, everyNth(volume, 2), 100, 100, {{}, &cancel}));
}

}  // namespace
}  // namespace echolucent
