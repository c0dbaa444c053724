#include "processing/adaptive/adaptive_otf.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "processing/adaptive/method_parameters.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "tests/processing/tube_core/plane_detection.h"

namespace echolucent {
namespace {

/// The paper's interface function and product, with what the program adds to them.
AdaptiveOtfConfig productOfVariance() {
    AdaptiveOtfConfig config;
    config.detection = VarianceRule{};
    config.curve = ProductRule{};
    config.surface.lowReach = 0;
    config.surface.highReach = 0;
    return config;
}

TEST(AdaptiveOtf, FindsASlantedPlaneInAnAnisotropicVolumeAtItsDepthInMm) {
    PlaneVolume plane;
    plane.size = {120, 60, 50};
    plane.spacing = {0.5, 1.0, 1.5};
    plane.normal = normalized(Vec3(0.2, -0.15, 1.0));
    plane.distanceMm = plane.normal.dot(plane.geometry().centreMm());
    for (const Viewpoint& view :
         {Viewpoint{}, Viewpoint{.azimuthDegrees = 20, .elevationDegrees = -15}, withFrontAcross({}, 6)}) {
        const Found found = tubesOnPlane(adapted(plane.make(), view), plane, 3.0);
        EXPECT_GT(found.of, 80);
        EXPECT_EQ(found.right, found.of);
    }
}

TEST(AdaptiveOtf, FindsAPlaneAlongEveryBeamAxisAndObliquely) {
    for (int beam = 0; beam < 6; ++beam)
        for (const double angle : {0.0, 25.0}) {
            const Viewpoint view{
                .beamAxis = static_cast<BeamAxis>(beam), .azimuthDegrees = angle, .elevationDegrees = -angle / 2};
            PlaneVolume plane;
            plane.normal = frameOf(Viewpoint{.beamAxis = view.beamAxis}).forward;
            plane.distanceMm = plane.normal.dot(plane.geometry().centreMm());
            const AdaptiveOtf result = adapted(plane.make(), view);
            const Found found = tubesOnPlane(result, plane, 3.0);
            EXPECT_GT(found.of, 100);
            EXPECT_EQ(found.right, found.of) << "beam " << beam << " angle " << angle;
            EXPECT_TRUE(result.message.empty());
        }
}

TEST(AdaptiveOtf, MeasuresTheIntensitiesOnBothSidesInUnits) {
    PlaneVolume plane;
    plane.noise = 0.7;
    const AdaptiveOtf result = adapted(plane.make(), {}, productOfVariance());
    EXPECT_EQ(result.tubesMeetingVolume, 225);
    EXPECT_DOUBLE_EQ(result.dMax, 6.75 / 225);
    for (const TubeCore& tube : result.tubes) {
        ASSERT_EQ(tube.status, TubeStatus::surface);
        EXPECT_NEAR(*tube.lowIntensity, 14 / 255.0, 0.003);
        EXPECT_NEAR(*tube.lowIntensityMax, 14 / 255.0, 0.01);
        EXPECT_NEAR(*tube.highIntensity, 67 / 255.0, 0.08) << "the middle of the ramp";
        EXPECT_NEAR(*tube.slope, 106 / 255.0 / 10, 0.003) << "the whole step over +-5 units";
        EXPECT_NEAR((*tube.surfaceVoxel)[2], 50, 1);
        EXPECT_EQ((*tube.surfaceVoxel)[2], tube.surfaceCell + 2.0) << "the cell's centre";
    }
    EXPECT_LT(result.curve.opacities[14], 14.0 * 14 / 255 / 255) << "lowered where the fluid is";
    EXPECT_GT(result.curve.opacities[67], 67.0 * 67 / 255 / 255) << "raised where the surface is";
}

TEST(AdaptiveOtf, ScalingTheStoredValuesChangesNothingButTheirScale) {
    const PlaneVolume plane;
    const AdaptiveOtf bytes = adapted(plane.make());
    std::vector<std::uint16_t> sixteenfold;
    for (const std::uint8_t value : plane.voxels<std::uint8_t>())
        sixteenfold.push_back(static_cast<std::uint16_t>(16 * value));
    const AdaptiveOtf words = adapted(Volume(plane.geometry(), std::move(sixteenfold), 255 * 16.0));
    const AdaptiveOtf floats = adapted(Volume(plane.geometry(), plane.voxels<float>(0.5), 255 * 0.5));
    for (std::size_t i = 0; i < 256; ++i) EXPECT_NEAR(words.curve.opacities[i], bytes.curve.opacities[i], 1e-9);
    for (std::size_t t = 0; t < bytes.tubes.size(); ++t) {
        EXPECT_EQ(words.tubes[t].surfaceCell, bytes.tubes[t].surfaceCell);
        // A scale of 0.5 rounds half the values: they are not the same, but the surfaces are.
        EXPECT_NEAR(floats.tubes[t].surfaceCell, bytes.tubes[t].surfaceCell, 1);
    }
}

TEST(AdaptiveOtf, FollowsFromThePublishedTubesByEquations4To11) {
    PlaneVolume plane;
    plane.normal = normalized(Vec3(0.5, 0.3, 1));
    plane.distanceMm = plane.normal.dot(plane.geometry().centreMm());
    plane.noise = 20;
    AdaptiveOtfConfig config = productOfVariance();
    config.initial = PowerCurve{2, 0.7};
    const AdaptiveOtf result = adapted(plane.make(), Viewpoint{.azimuthDegrees = 10}, config);
    const double n = result.tubesMeetingVolume;
    int compared = 0;
    for (const TubeCore& tube : result.tubes) {
        if (tube.status != TubeStatus::surface) {
            EXPECT_EQ(tube.d, 0.0);
            continue;
        }
        int lowerMaxima = 0, lowerSlopes = 0;
        for (const TubeCore& other : result.tubes) {
            if (other.status != TubeStatus::surface) continue;
            lowerMaxima += *other.lowIntensityMax <= *tube.lowIntensityMax ? 1 : 0;
            lowerSlopes += *other.slope > 0 && *other.slope <= *tube.slope ? 1 : 0;
        }
        const long double wI = 1 - lowerMaxima / static_cast<long double>(n);
        const long double wS = *tube.slope > 0 ? lowerSlopes / static_cast<long double>(n) : 0;
        const bool standsOut =
            tube.edgeToNoise.value_or(0) >= std::get<VarianceRule>(result.config.detection).leastEdgeToNoise;
        const long double extra = *tube.highIntensity > *tube.lowIntensity && standsOut ? 1 : 0;
        EXPECT_NEAR(tube.d, static_cast<double>(6.75L / n * wI * wS * extra), 1e-17);
        ++compared;
    }
    EXPECT_GT(compared, 100);
    for (int i = 1; i < 256; ++i) {
        const long double x = i / 255.0L;
        long double sum = std::log(0.7L * x * x), size = std::abs(sum);
        for (const TubeCore& tube : result.tubes) {
            if (!(tube.d > 0)) continue;
            const long double low = *tube.lowIntensity, high = *tube.highIntensity;
            const long double b = 2 / ((high - low) * (high - low)), c = 1 / std::sqrt(2 * b) + low;
            const long double g =
                std::sqrt(2 * b * std::numbers::e_v<long double>) * (x - c) * std::exp(-b * (x - c) * (x - c));
            sum += std::log1p(static_cast<long double>(tube.d)) * g;
            size += std::abs(std::log1p(static_cast<long double>(tube.d)) * g);
        }
        EXPECT_NEAR(result.logOpacity[static_cast<std::size_t>(i)], static_cast<double>(sum),
                    1e-12 * std::max(1.0, static_cast<double>(size)));
        EXPECT_NEAR(result.curve.opacities[static_cast<std::size_t>(i)],
                    std::min(1.0, static_cast<double>(std::exp(sum))), 1e-12);
    }
}

TEST(AdaptiveOtf, PriorCellsEndBeforeTheSurfaceCellBegins) {
    // I_L and the largest prior mean are found by counting over the published cell means (which are floats).
    PlaneVolume plane;
    plane.noise = 10;
    const AdaptiveOtf result = adapted(plane.make(), {}, productOfVariance());
    for (const TubeCore& tube : result.tubes) {
        double sum = 0, largest = 0;
        int count = 0;
        for (int i = tube.firstCell; i + 5 <= tube.surfaceCell; ++i, ++count) {
            const double mean = tube.cellMeans[static_cast<std::size_t>(i)];
            sum += mean;
            largest = std::max(largest, mean);
        }
        EXPECT_NEAR(*tube.lowIntensity, sum / count, 1e-7);
        EXPECT_NEAR(*tube.lowIntensityMax, largest, 1e-7);
        EXPECT_EQ(tube.trackedCells.size(), 6u);
        EXPECT_EQ(tube.trackedCells.back(), tube.surfaceCell);
        EXPECT_EQ(tube.cellMeans.size(), 96u) << "cells slide by one unit";
        EXPECT_EQ(tube.interfaceFunction.size(), 96u);
    }
}

TEST(AdaptiveOtf, BeginsBehindTheNearCut) {
    // A wall stands in front: uncut, it is among the prior cells; cut, only fluid is left before the plane.
    PlaneVolume plane;
    plane.noise = 1;
    auto voxels = plane.voxels<std::uint8_t>();
    std::fill(voxels.begin(), voxels.begin() + 100 * 100 * 12, std::uint8_t{60});
    const Volume volume(plane.geometry(), voxels);
    const AdaptiveOtf uncut = adapted(volume), cut = adapted(volume, withFrontAcross({}, 14));
    for (std::size_t t = 0; t < cut.tubes.size(); ++t) {
        EXPECT_GT(*uncut.tubes[t].lowIntensityMax, 0.2);
        ASSERT_EQ(cut.tubes[t].status, TubeStatus::surface);
        EXPECT_LT(*cut.tubes[t].lowIntensityMax, 0.1);
        EXPECT_NEAR((*cut.tubes[t].entryVoxel)[2], 13.5, 1e-9);
        EXPECT_EQ(cut.tubes[t].firstSampleVoxel[2], 14.0);
        EXPECT_NEAR((*cut.tubes[t].surfaceVoxel)[2], 50, 3);
    }
}

TEST(AdaptiveOtf, LeavesOutNoDataAndBeginsAtTheFirstData) {
    PlaneVolume plane;
    plane.fluid = 40;
    plane.noise = 1;
    auto voxels = plane.voxels<std::uint8_t>();
    std::vector<std::uint8_t> mask(voxels.size(), 1);
    std::fill(voxels.begin(), voxels.begin() + 100 * 100 * 20, std::uint8_t{0});
    std::fill(mask.begin(), mask.begin() + 100 * 100 * 20, std::uint8_t{0});
    for (std::size_t z = 0; z < 100; ++z)  // and a column without data at all: 40 x 40 voxels
        for (std::size_t y = 0; y < 40; ++y)
            for (std::size_t x = 0; x < 40; ++x) mask[x + 100 * (y + 100 * z)] = 0;
    const Volume posing(plane.geometry(), voxels), volume = posing.withDataMask(mask);
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 8}}) {
        const AdaptiveOtf result = adapted(volume, view);
        int outside = 0;
        for (const TubeCore& tube : result.tubes) {
            if (tube.status == TubeStatus::outside) {
                ++outside;
                EXPECT_FALSE(tube.entryVoxel);
                continue;
            }
            if (!(tube.d > 0)) continue;
            if (view == Viewpoint{}) {
                EXPECT_EQ(tube.firstCell, 20);
            }
            EXPECT_NEAR(*tube.lowIntensity, 40 / 255.0, 0.01) << "the zeros in front are no fluid";
        }
        EXPECT_GT(outside, 15);
        EXPECT_EQ(result.tubesMeetingVolume, 225 - outside);
    }
    EXPECT_LT(*adapted(posing, {}, productOfVariance()).tubes[224].lowIntensity, 30 / 255.0);
}

