// Tests of processing/volume/coarse_grid.h: where few voxels out of many lie, and that their boxes are one.
#include "processing/volume/coarse_grid.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/processing/grids.h"

namespace echolucent {
namespace {

/// A grid that is turned and lies away from the patient's origin.
VolumeGeometry placedGridOf(const std::array<std::int64_t, 3>& size, const Vec3& spacing) {
    VolumeGeometry geometry = gridOf(size, spacing);
    geometry.origin = Vec3(10, -20, 30);
    geometry.direction = rotationZ(30) * rotationX(-50);
    return geometry;
}

void expectNear(const Vec3& one, const Vec3& other, const char* what) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(one[axis], other[axis], 1e-9) << what << " axis " << axis;
}

TEST(CoarseGrid, TakesTheMiddleOfEveryFourVoxelsOf512) {
    const auto grid = coarseGridOf(placedGridOf({512, 512, 512}, {0.3, 0.3, 0.3}));
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->stride, (std::array<std::int64_t, 3>{4, 4, 4}));
    EXPECT_EQ(grid->geometry.size, (std::array<std::int64_t, 3>{128, 128, 128}));
    EXPECT_EQ(grid->voxelOf(0, 0), 1);
    EXPECT_EQ(grid->voxelOf(2, 127), 509);
}

TEST(CoarseGrid, HasVoxelsNearToCubes) {
    const auto slab = coarseGridOf(placedGridOf({1024, 1024, 64}, {0.2, 0.2, 1.6}));
    ASSERT_TRUE(slab);
    EXPECT_EQ(slab->stride, (std::array<std::int64_t, 3>{8, 8, 1})) << "no slice is left out";
    const auto flat = coarseGridOf(placedGridOf({8192, 8192, 1}, {0.1, 0.1, 0.1}));
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->stride, (std::array<std::int64_t, 3>{64, 64, 1}));
    EXPECT_EQ(flat->geometry.size, (std::array<std::int64_t, 3>{128, 128, 1}));
}

TEST(CoarseGrid, IsLeftOutOfSmallVolumes) {
    EXPECT_FALSE(coarseGridOf(placedGridOf({320, 320, 320}, {0.3, 0.3, 0.3})));
    EXPECT_TRUE(coarseGridOf(placedGridOf({323, 323, 323}, {0.3, 0.3, 0.3})));
}

/// Whatever the sizes, what the grid says of places in the patient is what the volume says.
TEST(CoarseGrid, LiesWhereTheVolumeLies) {
    const std::vector<std::pair<std::array<std::int64_t, 3>, Vec3>> volumes{{{512, 512, 512}, {0.3, 0.3, 0.3}},
                                                                            {{601, 613, 333}, {0.2, 0.21, 0.5}},
                                                                            {{333, 1000, 130}, {0.9, 0.1, 1.0}},
                                                                            {{40000, 900, 1}, {0.2, 0.1, 0.2}}};
    for (const auto& [size, spacing] : volumes) {
        VolumeGeometry volume = placedGridOf(size, spacing);
        volume.probe = StatedProbe{.apexMm = Vec3(1, 2, -3)};
        const auto grid = coarseGridOf(volume);
        ASSERT_TRUE(grid);
        const VolumeGeometry& coarse = grid->geometry;
        for (int axis = 0; axis < 3; ++axis) {
            const auto of = static_cast<std::size_t>(axis);
            EXPECT_LE(coarse.size[of], mostCoarseVoxels);
            EXPECT_LT(grid->voxelOf(axis, coarse.size[of] - 1), size[of]);
            EXPECT_GE(grid->voxelOf(axis, coarse.size[of]), size[of]) << "no more would fit";
        }
        const auto placeOf = [](const VolumeGeometry& geometry, const Vec3& gridMm) {
            return geometry.origin + geometry.direction * gridMm;
        };
        expectNear(placeOf(coarse, coarse.gridMmFromVoxel({3, 5, 0})),
                   volume.patientFromVoxel(Vec3(static_cast<double>(grid->voxelOf(0, 3)),
                                                static_cast<double>(grid->voxelOf(1, 5)),
                                                static_cast<double>(grid->voxelOf(2, 0)))),
                   "a voxel");
        expectNear(placeOf(coarse, grid->boxOfVolume().lowMm), placeOf(volume, volume.boxMinMm()), "low corner");
        expectNear(placeOf(coarse, grid->boxOfVolume().highMm), placeOf(volume, volume.boxMaxMm()), "high corner");
        expectNear(placeOf(coarse, *coarse.probe->apexMm), placeOf(volume, Vec3(1, 2, -3)), "apex");
    }
}

TEST(CoarseVolume, HasTheVolumesVoxelsMaskWhiteLevelAndBox) {
    const VolumeGeometry geometry = placedGridOf({330, 322, 318}, {0.5, 0.5, 0.5});
    std::vector<std::uint8_t> values(static_cast<std::size_t>(geometry.voxelCount()));
    std::vector<std::uint8_t> mask(values.size(), 1);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint8_t>(i * 2654435761U >> 13);
    // The lower half along x is no data.
    for (std::size_t i = 0; i < values.size(); ++i)
        if (i % 330 < 165) mask[i] = 0;
    const Volume whole(geometry, values, 200.0);
    const Volume half = whole.withDataMask(mask);
    const auto grid = coarseGridOf(geometry);
    const auto coarse = coarseVolumeOf(half);
    ASSERT_TRUE(grid && coarse);
    EXPECT_EQ(coarse->units, 3.0);
    EXPECT_EQ(coarse->voxels->whiteLevel(), 200.0);
    const VolumeGeometry& few = coarse->voxels->geometry();
    std::int64_t wrong = 0;
    for (std::int64_t z = 0; z < few.size[2]; ++z)
        for (std::int64_t y = 0; y < few.size[1]; ++y)
            for (std::int64_t x = 0; x < few.size[0]; ++x) {
                const auto at = geometry.offset(grid->voxelOf(0, x), grid->voxelOf(1, y), grid->voxelOf(2, z));
                const auto place = few.offset(x, y, z);
                wrong += coarse->voxels->storedValue(place) != half.storedValue(at) ||
                         coarse->voxels->hasData(place) != half.hasData(at);
            }
    EXPECT_EQ(wrong, 0);
    const DataBox box = coarse->voxels->dataBox(), all = grid->boxOfVolume();
    EXPECT_EQ(box.highMm, all.highMm);
    EXPECT_EQ(box.lowMm[1], all.lowMm[1]);
    // Half a coarse voxel before the first that is data: at most a coarse voxel from where the data begin.
    const double begins = all.lowMm[0] + 165 * 0.5;
    EXPECT_NEAR(box.lowMm[0], begins, 1.5);
    const auto coarseWhole = coarseVolumeOf(whole);
    ASSERT_TRUE(coarseWhole);
    EXPECT_EQ(coarseWhole->voxels->dataBox(), all);
    EXPECT_TRUE(coarseWhole->voxels->dataMask().empty());
}

}  // namespace
}  // namespace echolucent
