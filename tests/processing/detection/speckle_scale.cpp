// The scale of intensity on which speckle is equally strong, from slabs whose mean and spread are known.
#include "processing/detection/speckle_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "profile_samples.h"

namespace echolucent {
namespace {

/// Slabs of all means between two, with a spread that follows from the mean and is uncertain by a seventh.
std::vector<MadeProfile> slabsBetween(double least, double most, const std::function<double(double)>& spreadOf,
                                      int tubes = 225) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> means(least, most);
    std::normal_distribution<double> uncertain(0.0, 0.14);
    std::vector<MadeProfile> made(static_cast<std::size_t>(tubes));
    for (MadeProfile& profile : made)
        for (int k = 0; k < 200; ++k) {
            profile.means.push_back(means(random));
            profile.spreads.push_back(spreadOf(profile.means.back()) * std::exp(uncertain(random)));
        }
    return made;
}

TEST(SpeckleScale, OfMultiplicativeSpeckleIsALogarithm) {
    for (const double share : {0.08, 0.25, 0.5}) {
        const SpeckleScale scale(profilesOf(slabsBetween(0.05, 0.95, [&](double m) { return share * m; })));
        // One unit is one standard deviation: d scaled = dm / (share m). Medians of bins stand within 2 %, and the
        // spread, which may not grow faster than the mean, follows the least of them: 4 %.
        for (double mean = 0.06; mean < 0.46; mean += 0.05) {
            EXPECT_NEAR(scale.spreadAt(mean), share * mean, 0.04 * share * mean) << mean;
            EXPECT_NEAR(scale.scaled(2 * mean) - scale.scaled(mean), std::log(2.0) / share,
                        0.04 * std::log(2.0) / share)
                << mean;
        }
    }
}

TEST(SpeckleScale, OfConstantSpreadIsTheIntensityItself) {
    const double spread = 0.06;
    const SpeckleScale scale(profilesOf(slabsBetween(0.02, 0.98, [&](double) { return spread; })));
    for (double mean = 0.05; mean < 0.95; mean += 0.05)
        EXPECT_NEAR(scale.scaled(mean + 0.05) - scale.scaled(mean), 0.05 / spread, 0.02 * 0.05 / spread) << mean;
}

TEST(SpeckleScale, BetweenRawAndCompressedEchoFollowsTheSpread) {
    // Where the spread is a + b m, the scale is ln(a + b m) / b.
    const double a = 0.02, b = 0.15;
    const SpeckleScale scale(profilesOf(slabsBetween(0.02, 0.98, [&](double m) { return a + b * m; })));
    for (double mean = 0.05; mean < 0.85; mean += 0.1) {
        const double expected = std::log((a + b * (mean + 0.1)) / (a + b * mean)) / b;
        EXPECT_NEAR(scale.scaled(mean + 0.1) - scale.scaled(mean), expected, 0.02 * expected) << mean;
    }
}

TEST(SpeckleScale, RisesFromZeroAndHasAnInverse) {
    const auto multiplicative = slabsBetween(0.05, 0.6, [](double m) { return 0.3 * m; });
    const auto constant = slabsBetween(0.0, 1.0, [](double) { return 0.05; });
    const auto still = slabsBetween(0.2, 0.3, [](double) { return 0.0; });
    for (const auto& made : {multiplicative, constant, still, std::vector<MadeProfile>(9)}) {
        const SpeckleScale scale(profilesOf(made));
        EXPECT_EQ(scale.scaled(0.0), 0.0);
        std::vector<float> intensities;
        for (int i = 0; i <= 2000; ++i) intensities.push_back(static_cast<float>(i) / 2000.0f);
        std::vector<float> results(intensities.size());
        scale.scale(intensities, results);
        for (std::size_t i = 0; i < intensities.size(); ++i) {
            const double scaled = scale.scaled(intensities[i]);
            EXPECT_GT(scale.spreadAt(intensities[i]), 0.0);
            EXPECT_FLOAT_EQ(results[i], static_cast<float>(scaled));
            EXPECT_NEAR(scale.intensityAt(scaled), intensities[i], 1e-12);
            if (i > 0) {
                EXPECT_GT(scaled, scale.scaled(intensities[i - 1]));
            }
        }
        EXPECT_EQ(scale.intensityAt(-1.0), 0.0);
        EXPECT_EQ(scale.intensityAt(scale.scaled(1.0) + 1.0), 1.0);
    }
}

TEST(SpeckleScale, DoesNotSeeSlabsThatStraddleAWall) {
    SpeckledSlabs slabs(3);
    std::vector<MadeProfile> made;
    for (int t = 0; t < 225; ++t) {
        std::vector<double> levels;
        for (int k = 0; k < 200; ++k)
            levels.push_back(k % 100 < 50 ? slabs.drawn(0.04, 0.08) : slabs.drawn(0.25, 0.35));
        made.push_back(slabs.around(levels));
    }
    const SpeckleScale clean{profilesOf(made)};
    // Two in a hundred slabs hold both: a mean between and the spread of two levels.
    for (MadeProfile& profile : made)
        for (const std::size_t at : {17u, 18u, 101u, 160u}) {
            const double share = slabs.drawn(0.1, 0.9), low = 0.06, high = 0.3;
            profile.means[at] = low + share * (high - low);
            profile.spreads[at] = std::sqrt(share * (1 - share)) * (high - low);
        }
    const SpeckleScale straddled{profilesOf(made)};
    for (double mean = 0.0; mean <= 1.0; mean += 0.01) {
        EXPECT_NEAR(straddled.spreadAt(mean), clean.spreadAt(mean), 0.05 * clean.spreadAt(mean)) << mean;
        EXPECT_NEAR(straddled.scaled(mean), clean.scaled(mean), 0.03 * clean.scaled(mean)) << mean;
    }
}

}  // namespace
}  // namespace echolucent
