// Gradient magnitudes between voxels, against those of rows.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "processing/sampling/gradient_magnitude.h"
#include "tests/processing/grids.h"
#include "tests/processing/sampling/gradient_rows.h"

namespace echolucent {
namespace {

template <typename Stored>
Volume noise(const std::array<std::int64_t, 3>& size, const Vec3& spacing, double white) {
    const VolumeGeometry geometry = gridOf(size, spacing);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.2);
    std::vector<Stored> voxels;
    for (std::int64_t i = 0; i < geometry.voxelCount(); ++i)
        voxels.push_back(static_cast<Stored>(std::min(share(random), 1.0) * white));
    return {geometry, voxels, white};
}

std::vector<Volume> volumes() {
    VolumeGeometry geometry;
    geometry.size = {3, 4, 2};
    std::vector<float> holes(24, 0.5f);
    holes[3] = NAN;
    holes[17] = INFINITY;
    holes[8] = 0.9f;
    return {noise<std::uint8_t>({5, 4, 6}, {1, 1, 1}, 255), noise<std::uint16_t>({4, 7, 3}, {0.4, 0.9, 1.7}, 4095),
            noise<float>({6, 1, 5}, {2, 1, 0.5}, 3.5),      noise<std::uint8_t>({1, 1, 1}, {1, 1, 1}, 255),
            noise<float>({1, 2, 1}, {1, 3, 1}, 1),          Volume(geometry, holes, 1.0)};
}

TEST(GradientAtPlaces, OfVoxelCentresIsThatOfRows) {
    for (const Volume& volume : volumes()) {
        const auto rows = magnitudesOf(volume);
        const GradientMagnitude gradients(volume);
        const auto& size = volume.geometry().size;
        for (std::int64_t z = 0; z < size[2]; ++z)
            for (std::int64_t y = 0; y < size[1]; ++y)
                for (std::int64_t x = 0; x < size[0]; ++x) {
                    const Vec3 place(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
                    const float row = rows[static_cast<std::size_t>(volume.geometry().offset(x, y, z))];
                    EXPECT_NEAR(gradients.at(place), static_cast<double>(row), 1e-6) << x << ' ' << y << ' ' << z;
                }
    }
}

TEST(GradientAtPlaces, BetweenVoxelsIsTheTrilinearMeanAndOutsideThatOfTheBorder) {
    for (const Volume& volume : volumes()) {
        const auto rows = magnitudesOf(volume);
        const GradientMagnitude gradients(volume);
        const auto& size = volume.geometry().size;
        std::mt19937 random(3);
        for (int trial = 0; trial < 50; ++trial) {
            Vec3 place;
            for (int axis = 0; axis < 3; ++axis)
                place[axis] = std::uniform_real_distribution<double>(
                    -0.5, static_cast<double>(size[static_cast<std::size_t>(axis)]) - 0.5)(random);
            // Every voxel with the weight of a tent function.
            double mean = 0.0;
            for (std::int64_t z = 0; z < size[2]; ++z)
                for (std::int64_t y = 0; y < size[1]; ++y)
                    for (std::int64_t x = 0; x < size[0]; ++x) {
                        double weight = 1.0;
                        const std::array<std::int64_t, 3> voxel{x, y, z};
                        for (std::size_t axis = 0; axis < 3; ++axis) {
                            const double inside =
                                std::clamp(place[static_cast<int>(axis)], 0.0, static_cast<double>(size[axis] - 1));
                            weight *= std::max(0.0, 1.0 - std::abs(inside - static_cast<double>(voxel[axis])));
                        }
                        const float row = rows[static_cast<std::size_t>(volume.geometry().offset(x, y, z))];
                        mean += weight * static_cast<double>(row);
                    }
            EXPECT_NEAR(gradients.at(place), mean, 1e-6);
        }
    }
}

TEST(GradientAtPlaces, OfARampIsItsSlopePerUnit) {
    // 0.1 a voxel along z, which is 2 mm where the unit is 0.5 mm.
    VolumeGeometry geometry;
    geometry.size = {3, 3, 9};
    geometry.spacing = {0.5, 1, 2};
    std::vector<float> voxels;
    for (int z = 0; z < 9; ++z) voxels.insert(voxels.end(), 9, 0.1f * static_cast<float>(z));
    const Volume volume(geometry, voxels, 1.0);
    EXPECT_NEAR(GradientMagnitude(volume).at({1.2, 0.4, 4.7}), 0.1 / 4, 1e-6);
    EXPECT_NEAR(GradientMagnitude(volume).at({-3, 8, 99}), 0.1 / 4, 1e-6);
}

}  // namespace
}  // namespace echolucent
