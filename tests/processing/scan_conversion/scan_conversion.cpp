#include "processing/scan_conversion/scan_conversion.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>

#include "polar_probes.h"

namespace echolucent {
namespace {

template <typename Value>
void expectSameAsPlain(const NamedPolar& named, const ConversionGrid& grid, double rounding) {
    const std::string& name = named.name;
    const PolarGeometry& polar = named.polar;
    // Uneven lines bend within an entry of the table: a few thousandths of a line.
    const double tolerance = rounding + (name == "uneven" ? 0.05 : 0.01);
    const auto values = sampledValues<Value>(polar, smoothAt);
    const ScanConversion conversion(polar, grid);
    const auto converted = std::get<VoxelArray<Value>>(*conversion.convert(values));
    const auto mask = conversion.mask();
    std::size_t insonified = 0, off = 0;
    double worst = 0.0;
    Vec3 where;
    forEachVoxel(conversion.grid(), [&](std::size_t offset, const Vec3& mm) {
        const auto index = polarFromProbeMm(polar, mm);
        insonified += index ? 1 : 0;
        if (static_cast<bool>(index) != (mask[offset] != 0)) ++off;
        if (!index || mask[offset] == 0) return;
        const double difference =
            std::abs(static_cast<double>(converted[offset]) - plainTrilinear(polar, values, *index));
        if (difference <= worst || std::isnan(worst)) return;
        worst = difference;
        where = mm;
    });
    EXPECT_LE(worst, tolerance) << name << " " << where[0] << " " << where[1] << " " << where[2];
    EXPECT_GT(insonified, 1000U) << name;
    EXPECT_EQ(off, 0U) << name;
}

template <typename Value>
void expectSameAsPlain(double rounding) {
    for (const NamedPolar& named : everyPolar())
        expectSameAsPlain<Value>(named, conversionGridOf(named.polar, 1.1), rounding);
    // A sector whose apex is a voxel's centre.
    const PolarGeometry sector =
        polarGeometry({PolarKind::wobbler, 0, 0.5, {-28.5, 28.5}, {-28.5, 28.5}, 0, 0}, {100, 25, 25});
    const ConversionGrid grid = conversionGrid(sector);
    ASSERT_EQ(grid.geometry.origin[2], 0.0);
    ASSERT_EQ(grid.geometry.size[0] % 2, 1);
    ASSERT_EQ(grid.geometry.size[1] % 2, 1);
    expectSameAsPlain<Value>({"apex on the grid", sector}, grid, rounding);
}

TEST(ScanConversion, IsTrilinearInPolarCoordinates) {
    expectSameAsPlain<std::uint8_t>(0.5);
    expectSameAsPlain<std::uint16_t>(0.5);
    expectSameAsPlain<float>(0.0);
}

TEST(ScanConversion, VoxelsOutsideAreZeroAndNoData) {
    const PolarGeometry polar = everyPolar()[3].polar;
    const auto values = sampledValues<std::uint8_t>(polar, [](const Vec3&) { return 77.0; });
    const ScanConversion conversion(polar, conversionGrid(polar));
    const auto converted = std::get<VoxelArray<std::uint8_t>>(*conversion.convert(values));
    const auto mask = conversion.mask();
    for (std::size_t i = 0; i < mask.size(); ++i) ASSERT_EQ(converted[i], mask[i] != 0 ? 77 : 0);
    const auto share = static_cast<double>(std::count(mask.begin(), mask.end(), 1)) / static_cast<double>(mask.size());
    EXPECT_GT(share, 0.3);
    EXPECT_LT(share, 0.6);
}

// Where the grid's voxels are the samples, nothing is resampled.
TEST(ScanConversion, LinearProbeOnItsOwnGridKeepsEveryBit) {
    const PolarGeometry polar = polarGeometry({PolarKind::linear, 0, 0.5, {-4, 4}, {-3, 3}, 0, 0}, {20, 17, 13});
    std::mt19937 random(1);
    std::vector<std::uint16_t> values(20 * 17 * 13);
    for (auto& value : values) value = static_cast<std::uint16_t>(random());
    const ScanConversion conversion(polar, conversionGrid(polar));
    ASSERT_EQ(conversion.grid().geometry.size, (std::array<std::int64_t, 3>{17, 13, 20}));
    EXPECT_FALSE(conversion.grid().limitedByMemory);
    const auto converted = std::get<VoxelArray<std::uint16_t>>(*conversion.convert(values));
    for (std::size_t plane = 0; plane < 13; ++plane)
        for (std::size_t line = 0; line < 17; ++line)
            for (std::size_t sample = 0; sample < 20; ++sample)
                ASSERT_EQ(converted[line + 17 * (plane + 13 * sample)], values[sample + 20 * (line + 17 * plane)]);
    const auto mask = conversion.mask();
    EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 20 * 17 * 13);
}

template <typename Value>
void expectEveryBitKept(const PolarGeometry& polar) {
    const auto size = polar.size();
    std::vector<Value> values(static_cast<std::size_t>(size[0] * size[1] * size[2]));
    std::mt19937 random(7);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<Value>(i % 2 == 0 ? random() % 40000 : 65535 - random() % 3);
    if constexpr (std::is_same_v<Value, float>) {
        for (float& value : values) value *= 0.1F;
        values[5] = std::numeric_limits<float>::quiet_NaN();
    }
    const ScanConversion conversion(polar, conversionGrid(polar));
    const auto& grid = conversion.grid().geometry.size;
    ASSERT_EQ(grid, (std::array<std::int64_t, 3>{size[1], size[2], size[0]}));
    const auto converted = std::get<VoxelArray<Value>>(*conversion.convert(values));
    std::size_t different = 0;
    for (std::int64_t z = 0; z < grid[2]; ++z)
        for (std::int64_t y = 0; y < grid[1]; ++y)
            for (std::int64_t x = 0; x < grid[0]; ++x) {
                const Value is = converted[static_cast<std::size_t>(x + grid[0] * (y + grid[1] * z))];
                const Value was = values[static_cast<std::size_t>(z + size[0] * (x + size[1] * y))];
                const bool bothNan = std::isnan(static_cast<double>(is)) && std::isnan(static_cast<double>(was));
                different += is == was || bothNan ? 0 : 1;
            }
    EXPECT_EQ(different, 0U) << sizeof(Value);
}

// 0.3 mm is no number of the machine's, and floats of it lie off the samples by more than 16 bits forgive.
TEST(ScanConversion, LinearProbeKeepsEveryBitAtAnySpacing) {
    for (const PolarGeometry& polar :
         {polarGeometry({PolarKind::linear, 5, 0.3, {-1.2, 1.2}, {-1.2, 1.2}, 0, 0}, {400, 9, 9}),
          polarGeometry({PolarKind::linear, 5, 0.07, {-1.4, 1.4}, {-0.7, 0.7}, 0, 0}, {1500, 41, 21})}) {
        expectEveryBitKept<std::uint8_t>(polar);
        expectEveryBitKept<std::uint16_t>(polar);
        expectEveryBitKept<float>(polar);
    }
}

// A closed form sampled on the polar grid, converted and compared with itself. Linear interpolation is off by up to
// h^2 / 8 (2 pi / 30 mm)^2 100 / 3 in each direction; lines lie up to h = 4.1 mm apart, planes 2.8 and samples 1.5;
// uneven ones up to 1.6 times as far.
TEST(ScanConversion, ErrorAgainstAClosedFormIsThatOfLinearInterpolation) {
    for (const auto& [name, polar] : everyPolar({60, 40, 40})) {
        if (name.find("turn") != std::string::npos || name == "to one side") continue;
        const auto values = sampledValues<float>(polar, smoothAt);
        const ScanConversion conversion(polar, conversionGrid(polar));
        const auto converted = std::get<VoxelArray<float>>(*conversion.convert(values));
        const auto mask = conversion.mask();
        double largest = 0;
        forEachVoxel(conversion.grid(), [&](std::size_t offset, const Vec3& mm) {
            if (mask[offset] != 0) largest = std::max(largest, std::abs(converted[offset] - smoothAt(mm)));
        });
        EXPECT_LT(largest, name == "uneven" ? 5.0 * 1.6 * 1.6 : 5.0) << name;
        EXPECT_GT(largest, 0.1) << name;
    }
}

TEST(ScanConversion, MarkedCornersKeepTheirPlaces) {
    for (const auto& [name, polar] : everyPolar()) {
        if (name == "sector" || name == "three quarters of a turn" || name == "to one side") continue;
        const auto size = polar.size();
        std::vector<std::uint8_t> values(static_cast<std::size_t>(size[0] * size[1] * size[2]), 10);
        // Each corner has its own value, in a neighbourhood that a voxel's centre surely meets.
        for (int corner = 0; corner < 8; ++corner)
            for (std::int64_t i = 0; i < 27; ++i) {
                std::array<std::int64_t, 3> place{i % 3, i / 3 % 3, i / 9};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    if ((corner >> axis & 1) != 0) place[axis] = size[axis] - 1 - place[axis];
                values[static_cast<std::size_t>(place[0] + size[0] * (place[1] + size[1] * place[2]))] =
                    static_cast<std::uint8_t>(100 + 10 * corner);
            }
        const ScanConversion conversion(polar, conversionGridOf(polar, 0.7));
        const auto converted = std::get<VoxelArray<std::uint8_t>>(*conversion.convert(values));
        const auto& geometry = conversion.grid().geometry;
        for (int corner = 0; corner < 8; ++corner) {
            Vec3 index(1, 1, 1);
            for (int axis = 0; axis < 3; ++axis)
                if ((corner >> axis & 1) != 0)
                    index[axis] = static_cast<double>(size[static_cast<std::size_t>(axis)] - 2);
            const Vec3 mm = probeMmFromPolar(polar, index) - geometry.origin;
            const Vec3 voxel = geometry.voxelFromGridMm(mm);
            const auto offset = geometry.offset(std::lround(voxel[0]), std::lround(voxel[1]), std::lround(voxel[2]));
            EXPECT_EQ(converted[static_cast<std::size_t>(offset)], 100 + 10 * corner) << name << corner;
        }
    }
}

TEST(ScanConversion, SpacingFollowsTheFinestResolution) {
    const EvenPolar even{PolarKind::wobbler, 0, 0.5, {-30, 30}, {-30, 30}, 40, 25};
    // Neighbouring lines lie 60 / 60 degrees apart at a radius of 40 + 24.5 mm, planes 60 / 20 degrees at 25 + 24.5.
    const ConversionGrid byRange = conversionGrid(polarGeometry(even, {99, 61, 21}));
    EXPECT_DOUBLE_EQ(byRange.geometry.spacing[0], 0.5);
    EXPECT_FALSE(byRange.limitedByMemory);
    const ConversionGrid byLines = conversionGrid(polarGeometry(even, {99, 241, 21}));
    EXPECT_NEAR(byLines.geometry.spacing[0], 0.25 * std::numbers::pi / 180 * 64.5, 1e-9);
    const ConversionGrid byPlanes = conversionGrid(polarGeometry(even, {99, 61, 241}));
    EXPECT_NEAR(byPlanes.geometry.spacing[0], 0.25 * std::numbers::pi / 180 * 49.5, 1e-9);
    EXPECT_EQ(byPlanes.geometry.spacing[0], byPlanes.geometry.spacing[2]);
}

TEST(ScanConversion, GridHoldsTheWholeRegionAndNoMore) {
    for (const auto& [name, polar] : everyPolar()) {
        const ConversionGrid grid = conversionGridOf(polar, 0.8);
        const Vec3 low = grid.geometry.origin, high = low + grid.geometry.boxMaxMm() - Vec3(0.4, 0.4, 0.4);
        Vec3 least(1e9, 1e9, 1e9), most = -least;
        for (double sample = 0; sample <= 29; sample += 0.5)
            for (double line = 0; line <= 16; line += 0.25)
                for (double plane = 0; plane <= 12; plane += 0.25) {
                    const Vec3 mm = probeMmFromPolar(polar, {sample, line, plane});
                    if (!polarFromProbeMm(polar, mm)) continue;
                    for (int axis = 0; axis < 3; ++axis) {
                        least[axis] = std::min(least[axis], mm[axis]);
                        most[axis] = std::max(most[axis], mm[axis]);
                    }
                }
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(low[axis], least[axis], 0.41) << name << axis;
            EXPECT_NEAR(high[axis], most[axis], 0.41) << name << axis;
        }
    }
}

