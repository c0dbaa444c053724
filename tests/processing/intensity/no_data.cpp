// The guess of the scanned sector's outside, on made sectors and on scans without one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <type_traits>

#include "processing/intensity/no_data.h"
#include "processing/phantom/phantom.h"

namespace echolucent {
namespace {

using Inside = std::function<bool(double, double, double)>;

/// A cone with its tip at the top, 45 degrees to each side, ended by a sphere around the tip.
bool inCone(double x, double y, double z) {
    const double side = std::hypot(x - 31.5, y - 31.5);
    return side <= z + 3 && std::hypot(side, z) <= 60;
}

/// Speckle of 1 to 120 where `inside`, 0 elsewhere.
template <typename Voxel>
std::vector<Voxel> speckle(const VolumeGeometry& geometry, const Inside& inside, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::vector<Voxel> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const auto echo = static_cast<Voxel>(1 + random() % 120);
                if (inside(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)))
                    voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] = echo;
            }
    return voxels;
}

VolumeGeometry cubeOf(std::int64_t edge) {
    VolumeGeometry geometry;
    geometry.size = {edge, edge, edge};
    return geometry;
}

bool everywhere(double, double, double) { return true; }

/// Calls visit(offset, inside) for voxels at least `margin` away from the edge of the cone.
void awayFromEdge(const VolumeGeometry& geometry, double margin, const std::function<void(std::int64_t, bool)>& visit) {
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const auto in = [&](double dx, double dy, double dz) {
                    return inCone(static_cast<double>(x) + dx, static_cast<double>(y) + dy,
                                  static_cast<double>(z) + dz);
                };
                const bool here = in(0, 0, 0);
                if (in(margin, 0, 0) == here && in(-margin, 0, 0) == here && in(0, margin, 0) == here &&
                    in(0, -margin, 0) == here && in(0, 0, margin) == here && in(0, 0, -margin) == here)
                    visit(geometry.offset(x, y, z), here);
            }
}

template <typename Voxel>
class NoDataOfType : public testing::Test {};
using VoxelTypes = testing::Types<std::uint8_t, std::uint16_t, float>;
TYPED_TEST_SUITE(NoDataOfType, VoxelTypes);

TYPED_TEST(NoDataOfType, FindsTheOutsideOfACone) {
    const VolumeGeometry geometry = cubeOf(64);
    const auto mask = guessDataMask(Volume(geometry, speckle<TypeParam>(geometry, inCone)));
    ASSERT_EQ(mask.size(), static_cast<std::size_t>(geometry.voxelCount()));
    awayFromEdge(geometry, 2, [&](std::int64_t offset, bool inside) {
        ASSERT_EQ(mask[static_cast<std::size_t>(offset)], inside ? 1 : 0) << offset;
    });
}

/// Voxels that hold an echo and are marked as no data.
template <typename Voxel>
std::int64_t echoesLost(const std::vector<Voxel>& voxels, const DataMask& mask) {
    std::int64_t lost = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) lost += voxels[i] != 0 && mask[i] == 0;
    return lost;
}

TYPED_TEST(NoDataOfType, EveryEchoStays) {
    const VolumeGeometry geometry = cubeOf(64);
    auto voxels = speckle<TypeParam>(geometry, inCone);
    std::mt19937 random(3);
    awayFromEdge(geometry, 6, [&](std::int64_t offset, bool inside) {
        if (!inside && random() % 500 == 0) voxels[static_cast<std::size_t>(offset)] = 40;
    });
    const auto mask = guessDataMask(Volume(geometry, voxels));
    ASSERT_FALSE(mask.empty());
    EXPECT_EQ(echoesLost(voxels, mask), 0) << "lone echoes outside among them";
}

