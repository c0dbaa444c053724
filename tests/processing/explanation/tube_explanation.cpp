#include "processing/explanation/tube_explanation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "processing/adaptive/halved_lengths.h"
#include "processing/intensity/no_data.h"
#include "processing/sampling/interpolation.h"
#include "processing/tube_core/slabs/tube_samples.h"
#include "tests/processing/explanation/explained_scan.h"
#include "tests/processing/grids.h"
#include "tests/processing/tube_core/plane_volume.h"

namespace echolucent {
namespace {

void expectSameCurve(const ExplainedCurve& explained, const AdaptiveOtf& otf, int number) {
    EXPECT_EQ(explained.curve, otf.curve) << number;
    EXPECT_EQ(explained.tubesWithWeight, otf.tubesWithWeight) << number;
    EXPECT_EQ(explained.trust, otf.trust) << number;
    EXPECT_EQ(explained.message, otf.message) << number;
}

TEST(TubeExplanation, WithoutIsTheRunThatNeverPlacesTheTubeCoreToTheBit) {
    std::mt19937 random(36);
    for (const ExplainedRun* run : {&publishedRun(), &defaultRun()}) {
        std::vector<int> numbers(run->otf.tubes.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        std::shuffle(numbers.begin(), numbers.end(), random);
        ASSERT_GT(run->otf.tubesWithWeight, 30);
        int moved = 0;
        for (const int number : std::span(numbers).first(50)) {
            const TubeExplanation explained = run->explained(number);
            AdaptiveOtfConfig config = run->otf.config;
            config.grid.withoutTubes = {number};
            const AdaptiveOtf without = *adaptOpacity(explainedScan(), run->otf.view, config, {}, run->shown);
            expectSameCurve(explained.without, without, number);
            expectSameCurve(explained.full, run->otf, number);
            moved += explained.without.curve != explained.full.curve ? 1 : 0;
        }
        EXPECT_GT(moved, 25);
    }
}

TEST(TubeExplanation, OfATubeCoreThatIsNeverPlacedTheCurveWithoutItIsTheRuns) {
    AdaptiveOtfConfig config = configWithout({}, 40);
    EXPECT_EQ(configWithout(config, 40), config);
    EXPECT_EQ(configWithout(config, 12).grid.withoutTubes, (std::vector{12, 40}));
    const ExplainedRun run(config);
    const TubeExplanation explained = run.explained(40);
    EXPECT_EQ(explained.state, TubeState::neverPlaced);
    EXPECT_EQ(explained.without.curve, run.otf.curve);
    EXPECT_EQ(explained.alone.curve.opacities, explained.initial);
    EXPECT_FALSE(explained.factor);
    EXPECT_TRUE(explained.axis.read.empty());
    config.grid = {.columns = 9, .rows = 8, .spacing = 0, .withoutTubes = {12, 40}};
    EXPECT_EQ(run.explained(12).without.curve, adaptOpacity(explainedScan(), {}, config)->curve);
}

TEST(TubeExplanation, OfTheProductAloneIsTheInitialFunctionTimesItsFactor) {
    int compared = 0;
    for (std::size_t t = 0; t < publishedRun().otf.tubes.size(); t += 3) {
        const TubeExplanation explained = publishedRun().explained(static_cast<int>(t));
        const TubeCore& tube = explained.tube;
        if (!explained.factor) {
            EXPECT_EQ(explained.alone.curve.opacities, explained.initial) << t;
            continue;
        }
        ++compared;
        for (std::size_t i = 0; i < explained.initial.size(); ++i) {
            const double x = AdaptiveOtf::intensityOf(i), low = *tube.lowIntensity, high = *tube.highIntensity;
            const double b = 2.0 / ((high - low) * (high - low)), c = 1.0 / std::sqrt(2.0 * b) + low;
            const double g = std::sqrt(2.0 * b * std::exp(1.0)) * (x - c) * std::exp(-b * (x - c) * (x - c));
            const double factor = std::pow(1.0 + tube.d, g);
            ASSERT_NEAR(explained.factor->values[i], factor, 1e-12) << t;
            ASSERT_NEAR(explained.alone.curve.opacities[i], std::min(1.0, explained.initial[i] * factor), 1e-12) << t;
        }
    }
    EXPECT_GT(compared, 10);
}

TEST(TubeExplanation, OfTheRampAloneIsItsRampMixedWithTheRampForItsOwnSurface) {
    const ExplainedRun bright(configOf(MethodReading::firstVersion), explainedQuiet());
    const int heaviest = heaviestFirst(bright.otf).front();
    const TubeExplanation explained = bright.explained(heaviest);
    ASSERT_TRUE(explained.factor && explained.ramp && explained.quiet);
    EXPECT_EQ(explained.alone.trust, 1.0);
    for (std::size_t i = 0; i < explained.initial.size(); ++i) {
        const double x = AdaptiveOtf::intensityOf(i);
        const double risen =
            std::clamp((x - explained.ramp->begin) / (explained.ramp->full - explained.ramp->begin), 0.0, 1.0);
        ASSERT_NEAR(explained.factor->values[i], risen, 1e-12);
        ASSERT_NEAR(explained.alone.curve.opacities[i], risen, 1e-12) << "of an aim of 0 nothing is mixed in";
    }
    const TubeExplanation mixed = defaultRun().explained(heaviestFirst(defaultRun().otf).front());
    const double aim = RampRule{}.aim;
    // The ramp for every wall of this axis alone, read in the quiet voxels.
    AxisProfile axis{{mixed.axis.shown.begin(), mixed.axis.shown.end()},
                     mixed.tube.surfaceCell + (mixed.config.cells.size - 1) / 2.0};
    axis.intensities.resize(static_cast<std::size_t>(axis.surface + missedUnits) + 1);
    const TubeCore tube = curveTubeOf(defaultRun().otf, static_cast<std::size_t>(mixed.number));
    const auto wall = rampForEveryWall({&axis, 1}, {&tube, 1});
    ASSERT_TRUE(wall);
    double largest = 0.0;
    for (std::size_t i = 0; i < mixed.initial.size(); ++i) {
        const double x = AdaptiveOtf::intensityOf(i);
        const double ofWall = wall->opacity * std::clamp((x - wall->begin) / (wall->end - wall->begin), 0.0, 1.0);
        ASSERT_NEAR(mixed.alone.curve.opacities[i], (1.0 - aim) * mixed.factor->values[i] + aim * ofWall, 1e-6)
            << "the profile is read in single precision";
        largest = std::max(largest, std::abs(ofWall - mixed.factor->values[i]));
    }
    EXPECT_GT(largest, 0.05) << "the two ramps are not the same";
}

TEST(TubeExplanation, TellsWhichCellsWereRead) {
    for (const ExplainedRun* run : {&publishedRun(), &defaultRun()}) {
        int compared = 0;
        for (std::size_t t = 0; t < run->otf.tubes.size(); t += 5) {
            const TubeExplanation explained = run->explained(static_cast<int>(t));
            const TubeCore& tube = explained.tube;
            if (tube.status != TubeStatus::surface) continue;
            ++compared;
            const CellsRead& cells = explained.cells;
            const auto means = [&](const IndexRange& range) {
                return std::span(tube.cellMeans)
                    .subspan(static_cast<std::size_t>(range.first),
                             static_cast<std::size_t>(range.last - range.first + 1));
            };
            const auto low = means(cells.low), prior = means(cells.prior), high = means(cells.high);
            EXPECT_EQ(cells.tube.first, tube.firstCell);
            EXPECT_NEAR(std::accumulate(low.begin(), low.end(), 0.0) / static_cast<double>(low.size()),
                        *tube.lowIntensity, 1e-6);
            EXPECT_NEAR(*std::max_element(prior.begin(), prior.end()), *tube.lowIntensityMax, 1e-6);
            EXPECT_NEAR(*std::max_element(high.begin(), high.end()), *tube.highIntensity, 1e-6);
            EXPECT_NEAR(tube.cellMeans[static_cast<std::size_t>(cells.lowMaxCell)], *tube.lowIntensityMax, 1e-6);
            EXPECT_NEAR(tube.cellMeans[static_cast<std::size_t>(cells.highCell)], *tube.highIntensity, 1e-6);
            EXPECT_NEAR(
                (means(cells.slope).back() - means(cells.slope).front()) / (cells.slope.last - cells.slope.first),
                *tube.slope, 1e-6);
        }
        EXPECT_GT(compared, 5);
    }
}

TEST(TubeExplanation, SlabsAndAxisAreTheTubeCoresOwn) {
    const int number = heaviestFirst(publishedRun().otf)[3];
    const TubeExplanation explained = publishedRun().explained(number);
    const TubeCore& tube = explained.tube;
    const int size = explained.config.cells.size;
    ASSERT_EQ(explained.axis.slabMeans.size(), tube.cellMeans.size() + static_cast<std::size_t>(size) - 1);
    for (int cell = explained.cells.tube.first; cell <= explained.cells.tube.last; ++cell) {
        const auto first = explained.axis.slabMeans.begin() + cell;
        EXPECT_NEAR(std::accumulate(first, first + size, 0.0) / size, tube.cellMeans[static_cast<std::size_t>(cell)],
                    1e-6);
    }
    const Volume& scan = explainedScan();
    for (std::size_t k = 0; k < explained.axis.read.size(); ++k) {
        const Vec3 at = tube.firstSampleVoxel + publishedRun().otf.directionVoxel * static_cast<double>(k);
        const auto offset = scan.geometry().offset(std::llround(at[0]), std::llround(at[1]), std::llround(at[2]));
        EXPECT_NEAR(explained.axis.read[k], scan.storedValue(offset) / scan.whiteLevel(), 1e-12) << k;
    }
    EXPECT_TRUE(explained.axis.shown.empty());
    const TubeExplanation quiet = defaultRun().explained(number);
    ASSERT_EQ(quiet.axis.shown.size(), quiet.axis.read.size());
    EXPECT_NE(quiet.axis.shown, quiet.axis.read);
}

/// The weights of a Gaussian, cut and lowered to end at zero, applied as a sum around the ring of samples.
std::vector<double> aroundTheRing(const std::vector<double>& function, double sigma, const VarianceRule& rule) {
    const int radius = static_cast<int>(rule.kernelCut * sigma), size = static_cast<int>(function.size());
    const auto gaussian = [&](int distance) { return std::exp(-distance * distance / (2.0 * sigma * sigma)); };
    double sum = 0.0;
    std::vector<double> smoothed(function.size(), 0.0);
    for (int distance = -radius; distance <= radius; ++distance) {
        const double weight = gaussian(distance) - (rule.kernelEndsAtZero ? gaussian(radius + 1) : 0.0);
        sum += weight;
        for (int i = 0; i < size; ++i)
            smoothed[static_cast<std::size_t>(i)] +=
                weight * function[static_cast<std::size_t>(((i + distance) % size + size) % size)];
    }
    for (double& value : smoothed) value /= sum;
    return smoothed;
}

TEST(TubeExplanation, ScalesShrinkToTheSurface) {
    const auto& rule = std::get<VarianceRule>(publishedRun().otf.config.detection);
    int compared = 0;
    for (std::size_t t = 0; t < publishedRun().otf.tubes.size(); t += 2) {
        const TubeExplanation explained = publishedRun().explained(static_cast<int>(t));
        const TubeCore& tube = explained.tube;
        if (tube.status == TubeStatus::outside) continue;
        ASSERT_FALSE(explained.scales.empty());
        const TrackedScale& unsmoothed = explained.scales.back();
        EXPECT_FALSE(unsmoothed.sigma);
        for (std::size_t i = 0; i < unsmoothed.function.size(); ++i)
            ASSERT_NEAR(unsmoothed.function[i],
                        tube.interfaceFunction[i + static_cast<std::size_t>(explained.cells.tube.first)], 1e-6);
        if (tube.status != TubeStatus::surface) continue;
        ++compared;
        ASSERT_EQ(explained.scales.size(), 6u);
        ASSERT_EQ(tube.trackedCells.size(), 6u);
        EXPECT_EQ(unsmoothed.cell.value_or(tube.trackedCells.back()), tube.surfaceCell) << t;
        double sigma = 64.0;
        for (std::size_t scale = 0; scale < explained.scales.size(); ++scale) {
            const TrackedScale& one = explained.scales[scale];
            if (one.cell) {
                EXPECT_GE(*one.cell, one.searched.first) << t;
                EXPECT_LE(*one.cell, one.searched.last) << t;
                EXPECT_EQ(*one.cell, tube.trackedCells[scale]) << t;
            }
            if (!one.sigma) continue;
            EXPECT_EQ(*one.sigma, sigma /= 2.0);
            const auto expected = aroundTheRing(unsmoothed.function, *one.sigma, rule);
            for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(one.function[i], expected[i], 1e-12) << t;
            // The next scale is searched 2 sigma around what was found.
            if (!one.cell) continue;
            const IndexRange next = explained.scales[scale + 1].searched;
            EXPECT_EQ(next.first, std::max(explained.cells.tube.first, *one.cell - static_cast<int>(2 * *one.sigma)));
            EXPECT_EQ(next.last, std::min(explained.cells.tube.last, *one.cell + static_cast<int>(2 * *one.sigma)));
        }
    }
    EXPECT_GT(compared, 15);
}

TEST(TubeExplanation, OfATubeCoreWithoutASurfaceStillHoldsItsFunction) {
    AdaptiveOtfConfig config = configOf(MethodReading::settled);
    std::get<VarianceRule>(config.detection).coarsestMustHaveMaximum = true;
    const ExplainedRun run(config);
    int compared = 0;
    for (std::size_t t = 0; t < run.otf.tubes.size(); ++t) {
        if (run.otf.tubes[t].status != TubeStatus::none) continue;
        ++compared;
        const TubeExplanation explained = run.explained(static_cast<int>(t));
        EXPECT_EQ(explained.state, TubeState::noSurface);
        ASSERT_FALSE(explained.scales.empty());
        EXPECT_FALSE(explained.scales.back().sigma);
        EXPECT_EQ(explained.scales.back().function.size(),
                  static_cast<std::size_t>(explained.cells.tube.last - explained.cells.tube.first + 1));
    }
    EXPECT_GT(compared, 0);
}

TEST(TubeExplanation, ContrastsStandAtTheirBoundariesHoweverLittleFluidIsEnough) {
    AdaptiveOtfConfig config;
    config.grid.columns = 9;
    config.grid.rows = 8;
    AdaptiveOtfConfig little = config;
    std::get<RatioRule>(little.detection).leastFluid = 1;
    ASSERT_LT(1, config.cells.size / 2);
    const AdaptiveOtf otf = *adaptOpacity(explainedScan(), {}, config),
                      other = *adaptOpacity(explainedScan(), {}, little);
    ASSERT_EQ(std::get<RatioRule>(config.detection).leastFluid, 8);
    int compared = 0;
    for (int number = 0; number < 72; number += 7) {
        const TubeExplanation eight = *explainTube(explainedScan(), {}, otf, number);
        const TubeExplanation one = *explainTube(explainedScan(), {}, other, number);
        const IndexRange cells = eight.contrastCells;
        if (cells.empty()) continue;
        EXPECT_LE(one.contrastCells.first, cells.first);
        EXPECT_EQ(one.contrastCells.last, cells.last);
        for (int cell = cells.first; cell <= cells.last; ++cell)
            ASSERT_EQ(one.tube.interfaceFunction[static_cast<std::size_t>(cell)],
                      eight.tube.interfaceFunction[static_cast<std::size_t>(cell)])
                << number << ' ' << cell;
        ++compared;
    }
    EXPECT_GT(compared, 5);
}

TEST(TubeExplanation, RanksAreCountedAmongAllTubeCores) {
    for (const ExplainedRun* run : {&publishedRun(), &defaultRun()}) {
        const int bins = run->otf.config.weights.rankBins;
        double most = 0.0, steepest = 0.0;
        for (const TubeCore& tube : run->otf.tubes) {
            most = std::max(most, tube.lowIntensityMax.value_or(0.0));
            steepest = std::max(steepest, tube.slope.value_or(0.0));
        }
        const auto bin = [bins](double value, double largest) {
            return bins == 0 ? value : std::min(std::floor(value / largest * bins), bins - 1.0);
        };
        for (std::size_t t = 0; t < run->otf.tubes.size(); t += 4) {
            const TubeExplanation explained = run->explained(static_cast<int>(t));
            const TubeCore& own = explained.tube;
            if (own.status != TubeStatus::surface) {
                EXPECT_EQ(explained.intensityRank.rank, 0);
                EXPECT_FALSE(explained.slopeRank.value);
                continue;
            }
            int darker = 0, flatter = 0, surfaces = 0;
            for (const TubeCore& other : run->otf.tubes) {
                if (other.status != TubeStatus::surface) continue;
                ++surfaces;
                darker += bin(*other.lowIntensityMax, most) <= bin(*own.lowIntensityMax, most) ? 1 : 0;
                flatter +=
                    *own.slope > 0 && *other.slope > 0 && bin(*other.slope, steepest) <= bin(*own.slope, steepest) ? 1
                                                                                                                   : 0;
            }
            EXPECT_EQ(explained.intensityRank.rank, darker) << t;
            EXPECT_EQ(explained.slopeRank.rank, flatter) << t;
            EXPECT_EQ(static_cast<int>(explained.slopeRank.values.size()), surfaces);
            EXPECT_TRUE(std::ranges::is_sorted(explained.intensityRank.values));
            EXPECT_NEAR(explained.intensityRank.weight,
                        1.0 - static_cast<double>(darker) / explained.tubesMeetingVolume, 1e-15);
            EXPECT_NEAR(explained.slopeRank.weight, static_cast<double>(flatter) / explained.tubesMeetingVolume, 1e-15);
            EXPECT_NEAR(own.d,
                        explained.dMax * explained.intensityRank.weight * explained.slopeRank.weight * own.extraWeight,
                        1e-15);
        }
    }
}

TEST(TubeExplanation, OfACoarseVolumeHasTheHalvedLengths) {
    // A gap of fluid, shorter than the default lengths, before a bright wall.
    std::mt19937 random(3);
    std::normal_distribution<double> speckle(1.0, 0.15);
    std::vector<std::uint8_t> voxels;
    for (int z = 0; z < 56; ++z)
        for (int i = 0; i < 56 * 56; ++i) {
            const double level = z < 24 ? 80.0 : z < 29 ? 4.0 : 160.0;
            voxels.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(level * speckle(random), 0.0, 255.0))));
        }
    const Volume volume(gridOf({56, 56, 56}, {3, 3, 3}), std::move(voxels), 255.0);
    const AdaptiveOtf otf = *adaptOpacity(volume, {}, {});
    ASSERT_TRUE(otf.lengthsHalved);
    const int number = heaviestFirst(otf).front();
    const TubeExplanation explained = *explainTube(volume, {}, otf, number);
    EXPECT_TRUE(explained.lengthsHalved);
    EXPECT_EQ(explained.config, configUsed(otf));
    EXPECT_EQ(explained.cells.high.last - explained.cells.high.first, explained.config.surface.highReach);
    EXPECT_LT(explained.config.surface.highReach, otf.config.surface.highReach);
    EXPECT_EQ(explained.without.curve, adaptOpacity(volume, {}, configWithout({}, number))->curve);
    EXPECT_EQ(grownCurve(otf, otf.tubes.size()), otf.curve);
}

