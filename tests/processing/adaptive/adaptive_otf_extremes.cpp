// Every extreme ends in a curve or a sentence, never in NaN; with every reading, interface function and form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/tube_core/basis_function.h"
#include "processing/tube_core/ramp.h"
#include "processing/tube_core/tube_weights.h"
#include "tests/processing/tube_core/plane_detection.h"

namespace echolucent {
namespace {

void expectSoundTube(const TubeCore& tube) {
    EXPECT_TRUE(std::isfinite(tube.d));
    EXPECT_GE(tube.d, 0.0);
    for (const double weight : {tube.intensityWeight, tube.slopeWeight, tube.extraWeight}) {
        EXPECT_GE(weight, 0.0);
        EXPECT_LE(weight, 1.0);
    }
    for (const auto& value : {tube.lowIntensity, tube.highIntensity, tube.lowIntensityMax, tube.slope}) {
        EXPECT_EQ(value.has_value(), tube.status == TubeStatus::surface);
        EXPECT_TRUE(!value || std::isfinite(*value));
    }
    for (const auto& value : {tube.edgeToNoise, tube.contrast}) EXPECT_TRUE(!value || std::isfinite(*value));
    for (const float value : tube.interfaceFunction) EXPECT_TRUE(std::isfinite(value));
    for (const float value : tube.cellMeans) EXPECT_TRUE(value >= 0.0f && value <= 1.0f);
    if (tube.status != TubeStatus::surface) {
        EXPECT_EQ(tube.d, 0.0);
    }
}

void expectSound(const AdaptiveOtf& result) {
    ASSERT_EQ(result.logOpacity.size(), 256u);
    ASSERT_EQ(result.curve.opacities.size(), 256u);
    for (std::size_t i = 0; i < 256; ++i) {
        EXPECT_FALSE(std::isnan(result.logOpacity[i]));
        EXPECT_LT(result.logOpacity[i], std::numeric_limits<double>::infinity());
        EXPECT_GE(result.curve.opacities[i], 0.0);
        EXPECT_LE(result.curve.opacities[i], 1.0);
    }
    EXPECT_TRUE(result.trust >= 0.0 && result.trust <= 1.0);
    EXPECT_TRUE(std::isfinite(result.dMax));
    for (const TubeCore& tube : result.tubes) expectSoundTube(tube);
    if (result.tubesWithWeight > 0) return;
    // What cannot be computed is said, and the curve is the one that was asked for to begin with.
    EXPECT_NE(result.message.find("the initial function is used."), std::string::npos) << result.message;
    EXPECT_TRUE(!result.message.empty() && std::isupper(static_cast<unsigned char>(result.message.front())) != 0);
    const auto initial = sampledOpacities(result.config.initial, 256);
    for (std::size_t i = 0; i < 256; ++i) EXPECT_NEAR(result.curve.opacities[i], initial[i], 1e-15);
}

struct Named {
    std::string name;
    AdaptiveOtfConfig config;
};

/// The three readings, and both interface functions with both forms.
const std::vector<Named>& configs() {
    static const std::vector<Named> all = [] {
        std::vector<Named> made;
        for (const MethodReading reading :
             {MethodReading::asPublished, MethodReading::settled, MethodReading::standard})
            made.push_back({std::string(nameOf(reading)), configOf(reading)});
        for (const DetectionRule& detection : {DetectionRule(VarianceRule{}), DetectionRule(RatioRule{})})
            for (const CurveRule& curve : {CurveRule(ProductRule{}), CurveRule(RampRule{})}) {
                AdaptiveOtfConfig config;
                config.detection = detection;
                config.curve = curve;
                made.push_back({std::string(std::holds_alternative<RatioRule>(detection) ? "ratio, " : "variance, ") +
                                    (std::holds_alternative<RampRule>(curve) ? "ramp" : "product"),
                                config});
            }
        return made;
    }();
    return all;
}

using Check = std::function<void(const AdaptiveOtf&, const AdaptiveOtfConfig&)>;

/// Runs every config, changed by `change`, along the beam and obliquely.
void forEveryConfig(const Volume& volume, const Check& check = {},
                    const std::function<void(AdaptiveOtfConfig&)>& change = {},
                    const std::vector<Viewpoint>& views = {Viewpoint{},
                                                           Viewpoint{.azimuthDegrees = 31, .elevationDegrees = 12}}) {
    for (const Named& named : configs())
        for (const Viewpoint& view : views) {
            SCOPED_TRACE(named.name + ", azimuth " + std::to_string(view.azimuthDegrees));
            AdaptiveOtfConfig config = named.config;
            if (change) change(config);
            const AdaptiveOtf result = adapted(volume, view, config);
            expectSound(result);
            if (check) check(result, config);
        }
}

Volume constantVolume(std::array<std::int64_t, 3> size, std::uint8_t value) {
    VolumeGeometry geometry;
    geometry.size = size;
    return Volume(geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()), value));
}