TEST(NoData, ThinWiresInEmptyWaterStay) {
    const VolumeGeometry geometry = cubeOf(64);
    const auto onWire = [](double x, double /*y*/, double z) { return std::fmod(x, 9) == 4 && std::fmod(z, 9) == 4; };
    EXPECT_TRUE(guessDataMask(Volume(geometry, speckle<std::uint8_t>(geometry, onWire))).empty())
        << "there is no sector, and the water is fluid";
    const auto voxels = speckle<std::uint8_t>(geometry, [&](double x, double y, double z) {
        return onWire(x, y, z) || std::hypot(std::hypot(x - 40, y - 30), z - 35) < 15;
    });
    const auto mask = guessDataMask(Volume(geometry, voxels));
    ASSERT_FALSE(mask.empty());
    EXPECT_EQ(echoesLost(voxels, mask), 0);
    EXPECT_EQ(mask[static_cast<std::size_t>(geometry.offset(0, 0, 0))], 0);
}

TEST(NoData, AGuessCanBeTakenBackAndWhatIsKnownStays) {
    const VolumeGeometry geometry = cubeOf(64);
    auto voxels = speckle<float>(geometry, inCone);
    const Volume clean(geometry, voxels);
    const auto hole = static_cast<std::size_t>(geometry.offset(32, 32, 40));
    voxels[hole] = NAN;
    const Volume holed(geometry, voxels);
    EXPECT_TRUE(dataMaskWithoutGuess(clean.withDataMask(guessDataMask(clean))).empty());
    EXPECT_EQ(dataMaskWithoutGuess(holed.withDataMask(guessDataMask(holed))), holed.dataMask());
    EXPECT_TRUE(dataMaskWithoutGuess(clean).empty());
}

TEST(NoData, FluidInsideTheSectorStaysData) {
    const VolumeGeometry geometry = cubeOf(64);
    auto voxels = speckle<std::uint8_t>(geometry, inCone);
    std::vector<std::size_t> fluid;
    for (std::int64_t z = 0; z < 64; ++z)
        for (std::int64_t y = 0; y < 64; ++y)
            for (std::int64_t x = 0; x < 64; ++x)
                if (std::hypot(std::hypot(x - 30.0, y - 33.0), z - 40.0) < 10)
                    fluid.push_back(static_cast<std::size_t>(geometry.offset(x, y, z)));
    for (const std::size_t offset : fluid) voxels[offset] = 0;
    // A duct one voxel wide leads from the fluid out of the sector.
    for (std::int64_t x = 30; x < 64; ++x) voxels[static_cast<std::size_t>(geometry.offset(x, 33, 40))] = 0;
    const auto mask = guessDataMask(Volume(geometry, voxels));
    ASSERT_FALSE(mask.empty());
    for (const std::size_t offset : fluid) ASSERT_EQ(mask[offset], 1);
}

TEST(NoData, TheZerosAroundLoneEchoesStayOutside) {
    const VolumeGeometry geometry = cubeOf(64);
    auto voxels = speckle<std::uint8_t>(geometry, inCone);
    std::mt19937 random(3);
    std::int64_t outside = 0;
    awayFromEdge(geometry, 6, [&](std::int64_t offset, bool inside) {
        if (!inside && random() % 500 == 0) voxels[static_cast<std::size_t>(offset)] = 40;
    });
    const auto mask = guessDataMask(Volume(geometry, voxels));
    ASSERT_FALSE(mask.empty());
    std::int64_t kept = 0;
    awayFromEdge(geometry, 2, [&](std::int64_t offset, bool inside) {
        if (inside || voxels[static_cast<std::size_t>(offset)] != 0) return;
        ++outside;
        kept += mask[static_cast<std::size_t>(offset)];
    });
    EXPECT_LT(kept, outside / 500) << "but for zeros that are shut in between echoes";
}

TEST(NoData, JoinsWhatIsKnownToBeNoData) {
    const VolumeGeometry geometry = cubeOf(64);
    auto voxels = speckle<float>(geometry, inCone);
    const auto hole = static_cast<std::size_t>(geometry.offset(32, 32, 40));
    const auto outside = static_cast<std::size_t>(geometry.offset(1, 1, 1));
    voxels[hole] = NAN;
    voxels[outside] = NAN;
    const auto mask = guessDataMask(Volume(geometry, voxels));
    ASSERT_FALSE(mask.empty());
    EXPECT_EQ(mask[hole], 0);
    EXPECT_EQ(mask[outside], 0);
    EXPECT_EQ(mask[hole + 1], 1);
}

