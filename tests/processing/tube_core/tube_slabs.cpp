#include "processing/tube_core/slabs/tube_slabs.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <limits>
#include <random>

#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/tube_core/cell_statistics.h"
#include "tests/processing/grids.h"
#include "tests/processing/tube_core/view_samples.h"

namespace echolucent {
namespace {

/// Noise up to `largest`, every voxel on its own: the steepest there is.
template <typename Voxel>
Volume noiseUpTo(const std::array<std::int64_t, 3>& size, double largest, const Vec3& spacing = {1, 1, 1},
                 std::optional<double> white = std::nullopt) {
    const VolumeGeometry geometry = gridOf(size, spacing);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> value(0.0, largest);
    std::vector<Voxel> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (auto& voxel : voxels) voxel = static_cast<Voxel>(value(random));
    return Volume(geometry, std::move(voxels), white);
}

/// Single voxels and a corner without data.
Volume masked(const Volume& volume) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(volume.geometry().voxelCount()), 1);
    for (std::size_t i = 5; i < mask.size(); i += 997) mask[i] = 0;
    const auto& size = volume.geometry().size;
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x)
                if (x + y + z < 30) mask[static_cast<std::size_t>(volume.geometry().offset(x, y, z))] = 0;
    return volume.withDataMask(std::move(mask));
}

/// Sums by the definition.
template <typename Stored>
void expectSumsByDefinition(const Volume& volume, std::uint32_t limit, const TubeSamples& tube, const SlabSums& sums) {
    const auto& voxels = std::get<VoxelArray<Stored>>(volume.voxels());
    const auto& size = volume.geometry().size;
    const double half = (tube.cellSize - 1) / 2.0;
    ASSERT_EQ(sums.sums.size(), static_cast<std::size_t>(tube.slabs));
    for (int k = 0; k < tube.slabs; ++k) {
        std::int64_t count = 0, sum = 0;
        std::uint64_t squares = 0;
        for (int b = 0; b < tube.cellSize; ++b)
            for (int a = 0; a < tube.cellSize; ++a) {
                const Vec3 at = tube.onAxis(k) + tube.down * (b - half) + tube.right * (a - half);
                const std::int64_t x = std::llround(at[0]), y = std::llround(at[1]), z = std::llround(at[2]);
                if (x < 0 || y < 0 || z < 0 || x >= size[0] || y >= size[1] || z >= size[2]) continue;
                const auto offset = volume.geometry().offset(x, y, z);
                if (!volume.hasData(offset)) continue;
                const std::uint64_t value = std::min<std::uint32_t>(voxels[static_cast<std::size_t>(offset)], limit);
                ++count;
                sum += static_cast<std::int64_t>(value);
                squares += value * value;
            }
        const auto i = static_cast<std::size_t>(k);
        ASSERT_EQ(sums.counts[i], count);
        ASSERT_EQ(sums.sums[i], sum);
        ASSERT_EQ(sums.sumsOfSquares[i], squares);
    }
}

template <typename Stored>
void expectSumsOfAllAxisViews(const Volume& volume, std::uint32_t limit) {
    for (int beam = 0; beam < 6; ++beam)
        for (const double roll : {0.0, 90.0, 180.0})
            for (const int cellSize : {5, 4, 9, 32}) {
                AdaptiveOtfConfig config;
                config.cells.size = cellSize;
                config.grid.columns = config.grid.rows = 7;
                const Viewpoint view =
                    withFrontAcross({.beamAxis = static_cast<BeamAxis>(beam), .rollDegrees = roll}, 3.3);
                const auto tubes = samplesFor(volume, view, config);
                std::vector<SlabSums> sums(tubes.size());
                sumSlabs(volume, limit, tubes, sums);
                for (std::size_t t = 0; t < tubes.size(); ++t)
                    expectSumsByDefinition<Stored>(volume, limit, tubes[t], sums[t]);
            }
}

TEST(TubeSlabs, SumsOnVoxelsAreThoseOfTheDefinitionInEveryAxisView) {
    // Some tubes hang over the border; the volume's last voxels end tubes; stored values above the limit are cut.
    const Volume bytes = noiseUpTo<std::uint8_t>({31, 28, 36}, 255),
                 shorts = noiseUpTo<std::uint16_t>({31, 28, 36}, 65535);
    expectSumsOfAllAxisViews<std::uint8_t>(bytes, 255);
    expectSumsOfAllAxisViews<std::uint8_t>(masked(bytes), 200);
    expectSumsOfAllAxisViews<std::uint16_t>(shorts, 65535);
    expectSumsOfAllAxisViews<std::uint16_t>(masked(shorts), 4095);
}

