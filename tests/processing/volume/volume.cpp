#include "processing/volume/volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace echolucent {
namespace {

VolumeGeometry geometryOf(std::int64_t x, std::int64_t y, std::int64_t z) {
    VolumeGeometry geometry;
    geometry.size = {x, y, z};
    return geometry;
}

TEST(Volume, PositionsInVoxelsGridAndPatient) {
    VolumeGeometry geometry = geometryOf(4, 6, 8);
    geometry.spacing = {0.5, 2, 3};
    geometry.origin = {10, 20, 30};
    geometry.direction = rotationZ(90);
    EXPECT_EQ(geometry.voxelCount(), 192);
    EXPECT_EQ(geometry.offset(0, 0, 0), 0);
    EXPECT_EQ(geometry.offset(1, 0, 0), 1) << "x fastest";
    EXPECT_EQ(geometry.offset(3, 5, 7), 191);
    EXPECT_EQ(geometry.unit(), 0.5);
    EXPECT_EQ(geometry.gridMmFromVoxel({2, 3, 4}), Vec3(1, 6, 12));
    EXPECT_EQ(geometry.voxelFromGridMm({1, 6, 12}), Vec3(2, 3, 4));
    EXPECT_EQ(geometry.boxMinMm(), Vec3(-0.25, -1, -1.5));
    EXPECT_EQ(geometry.boxMaxMm(), Vec3(1.75, 11, 22.5));
    EXPECT_EQ(geometry.centreMm(), Vec3(0.75, 5, 10.5));
    EXPECT_EQ(geometry.patientFromVoxel({2, 0, 0}), Vec3(10, 21, 30)) << "the grid's x axis points along patient +y";
    EXPECT_EQ(geometry.patientFromVoxel({0, 1, 1}), Vec3(8, 20, 33));
}

TEST(Volume, TheWhiteLevelIsDeclaredOrTheLargestValue) {
    EXPECT_EQ(Volume(geometryOf(2, 1, 1), std::vector<std::uint8_t>{0, 17}).whiteLevel(), 255.0);
    EXPECT_EQ(Volume(geometryOf(2, 1, 1), std::vector<std::uint16_t>{9, 3000}).whiteLevel(), 3000.0) << "not 65535";
    EXPECT_EQ(Volume(geometryOf(3, 1, 1), std::vector<float>{0.5f, INFINITY, NAN}).whiteLevel(), 0.5);
    EXPECT_EQ(Volume(geometryOf(2, 1, 1), std::vector<float>{-4.0f, -1.0f}).whiteLevel(), 1.0);
    EXPECT_EQ(Volume(geometryOf(2, 1, 1), std::vector<std::uint16_t>{9, 3000}, 4095.0).whiteLevel(), 4095.0);
    for (const double nonsense : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(Volume(geometryOf(2, 1, 1), std::vector<std::uint16_t>{9, 30}, nonsense).whiteLevel(), 30.0);
}

TEST(Volume, NormalisedIntensityIsInItsRange) {
    const Volume volume(geometryOf(5, 1, 1), std::vector<float>{-1.0f, 0.5f, 9.0f, NAN, INFINITY}, 2.0);
    EXPECT_EQ(volume.normalisedIntensity(0), 0.0);
    EXPECT_EQ(volume.normalisedIntensity(1), 0.25);
    EXPECT_EQ(volume.normalisedIntensity(2), 1.0);
    EXPECT_EQ(volume.normalisedIntensity(3), 0.0);
    EXPECT_EQ(volume.storedValue(2), 9.0);
    EXPECT_TRUE(std::isnan(volume.storedValue(3)));
    EXPECT_EQ(volume.dataMask(), (std::vector<std::uint8_t>{1, 1, 1, 0, 0})) << "not finite: no data";
    EXPECT_EQ(volume.typeName(), "float32");
}

TEST(Volume, SharesItsVoxelsUnderAnotherMask) {
    const Volume volume(geometryOf(2, 2, 1), std::vector<std::uint8_t>{1, 2, 3, 4});
    EXPECT_TRUE(volume.dataMask().empty());
    EXPECT_TRUE(volume.hasData(3));
    const Volume marked = volume.withDataMask({1, 0, 1, 1});
    EXPECT_EQ(&std::get<0>(marked.voxels()), &std::get<0>(volume.voxels()));
    EXPECT_FALSE(marked.hasData(1));
    EXPECT_TRUE(marked.hasData(0));
    EXPECT_TRUE(volume.hasData(1)) << "the first volume is not changed";
    EXPECT_TRUE(marked.withDataMask(std::vector<std::uint8_t>{}).hasData(1));
    EXPECT_THROW((void)volume.withDataMask({1, 0}), std::invalid_argument);
}

TEST(Volume, RefusesWhatIsNoVolume) {
    const auto bytes = [](std::size_t count) { return std::vector<std::uint8_t>(count); };
    EXPECT_THROW(Volume(geometryOf(2, 2, 2), bytes(7)), std::invalid_argument);
    EXPECT_THROW(Volume(geometryOf(0, 2, 2), bytes(0)), std::invalid_argument);
    EXPECT_THROW(Volume(geometryOf(-1, -1, 2), bytes(2)), std::invalid_argument);
    for (const double spacing : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        VolumeGeometry geometry = geometryOf(1, 1, 1);
        geometry.spacing[1] = spacing;
        EXPECT_THROW(Volume(geometry, bytes(1)), std::invalid_argument) << spacing;
    }
}

}  // namespace
}  // namespace echolucent