TEST(TubeExplanation, WhereDataBeginTheCurveStaysTheInitialFunction) {
    // Tissue in the far half, 0 and a few lone echoes before it.
    const PlaneVolume plane;
    auto echoes = plane.voxels<std::uint8_t>();
    const VolumeGeometry geometry = plane.geometry();
    for (std::size_t i = 0; i < echoes.size(); ++i)
        if (static_cast<std::int64_t>(i) / (geometry.size[0] * geometry.size[1]) < geometry.size[2] / 2)
            echoes[i] = i * 2654435761 % 1009 == 0 ? 40 : 0;
    const Volume all(geometry, echoes);
    const Volume guessed = all.withDataMask(guessDataMask(all));
    AdaptiveOtfConfig config;
    config.grid.columns = config.grid.rows = 7;
    const AdaptiveOtf otf = *adaptOpacity(guessed, {}, config);
    ASSERT_TRUE(otf.surfacesWhereDataBegin);
    ASSERT_GT(otf.tubesWithWeight, 0);
    const auto weighty = std::ranges::max_element(otf.tubes, {}, &TubeCore::d);
    const TubeExplanation explained = *explainTube(guessed, {}, otf, static_cast<int>(weighty - otf.tubes.begin()));
    EXPECT_EQ(explained.state, TubeState::weighs);
    EXPECT_FALSE(explained.factor);
    EXPECT_EQ(explained.full.curve.opacities, explained.initial);
    EXPECT_EQ(explained.alone.curve.opacities, explained.initial);
    EXPECT_FALSE(std::isnan(explained.axis.read.front())) << "the zeros before the surface count as data";
    EXPECT_GE(explained.cells.low.first, 0);
    EXPECT_TRUE(heaviestFirst(otf).empty());
    EXPECT_EQ(grownCurve(otf, 3), otf.curve);
}

TEST(TubeExplanation, RefusesANumberThatTheGridDoesNotHoldAndEndsIfCancelled) {
    const ExplainedRun& run = publishedRun();
    EXPECT_THROW((void)run.explained(-1), std::invalid_argument);
    EXPECT_THROW((void)run.explained(72), std::invalid_argument);
    EXPECT_NO_THROW((void)run.explained(71));
    const std::atomic<bool> cancel = true;
    EXPECT_FALSE(explainTube(explainedScan(), {}, run.otf, 3, {{}, &cancel}));
}

}  // namespace
}  // namespace echolucent
