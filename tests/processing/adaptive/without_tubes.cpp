// Tube cores that are never placed: all follows as if the grid had not held them.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "processing/adaptive/adapted_curve.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "processing/tube_core/tube_weights.h"
#include "tests/processing/tube_core/plane_detection.h"

namespace echolucent {
namespace {

/// A slanted, noisy plane: every tube core has ranks of its own.
PlaneVolume slantedPlane() {
    PlaneVolume plane;
    plane.normal = normalized(Vec3(0.5, 0.3, 1));
    plane.distanceMm = plane.normal.dot(plane.geometry().centreMm());
    plane.noise = 12;
    return plane;
}

AdaptiveOtfConfig without(AdaptiveOtfConfig config, std::vector<int> tubes) {
    config.grid.withoutTubes = std::move(tubes);
    return config;
}

void expectSameFinding(const TubeCore& one, const TubeCore& other, std::size_t tube) {
    EXPECT_EQ(one.column, other.column) << tube;
    EXPECT_EQ(one.row, other.row) << tube;
    EXPECT_EQ(one.status, other.status) << tube;
    EXPECT_EQ(one.surfaceCell, other.surfaceCell) << tube;
    EXPECT_EQ(one.intensityWeight, other.intensityWeight) << tube;
    EXPECT_EQ(one.slopeWeight, other.slopeWeight) << tube;
    EXPECT_EQ(one.extraWeight, other.extraWeight) << tube;
    EXPECT_EQ(one.d, other.d) << tube;
}

/// The volume in which the columns of these tube cores, seen along +z, hold no data.
Volume blindedFor(const PlaneVolume& plane, const AdaptiveOtfConfig& config, const std::vector<int>& tubes) {
    const Volume volume = plane.make();
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(volume.geometry().voxelCount()), 1);
    const auto axes = tubeAxes(volume.geometry(), {}, config.grid, config.cells.size);
    for (const int tube : tubes) {
        const Vec3 middle = volume.geometry().voxelFromGridMm(axes[static_cast<std::size_t>(tube)].pointMm);
        for (std::int64_t z = 0; z < volume.geometry().size[2]; ++z)
            for (int y = -2; y <= 2; ++y)
                for (int x = -2; x <= 2; ++x) {
                    const auto column = std::llround(middle[0]) + x, row = std::llround(middle[1]) + y;
                    mask[static_cast<std::size_t>(volume.geometry().offset(column, row, z))] = 0;
                }
    }
    return volume.withDataMask(std::move(mask));
}

TEST(WithoutTubes, AColumnThatSeesNothingGivesTheSameWeightsLevelsAndCurve) {
    const PlaneVolume plane = slantedPlane();
    const std::vector<int> left{0, 31, 112, 113, 224};
    for (const MethodReading reading : {MethodReading::asPublished, MethodReading::settled, MethodReading::standard}) {
        const AdaptiveOtfConfig config = configOf(reading);
        const AdaptiveOtf all = adapted(plane.make(), {}, config);
        const AdaptiveOtf blinded = adapted(blindedFor(plane, config, left), {}, config);
        const AdaptiveOtf otf = adapted(plane.make(), {}, without(config, left));
        ASSERT_GT(all.tubesWithWeight, 100) << nameOf(reading);
        EXPECT_EQ(otf.tubesMeetingVolume, 220);
        EXPECT_EQ(otf.tubesMeetingVolume, blinded.tubesMeetingVolume);
        EXPECT_EQ(otf.dMax, blinded.dMax);
        EXPECT_EQ(otf.leastContrast, blinded.leastContrast);
        EXPECT_EQ(otf.fluidIntensity, blinded.fluidIntensity);
        EXPECT_EQ(otf.curve, blinded.curve);
        EXPECT_NE(otf.curve, all.curve);
        for (std::size_t t = 0; t < otf.tubes.size(); ++t) expectSameFinding(otf.tubes[t], blinded.tubes[t], t);
    }
}

TEST(WithoutTubes, WeightsAndCurveAreThoseOfTheOthersAlone) {
    // By variance each tube core finds its surface alone, so that what the others found can be taken as it is.
    AdaptiveOtfConfig config;
    config.detection = VarianceRule{};
    config.curve = ProductRule{};
    const std::vector<int> left{17, 100, 101};
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 15, .rollDegrees = 7}}) {
        const Volume volume = slantedPlane().make();
        const AdaptiveOtf otf = adapted(volume, view, without(config, left));
        std::vector<TubeCore> others = adapted(volume, view, config).tubes;
        for (const int tube : left) {
            TubeCore& gone = others[static_cast<std::size_t>(tube)];
            ASSERT_GT(gone.d, 0.0);
            TubeCore unplaced;
            unplaced.column = gone.column;
            unplaced.row = gone.row;
            gone = unplaced;
        }
        const double dMax = paperStrength / tubesMeetingVolume(others);
        weighTubes(others, dMax, VarianceRule{}.leastEdgeToNoise, config.weights);
        EXPECT_EQ(otf.dMax, dMax);
        for (std::size_t t = 0; t < others.size(); ++t) expectSameFinding(otf.tubes[t], others[t], t);
        EXPECT_EQ(otf.curve, adaptedCurve(config.curve, config.initial, others, AdaptiveOtf::sampleCount).curve);
    }
}

