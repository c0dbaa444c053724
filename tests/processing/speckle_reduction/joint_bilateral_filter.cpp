// What the joint bilateral filter keeps that a Gaussian does not, and the speckle that it measures.
#include "processing/speckle_reduction/joint_bilateral_filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "processing/speckle_reduction/gaussian_filter.h"
#include "processing/speckle_reduction/speckle_law.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "tests/processing/speckle_reduction/joint_bilateral_passes.h"
#include "tests/processing/speckle_reduction/noisy_volumes.h"

namespace echolucent {
namespace {

double meanOfSlice(const Volume& volume, std::int64_t slice) {
    return momentsOf(volume, [&](auto, auto, auto z) { return z == slice; }).mean;
}

TEST(JointBilateral, KeepsAMembraneThatAGaussianWashesOut) {
    const auto membrane = [](auto, auto, auto z) { return z == 15 || z == 16 ? 90.0 : 20.0; };
    const Volume volume = noisyVolume<std::uint8_t>(gridOf({32, 32, 32}), 0.4, membrane);
    const Volume kept = *jointBilateralFiltered(volume, onePass), washed = *gaussianFiltered(volume, 1.6);
    const auto contrast = [](const Volume& of) { return meanOfSlice(of, 15) - meanOfSlice(of, 4); };
    EXPECT_GT(contrast(kept), 0.85 * contrast(volume));
    EXPECT_LT(contrast(washed), 0.6 * contrast(volume));
}

TEST(JointBilateral, LeavesAStepWhereItIs) {
    const auto step = [](auto x, auto, auto) { return x < 16 ? 30.0 : 120.0; };
    const Volume volume = noisyVolume<float>(gridOf({32, 24, 24}), 0.3, step, 255.0);
    const Volume quiet = *jointBilateralFiltered(volume, onePass);
    const auto column = [&](std::int64_t at) {
        return momentsOf(quiet, [&](auto x, auto, auto) { return x == at; }).mean;
    };
    EXPECT_NEAR(column(14), 30.0, 3.0);
    EXPECT_NEAR(column(15), 30.0, 9.0);
    EXPECT_NEAR(column(16), 120.0, 9.0);
    EXPECT_NEAR(column(17), 120.0, 3.0);
}

TEST(JointBilateral, AgreesWithThePlainMeanWhereAllIsAlike) {
    // So wide a reach that every voxel counts as like: the mean over a ball, weighted by distance.
    const Volume volume = noisyVolume<float>(
        gridOf({13, 12, 11}), 0.2, [](auto, auto, auto) { return 100.0; }, 255.0);
    const std::array passes{JointBilateralPass{.spreads = 1e4, .radius = 2.0, .sigma = 1.5}};
    const Volume quiet = *jointBilateralFiltered(volume, passes);
    double sum = 0, weights = 0;
    for (int z = -2; z <= 2; ++z)
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x) {
                const int squared = x * x + y * y + z * z;
                if (squared > 4) continue;
                const double weight = std::exp(-squared / 4.5);
                weights += weight;
                sum += weight * volume.storedValue(volume.geometry().offset(6 + x, 5 + y, 4 + z));
            }
    EXPECT_NEAR(quiet.storedValue(volume.geometry().offset(6, 5, 4)), sum / weights, 1e-3);
}

TEST(JointBilateral, HasNoScaleOfItsOwn) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> echo(0.0F, 1.0F);
    VolumeGeometry geometry;
    geometry.size = {14, 13, 12};
    std::vector<float> usual(static_cast<std::size_t>(geometry.voxelCount()));
    for (float& voxel : usual) voxel = echo(random);
    const auto quietOf = [&](float scale) {
        std::vector<float> scaled = usual;
        for (float& voxel : scaled) voxel *= scale;
        return *quietVolume(Volume(geometry, scaled, static_cast<double>(scale)), SpeckleReduction::medium);
    };
    const Volume expected = quietOf(1.0F);
    for (const float scale : {1e36F, 1e-36F}) {
        const Volume quiet = quietOf(scale);
        for (std::int64_t i = 0; i < geometry.voxelCount(); ++i)
            ASSERT_NEAR(quiet.storedValue(i) / static_cast<double>(scale), expected.storedValue(i), 1e-5) << scale;
    }
}

TEST(JointBilateral, RefusesAPassThatMakesNoSense) {
    const Volume volume = noisyVolume<float>(gridOf({3, 3, 3}), 0.0, [](auto, auto, auto) { return 1.0; });
    for (const JointBilateralPass& pass : {JointBilateralPass{.guideSigma = 0}, JointBilateralPass{.spreads = -1},
                                           JointBilateralPass{.radius = std::nan("")}, JointBilateralPass{.sigma = 0}})
        EXPECT_THROW((void)jointBilateralFiltered(volume, std::array{pass}), std::invalid_argument);
}

TEST(SpeckleLaw, FindsTheExponentAndTheSpreadOfKnownNoise) {
    // Uniform noise in +-30 % of the value, on a slow slope: the spread is 0.3 / sqrt(3) of the intensity.
    const auto slow = [](auto x, auto, auto) { return 20.0 + 2.0 * static_cast<double>(x); };
    const SpeckleLaw multiplied = speckleLawOf(noisyVolume<float>(gridOf({100, 60, 60}), 0.3, slow, 255.0));
    EXPECT_GT(multiplied.exponent, 0.85);
    EXPECT_NEAR(multiplied.spreadAt(120.0 / 255.0), 0.3 / std::sqrt(3.0) * 120.0 / 255.0, 0.012);
    // The scale is the integral of 1 / spread.
    const double step = 1e-4, derivative = (multiplied.scaled(0.4 + step) - multiplied.scaled(0.4 - step)) / (2 * step);
    EXPECT_NEAR(derivative * multiplied.spreadAt(0.4), 1.0, 1e-4);
    EXPECT_EQ(speckleLawOf(noisyVolume<float>(gridOf({9, 9, 9}), 0.0, [](auto, auto, auto) { return 5.0; })).exponent,
              0.0);
}

}  // namespace
}  // namespace echolucent
