// The sums of a histogram volume: by their plain definition, and in closed form.
#include "processing/designers/gradients/histogram_volume.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <span>

#include "processing/sampling/gradient_magnitude.h"
#include "tests/processing/designers/gradients/blurred_steps.h"
#include "tests/processing/speckle_reduction/noisy_volumes.h"

namespace echolucent {
namespace {

double bumps(std::int64_t x, std::int64_t y, std::int64_t z) {
    return 90.0 + 50.0 * std::sin(0.7 * static_cast<double>(x)) * std::cos(0.5 * static_cast<double>(y - 2 * z));
}

/// The derivatives of one voxel as they are defined, in double.
class PlainDerivatives {
public:
    explicit PlainDerivatives(const Volume& volume) : m_volume(volume), m_geometry(volume.geometry()) {}

    [[nodiscard]] double intensity(const Vec3& voxel) const { return m_volume.normalisedIntensity(offset(voxel)); }
    [[nodiscard]] Vec3 gradient(const Vec3& voxel) const {
        Vec3 all;
        for (int axis = 0; axis < 3; ++axis)
            all[axis] = (intensity(voxel + step(axis)) - intensity(voxel - step(axis))) / (2.0 * units(axis));
        return all;
    }
    [[nodiscard]] double second(const Vec3& voxel) const {
        double laplacian = 0.0, divergence = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double sides = intensity(voxel + step(axis)) + intensity(voxel - step(axis));
            laplacian += (sides - 2.0 * intensity(voxel)) / (units(axis) * units(axis));
            divergence += (unit(voxel + step(axis))[axis] - unit(voxel - step(axis))[axis]) / (2.0 * units(axis));
        }
        return laplacian - length(gradient(voxel)) * divergence;
    }
    /// Whether all voxels carry data that the second derivative is made of.
    [[nodiscard]] bool known(const Vec3& voxel) const {
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                const Vec3 beside = voxel + step(axis) * side;
                if (!isData(voxel) || !isData(beside)) return false;
                for (int other = 0; other < 3; ++other)
                    if (!isData(beside + step(other)) || !isData(beside - step(other))) return false;
            }
        return true;
    }

private:
    [[nodiscard]] std::int64_t offset(const Vec3& voxel) const {
        return m_geometry.offset(std::llround(voxel[0]), std::llround(voxel[1]), std::llround(voxel[2]));
    }
    [[nodiscard]] static Vec3 step(int axis) {
        Vec3 all(0, 0, 0);
        all[axis] = 1.0;
        return all;
    }
    [[nodiscard]] double units(int axis) const { return m_geometry.spacing[axis] / m_geometry.unit(); }
    [[nodiscard]] Vec3 unit(const Vec3& voxel) const {
        const Vec3 all = gradient(voxel);
        return length(all) > 0.0 ? all / length(all) : all;
    }
    [[nodiscard]] bool isData(const Vec3& voxel) const {
        for (int axis = 0; axis < 3; ++axis)
            if (voxel[axis] < 0 ||
                voxel[axis] > static_cast<double>(m_geometry.size[static_cast<std::size_t>(axis)]) - 1)
                return false;
        return m_volume.hasData(offset(voxel));
    }

    const Volume& m_volume;
    const VolumeGeometry& m_geometry;
};

template <typename Visit>
void forEachVoxel(const VolumeGeometry& geometry, const Visit& visit) {
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) visit(x, y, z);
}

DerivativeSums total(const std::vector<DerivativeSums>& all) {
    DerivativeSums sum;
    for (const DerivativeSums& one : all) sum += one;
    return sum;
}

void expectNear(const DerivativeSums& found, const DerivativeSums& expected, double tolerance) {
    EXPECT_EQ(found.voxels, expected.voxels);
    EXPECT_NEAR(found.intensities, expected.intensities, tolerance);
    EXPECT_NEAR(found.gradients, expected.gradients, tolerance);
    EXPECT_NEAR(found.seconds, expected.seconds, tolerance);
}