TEST(WithoutTubes, RanksCountByTheEquationsAmongTheOthers) {
    const AdaptiveOtf otf = adapted(slantedPlane().make(), {}, without({}, {40, 41, 42, 43, 44}));
    const double n = otf.tubesMeetingVolume;
    EXPECT_EQ(n, 220);
    int compared = 0;
    for (const TubeCore& tube : otf.tubes) {
        if (tube.status != TubeStatus::surface) continue;
        int darker = 0, flatter = 0;
        for (const TubeCore& other : otf.tubes) {
            if (other.status != TubeStatus::surface) continue;
            darker += *other.lowIntensityMax <= *tube.lowIntensityMax ? 1 : 0;
            flatter += *other.slope > 0 && *other.slope <= *tube.slope ? 1 : 0;
        }
        EXPECT_NEAR(tube.intensityWeight, 1 - darker / n, 1e-15);
        EXPECT_NEAR(tube.slopeWeight, *tube.slope > 0 ? flatter / n : 0.0, 1e-15);
        ++compared;
    }
    EXPECT_GT(compared, 100);
    for (const std::size_t t : {40u, 44u}) {
        EXPECT_EQ(otf.tubes[t].status, TubeStatus::outside);
        EXPECT_EQ(otf.tubes[t].column, static_cast<int>(t % 15));
        EXPECT_EQ(otf.tubes[t].row, static_cast<int>(t / 15));
        EXPECT_FALSE(otf.tubes[t].entryVoxel);
        EXPECT_EQ(otf.tubes[t].d, 0.0);
    }
    EXPECT_GT(otf.tubes[39].d, 0.0);
}

TEST(WithoutTubes, QuietVoxelsAreReadAlongTheOthersAlone) {
    const PlaneVolume plane = slantedPlane();
    const Volume volume = plane.make(), quiet = *quietVolume(volume, SpeckleReduction::medium);
    const QuietVoxels shown{&quiet, SpeckleReduction::medium};
    const std::vector<int> left{2, 90, 133};
    const AdaptiveOtf blinded = *adaptOpacity(blindedFor(plane, {}, left), {}, {}, {}, shown);
    const AdaptiveOtf otf = *adaptOpacity(volume, {}, without({}, left), {}, shown);
    EXPECT_LT(otf.speckleLeft.value(), 0.9);
    EXPECT_EQ(otf.speckleLeft, blinded.speckleLeft);
    EXPECT_EQ(otf.curve, blinded.curve);
    EXPECT_NE(otf.curve, adaptOpacity(volume, {}, {}, {}, shown)->curve);
}

TEST(WithoutTubes, ThatMissTheVolumeAnywayChangeNothing) {
    AdaptiveOtfConfig config;
    config.grid = {.columns = 9, .rows = 9, .spacing = 14};
    const Volume volume = slantedPlane().make();
    const AdaptiveOtf all = adapted(volume, {}, config);
    std::vector<int> outside;
    for (int t = 0; t < 81; ++t)
        if (all.tubes[static_cast<std::size_t>(t)].status == TubeStatus::outside) outside.push_back(t);
    ASSERT_GT(outside.size(), 20u);
    const AdaptiveOtf otf = adapted(volume, {}, without(config, outside));
    EXPECT_EQ(otf.curve, all.curve);
    EXPECT_EQ(otf.dMax, all.dMax);
    for (std::size_t t = 0; t < otf.tubes.size(); ++t) expectSameFinding(otf.tubes[t], all.tubes[t], t);
}

TEST(WithoutTubes, NoneAtAllIsTheInitialFunctionAndSaysSo) {
    AdaptiveOtfConfig config;
    config.grid = {.columns = 3, .rows = 2, .spacing = 20};
    const AdaptiveOtf otf = adapted(slantedPlane().make(), {}, without(config, {0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(otf.message, "No tube core is placed: the initial function is used.");
    EXPECT_EQ(otf.tubesMeetingVolume, 0);
    EXPECT_EQ(otf.curve.opacities, sampledOpacities(config.initial, AdaptiveOtf::sampleCount));
}

TEST(WithoutTubes, OutsideTheGridIsRefused) {
    const Volume volume = slantedPlane().make();
    for (const std::vector<int>& wrong : {std::vector{225}, std::vector{-1}, std::vector{4, 4}, std::vector{5, 4}})
        EXPECT_THROW((void)adaptOpacity(volume, {}, without({}, wrong)), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