TEST(ScanConversion, MemoryLimitIsKeptAndUsed) {
    const PolarGeometry polar = polarGeometry({}, {800, 300, 300});
    for (const std::int64_t bytes : {1, 4})
        for (const std::int64_t phases : {1, 8, 40}) {
            const ConversionMemory memory{bytes, phases, 16 << 20};
            const ConversionGrid grid = conversionGrid(polar, memory);
            const auto taken = static_cast<double>(grid.geometry.voxelCount() * bytes);
            const double allowed = std::min(16.0, 16.0 * 8 / static_cast<double>(phases)) * (1 << 20);
            EXPECT_LE(taken, allowed);
            EXPECT_GT(taken, 0.97 * allowed);
            EXPECT_TRUE(grid.limitedByMemory);
            EXPECT_GT(grid.geometry.spacing[0], grid.finestMm);
        }
}

// Beams that lie side by side within a hundredth of a millimetre make rows of one voxel, whose tables take more.
TEST(ScanConversion, MemoryLimitHoldsForTheTablesToo) {
    const PolarGeometry polar =
        polarGeometry({PolarKind::linear, 0, 0.02, {0, 0.01}, {0, 79.98}, 0, 0}, {4000, 2, 4000});
    const ConversionMemory memory;
    const ConversionGrid grid = conversionGrid(polar, memory);
    EXPECT_LE(grid.rows() * conversionRowBytes, memory.phaseBytes);
    EXPECT_GT(grid.rows() * conversionRowBytes, memory.phaseBytes * 97 / 100);
    EXPECT_TRUE(grid.limitedByMemory);
}