TEST(AdaptiveOtf, GivesTheSameBitsOnAnyNumberOfThreads) {
    PlaneVolume plane;
    plane.noise = 25;
    const Volume volume = plane.make();
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 17, .elevationDegrees = 9}}) {
        std::optional<AdaptiveOtf> first;
        for (const std::size_t threads : {1u, 2u, 7u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const AdaptiveOtf result = adapted(volume, view);
            if (!first) first = result;
            EXPECT_EQ(result.logOpacity, first->logOpacity);
            for (std::size_t t = 0; t < result.tubes.size(); ++t) {
                EXPECT_EQ(result.tubes[t].d, first->tubes[t].d);
                EXPECT_EQ(result.tubes[t].surfaceCell, first->tubes[t].surfaceCell);
                EXPECT_EQ(result.tubes[t].cellMeans, first->tubes[t].cellMeans);
            }
        }
    }
}

TEST(AdaptiveOtf, TheCurveDependsLittleOnTheNumberOfTubes) {
    const PlaneVolume plane;
    AdaptiveOtfConfig many;
    many.grid.columns = many.grid.rows = 45;
    many.grid.spacing = 2;
    const AdaptiveOtf few = adapted(plane.make()), dense = adapted(plane.make(), {}, many);
    for (std::size_t i = 0; i < 256; ++i) EXPECT_NEAR(dense.curve.opacities[i], few.curve.opacities[i], 0.03);
}