TEST(NoData, SpeckleWithoutASectorHasNone) {
    const VolumeGeometry geometry = cubeOf(48);
    EXPECT_TRUE(guessDataMask(Volume(geometry, speckle<std::uint8_t>(geometry, everywhere))).empty());
    // The echoes are so weak that six of ten voxels are clipped to 0, all of them connected to the border.
    auto weak = speckle<std::uint8_t>(geometry, everywhere);
    for (std::uint8_t& voxel : weak) voxel = voxel > 72 ? static_cast<std::uint8_t>(voxel - 72) : std::uint8_t{0};
    EXPECT_TRUE(guessDataMask(Volume(geometry, weak)).empty());
}

TEST(NoData, PhantomsHaveNone) {
    for (const PhantomScene scene : {PhantomScene::shapes, PhantomScene::fetus, PhantomScene::empty})
        for (const double decibel : {0.0, 50.0}) {
            PhantomConfig config;
            config.scene = scene;
            config.size = {64, 60, 66};
            config.speckle = 1.0;
            config.logCompressDecibel = decibel;
            EXPECT_TRUE(guessDataMask(*makePhantom(config)).empty()) << nameOf(scene) << " " << decibel;
        }
}

TEST(NoData, AnechoicFluidAtTheBorderIsFluid) {
    const VolumeGeometry geometry = cubeOf(64);
    // Half a ball of exact zeros lies against one face: it is 3 % of the volume and solid, but no sector leaves its
    // corners full.
    auto voxels = speckle<std::uint8_t>(
        geometry, [](double x, double y, double z) { return std::hypot(std::hypot(x - 32, y - 32), z) > 17; });
    EXPECT_TRUE(guessDataMask(Volume(geometry, voxels)).empty());
    // A corner of zeros is too small to matter.
    voxels = speckle<std::uint8_t>(geometry, [](double x, double y, double z) { return x > 12 || y > 12 || z > 12; });
    EXPECT_TRUE(guessDataMask(Volume(geometry, voxels)).empty());
    // A skin of zeros, one voxel thin, lies on all six faces.
    voxels = speckle<std::uint8_t>(geometry, [](double x, double y, double z) {
        return std::min({x, y, z}) > 0 && std::max({x, y, z}) < 63;
    });
    const auto skin = guessDataMask(Volume(geometry, voxels));
    if (!skin.empty()) {
        EXPECT_EQ(skin[static_cast<std::size_t>(geometry.offset(1, 1, 1))], 1) << "nothing beyond the skin is taken";
    }
}

TEST(NoData, NothingButZerosHasNoOutside) {
    const VolumeGeometry geometry = cubeOf(20);
    EXPECT_TRUE(guessDataMask(Volume(geometry, std::vector<std::uint8_t>(8000, 0))).empty());
    EXPECT_TRUE(guessDataMask(Volume(geometry, std::vector<float>(8000, 0.0f))).empty());
    std::vector<std::uint8_t> almost(8000, 0);
    almost[4210] = 9;
    EXPECT_TRUE(guessDataMask(Volume(geometry, almost)).empty()) << "one echo is no sector";
}

TEST(NoData, WhereThereIsNoOutsideTheVolumesOwnMaskStays) {
    const VolumeGeometry geometry = cubeOf(20);
    std::vector<float> voxels(8000, 0.5f);
    voxels[4210] = NAN;
    const Volume volume(geometry, voxels);
    ASSERT_FALSE(volume.hasData(4210));
    EXPECT_EQ(guessDataMask(volume), volume.dataMask());
}

TEST(NoData, ThinAndTinyVolumes) {
    for (const auto& size : {std::array<std::int64_t, 3>{1, 1, 1}, {1, 40, 30}, {130, 1, 1}, {70, 66, 1}, {2, 2, 2}}) {
        VolumeGeometry geometry;
        geometry.size = size;
        for (const int value : {0, 7}) {
            const Volume volume(geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()),
                                                                    static_cast<std::uint8_t>(value)));
            EXPECT_TRUE(guessDataMask(volume).empty());
        }
    }
}

}  // namespace
}  // namespace echolucent
