// The readings of the method as configs, and the literal one against a slow program of its own that shares no code with
// the library beyond where tube cores lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "processing/phantom/phantom.h"

namespace echolucent {
namespace {

TEST(MethodReading, HasANameAndIsFoundByIt) {
    for (const MethodReading reading : {MethodReading::asPublished, MethodReading::settled, MethodReading::standard}) {
        EXPECT_EQ(methodReadingFromName(nameOf(reading)), reading);
        EXPECT_EQ(problemOf(configOf(reading)), "");
        AdaptiveOtfConfig config = configOf(reading);
        EXPECT_EQ(readingOf(config), reading);
        config.grid.columns = 3;
        config.grid.spacing = 4;
        config.initial = PowerCurve{4, 0.5};
        EXPECT_EQ(readingOf(config), reading) << "grid and initial function belong to no reading";
        config.surface.lowReach += 1;
        EXPECT_EQ(readingOf(config), std::nullopt);
    }
    EXPECT_FALSE(methodReadingFromName("literal"));
    EXPECT_EQ(configOf(MethodReading::standard), AdaptiveOtfConfig{});
}

TEST(MethodReading, PublishedAndSettledHaveADMaxOf3PercentAtThePapers225Tubes) {
    for (const MethodReading reading : {MethodReading::asPublished, MethodReading::settled})
        EXPECT_DOUBLE_EQ(strengthOf(configOf(reading).curve) / 225, 0.03);
}

/// The literal reading of one tube, straight from the paper's words: everything is in long double and plain loops.
struct LiteralTube {
    std::vector<long double> means, variances;
    int surface = -1;
    long double low = 0, lowMax = 0, high = 0, slope = 0;
};

constexpr int cellSize = 5;
using Values = std::vector<long double>;

LiteralTube cellsAlong(const Volume& volume, const Vec3& first) {
    LiteralTube tube;
    const auto& size = volume.geometry().size;
    const std::int64_t x0 = std::llround(first[0] - 2), y0 = std::llround(first[1] - 2), z0 = std::llround(first[2]);
    for (std::int64_t z = z0; z + cellSize <= size[2]; ++z) {
        Values inside;
        for (std::int64_t k = z; k < z + cellSize; ++k)
            for (std::int64_t y = std::max<std::int64_t>(y0, 0); y < std::min(y0 + cellSize, size[1]); ++y)
                for (std::int64_t x = std::max<std::int64_t>(x0, 0); x < std::min(x0 + cellSize, size[0]); ++x)
                    inside.push_back(volume.normalisedIntensity(volume.geometry().offset(x, y, k)));
        long double mean = 0, variance = 0;
        for (const long double value : inside) mean += value / static_cast<long double>(inside.size());
        for (const long double value : inside)
            variance += (value - mean) * (value - mean) / static_cast<long double>(inside.size());
        tube.means.push_back(mean);
        tube.variances.push_back(variance);
    }
    return tube;
}

Values onARing(const Values& function, double sigma) {
    const int count = static_cast<int>(function.size()), radius = static_cast<int>(3 * sigma);
    long double all = 0;
    for (int j = -radius; j <= radius; ++j) all += std::exp(-0.5L * j * j / sigma / sigma);
    Values result(function.size(), 0);
    for (int i = 0; i < count; ++i)
        for (int j = -radius; j <= radius; ++j)
            result[static_cast<std::size_t>(i)] +=
                std::exp(-0.5L * j * j / sigma / sigma) / all *
                function[static_cast<std::size_t>(((i + j) % count + count) % count)];
    return result;
}

/// The first sample from `from` to `to` that is larger than both its neighbours; it is -1 where there is none.
int firstMaximum(const Values& function, int from, int to) {
    for (int i = std::max(from, 1); i <= std::min(to, static_cast<int>(function.size()) - 2); ++i) {
        const auto at = static_cast<std::size_t>(i);
        if (function[at] > function[at - 1] && function[at] > function[at + 1]) return i;
    }
    return -1;
}

void detect(LiteralTube& tube) {
    const int last = static_cast<int>(tube.means.size()) - 1;
    int from = 0, to = last, position = -1;
    for (const int sigma : {32, 16, 8, 4, 2}) {
        const int maximum = firstMaximum(onARing(tube.variances, sigma), from, to);
        if (maximum < 0 && position < 0) return;
        if (maximum < 0) continue;
        position = maximum;
        from = position - 2 * sigma;
        to = position + 2 * sigma;
    }
    const int maximum = firstMaximum(tube.variances, from, to);
    if (maximum >= 0) position = maximum;
    if (position < 1) return;
    tube.surface = position;
    for (int i = 0; i < position; ++i) {
        tube.low += tube.means[static_cast<std::size_t>(i)] / position;
        tube.lowMax = std::max(tube.lowMax, tube.means[static_cast<std::size_t>(i)]);
    }
    tube.high = tube.means[static_cast<std::size_t>(position)];
    const int before = std::max(position - 5, 0), behind = std::min(position + 5, last);
    tube.slope = (tube.means[static_cast<std::size_t>(behind)] - tube.means[static_cast<std::size_t>(before)]) /
                 (behind - before);
}

/// The share of the values in bins up to this value's, of 256 bins from 0 to the largest.
long double cumulated(const Values& values, long double value, int total) {
    const long double largest = *std::max_element(values.begin(), values.end());
    const auto bin = [&](long double v) { return std::min(255, static_cast<int>(v / largest * 256)); };
    int count = 0;
    for (const long double other : values) count += bin(other) <= bin(value) ? 1 : 0;
    return static_cast<long double>(count) / total;
}

std::vector<long double> literalWeights(const std::vector<LiteralTube>& tubes) {
    Values lowMaxima, slopes, d;
    for (const LiteralTube& tube : tubes) {
        if (tube.surface < 0) continue;
        lowMaxima.push_back(tube.lowMax);
        if (tube.slope > 0) slopes.push_back(tube.slope);
    }
    const int total = static_cast<int>(tubes.size());
    for (const LiteralTube& tube : tubes) {
        const bool counts = tube.surface >= 0 && tube.slope > 0 && tube.high > tube.low;
        d.push_back(counts ? 6.75L / total * (1 - cumulated(lowMaxima, tube.lowMax, total)) *
                                 cumulated(slopes, tube.slope, total)
                           : 0);
    }
    return d;
}

TEST(PublishedReading, EqualsASlowProgramOfItsOwn) {
    PhantomConfig phantom = defaultPhantom(PhantomScene::shapes);
    phantom.size = {96, 90, 118};
    phantom.seed = 31;
    const Volume volume = *makePhantom(phantom);
    AdaptiveOtfConfig config = configOf(MethodReading::asPublished);
    config.cells.precision = Precision::double64;
    config.grid.columns = config.grid.rows = 11;
    const AdaptiveOtf result = *adaptOpacity(volume, {}, config);
    std::vector<LiteralTube> expected;
    for (const TubeCore& tube : result.tubes) {
        ASSERT_NE(tube.status, TubeStatus::outside);
        expected.push_back(cellsAlong(volume, tube.firstSampleVoxel));
        detect(expected.back());
    }
    const auto d = literalWeights(expected);
    int surfaces = 0;
    long double sum = 0;
    for (std::size_t t = 0; t < result.tubes.size(); ++t) {
        const TubeCore& tube = result.tubes[t];
        EXPECT_EQ(tube.surfaceCell, expected[t].surface) << t;
        EXPECT_NEAR(tube.d, static_cast<double>(d[t]), 1e-12) << t;
        sum += d[t];
        if (expected[t].surface < 0) continue;
        ++surfaces;
        EXPECT_NEAR(tube.lowIntensity.value(), static_cast<double>(expected[t].low), 1e-12);
        EXPECT_NEAR(tube.lowIntensityMax.value(), static_cast<double>(expected[t].lowMax), 1e-12);
        EXPECT_NEAR(tube.highIntensity.value(), static_cast<double>(expected[t].high), 1e-12);
        EXPECT_NEAR(tube.slope.value(), static_cast<double>(expected[t].slope), 1e-12);
    }
    std::printf("published reading: %d of %zu tubes with a surface, sum of d %.4f\n", surfaces, result.tubes.size(),
                static_cast<double>(sum));
    EXPECT_GT(surfaces, 60);
    EXPECT_GT(sum, 0.1L);
    for (std::size_t i = 1; i < result.logOpacity.size(); ++i) {
        const long double x = static_cast<long double>(i) / (AdaptiveOtf::sampleCount - 1);
        long double expectedLog = 2 * std::log(x);
        for (std::size_t t = 0; t < expected.size(); ++t) {
            if (d[t] == 0) continue;
            const long double gap = expected[t].high - expected[t].low, b = 2 / (gap * gap),
                              c = 1 / std::sqrt(2 * b) + expected[t].low;
            expectedLog +=
                std::log1p(d[t]) * std::sqrt(2 * b * std::exp(1.0L)) * (x - c) * std::exp(-b * (x - c) * (x - c));
        }
        EXPECT_NEAR(result.logOpacity[i], static_cast<double>(expectedLog), 1e-10) << i;
    }
}

}  // namespace
}  // namespace echolucent