TEST(AdaptiveOtf, StopsWhenCancelled) {
    const PlaneVolume plane;
    const std::atomic<bool> cancel = true;
    EXPECT_FALSE(adaptOpacity(plane.make(), {}, {}, Progress{{}, &cancel}));
}

TEST(AdaptiveOtf, ReportsProgressThatRisesToOneAndTimesOfEveryStage) {
    const Volume volume = PlaneVolume{}.make();
    // Only the caller's thread reports, and others may do all the work.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    for (const DetectionRule& detection : {DetectionRule(VarianceRule{}), DetectionRule(RatioRule{})}) {
        AdaptiveOtfConfig config;
        config.detection = detection;
        std::vector<double> shares;
        const AdaptiveOtf otf =
            *adaptOpacity(volume, {}, config, Progress{[&](double share) { shares.push_back(share); }, nullptr});
        ASSERT_GT(shares.size(), 5u) << "both ways of detecting say how far they are";
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
        EXPECT_EQ(shares.back(), 1.0);
        const StageTimes& times = otf.times;
        double sum = 0.0;
        for (const double time : {times.sampling, times.cells, times.detection, times.weights, times.curve}) {
            EXPECT_GT(time, 0.0);
            sum += time;
        }
        EXPECT_LE(sum, times.total);
    }
}