bool isCircular(const AdaptiveOtfConfig& config) {
    const auto* variance = std::get_if<VarianceRule>(&config.detection);
    return variance != nullptr && variance->border == TubeBorder::circular;
}

void expectNoSurface(const AdaptiveOtf& result, const AdaptiveOtfConfig& config) {
    EXPECT_EQ(result.tubesWithWeight, 0);
    // Interpolation rounds, so where a plain volume is not met on its voxels, rounding may pose as a surface.
    if (result.view == Viewpoint{} && !isCircular(config)) {
        EXPECT_EQ(result.message, "No surface found: the initial function is used.");
    }
}

TEST(AdaptiveOtfExtremes, ConstantVolumesHaveNoSurface) {
    for (const int value : {0, 77, 255})
        forEveryConfig(constantVolume({60, 50, 70}, static_cast<std::uint8_t>(value)), expectNoSurface);
}

TEST(AdaptiveOtfExtremes, ConstantVolumesOf16BitsAndFloatsHaveNoSurface) {
    VolumeGeometry geometry;
    geometry.size = {50, 50, 60};
    const auto count = static_cast<std::size_t>(geometry.voxelCount());
    for (const std::uint16_t value : {0, 1, 65000, 65535})
        forEveryConfig(Volume(geometry, std::vector<std::uint16_t>(count, value), 65535.0), expectNoSurface);
    for (const float value : {0.0f, -3.0f, 1e-38f, 0.1f, 7.25f, 3e38f})
        forEveryConfig(Volume(geometry, std::vector<float>(count, value)), expectNoSurface);
}

TEST(AdaptiveOtfExtremes, SmallAndThinVolumes) {
    for (const std::array<std::int64_t, 3>& size : std::initializer_list<std::array<std::int64_t, 3>>{{1, 1, 1},
                                                                                                      {2, 2, 2},
                                                                                                      {1, 40, 50},
                                                                                                      {40, 1, 50},
                                                                                                      {40, 50, 1},
                                                                                                      {1, 1, 50},
                                                                                                      {1, 50, 1},
                                                                                                      {50, 1, 1},
                                                                                                      {4, 4, 4},
                                                                                                      {5, 5, 5},
                                                                                                      {3, 3, 200},
                                                                                                      {6, 6, 11}})
        forEveryConfig(constantVolume(size, 9), {}, {},
                       {Viewpoint{}, Viewpoint{.beamAxis = BeamAxis::minusX}, Viewpoint{.beamAxis = BeamAxis::plusY},
                        Viewpoint{.azimuthDegrees = 45, .elevationDegrees = 30}});
    for (const Named& named : configs())
        EXPECT_FALSE(adapted(constantVolume({1, 1, 1}, 9), {}, named.config).message.empty()) << named.name;
}

TEST(AdaptiveOtfExtremes, ThinVolumesWithASurfaceAcross) {
    for (const std::array<std::int64_t, 3>& size : std::initializer_list<std::array<std::int64_t, 3>>{
             {1, 90, 90}, {90, 1, 90}, {4, 60, 90}, {3, 3, 120}, {90, 90, 4}}) {
        PlaneVolume plane;
        plane.size = size;
        plane.distanceMm = static_cast<double>(size[2]) / 2;
        forEveryConfig(plane.make(), {}, {},
                       {Viewpoint{}, Viewpoint{.beamAxis = BeamAxis::plusX}, Viewpoint{.beamAxis = BeamAxis::minusY}});
    }
}

TEST(AdaptiveOtfExtremes, OneBrightVoxel) {
    VolumeGeometry geometry;
    geometry.size = {60, 60, 60};
    const auto at = static_cast<std::size_t>(geometry.offset(30, 30, 30));
    std::vector<std::uint8_t> bytes(60 * 60 * 60, 0);
    bytes[at] = 255;
    forEveryConfig(Volume(geometry, bytes));
    std::vector<float> floats(60 * 60 * 60, 0.0f);
    floats[at] = 1e30f;
    forEveryConfig(Volume(geometry, floats));
}