TEST(TubeSlabs, TheLargest16BitCellsDoNotOverflow) {
    VolumeGeometry geometry;
    geometry.size = {40, 40, 40};
    const Volume volume(geometry, std::vector<std::uint16_t>(40 * 40 * 40, 65535));
    AdaptiveOtfConfig config;
    config.cells.size = largestCellSize;
    config.grid.columns = config.grid.rows = 1;
    const auto tubes = samplesFor(volume, Viewpoint{}, config);
    std::vector<SlabSums> sums(1);
    sumSlabs(volume, 65535, tubes, sums);
    CellStatistics cells;
    cellsFrom(sums[0], config.cells.size, 65535, cells);
    ASSERT_GE(cells.lastCell, 0);
    for (int i = 0; i <= cells.lastCell; ++i) {
        EXPECT_EQ(cells.means[static_cast<std::size_t>(i)], 1.0);
        EXPECT_EQ(cells.variances[static_cast<std::size_t>(i)], 0.0);
    }
}

/// How far the fast route may be from the reference, in stored values, for a volume with values up to `largest`:
/// positions are rounded to 2^-16 voxel (bytes: shares along x to 2^-14), which moves an interpolated value by at most
/// 2^-13 of the range; single precision adds 8 roundings of 2^-24.
double toleranceFor(double largest) { return largest * (0x1p-13 + 8 * 0x1p-24); }

/// Whether rounding a position decides what is taken: a sample next to a whole number (where a neighbour's share, and
/// with it its lack of data, comes and goes) or half way between two (where the nearest voxel and the border change).
bool roundingDecides(const TubeSamples& tube, int slab) {
    const double half = (tube.cellSize - 1) / 2.0;
    for (int b = 0; b < tube.cellSize; ++b)
        for (int a = 0; a < tube.cellSize; ++a) {
            const Vec3 at = tube.onAxis(slab) + tube.down * (b - half) + tube.right * (a - half);
            for (int axis = 0; axis < 3; ++axis)
                if (std::abs(2 * at[axis] - std::round(2 * at[axis])) < 0x1p-12) return true;
        }
    return false;
}

/// Compares all tubes of a view with the reference and counts the slabs compared: those in which rounding
/// does not decide.
int slabsLikeTheReference(const Volume& volume, const Viewpoint& view, Interpolation sampling, double largest) {
    AdaptiveOtfConfig config;
    config.grid.columns = config.grid.rows = 9;
    const auto tubes = samplesFor(volume, view, config);
    std::vector<SlabMeans> fast(tubes.size());
    meanSlabs(volume, sampling, tubes, fast);
    std::vector<SlabMoments> reference;
    std::vector<double> scratch;
    int compared = 0;
    const double scale = slabScale(volume), tolerance = toleranceFor(largest * scale);
    const double white = volume.whiteLevel() * scale;
    for (std::size_t t = 0; t < tubes.size(); ++t) {
        sampleSlabs(volume, sampling, tubes[t], reference, scratch);
        for (std::size_t k = 0; k < reference.size(); ++k) {
            if (roundingDecides(tubes[t], static_cast<int>(k))) continue;
            ++compared;
            EXPECT_EQ(fast[t].counts[k], static_cast<float>(reference[k].count));
            const double n = reference[k].count, spread = std::sqrt(reference[k].squaredDeviations * n) * white;
            EXPECT_NEAR(fast[t].means[k], reference[k].mean * white, tolerance);
            // Samples off by e change the sum of squared deviations by at most 2 e sqrt(n D) + n e^2.
            EXPECT_NEAR(fast[t].squaredDeviations[k], reference[k].squaredDeviations * white * white,
                        2 * tolerance * spread + n * tolerance * tolerance);
        }
    }
    return compared;
}