TEST(HistogramVolume, HoldsTheSumsOfThePlainDefinition) {
    const VolumeGeometry geometry = gridOf({17, 13, 11}, {0.5, 0.7, 0.9});
    const Volume whole = noisyVolume<std::uint8_t>(geometry, 0.4, bumps);
    const Volume masked =
        whole.withDataMask(maskWithout(geometry, [](auto x, auto y, auto z) { return x + y < z || x == 11 + z / 5; }));
    for (const Volume* volume : {&whole, &masked}) {
        const HistogramVolume found = *histogramVolume(*volume, {.prefilter = 0.0});
        const PlainDerivatives plain(*volume);
        std::vector<DerivativeSums> expected(HistogramVolume::intensityNodes);
        std::uint64_t data = 0, used = 0;
        forEachVoxel(geometry, [&](auto x, auto y, auto z) {
            const Vec3 voxel(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
            data += volume->hasData(geometry.offset(x, y, z)) ? 1 : 0;
            if (!plain.known(voxel)) return;
            ++used;
            // A byte is a node of its own.
            const auto node = static_cast<std::size_t>(volume->storedValue(geometry.offset(x, y, z)));
            expected[node] += {1.0, plain.intensity(voxel), length(plain.gradient(voxel)), plain.second(voxel)};
        });
        EXPECT_EQ(found.dataVoxels, data);
        EXPECT_EQ(found.usedVoxels, used);
        EXPECT_GT(used, 100U);
        for (std::size_t node = 0; node < HistogramVolume::intensityNodes; ++node)
            expectNear(found.overIntensity[node], expected[node], 1e-5 * (1.0 + expected[node].voxels));
    }
}

TEST(HistogramVolume, OverBothCountsVoxelsWherePicturesReadThem) {
    const VolumeGeometry geometry = gridOf({15, 14, 12}, {1.0, 1.0, 1.4});
    const Volume volume = noisyVolume<std::uint8_t>(geometry, 0.4, bumps);
    constexpr int rows = 20;
    const HistogramVolume found = *histogramVolume(volume, {.prefilter = 1.0, .gradients = rows});
    ASSERT_EQ(found.overBoth.size(), static_cast<std::size_t>(rows * HistogramVolume::intensityNodes));
    EXPECT_EQ(found.gradientNodes, rows);
    EXPECT_EQ(found.largestGradient, gradientRange(volume, volume)->largest);
    expectNear(total(found.overBoth), total(found.overIntensity), 1e-6);
    std::vector<double> expected(found.overBoth.size());
    const GradientMagnitude magnitudes(volume);
    std::vector<float> row(15);
    forEachVoxel(geometry, [&](auto x, auto y, auto z) {
        if (x < 3 || y < 3 || z < 3 || x > 11 || y > 10 || z > 8) return;
        magnitudes.row(y, z, row);
        const double gradient = row[static_cast<std::size_t>(x)];
        const auto node = std::lround(gradient / found.largestGradient * (rows - 1));
        ++expected[static_cast<std::size_t>(node * HistogramVolume::intensityNodes) +
                   static_cast<std::size_t>(volume.storedValue(geometry.offset(x, y, z)))];
    });
    for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(found.overBoth[i].voxels, expected[i]) << i;
}

TEST(HistogramVolume, ARampHasItsSlopeAndNoSecondDerivative) {
    // 0.01 per unit along a slanting direction; the smallest spacing is the unit.
    const VolumeGeometry geometry = gridOf({40, 30, 30}, {0.4, 0.6, 0.8});
    const Vec3 direction = normalized({2, 1, -1});
    const Volume volume =
        volumeOf<float>(geometry, [&](const Vec3& place) { return 0.5 + 0.01 * direction.dot(place); });
    const HistogramVolume plain = *histogramVolume(volume, {.prefilter = 0.0});
    const DerivativeSums all = total(plain.overIntensity);
    EXPECT_EQ(all.voxels, 36.0 * 26 * 26);
    EXPECT_NEAR(all.gradients / all.voxels, 0.01, 1e-6);
    EXPECT_NEAR(all.seconds / all.voxels, 0.0, 1e-7);
    // A Gaussian leaves a ramp as it is, and nothing is taken of where the grid cuts it off.
    const HistogramVolume smooth = *histogramVolume(volume, {.prefilter = 1.5});
    for (const DerivativeSums& here : smooth.overIntensity) {
        if (here.voxels == 0.0) continue;
        EXPECT_NEAR(here.gradients / here.voxels, 0.01, 5e-4);
        EXPECT_NEAR(here.seconds / here.voxels, 0.0, 5e-4);
    }
}

TEST(HistogramVolume, CurvatureIsNoSecondDerivativeAlongTheGradient) {
    // Along its gradient a cone rises evenly, while its Laplacian is twice its slope over the radius.
    const VolumeGeometry geometry = gridOf({41, 41, 41});
    const Volume cone = volumeOf<float>(geometry, [](const Vec3& place) { return 0.025 * length(place); });
    const HistogramVolume found = *histogramVolume(cone, {.prefilter = 0.0});
    for (int node = 60; node < 120; ++node) {
        const DerivativeSums here = found.overIntensity[static_cast<std::size_t>(node)];
        const double laplacian = 2.0 * 0.025 / (node / 255.0 / 0.025);
        EXPECT_LT(std::abs(here.seconds / here.voxels), 0.06 * laplacian) << node;
    }
}

TEST(HistogramVolume, WhereTheDataEndsThereIsNoBoundary) {
    const VolumeGeometry geometry = gridOf({24, 20, 18});
    std::vector<std::uint8_t> mask = maskWithout(geometry, [](auto x, auto, auto) { return x < 9; });
    std::vector<std::uint8_t> voxels(mask.size());
    for (std::size_t i = 0; i < mask.size(); ++i) voxels[i] = mask[i] != 0 ? 100 : 255;
    const Volume volume = Volume(geometry, std::move(voxels)).withDataMask(std::move(mask));
    for (const double prefilter : {0.0, 1.0}) {
        const HistogramVolume found = *histogramVolume(volume, {.prefilter = prefilter, .gradients = 8});
        EXPECT_EQ(found.dataVoxels, 15U * 20 * 18);
        const std::uint64_t used = prefilter > 0.0 ? 9 * 14 * 12 : 11 * 16 * 14;
        EXPECT_EQ(found.usedVoxels, used);
        EXPECT_EQ(found.overIntensity[100].voxels, static_cast<double>(used));
        EXPECT_NEAR(found.overIntensity[100].gradients, 0.0, 1e-3);
        EXPECT_NEAR(found.overIntensity[100].seconds, 0.0, 1e-3);
        EXPECT_EQ(found.overBoth[100].voxels, static_cast<double>(used));
    }
}

TEST(HistogramVolume, WhatAScalpelCutCountsNoMoreButIsReadBesideTheCut) {
    const VolumeGeometry geometry = gridOf({20, 18, 16});
    const Volume whole = noisyVolume<std::uint8_t>(geometry, 0.3, bumps);
    const auto cut = std::make_shared<const DataMask>(maskWithout(geometry, [](auto x, auto, auto) { return x < 8; }));
    const Volume other = whole.withCut(
        std::make_shared<const DataMask>(maskWithout(geometry, [](auto x, auto, auto) { return x >= 8; })));
    const HistogramVolumeConfig config{.prefilter = 1.0, .gradients = 16};
    const HistogramVolume all = *histogramVolume(whole, config), rest = *histogramVolume(whole.withCut(cut), config),
                          gone = *histogramVolume(other, config);
    for (std::size_t node = 0; node < HistogramVolume::intensityNodes; ++node) {
        DerivativeSums both = rest.overIntensity[node];
        both += gone.overIntensity[node];
        expectNear(both, all.overIntensity[node], 1e-9);
    }
    EXPECT_EQ(all.largestGradient,
              rest.largestGradient >= gone.largestGradient ? rest.largestGradient : gone.largestGradient);
}

TEST(HistogramVolume, IsTheSameWhereTheVolumeStandsOnItsHead) {
    // A slab ends after its eighth slice, which is another one of the mirrored volume.
    const VolumeGeometry geometry = gridOf({520, 510, 13});
    const Volume volume = noisyVolume<std::uint8_t>(geometry, 0.4, bumps);
    const Volume mirrored = noisyVolume<std::uint8_t>(
        geometry, 0.0, [&](auto x, auto y, auto z) { return volume.storedValue(geometry.offset(x, y, 12 - z)); });
    const HistogramVolume one = *histogramVolume(volume, {.prefilter = 0.7}),
                          other = *histogramVolume(mirrored, {.prefilter = 0.7});
    const DerivativeSums all = total(one.overIntensity), allMirrored = total(other.overIntensity);
    EXPECT_EQ(all.voxels, 514.0 * 504 * 7);
    EXPECT_EQ(all.voxels, allMirrored.voxels);
    EXPECT_NEAR(all.gradients, allMirrored.gradients, 1e-6 * all.voxels);
    EXPECT_NEAR(all.seconds, allMirrored.seconds, 1e-6 * all.voxels);
    for (std::size_t node = 0; node < HistogramVolume::intensityNodes; ++node)
        EXPECT_NEAR(one.overIntensity[node].seconds, other.overIntensity[node].seconds,
                    1e-3 * (1 + all.voxels / HistogramVolume::intensityNodes));
}

TEST(HistogramVolume, HasTheSameBitsForAnyNumberOfThreads) {
    const Volume volume = noisyVolume<std::uint16_t>(gridOf({37, 31, 41}), 0.5, bumps);
    std::vector<HistogramVolume> results;
    for (const std::size_t threads : {1, 2, 5}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        results.push_back(*histogramVolume(volume, {.prefilter = 1.0, .gradients = 32}));
    }
    for (const HistogramVolume& other : results) {
        EXPECT_EQ(other.overIntensity, results[0].overIntensity);
        EXPECT_EQ(other.overBoth, results[0].overBoth);
    }
}

TEST(HistogramVolume, ThinAndEmptyVolumesHaveFiniteSums) {
    for (const std::array<std::int64_t, 3>& size :
         {std::array<std::int64_t, 3>{1, 1, 1}, {4, 4, 4}, {30, 1, 1}, {20, 20, 1}, {3, 20, 20}}) {
        const Volume volume = noisyVolume<std::uint8_t>(gridOf(size), 0.5, bumps);
        const HistogramVolume found = *histogramVolume(volume, {.prefilter = 1.0, .gradients = 4});
        const DerivativeSums all = total(found.overIntensity);
        EXPECT_EQ(all.voxels, static_cast<double>(found.usedVoxels));
        EXPECT_GT(found.usedVoxels, 0U);
        EXPECT_TRUE(std::isfinite(all.gradients) && std::isfinite(all.seconds));
        EXPECT_GT(found.largestGradient, 0.0);
    }
    // Derivatives along an axis are those of a plane where there is but one slice.
    const Volume slice = volumeOf<float>(gridOf({20, 20, 1}), [](const Vec3& place) { return 0.5 + 0.01 * place[0]; });
    const DerivativeSums all = total(histogramVolume(slice, {.prefilter = 0.0})->overIntensity);
    EXPECT_EQ(all.voxels, 256.0);
    EXPECT_NEAR(all.gradients / all.voxels, 0.01, 1e-6);
    const Volume none =
        noisyVolume<std::uint8_t>(gridOf({8, 8, 8}), 0.5, bumps).withDataMask(std::vector<std::uint8_t>(512, 0));
    EXPECT_EQ(histogramVolume(none, {.gradients = 4})->usedVoxels, 0U);
    std::vector<float> floats(1000, 0.25F);
    floats[555] = std::numeric_limits<float>::quiet_NaN();
    floats[7] = std::numeric_limits<float>::infinity();
    const HistogramVolume found = *histogramVolume(Volume(gridOf({10, 10, 10}), std::move(floats), 1.0), {});
    EXPECT_EQ(found.dataVoxels, 998U);
    EXPECT_NEAR(total(found.overIntensity).seconds, 0.0, 1e-4);
}

TEST(HistogramVolume, IsCancelledAndRefusesWhatIsOutOfRange) {
    const Volume volume = noisyVolume<std::uint8_t>(gridOf({12, 12, 12}), 0.5, bumps);
    const std::atomic<bool> cancel = true;
    EXPECT_FALSE(histogramVolume(volume, {}, {{}, &cancel}));
    EXPECT_FALSE(histogramVolume(volume, {.gradients = 8}, {{}, &cancel}));
    EXPECT_THROW((void)histogramVolume(volume, {.prefilter = -1.0}), std::invalid_argument);
    EXPECT_THROW((void)histogramVolume(volume, {.prefilter = std::nan("")}), std::invalid_argument);
    EXPECT_THROW((void)histogramVolume(volume, {.gradients = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
