#include "processing/tube_core/slabs/profile_kernels.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace echolucent {
namespace {

/// Runs the check on every instruction set of this machine.
template <typename Check>
void onEveryTarget(const Check& check) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        check();
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST(ProfileKernels, MomentsFollowFromExactSums) {
    // The test goes up to the largest sums there are: 1024 values of 65535, where the variance must vanish exactly.
    std::vector<std::int32_t> counts{25, 25, 1, 0, 1024, 1024, 2, 9, 25, 25, 25};
    std::vector<std::int32_t> sums{250, 251, 65535, 0, 1024 * 65535, 512 * 65535, 65535, 81, 25 * 65000, 1, 0};
    std::vector<std::uint64_t> squares{2500,
                                       2521,
                                       65535ull * 65535,
                                       0,
                                       1024ull * 65535 * 65535,
                                       512ull * 65535 * 65535,
                                       65535ull * 65535,
                                       729,
                                       25ull * 65000 * 65000,
                                       1,
                                       0};
    onEveryTarget([&] {
        std::vector<float> means(counts.size()), spreads(counts.size());
        momentsFromSums(counts, sums, squares, 65535.0, means, spreads);
        for (std::size_t k = 0; k < counts.size(); ++k) {
            const long double n = std::max(counts[k], 1), sum = sums[k];
            const long double variance = (n * static_cast<long double>(squares[k]) - sum * sum) / (n * n);
            EXPECT_EQ(means[k], static_cast<float>(static_cast<double>(sum) / (static_cast<double>(n) * 65535.0)));
            // The bound is three roundings of single precision.
            EXPECT_NEAR(spreads[k], static_cast<double>(std::sqrt(variance)) / 65535.0, 3 * 0x1p-24 * 0.5);
            if (variance == 0) {
                EXPECT_EQ(spreads[k], 0.0f);
            }
        }
    });
}

TEST(ProfileKernels, TablesAreLinearBetweenTheirSamplesAndEndAtTheirEnds) {
    std::vector<double> table;
    for (int i = 0; i <= 64; ++i) table.push_back(i * i);
    std::vector<float> positions{-1.0f, 0.0f, 1.0f, 2.0f, 0.5f};
    for (int i = 0; i < 100; ++i) positions.push_back(static_cast<float>(i) / 99.0f);
    onEveryTarget([&] {
        std::vector<float> values(positions.size());
        lookUp(table, positions, values);
        for (std::size_t k = 0; k < positions.size(); ++k) {
            const double at = std::clamp<double>(positions[k], 0.0, 1.0) * 64, low = std::min(std::floor(at), 63.0);
            EXPECT_EQ(values[k], static_cast<float>(low * low + (at - low) * (2 * low + 1)));
        }
    });
}

TEST(ProfileKernels, DifferencesOfMeansAreThoseOfTheDefinition) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> value(0.0f, 50.0f);
    std::vector<float> profile(203);
    for (float& element : profile) element = value(random);
    onEveryTarget([&] {
        for (const auto& [before, behind] : {std::pair{10, 6}, {1, 1}, {3, 20}}) {
            std::vector<float> differences(profile.size() - static_cast<std::size_t>(before + behind) + 1);
            differencesOfMeans(profile, before, behind, differences);
            for (std::size_t i = 0; i < differences.size(); ++i) {
                long double front = 0, back = 0;
                for (int k = 0; k < before; ++k) front += profile[i + static_cast<std::size_t>(k)];
                for (int k = 0; k < behind; ++k) back += profile[i + static_cast<std::size_t>(before + k)];
                EXPECT_NEAR(differences[i], static_cast<double>(back / behind - front / before), 50 * 0x1p-24);
            }
        }
    });
}

TEST(ProfileKernels, AConvolutionIsThePlainSumInItsOrder) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    std::vector<double> function(300), weights(25);
    for (double& element : function) element = value(random);
    for (double& weight : weights) weight = value(random);
    onEveryTarget([&] {
        for (const std::size_t count : {8u, 64u, 104u, 248u}) {
            std::vector<double> results(count);
            convolve(function.data() + 24, weights, results);
            for (std::size_t i = 0; i < count; ++i) {
                const double* at = function.data() + 24 + i;
                double sum = weights[0] * at[0];
                for (std::ptrdiff_t d = 1; d < 25; ++d) sum += weights[static_cast<std::size_t>(d)] * (at[-d] + at[d]);
                EXPECT_EQ(results[i], sum) << "bit for bit";
            }
        }
    });
}

}  // namespace
}  // namespace echolucent