template <typename Voxel>
void expectTheReference(double largest, std::optional<double> white = std::nullopt) {
    for (const Vec3& spacing : {Vec3(1, 1, 1), Vec3(0.5, 0.7, 0.9), Vec3(2, 0.8, 0.3)}) {
        const Volume complete = noiseUpTo<Voxel>({47, 52, 58}, largest, spacing, white);
        for (const Volume& volume : {complete, masked(complete)})
            for (const Viewpoint& view :
                 {Viewpoint{.azimuthDegrees = 20, .elevationDegrees = -12},
                  Viewpoint{.beamAxis = BeamAxis::minusX, .azimuthDegrees = 63, .elevationDegrees = 31},
                  Viewpoint{.beamAxis = BeamAxis::plusY, .azimuthDegrees = -7, .rollDegrees = 33}})
                for (const Interpolation sampling : {Interpolation::trilinear, Interpolation::nearest})
                    EXPECT_GT(slabsLikeTheReference(volume, view, sampling, largest), 500);
    }
}

TEST(TubeSlabs, BytesBetweenVoxelsAgreeWithTheReference) { expectTheReference<std::uint8_t>(255); }
TEST(TubeSlabs, ShortsBetweenVoxelsAgreeWithTheReference) {
    expectTheReference<std::uint16_t>(65535);
    expectTheReference<std::uint16_t>(4095, 3000);
}
TEST(TubeSlabs, FloatsBetweenVoxelsAgreeWithTheReference) { expectTheReference<float>(1.0, 0.8); }

TEST(TubeSlabs, ConstantsStayConstantToTheLastBit) {
    VolumeGeometry geometry;
    geometry.size = {50, 50, 50};
    const Volume volume(geometry, std::vector<std::uint16_t>(50 * 50 * 50, 12345));
    AdaptiveOtfConfig config;
    const auto tubes = samplesFor(volume, Viewpoint{.azimuthDegrees = 31, .elevationDegrees = 17}, config);
    std::vector<SlabMeans> slabs(tubes.size());
    meanSlabs(volume, Interpolation::trilinear, tubes, slabs);
    for (const SlabMeans& tube : slabs)
        for (std::size_t k = 0; k < tube.means.size(); ++k) {
            EXPECT_EQ(tube.means[k], tube.counts[k] > 0 ? 12345.0f : 0.0f);
            EXPECT_EQ(tube.squaredDeviations[k], 0.0f);
        }
}

TEST(TubeSlabs, ALargeMeanDoesNotDrownASmallSpread) {
    // Mean 65000, values of a chessboard two apart: interpolated values lie within one of the mean.
    VolumeGeometry geometry;
    geometry.size = {40, 40, 40};
    std::vector<std::uint16_t> voxels(40 * 40 * 40);
    for (std::size_t i = 0; i < voxels.size(); ++i)
        voxels[i] = static_cast<std::uint16_t>(64999 + 2 * ((i + i / 40 + i / 1600) % 2));
    const Volume volume(geometry, voxels, 65535);
    AdaptiveOtfConfig config;
    config.grid.columns = config.grid.rows = 3;
    const auto tubes = samplesFor(volume, Viewpoint{.azimuthDegrees = 10}, config);
    std::vector<SlabMeans> fast(tubes.size());
    meanSlabs(volume, Interpolation::trilinear, tubes, fast);
    std::vector<SlabMoments> reference;
    std::vector<double> scratch;
    for (std::size_t t = 0; t < tubes.size(); ++t) {
        sampleSlabs(volume, Interpolation::trilinear, tubes[t], reference, scratch);
        for (std::size_t k = 0; k < reference.size(); ++k) {
            // Single precision near 65000 rounds samples to 2^-8 / 2.
            const double expected = reference[k].squaredDeviations * 65535.0 * 65535.0;
            EXPECT_NEAR(fast[t].squaredDeviations[k], expected, 25 * 0.03 * std::sqrt(expected / 25) + 0.01);
        }
    }
}

TEST(TubeSlabs, NotFiniteVoxelsAreLeftOut) {
    VolumeGeometry geometry;
    geometry.size = {40, 40, 40};
    std::vector<float> voxels(40 * 40 * 40, 0.5f);
    for (std::size_t i = 0; i < voxels.size(); i += 101)
        voxels[i] = i % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    const Volume volume(geometry, voxels, 1.0);
    AdaptiveOtfConfig config;
    const auto tubes = samplesFor(volume, Viewpoint{.azimuthDegrees = 20, .elevationDegrees = -12}, config);
    std::vector<SlabMeans> slabs(tubes.size());
    meanSlabs(volume, Interpolation::trilinear, tubes, slabs);
    for (const SlabMeans& tube : slabs)
        for (std::size_t k = 0; k < tube.means.size(); ++k) {
            if (tube.counts[k] == 0) continue;
            EXPECT_EQ(tube.means[k], 0.5f);
            EXPECT_EQ(tube.squaredDeviations[k], 0.0f);
        }
}

