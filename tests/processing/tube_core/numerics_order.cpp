// The curve has the same bits for any number of threads and any order of the tube cores.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "plane_detection.h"
#include "processing/adaptive/method_reading.h"
#include "processing/phantom/phantom.h"
#include "processing/phantom/splitmix.h"
#include "processing/tube_core/basis_function.h"
#include "processing/tube_core/ramp.h"

namespace echolucent {
namespace {

/// Everything a result holds except its times, bit by bit, in one row of bytes.
class Bits {
public:
    explicit Bits(const AdaptiveOtf& otf) {
        add(otf.tubeSpacingUnits);
        add(otf.directionVoxel);
        add(otf.tubeLengthUnit, otf.tubesMeetingVolume, otf.tubesWithWeight, otf.dMax, otf.trust);
        add(otf.leastContrast, otf.fluidIntensity);
        addAll(otf.logOpacity);
        addAll(otf.curve.opacities);
        addAll(otf.message);
        for (const TubeCore& tube : otf.tubes) add(tube);
    }
    [[nodiscard]] const std::string& bytes() const { return m_bytes; }

private:
    template <typename... Values>
    requires(std::is_trivially_copyable_v<Values>&&...) void add(const Values&... values) {
        (m_bytes.append(reinterpret_cast<const char*>(&values), sizeof(values)), ...);
    }
    void add(const Vec3& values) { add(values[0], values[1], values[2]); }
    template <typename... Values>
    void add(const std::optional<Values>&... values) {
        ((values ? add(*values) : add(char{0})), ...);
    }
    template <typename Sequence>
    void addAll(const Sequence& values) {
        add(values.size());
        for (const auto& value : values) add(value);
    }
    void add(const TubeCore& tube) {
        add(tube.firstSampleVoxel);
        add(tube.column, tube.row, tube.status, tube.firstCell, tube.surfaceCell);
        add(tube.entryVoxel, tube.surfaceVoxel);
        add(tube.lowIntensity, tube.highIntensity, tube.lowIntensityMax, tube.slope, tube.edgeToNoise, tube.contrast);
        add(tube.fluidSpread);
        add(tube.intensityWeight, tube.slopeWeight, tube.extraWeight, tube.d);
        addAll(tube.cellMeans);
        addAll(tube.interfaceFunction);
        addAll(tube.trackedCells);
    }

    std::string m_bytes;
};

std::string bitsOn(std::size_t threads, const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return Bits(adapted(volume, view, config)).bytes();
}

struct Named {
    std::string name;
    AdaptiveOtfConfig config;
};

/// The configs are those of the readings, and both interface functions with both forms.
std::vector<Named> allConfigs() {
    std::vector<Named> configs;
    for (const MethodReading reading : {MethodReading::asPublished, MethodReading::settled})
        configs.push_back({std::string(nameOf(reading)), configOf(reading)});
    for (const DetectionRule& detection : {DetectionRule(VarianceRule{}), DetectionRule(RatioRule{})})
        for (const CurveRule& curve : {CurveRule(ProductRule{}), CurveRule(RampRule{})}) {
            AdaptiveOtfConfig config;
            config.detection = detection;
            config.curve = curve;
            configs.push_back({std::string(std::holds_alternative<RatioRule>(detection) ? "ratio" : "variance") +
                                   (std::holds_alternative<RampRule>(curve) ? ", ramp" : ", product"),
                               config});
        }
    return configs;
}

/// A phantom of one kind of voxels.
Volume phantomOf(int bits) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {70, 66, 84};
    config.seed = 12;
    config.bits = bits == 8 ? 8 : 16;
    Volume stored = *makePhantom(config);
    if (bits != 32) return stored;
    std::vector<float> voxels(static_cast<std::size_t>(stored.geometry().voxelCount()));
    for (std::size_t i = 0; i < voxels.size(); ++i)
        voxels[i] = static_cast<float>(stored.storedValue(static_cast<std::int64_t>(i)) / 37.0);
    return Volume(stored.geometry(), voxels, stored.whiteLevel() / 37.0);
}

TEST(SameBits, WithOneTwoAndSevenThreads) {
    for (const int bits : {8, 16, 32}) {
        const Volume volume = phantomOf(bits);
        for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 24, .elevationDegrees = -13}})
            for (const Named& named : allConfigs()) {
                const std::string one = bitsOn(1, volume, view, named.config);
                EXPECT_GT(one.size(), 90000u);
                for (const std::size_t threads : {2u, 7u})
                    EXPECT_EQ(one == bitsOn(threads, volume, view, named.config), true)
                        << bits << " bits, azimuth " << view.azimuthDegrees << ", " << named.name << ", " << threads
                        << " threads";
            }
    }
}

/// Tubes whose d, I_L and I_H are often the same as another's, one or two at a time.
std::vector<TubeCore> tubesWithTies(std::size_t count) {
    std::vector<TubeCore> tubes(count);
    for (std::size_t t = 0; t < count; ++t) {
        tubes[t].status = TubeStatus::surface;
        tubes[t].d = 0.003 * static_cast<double>(splitmix64(3 * t) % 40);
        tubes[t].lowIntensity = 0.3 * static_cast<double>(splitmix64(3 * t + 1) % 11) / 11.0;
        tubes[t].highIntensity = *tubes[t].lowIntensity + 0.05 * static_cast<double>(1 + splitmix64(3 * t + 2) % 9);
    }
    return tubes;
}

TEST(SameBits, WhateverTheOrderOfTheTubes) {
    for (const std::size_t count : {std::size_t{225}, std::size_t{20000}}) {
        std::vector<TubeCore> tubes = tubesWithTies(count);
        const auto product = adaptedLogOpacity(PowerCurve{2, 0.7}, tubes, 256);
        const auto ramp = meanRamp(tubes, RampRule{}, 256);
        std::mt19937 random(4);
        for (int turn = 0; turn < 5; ++turn) {
            std::shuffle(tubes.begin(), tubes.end(), random);
            EXPECT_EQ(adaptedLogOpacity(PowerCurve{2, 0.7}, tubes, 256), product);
            EXPECT_EQ(meanRamp(tubes, RampRule{}, 256), ramp);
        }
    }
}

TEST(SameBits, AnIntensitysValueDoesNotDependOnThoseBesideIt) {
    // Few samples fill vectors otherwise than many do; i / 15 = 17 i / 255, so both curves have these intensities.
    const auto tubes = tubesWithTies(225);
    const auto few = adaptedLogOpacity(PowerCurve{2, 0.7}, tubes, 16);
    const auto many = adaptedLogOpacity(PowerCurve{2, 0.7}, tubes, 256);
    int compared = 0;
    for (std::size_t i = 0; i < 16; ++i) {
        if (static_cast<double>(i) / 15 != static_cast<double>(17 * i) / 255) continue;
        EXPECT_EQ(few[i], many[17 * i]);
        ++compared;
    }
    EXPECT_GT(compared, 8);
}

}  // namespace
}  // namespace echolucent
