// The aim of the curve: the ramp that shows every surface found, and what lies between it and the mean of the ramps.
#include "processing/adaptive/found_ramp.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <limits>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/comparison/classification_measures.h"
#include "processing/phantom/phantom.h"
#include "processing/sampling/sampler.h"
#include "processing/speckle_reduction/speckle_reduction.h"

namespace echolucent {
namespace {

constexpr float noData = std::numeric_limits<float>::quiet_NaN();

/// Fluid, then a wall from sample `surface` on.
AxisProfile wallAt(int surface, float fluid, float wall, int count) {
    AxisProfile profile{std::vector<float>(static_cast<std::size_t>(count), fluid), static_cast<double>(surface)};
    for (int i = surface; i < count; ++i) profile.intensities[static_cast<std::size_t>(i)] = wall;
    return profile;
}

double rightOf(const AxisProfile& profile, const FoundRamp& ramp) { return shownRight(std::span(&profile, 1), ramp); }

TEST(FoundRamp, IsClearThenRisesThenFull) {
    const FoundRamp ramp{0.2, 0.6, 0.5};
    EXPECT_EQ(opacityAt(ramp, 0.2), 0.0);
    EXPECT_EQ(opacityAt(ramp, 0.1), 0.0);
    EXPECT_NEAR(opacityAt(ramp, 0.3), 0.125, 1e-15);
    EXPECT_EQ(opacityAt(ramp, 0.6), 0.5);
    EXPECT_EQ(opacityAt(ramp, 1.0), 0.5);
}

TEST(ShownRight, FallsFromTwoUnitsOnAndSoonerBeforeTheSurface) {
    // Half of the light is held back half way from the sample before the wall to its first: at 9.5 for a wall at 10.
    const FoundRamp opaque{0.3, 0.30001, 1.0};
    for (const auto& [surface, expected] :
         {std::pair{9.5, 1.0}, {11.5, 1.0}, {12.0, 0.5}, {12.5, 0.0}, {7.5, 1.0}, {5.5, 0.5}, {3.5, 0.0}}) {
        AxisProfile profile = wallAt(10, 0.1f, 0.5f, 20);
        profile.surface = surface;
        EXPECT_NEAR(rightOf(profile, opaque), expected, 1e-6) << surface;
    }
    EXPECT_EQ(rightOf(wallAt(10, 0.1f, 0.2f, 20), opaque), 0.0) << "half of the light comes through";
    EXPECT_EQ(shownRight({}, opaque), 0.0);
    const std::array<AxisProfile, 2> both{wallAt(10, 0.1f, 0.5f, 20), wallAt(10, 0.1f, 0.2f, 20)};
    EXPECT_NEAR(shownRight(both, opaque), 0.5, 1e-6);
}

TEST(ShownRight, AgreesWithTheMeasureOfComparedPictures) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {96, 96, 96};
    const Volume volume = *makePhantom(config);
    AdaptiveOtfConfig all;
    all.grid.columns = all.grid.rows = 19;
    const AdaptiveOtf otf = *adaptOpacity(volume, {}, all);
    const auto samples =
        samplesOf(tubeAxes(volume.geometry(), {}, all.grid, all.cells.size), volume.geometry(), {}, all.cells.size);
    const auto profiles = axisProfiles(volume, samples, otf.tubes, all.cells);
    ASSERT_GT(profiles.size(), 50u);
    for (const FoundRamp& ramp : {FoundRamp{0.15, 0.3, 0.6}, FoundRamp{0.05, 0.5, 0.3}, FoundRamp{0.3, 0.4, 1.0}}) {
        const OpacityCurve curve = ManualCurve{{{ramp.begin, 0.0}, {ramp.end, ramp.opacity}, {1.0, ramp.opacity}}};
        const OpacityTable table{Classification(curve)};
        double right = 0.0;
        for (const AxisProfile& profile : profiles) {
            RaySamples ray;
            ray.intensities.assign(profile.intensities.begin(), profile.intensities.end());
            const auto shown = shownSample(ray, table);
            right += shown && std::abs(*shown - profile.surface) <= rightUnits ? 1.0 : 0.0;
            // What counts fully here is what the measure calls right.
            const double own = rightOf(profile, ramp);
            const auto kind = shownSurfaceAt(shown ? std::optional(*shown - profile.surface) : std::nullopt);
            if (own > 0.999) {
                EXPECT_EQ(kind, ShownSurface::right);
            }
            if (kind == ShownSurface::right) {
                EXPECT_GT(own, 0.99);
            }
        }
        EXPECT_GT(right, 0.0);
    }
}

TubeCore tubeOf(double low, double high, double d) {
    TubeCore tube;
    tube.status = TubeStatus::surface;
    tube.lowIntensity = low;
    tube.highIntensity = high;
    tube.d = d;
    return tube;
}

TEST(RampForEveryWall, IsTheMeanOfAllRampsTriedByHowRightTheyShow) {
    std::vector<AxisProfile> profiles;
    for (int i = 0; i < 40; ++i) {
        AxisProfile profile =
            wallAt(20 + i, 0.1f + 0.002f * static_cast<float>(i), 0.3f + 0.01f * static_cast<float>(i), 20 + i + 7);
        profile.intensities[static_cast<std::size_t>(i) / 2] = noData;
        profiles.push_back(profile);
    }
    std::vector<TubeCore> tubes{tubeOf(0.1, 0.4, 0.01), tubeOf(0.16, 0.6, 0.02), tubeOf(0.9, 0.95, 0.0)};
    tubes[0].fluidSpread = 0.03;
    tubes[1].fluidSpread = 0.07;
    const double low = (0.1 + 0.16) / 2, rise = (0.4 + 0.6) / 2 - low;
    // Two spreads, (0.03 + 0.07) / 2 in the mean, reach farther than a quarter of the way.
    const double middle = low + 2 * 0.05;
    ASSERT_GT(middle, low + 0.25 * rise);
    double sum = 0.0, begin = 0.0, logOpacity = 0.0;
    for (int b = 0; b < 8; ++b)
        for (const double opacity : {1.0, 0.7, 0.5, 0.35}) {
            const double from = middle + 0.07 * (b - 3.5) * rise;
            const double weight = std::exp(shownRight(profiles, {from, from + 0.5 * rise, opacity}) / 0.6);
            sum += weight;
            begin += weight * from;
            logOpacity += weight * std::log(opacity);
        }
    const FoundRamp ramp = rampForEveryWall(profiles, tubes).value();
    EXPECT_NEAR(ramp.begin, begin / sum, 1e-5);
    EXPECT_NEAR(ramp.end - ramp.begin, 0.5 * rise, 1e-12);
    EXPECT_NEAR(ramp.opacity, std::exp(logOpacity / sum), 1e-5);
    for (TubeCore& tube : tubes) tube.fluidSpread.reset();  // detection by variance measures none
    EXPECT_LT(rampForEveryWall(profiles, tubes).value().begin, ramp.begin);
    EXPECT_FALSE(rampForEveryWall({}, tubes));
    EXPECT_FALSE(rampForEveryWall(profiles, std::vector<TubeCore>{tubeOf(0.9, 0.95, 0.0)}));
}

TEST(RampForEveryWall, OfExtremeProfilesIsARamp) {
    const std::vector<AxisProfile> extremes{wallAt(8, 0.0f, 1.0f, 15),
                                            wallAt(0, 1.0f, 1.0f, 1),
                                            {{}, 3.0},
                                            {std::vector<float>(300, noData), 290.5},
                                            wallAt(3000, 0.5f, 0.5f, 3007)};
    for (const auto& [low, high] :
         {std::pair{0.0, 1.0}, {0.5, std::nextafter(0.5, 1.0)}, {0.0, 1e-300}, {0.999, 1.0}}) {
        const std::vector<TubeCore> tubes{tubeOf(low, high, 1e-300)};
        for (const AxisProfile& one : extremes) {
            const FoundRamp ramp = rampForEveryWall(std::span(&one, 1), tubes).value();
            EXPECT_TRUE(std::isfinite(ramp.begin));
            EXPECT_GT(ramp.end, ramp.begin);
            EXPECT_GE(ramp.opacity, 0.35 * (1 - 1e-6));
            EXPECT_LE(ramp.opacity, 1.0);
        }
    }
}

struct Scan {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    std::optional<Volume> raw, quiet;
    Scan() {
        config.size = {128, 128, 128};
        config.seed = 29;
        raw = makePhantom(config);
        quiet = quietVolume(*raw, SpeckleReduction::medium);
    }
    [[nodiscard]] AdaptiveOtf aimed(double aim, const Viewpoint& view = {}) const {
        AdaptiveOtfConfig asked;
        std::get<RampRule>(asked.curve).aim = aim;
        return *adaptOpacity(*raw, view, asked, {}, {&*quiet, SpeckleReduction::medium});
    }
};
const Scan& scan() {
    static const Scan one;
    return one;
}

TEST(Aim, AtItsEndsIsTheMeanOfTheRampsAndTheRampFound) {
    EXPECT_EQ(scan().aimed(0.0).curve, adaptOpacity(*scan().raw, {}, configOf(MethodReading::firstVersion), {},
                                                    {&*scan().quiet, SpeckleReduction::medium})
                                           ->curve);
    EXPECT_FALSE(scan().aimed(0.0).everyWall);
    const AdaptiveOtf walls = scan().aimed(1.0);
    ASSERT_TRUE(walls.everyWall);
    ASSERT_EQ(walls.trust, 1.0);
    for (std::size_t i = 0; i < AdaptiveOtf::sampleCount; ++i)
        EXPECT_NEAR(walls.curve.opacities[i], opacityAt(*walls.everyWall, AdaptiveOtf::intensityOf(i)), 1e-12);
}

TEST(Aim, MovesNoSampleByMoreThanItMovesItself) {
    std::vector<double> before = scan().aimed(0.0).curve.opacities;
    double farthest = 0.0;
    for (int percent = 1; percent <= 100; percent += 9) {
        const auto after = scan().aimed(percent / 100.0).curve.opacities;
        const double step = percent == 1 ? 0.01 : 0.09;
        for (std::size_t i = 0; i < after.size(); ++i) {
            EXPECT_LE(std::abs(after[i] - before[i]), step + 1e-12);
            farthest = std::max(farthest, std::abs(after[i] - before[i]));
        }
        before = after;
    }
    EXPECT_GT(farthest, 0.01);
}

TEST(Aim, TradesBrightSurfacesForEveryWall) {
    const PhantomTruth truth(scan().config);
    const VolumeGeometry& geometry = scan().raw->geometry();
    std::vector<Classification> curves;
    for (const double aim : {0.0, 0.25, 0.5, 0.75, 1.0}) curves.emplace_back(scan().aimed(aim).curve);
    const auto rightOfAll = [&](InterfaceInto into) {
        std::vector<double> right;
        const auto measures = measuresOf(*scan().quiet, {}, trueSurfaces(geometry, truth, {}, into, 2.0), curves);
        for (const ClassificationMeasures& one : measures.value())
            right.push_back(one.depth.share(ShownSurface::right).value());
        return right;
    };
    const auto walls = rightOfAll(InterfaceInto::tissue), objects = rightOfAll(InterfaceInto::object);
    for (std::size_t i = 1; i < walls.size(); ++i) EXPECT_GT(walls[i], walls[i - 1]) << i;
    EXPECT_GT(walls.back(), walls.front() + 0.3);
    EXPECT_GT(objects.front(), 0.9);
    EXPECT_GT(objects.back(), 0.75);
}

TEST(Aim, HasTheSameBitsForAnyNumberOfThreads) {
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 23, .elevationDegrees = -14}}) {
        const AdaptiveOtf otf = scan().aimed(0.6, view);
        for (const std::size_t threads : {1u, 2u, 7u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const AdaptiveOtf again = scan().aimed(0.6, view);
            EXPECT_EQ(again.everyWall, otf.everyWall);
            EXPECT_EQ(again.curve, otf.curve);
        }
    }
}

