// The Gaussian against a plain sum over all voxels in double.
#include "processing/speckle_reduction/gaussian_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/processing/speckle_reduction/noisy_volumes.h"

namespace echolucent {
namespace {

double ramp(std::int64_t x, std::int64_t y, std::int64_t z) { return static_cast<double>(20 + 7 * x + 5 * y + 3 * z); }

/// The mean of all voxels with data, weighted by a Gaussian of `sigmas` voxels that is cut at three.
double meanAt(const Volume& volume, const Vec3& sigmas, std::int64_t x, std::int64_t y, std::int64_t z) {
    const VolumeGeometry& geometry = volume.geometry();
    double sum = 0, weights = 0;
    for (std::int64_t k = 0; k < geometry.size[2]; ++k)
        for (std::int64_t j = 0; j < geometry.size[1]; ++j)
            for (std::int64_t i = 0; i < geometry.size[0]; ++i) {
                const Vec3 apart(static_cast<double>(i - x), static_cast<double>(j - y), static_cast<double>(k - z));
                double exponent = 0;
                bool within = volume.hasData(geometry.offset(i, j, k));
                for (int axis = 0; axis < 3; ++axis) {
                    within = within && std::abs(apart[axis]) <= std::ceil(3 * sigmas[axis]);
                    exponent += std::pow(apart[axis] / sigmas[axis], 2);
                }
                if (!within) continue;
                const double weight = std::exp(-exponent / 2);
                sum += weight * volume.storedValue(geometry.offset(i, j, k));
                weights += weight;
            }
    return sum / weights;
}

void expectMeans(const Volume& volume, double sigma, const Vec3& sigmas, double tolerance) {
    const Volume quiet = *gaussianFiltered(volume, sigma);
    const VolumeGeometry& geometry = volume.geometry();
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                if (!volume.hasData(geometry.offset(x, y, z))) continue;
                ASSERT_NEAR(quiet.storedValue(geometry.offset(x, y, z)), meanAt(volume, sigmas, x, y, z), tolerance)
                    << x << " " << y << " " << z;
            }
}

TEST(GaussianFilter, IsAMeanOverAllVoxelsWithData) {
    const VolumeGeometry geometry = gridOf({19, 9, 7});
    const auto mask = maskWithout(geometry, [](auto x, auto y, auto z) { return x + 2 * y < z + 4; });
    for (const double sigma : {0.6, 1.3}) {
        const Vec3 sigmas(sigma, sigma, sigma);
        const Volume bytes = noisyVolume<std::uint8_t>(geometry, 0.3, ramp),
                     floats = noisyVolume<float>(geometry, 0.3, ramp);
        const Volume words = noisyVolume<std::uint16_t>(geometry, 0.3, ramp);
        for (const auto* volume : {&bytes, &words}) {
            expectMeans(*volume, sigma, sigmas, 0.501);
            expectMeans(volume->withDataMask(mask), sigma, sigmas, 0.501);
        }
        expectMeans(floats, sigma, sigmas, 1e-3);
        expectMeans(floats.withDataMask(mask), sigma, sigmas, 1e-3);
    }
}

TEST(GaussianFilter, MeasuresInMeanVoxelsWhereTheSpacingIsKnown) {
    VolumeGeometry geometry = gridOf({12, 11, 10}, {0.5, 1.0, 2.0});
    expectMeans(noisyVolume<float>(geometry, 0.3, ramp), 1.0, {2.0, 1.0, 0.5}, 1e-3);
    geometry.spacingKnown = false;
    expectMeans(noisyVolume<float>(geometry, 0.3, ramp), 1.0, {1.0, 1.0, 1.0}, 1e-3);
    // The spacing of a single slice says nothing.
    expectMeans(noisyVolume<float>(gridOf({12, 11, 1}, {0.5, 2.0, 50.0}), 0.3, ramp), 1.0, {2.0, 0.5, 1.0}, 1e-3);
}

TEST(GaussianFilter, RefusesASigmaThatIsNone) {
    const Volume volume = noisyVolume<float>(gridOf({3, 3, 3}), 0.0, ramp);
    EXPECT_THROW((void)gaussianFiltered(volume, 0.0), std::invalid_argument);
    EXPECT_THROW((void)gaussianFiltered(volume, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