TEST(TubeSlabs, EveryInstructionSetGivesTheSameBits) {
    const Volume volume = masked(noiseUpTo<std::uint8_t>({60, 61, 62}, 255));
    const Volume floating = noiseUpTo<float>({60, 61, 62}, 1.0);
    AdaptiveOtfConfig config;
    const Viewpoint view{.azimuthDegrees = 20, .elevationDegrees = -12};
    const auto tubes = samplesFor(volume, view, config);
    const auto onVoxels = samplesFor(volume, Viewpoint{}, config);
    std::vector<std::vector<float>> all;
    std::vector<std::vector<std::int32_t>> allSums;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        std::vector<float> bits;
        for (const Volume* tested : {&volume, &floating}) {
            std::vector<SlabMeans> slabs(tubes.size());
            meanSlabs(*tested, Interpolation::trilinear, tubes, slabs);
            for (const SlabMeans& tube : slabs)
                for (const auto* values : {&tube.counts, &tube.means, &tube.squaredDeviations})
                    bits.insert(bits.end(), values->begin(), values->end());
        }
        all.push_back(std::move(bits));
        std::vector<SlabSums> sums(onVoxels.size());
        sumSlabs(volume, 255, onVoxels, sums);
        allSums.emplace_back();
        for (const SlabSums& tube : sums)
            allSums.back().insert(allSums.back().end(), tube.sums.begin(), tube.sums.end());
    }
    hwy::SetSupportedTargetsForTest(0);
    for (std::size_t i = 1; i < all.size(); ++i) {
        EXPECT_EQ(all[i], all[0]);
        EXPECT_EQ(allSums[i], allSums[0]);
    }
}

TEST(TubeSlabs, SaysWhichVolumesNeedTheReference) {
    EXPECT_TRUE(canMeanSlabs(noiseUpTo<std::uint8_t>({2, 2, 1}, 255)));
    EXPECT_FALSE(canMeanSlabs(noiseUpTo<std::uint8_t>({1, 9, 9}, 255)));
    EXPECT_FALSE(canMeanSlabs(noiseUpTo<std::uint8_t>({3, 1, 9}, 255)));
    EXPECT_FALSE(canMeanSlabs(noiseUpTo<std::uint8_t>({9, 9, 9}, 255, {1, 1, 1}, 100.0)));
    EXPECT_TRUE(canMeanSlabs(noiseUpTo<std::uint16_t>({9, 9, 9}, 255, {1, 1, 1}, 100.0)));
}

TEST(TubeSlabs, ThinVolumesAgreeWithTheReference) {
    int compared = 0;
    for (const std::array<std::int64_t, 3> size : {std::array<std::int64_t, 3>{40, 1, 40}, {40, 40, 1}, {4, 2, 50}}) {
        const Volume volume = noiseUpTo<std::uint8_t>(size, 255);
        ASSERT_TRUE(canMeanSlabs(volume));
        for (const Viewpoint& view :
             {Viewpoint{.azimuthDegrees = 3, .elevationDegrees = 2}, Viewpoint{.elevationDegrees = 81}})
            compared += slabsLikeTheReference(volume, view, Interpolation::trilinear, 255);
    }
    EXPECT_GT(compared, 100);
}

TEST(TubeSlabs, StoredSumsAreExactOnlyForIntegersWithAnIntegerWhiteLevel) {
    VolumeGeometry geometry;
    geometry.size = {2, 1, 1};
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<std::uint8_t>{1, 2})), 255u);
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<std::uint16_t>{1, 4095})), 4095u);
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<std::uint16_t>{1, 4095}, 1000.5)), std::nullopt);
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<std::uint16_t>{1, 4095}, 1e6)), 65535u);
    EXPECT_EQ(exactStoredLimit(Volume(geometry, std::vector<float>{1, 2})), std::nullopt);
}

}  // namespace
}  // namespace echolucent