TEST(AxisProfiles, AreTheSamplesOnTheAxesWhicheverRouteReadsThem) {
    for (const auto& [cellSize, precision] :
         {std::pair{4, Precision::single32}, {5, Precision::single32}, {5, Precision::double64}}) {
        AdaptiveOtfConfig config;
        config.cells.size = cellSize;
        config.cells.precision = precision;
        for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 20, .elevationDegrees = -12}}) {
            const AdaptiveOtf otf = *adaptOpacity(*scan().raw, view, config);
            const VolumeGeometry& geometry = scan().raw->geometry();
            const auto samples = samplesOf(tubeAxes(geometry, view, config.grid, cellSize), geometry, view, cellSize);
            const auto profiles = axisProfiles(*scan().quiet, samples, otf.tubes, config.cells);
            const VolumeSampler sampler(*scan().quiet);
            std::size_t place = 0;
            for (std::size_t t = 0; t < otf.tubes.size(); ++t) {
                if (!(otf.tubes[t].d > 0.0)) continue;
                const AxisProfile& profile = profiles.at(place++);
                const Vec3 surface = samples[t].onAxis(profile.surface), found = *otf.tubes[t].surfaceVoxel;
                for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(surface[axis], found[axis], 1e-9);
                EXPECT_LE(profile.intensities.size(), profile.surface + missedUnits + 2);
                for (std::size_t k = 0; k < profile.intensities.size(); k += 7)
                    EXPECT_NEAR(profile.intensities[k],
                                sampler.intensityAt(samples[t].onAxis(static_cast<double>(k))).value(), 2e-5);
            }
            EXPECT_EQ(place, profiles.size());
        }
    }
}

}  // namespace
}  // namespace echolucent