TEST(AdaptiveOtfExtremes, NotFiniteVoxels) {
    PlaneVolume plane;
    auto voxels = plane.voxels<float>();
    for (std::size_t i = 0; i < voxels.size(); i += 97)
        voxels[i] = i % 2 ? std::nanf("") : -std::numeric_limits<float>::infinity();
    forEveryConfig(Volume(plane.geometry(), voxels, 255.0), [&](const AdaptiveOtf& result, const AdaptiveOtfConfig& c) {
        if (isCircular(c) || result.view.azimuthDegrees != 0.0) return;
        const Found found = tubesOnPlane(result, plane, 3.0);
        EXPECT_GT(found.of, 100);
        EXPECT_EQ(found.right, found.of) << "holes of no data make no difference";
    });
    forEveryConfig(Volume(plane.geometry(), std::vector<float>(voxels.size(), std::nanf(""))),
                   [](const AdaptiveOtf& result, const AdaptiveOtfConfig&) {
                       EXPECT_EQ(result.message, "No tube core meets the volume's data: the initial function is used.");
                   });
}

TEST(AdaptiveOtfExtremes, AnAbsurdVoxelIsNoWhiteLevel) {
    PlaneVolume plane;
    auto voxels = plane.voxels<float>();
    const Volume clean(plane.geometry(), voxels);
    for (std::size_t i = 4999; i < voxels.size(); i += 9973) voxels[i] = 3e38f;
    const Volume spoilt(plane.geometry(), voxels);
    EXPECT_EQ(spoilt.whiteLevel(), clean.whiteLevel());
    forEveryConfig(spoilt);
    const Found found = tubesOnPlane(adapted(spoilt), plane, 3.0);
    EXPECT_GT(found.of, 100);
    EXPECT_GE(found.right, 0.9 * found.of);
}

TEST(AdaptiveOtfExtremes, OneTubeSaysThatNoneStandsOut) {
    PlaneVolume plane;
    plane.noise = 1;
    forEveryConfig(
        plane.make(),
        [](const AdaptiveOtf& result, const AdaptiveOtfConfig&) {
            EXPECT_EQ(result.tubes.size(), 1u);
            EXPECT_EQ(result.tubes[0].status, TubeStatus::surface);
        },
        [](AdaptiveOtfConfig& config) { config.grid.columns = config.grid.rows = 1; }, {Viewpoint{}});
}

TEST(AdaptiveOtfExtremes, AllTubesEqual) {
    PlaneVolume plane;
    plane.noise = 0;
    forEveryConfig(plane.make(), [](const AdaptiveOtf& result, const AdaptiveOtfConfig&) {
        if (result.view != Viewpoint{}) return;
        for (const TubeCore& tube : result.tubes) EXPECT_EQ(tube.d, result.tubes[0].d) << "equal tubes, equal weights";
    });
}

TEST(AdaptiveOtfExtremes, FallingInterfacesWeighNothing) {
    PlaneVolume plane;
    plane.fluid = 150;
    plane.tissue = 20;
    forEveryConfig(plane.make(), [](const AdaptiveOtf& result, const AdaptiveOtfConfig& config) {
        if (isCircular(config) || result.view.azimuthDegrees != 0.0) return;
        for (const TubeCore& tube : result.tubes) EXPECT_EQ(tube.d, 0.0);
    });
}

TEST(AdaptiveOtfExtremes, StrengthsFromNothingToHuge) {
    const PlaneVolume plane;
    const Volume volume = plane.make();
    forEveryConfig(
        volume,
        [](const AdaptiveOtf& result, const AdaptiveOtfConfig&) {
            EXPECT_EQ(result.tubesWithWeight, 0);
            EXPECT_EQ(result.message, "The strength is 0: the initial function is used.");
        },
        [](AdaptiveOtfConfig& config) { config.curve = ProductRule{0}; }, {Viewpoint{}});
    forEveryConfig(
        volume, [](const AdaptiveOtf& result, const AdaptiveOtfConfig&) { EXPECT_DOUBLE_EQ(result.dMax, 1e6); },
        [](AdaptiveOtfConfig& config) { config.curve = ProductRule{225e6}; }, {Viewpoint{}});
    // These are the largest and smallest parameters that are allowed, and opacities of nothing and of far too much.
    for (const double strength : {5e-324, 1e12})
        for (const double scale : {0.0, 1e-300, 1e6})
            forEveryConfig(volume, {},
                           [&](AdaptiveOtfConfig& config) {
                               config.curve = ProductRule{strength};
                               config.initial = PowerCurve{4, scale};
                           },
                           {Viewpoint{}});
}

TEST(AdaptiveOtfExtremes, SpacingOfOneToFifty) {
    PlaneVolume plane;
    plane.size = {60, 50, 12};
    plane.spacing = {0.1, 0.1, 5.0};
    plane.distanceMm = 30;
    plane.rampMm = 2;
    forEveryConfig(plane.make(), {}, [](AdaptiveOtfConfig& config) { config.grid.columns = config.grid.rows = 4; },
                   {Viewpoint{}, Viewpoint{.beamAxis = BeamAxis::plusY, .azimuthDegrees = 3}});
    plane.size = {12, 50, 60};
    plane.spacing = {5.0, 0.1, 0.1};
    plane.distanceMm = 3;
    plane.rampMm = 0.3;
    forEveryConfig(plane.make(), {}, [](AdaptiveOtfConfig& config) { config.grid.columns = config.grid.rows = 4; });
}