TEST(ScanConversion, TablesAndMaskEndAtOnceWhenCancelled) {
    const PolarGeometry polar = everyPolar({60, 60, 60})[3].polar;
    const ConversionGrid grid = conversionGridOf(polar, 0.4);
    std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    const ScanConversion whole(polar, grid);
    EXPECT_TRUE(whole.mask(progress).empty());
    // A cancelled conversion has made no tables, and what it converts is nothing.
    const ScanConversion none(polar, grid, progress);
    EXPECT_TRUE(none.mask(progress).empty());
    EXPECT_FALSE(none.convert(sampledValues<std::uint8_t>(polar, smoothAt), progress));
}

TEST(ScanConversion, AnyNumberOfThreadsGivesTheSameBits) {
    const PolarGeometry polar = everyPolar()[9].polar;
    const auto values = sampledValues<float>(polar, smoothAt);
    const auto convertedOn = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const ScanConversion conversion(polar, conversionGridOf(polar, 0.6));
        return std::pair(*conversion.convert(values), conversion.mask());
    };
    EXPECT_EQ(convertedOn(1), convertedOn(4));
}

TEST(ScanConversion, EndsWithinAPhaseWhenCancelled) {
    const PolarGeometry polar = everyPolar({60, 60, 60})[3].polar;
    const auto values = sampledValues<std::uint8_t>(polar, smoothAt);
    const ScanConversion conversion(polar, conversionGridOf(polar, 0.4));
    std::atomic<bool> cancel = false;
    std::atomic<int> reports = 0;
    Progress progress;
    progress.cancel = &cancel;
    progress.report = [&](double) {
        ++reports;
        cancel = true;
    };
    EXPECT_FALSE(conversion.convert(values, progress));
    // Each of the grid's more than a hundred layers would have reported.
    EXPECT_LT(reports, 20);
}

