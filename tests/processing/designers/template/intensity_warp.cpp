// The warp of the intensity axis: what is known is found, and what is promised is kept whatever the histograms are.
#include "processing/designers/template/intensity_warp.h"
#include "tests/inputs.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace echolucent {
namespace {

using Histogram = std::vector<double>;

Histogram normalised(Histogram shares) {
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    for (double& share : shares) share /= sum;
    return shares;
}

/// Fluid, tissue and bone: bell curves at their bins, with what shares there are of them.
Histogram classes(double fluid, double tissue, double bone, double shift = 0.0) {
    Histogram shares(warpBins);
    const auto bell = [](double bin, double middle, double width) {
        return std::exp(-0.5 * std::pow((bin - middle) / width, 2)) / width;
    };
    for (std::size_t i = 0; i < warpBins; ++i) {
        const double bin = static_cast<double>(i) - shift;
        shares[i] = fluid * bell(bin, 30, 4) + tissue * bell(bin, 95, 9) + bone * bell(bin, 150, 12) + 1e-4;
    }
    return normalised(shares);
}

/// Shares with gaps and spikes that follow from a seed.
Histogram scattered(std::uint32_t seed) {
    Histogram shares(warpBins);
    for (double& share : shares) {
        seed = seed * 1664525U + 1013904223U;
        share = seed >> 31 == 0 ? 0.0 : static_cast<double>(seed >> 8 & 0xffffU);
    }
    return normalised(shares);
}

WarpRule rule(TemplateComparison comparison, double least = 0.25, double largest = 4.0) {
    return {comparison, least, largest};
}

TEST(IntensityWarp, EqualHistogramsGiveTheIdentity) {
    for (const TemplateComparison comparison : allTemplateComparisons)
        for (const Histogram& shares : {classes(4, 5, 1), scattered(1), scattered(2)}) {
            if (takesSomeInputs && comparison != TemplateComparison::logarithm) continue;
            const FoundWarp found = *findWarp(shares, shares, rule(comparison));
            for (std::size_t i = 0; i < found.warp.values.size(); ++i)
                EXPECT_EQ(found.warp.values[i],
                          static_cast<double>(i) / static_cast<double>(found.warp.values.size() - 1));
            EXPECT_EQ(found.distance, 0.0);
            EXPECT_EQ(found.distanceBefore, 0.0);
        }
}

/// Of anything, a monotone warp comes out whose slopes are kept, and whose inverse is its inverse.
TEST(IntensityWarp, SlopesAreKeptWhateverTheHistogramsAre) {
    Histogram ends(warpBins, 0.0);
    ends[0] = ends[255] = 0.5;
    const std::vector<Histogram> all{scattered(3), ends};
    for (const TemplateComparison comparison : allTemplateComparisons)
        for (const auto& [least, largest] : {std::pair{0.25, 4.0}, {0.8, 1.5}, {1.0, 1.0}, {1.0 / 8.0, 8.0}})
            for (const Histogram& reference : all)
                for (const Histogram& other : all) {
                    if (takesSomeInputs && (least != 0.25 || &reference == &other)) continue;
                    const IntensityWarp warp = findWarp(reference, other, rule(comparison, least, largest))->warp;
                    const double steps = static_cast<double>(warp.values.size() - 1);
                    for (std::size_t i = 1; i < warp.values.size(); ++i) {
                        const double slope = (warp.values[i] - warp.values[i - 1]) * steps;
                        ASSERT_GE(slope, least - 1e-9);
                        ASSERT_LE(slope, largest + 1e-9);
                    }
                    for (const double v : {0.0, 0.13, 0.5, 0.77, 1.0}) ASSERT_NEAR(warp.inverse(warp.at(v)), v, 1e-9);
                }
}

TEST(IntensityWarp, AShiftIsFoundWithWhatItCutsOff) {
    const Histogram reference = classes(4, 5, 1);
    for (const TemplateComparison comparison : allTemplateComparisons)
        for (const int shift : {-28, -10, 20, 90}) {
            if (takesSomeInputs && shift != 20) continue;
            Histogram other(warpBins, 0.0);
            for (int i = 0; i < 256; ++i)
                other[static_cast<std::size_t>(std::clamp(i + shift, 0, 255))] +=
                    reference[static_cast<std::size_t>(i)];
            const IntensityWarp warp = findWarp(reference, other, rule(comparison))->warp;
            for (int bin = 20; bin < 180; ++bin) {
                const double v = (bin + 0.5) / 256.0, expected = v + shift / 256.0;
                if (expected < 1.0 / 256.0 || expected > 255.0 / 256.0) continue;
                EXPECT_NEAR(256.0 * warp.at(v), 256.0 * expected, 1.0) << nameOf(comparison) << " " << shift;
            }
        }
}

/// Shares say how much of a tissue there is, and a warp must not read that as a change of intensities.
TEST(IntensityWarp, ByLogarithmsProportionsMatterLittle) {
    const Histogram reference = classes(4, 5, 1), other = classes(1, 8, 1, 12);
    const auto errorAt = [&](TemplateComparison comparison, double bin) {
        const IntensityWarp warp = findWarp(reference, other, rule(comparison))->warp;
        return std::abs(256.0 * warp.at((bin + 0.5) / 256.0) - (bin + 0.5 + 12.0));
    };
    for (const double bin : {30.0, 95.0, 150.0}) EXPECT_LT(errorAt(TemplateComparison::logarithm, bin), 4.0) << bin;
    EXPECT_GT(errorAt(TemplateComparison::cumulative, 30.0), 15.0);
}

TEST(IntensityWarp, IsLinearBetweenItsValuesAndEndsWhereTheyEnd) {
    const IntensityWarp warp{{-0.2, 0.3, 0.4, 1.2}};
    EXPECT_DOUBLE_EQ(warp.at(0.0), -0.2);
    EXPECT_DOUBLE_EQ(warp.at(0.5), 0.35);
    EXPECT_DOUBLE_EQ(warp.at(7.0), 1.2);
    EXPECT_DOUBLE_EQ(warp.at(std::nan("")), -0.2);
    EXPECT_DOUBLE_EQ(warp.inverse(0.35), 0.5);
    EXPECT_DOUBLE_EQ(warp.inverse(-0.3), 0.0);
    EXPECT_DOUBLE_EQ(warp.inverse(2.0), 1.0);
    EXPECT_DOUBLE_EQ(IntensityWarp{}.at(0.25), 0.25);
}

TEST(IntensityWarp, HasTheSameBitsForAnyNumberOfThreads) {
    const Histogram one = scattered(11), other = classes(2, 3, 4);
    const FoundWarp many = *findWarp(one, other, {});
    const tbb::global_control single(tbb::global_control::max_allowed_parallelism, 1);
    const FoundWarp alone = *findWarp(one, other, {});
    EXPECT_EQ(many.warp.values, alone.warp.values);
    EXPECT_EQ(many.distance, alone.distance);
}

TEST(IntensityWarp, BrokenContractsThrow) {
    const Histogram good = classes(4, 5, 1);
    Histogram negative = good, unknown = good;
    negative[3] = -0.1;
    negative[4] += good[3] + 0.1;
    unknown[3] = std::nan("");
    const Histogram none(warpBins, 0.0), few(255, 1.0 / 255.0);
    for (const Histogram& bad : {negative, unknown, none, few}) {
        EXPECT_THROW((void)findWarp(bad, good, {}), std::invalid_argument);
        EXPECT_THROW((void)findWarp(good, bad, {}), std::invalid_argument);
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [least, largest] :
         {std::pair{0.01, 3.0}, {1.1, 3.0}, {0.5, 0.9}, {0.5, 8.5}, {nan, 3.0}, {0.5, nan}})
        EXPECT_THROW((void)findWarp(good, good, rule(TemplateComparison::logarithm, least, largest)),
                     std::invalid_argument);
}

TEST(IntensityWarp, IsEmptyWhereItWasCancelled) {
    const std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(findWarp(scattered(1), scattered(2), {}, progress).has_value());
}

}  // namespace
}  // namespace echolucent