TEST(AdaptiveOtf, RefusesAConfigOutOfRange) {
    const Volume volume(VolumeGeometry{}, std::vector<std::uint8_t>{1});
    const auto wrong = [](auto change) {
        AdaptiveOtfConfig config;
        change(config);
        return config;
    };
    const auto variance = [](VarianceRule rule) {
        AdaptiveOtfConfig config;
        config.detection = rule;
        return config;
    };
    const double nan = std::nan("");
    for (const auto& config :
         {wrong([](auto& c) { c.grid.columns = 0; }), wrong([](auto& c) { c.grid.rows = -1; }),
          wrong([](auto& c) { c.grid.columns = c.grid.rows = 4096; }), wrong([](auto& c) { c.cells.size = 33; }),
          wrong([&](auto& c) { c.grid.spacing = nan; }), wrong([](auto& c) { c.surface.slopeHalfStep = 0; }),
          wrong([](auto& c) { c.curve = RampRule{.begin = 1.0, .end = 1.0}; }),
          wrong([&](auto& c) { c.curve = ProductRule{.strength = nan}; }), variance({.coarsestScale = 2}),
          variance({.sigmaPerKernelSize = nan})}) {
        EXPECT_FALSE(problemOf(config).empty());
        EXPECT_THROW((void)adaptOpacity(volume, {}, config), std::invalid_argument);
    }
    EXPECT_TRUE(problemOf(AdaptiveOtfConfig{}).empty());
}

}  // namespace
}  // namespace echolucent
