// Every extreme ends in a curve or a sentence, never in NaN.
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "plane_detection.h"
#include "processing/adaptive_otf.h"

namespace echolucent {
namespace {

void expectSound(const AdaptiveOtf& result) {
    ASSERT_EQ(result.logOpacity.size(), 256u);
    ASSERT_EQ(result.curve.opacities.size(), 256u);
    for (std::size_t i = 0; i < 256; ++i) {
        EXPECT_FALSE(std::isnan(result.logOpacity[i]));
        EXPECT_GE(result.curve.opacities[i], 0.0);
        EXPECT_LE(result.curve.opacities[i], 1.0);
    }
    for (const TubeCore& tube : result.tubes) {
        EXPECT_TRUE(std::isfinite(tube.d));
        EXPECT_GE(tube.d, 0.0);
        EXPECT_GE(tube.intensityWeight, 0.0);
        for (const auto& value : {tube.lowIntensity, tube.highIntensity, tube.lowIntensityMax, tube.slope}) {
            EXPECT_EQ(value.has_value(), tube.status == TubeStatus::surface);
            EXPECT_TRUE(!value || std::isfinite(*value));
        }
        for (const float value : tube.interfaceFunction) EXPECT_TRUE(std::isfinite(value));
    }
    EXPECT_EQ(result.message.empty(), result.tubesWithSurface > 0);
    if (result.tubesWithSurface == 0) {
        EXPECT_NE(result.message.find("the initial function is used."), std::string::npos);
        const auto initial = sampledOpacities(result.config.initial, 256);
        for (std::size_t i = 0; i < 256; ++i) EXPECT_NEAR(result.curve.opacities[i], initial[i], 1e-15);
    }
}

Volume constantVolume(std::array<std::int64_t, 3> size, std::uint8_t value) {
    VolumeGeometry geometry;
    geometry.size = size;
    return Volume(geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()), value));
}

TEST(AdaptiveOtfExtremes, ConstantVolumesHaveNoSurface) {
    for (const int value : {0, 77, 255})
        for (const View& view : {View{}, View{.azimuthDegrees = 31, .elevationDegrees = 12}}) {
            const AdaptiveOtf result = adapted(constantVolume({60, 50, 70}, static_cast<std::uint8_t>(value)), view);
            expectSound(result);
            if (view == View{}) {
                EXPECT_EQ(result.message, "No surface found: the initial function is used.");
            }
            EXPECT_EQ(result.tubesWithSurface, 0);
        }
}

TEST(AdaptiveOtfExtremes, SmallVolumes) {
    for (const std::array<std::int64_t, 3>& size : std::initializer_list<std::array<std::int64_t, 3>>{
             {1, 1, 1}, {1, 40, 50}, {40, 1, 50}, {40, 50, 1}, {4, 4, 4}, {5, 5, 5}, {3, 3, 200}, {6, 6, 11}})
        for (const View& view :
             {View{}, View{.beamAxis = BeamAxis::minusX}, View{.azimuthDegrees = 45, .elevationDegrees = 30}})
            expectSound(adapted(constantVolume(size, 9), view));
    EXPECT_FALSE(adapted(constantVolume({1, 1, 1}, 9)).message.empty());
}

TEST(AdaptiveOtfExtremes, OneBrightVoxel) {
    VolumeGeometry geometry;
    geometry.size = {60, 60, 60};
    std::vector<std::uint8_t> voxels(60 * 60 * 60, 0);
    voxels[static_cast<std::size_t>(geometry.offset(30, 30, 30))] = 255;
    expectSound(adapted(Volume(geometry, voxels)));
}

TEST(AdaptiveOtfExtremes, NotFiniteVoxels) {
    PlaneVolume plane;
    auto voxels = plane.voxels<float>();
    for (std::size_t i = 0; i < voxels.size(); i += 97)
        voxels[i] = i % 2 ? std::nanf("") : -std::numeric_limits<float>::infinity();
    const Volume volume(plane.geometry(), voxels, 255.0);
    for (const View& view : {View{}, View{.azimuthDegrees = 12}}) {
        const AdaptiveOtf result = adapted(volume, view);
        expectSound(result);
        const Found found = tubesOnPlane(result, plane, 3.0);
        EXPECT_EQ(found.right, found.of);
    }
    expectSound(adapted(Volume(plane.geometry(), std::vector<float>(voxels.size(), std::nanf("")))));
}

TEST(AdaptiveOtfExtremes, OneTubeOrAllTubesEqualSayThatNoneStandsOut) {
    PlaneVolume plane;
    plane.noise = 0;
    AdaptiveOtfConfig one;
    one.tubeColumns = one.tubeRows = 1;
    for (const AdaptiveOtf& result : {adapted(plane.make(), {}, one), adapted(plane.make())}) {
        expectSound(result);
        EXPECT_EQ(result.tubes[0].status, TubeStatus::surface);
        EXPECT_EQ(result.tubesWithSurface, 0) << "inclusive ranks: the largest prior maximum weighs 0";
        EXPECT_NE(result.message.find("do not differ enough to weigh them"), std::string::npos);
    }
}

TEST(AdaptiveOtfExtremes, FallingInterfacesWeighNothing) {
    PlaneVolume plane;
    plane.fluid = 150;
    plane.tissue = 20;
    const AdaptiveOtf result = adapted(plane.make());
    expectSound(result);
    for (const TubeCore& tube : result.tubes) EXPECT_EQ(tube.d, 0.0);
}

TEST(AdaptiveOtfExtremes, StrengthsFromNothingToHuge) {
    const PlaneVolume plane;
    AdaptiveOtfConfig config;
    config.strength = 0;
    const AdaptiveOtf none = adapted(plane.make(), {}, config);
    expectSound(none);
    EXPECT_EQ(none.message, "The strength is 0: the initial function is used.");
    config.strength = 225e6;
    const AdaptiveOtf huge = adapted(plane.make(), {}, config);
    expectSound(huge);
    EXPECT_DOUBLE_EQ(huge.dMax, 1e6);
}

TEST(AdaptiveOtfExtremes, SpacingOfOneToFifty) {
    PlaneVolume plane;
    plane.size = {60, 50, 12};
    plane.spacing = {0.1, 0.1, 5.0};
    plane.distanceMm = 30;
    plane.rampMm = 2;
    AdaptiveOtfConfig config;
    config.tubeColumns = config.tubeRows = 4;
    expectSound(adapted(plane.make(), {}, config));
    expectSound(adapted(plane.make(), View{.beamAxis = BeamAxis::plusY, .azimuthDegrees = 3}, config));
}

}  // namespace
}  // namespace echolucent