TEST(AdaptiveOtfExtremes, ASurfaceOfOneUlp) {
    // Float voxels lie a single ulp apart: variance and rise are next to nothing, but not nothing.
    PlaneVolume plane;
    std::vector<float> voxels(static_cast<std::size_t>(plane.geometry().voxelCount()), 0.5f);
    std::fill(voxels.begin() + static_cast<std::ptrdiff_t>(voxels.size() / 2), voxels.end(),
              std::nextafter(0.5f, 1.0f));
    forEveryConfig(Volume(plane.geometry(), voxels, 1.0));
    for (float& voxel : voxels) voxel *= 1e-38f;
    forEveryConfig(Volume(plane.geometry(), voxels, 1.0));
}

TEST(AdaptiveOtfExtremes, FloatsOfAnyMagnitude) {
    // Their squares, or their ratios, leave the range of single precision.
    PlaneVolume plane;
    plane.size = {80, 80, 80};
    plane.distanceMm = 40;
    const auto voxels = plane.voxels<float>();
    const auto scaled = [&](double scale) {
        std::vector<float> made(voxels.size());
        std::transform(voxels.begin(), voxels.end(), made.begin(),
                       [scale](float voxel) { return static_cast<float>(voxel * scale); });
        return Volume(plane.geometry(), made, 255.0 * scale);
    };
    for (const Named& named : configs())
        for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 14, .elevationDegrees = 5}}) {
            const AdaptiveOtf usual = adapted(scaled(1.0), view, named.config);
            for (const double scale : {0x1p-119, 0x1p-60, 0x1p60, 0x1p119}) {
                SCOPED_TRACE(named.name + ", azimuth " + std::to_string(view.azimuthDegrees) + ", scale " +
                             std::to_string(std::log2(scale)));
                const AdaptiveOtf result = adapted(scaled(scale), view, named.config);
                expectSound(result);
                EXPECT_EQ(result.tubesWithWeight, usual.tubesWithWeight);
                for (std::size_t i = 0; i < 256; ++i)
                    EXPECT_NEAR(result.curve.opacities[i], usual.curve.opacities[i], 1e-6);
            }
        }
}

TEST(AdaptiveOtfExtremes, HighIntensityEqualToLowOrOneUlpAbove) {
    for (const double low : {0.0, 1e-300, 0.1, 0.5, 1.0}) {
        std::vector<TubeCore> tubes(8);
        for (std::size_t t = 0; t < tubes.size(); ++t) {
            tubes[t].status = TubeStatus::surface;
            tubes[t].lowIntensity = low;
            tubes[t].highIntensity = t % 2 == 0 ? low : std::nextafter(low, 2.0);
            tubes[t].lowIntensityMax = low * static_cast<double>(t + 1) / 16.0;
            tubes[t].slope = static_cast<double>(t + 1);
            tubes[t].edgeToNoise = 10.0;
        }
        tubes.resize(16);  // the others meet the volume without a surface
        for (std::size_t t = 8; t < 16; ++t) tubes[t].status = TubeStatus::none;
        weighTubes(tubes, 1e6, 4.0, {});
        tubes.resize(8);
        for (std::size_t t = 0; t < tubes.size(); ++t) EXPECT_EQ(tubes[t].d > 0.0, t % 2 == 1) << low << " " << t;
        const auto logOpacity = adaptedLogOpacity(PowerCurve{2, 1.0}, tubes, 256);
        const auto ramp = meanRamp(tubes, RampRule{}, 256);
        for (std::size_t i = 0; i < 256; ++i) {
            const double x = static_cast<double>(i) / 255;
            EXPECT_FALSE(std::isnan(logOpacity[i]));
            EXPECT_TRUE(ramp[i] >= 0.0 && ramp[i] <= 1.0) << low << " " << i;
            // Only the intensity itself is met by a basis function this narrow.
            if (i > 0 && std::abs(x - low) > 1e-9) {
                EXPECT_DOUBLE_EQ(logOpacity[i], 2 * std::log(x));
            }
        }
    }
}

TEST(AdaptiveOtfExtremes, AViewBesideTheVolumeMeetsNothing) {
    const PlaneVolume plane;
    forEveryConfig(plane.make(),
                   [](const AdaptiveOtf& result, const AdaptiveOtfConfig&) { EXPECT_EQ(result.tubesMeetingVolume, 0); },
                   {}, {withFrontAcross({}, 1e6)});
}

}  // namespace
}  // namespace echolucent