TEST(ScanConversion, WhatIsNotFiniteStaysSo) {
    const PolarGeometry polar = everyPolar()[3].polar;
    auto values = sampledValues<float>(polar, smoothAt);
    values[static_cast<std::size_t>(15 + 30 * (8 + 17 * 6))] = std::numeric_limits<float>::quiet_NaN();
    const ScanConversion conversion(polar, conversionGridOf(polar, 0.8));
    const auto converted = std::get<VoxelArray<float>>(*conversion.convert(values));
    const auto lost = std::count_if(converted.begin(), converted.end(), [](float value) { return std::isnan(value); });
    EXPECT_GT(lost, 10);
    EXPECT_LT(lost, 1000);
}

TEST(ScanConversion, BrokenContractsThrow) {
    PolarGeometry polar = everyPolar()[3].polar;
    const ConversionGrid grid = conversionGrid(polar);
    EXPECT_THROW((void)ScanConversion(polar, grid).convert(std::vector<std::uint8_t>(5)), std::invalid_argument);
    EXPECT_THROW((void)conversionGridOf(polar, 0), std::invalid_argument);
    polar.lines.values[0] = 9;
    EXPECT_THROW(ScanConversion(polar, grid), std::invalid_argument);
    EXPECT_THROW((void)conversionGrid(polar), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
