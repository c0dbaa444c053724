// Planes through a volume: against a closed form, against the plain sampler, and which way round they are.
#include "processing/sampling/plane_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>

#include "processing/sampling/sampler.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {
namespace {

VolumeGeometry anisotropic() {
    VolumeGeometry geometry;
    geometry.size = {19, 23, 17};
    geometry.spacing = {0.7, 1.3, 0.4};
    return geometry;
}

/// A plane that looks along an unusual view through the volume's centre, and reaches beyond its box.
PlaneGrid oblique(const VolumeGeometry& geometry, double azimuth, double elevation, double roll) {
    const ViewFrame frame = frameOf(Viewpoint{BeamAxis::plusZ, azimuth, elevation, roll});
    const double stepMm = 0.31;
    PlaneGrid grid;
    grid.columns = 131;
    grid.rows = 117;
    grid.perColumnMm = frame.right * stepMm;
    grid.perRowMm = frame.down * stepMm;
    grid.firstMm = geometry.centreMm() - grid.perColumnMm * 65.0 - grid.perRowMm * 58.0;
    return grid;
}

Vec3 placeOf(const PlaneGrid& grid, int column, int row) {
    return grid.firstMm + grid.perColumnMm * column + grid.perRowMm * row;
}

float at(const PlaneSamples& samples, int column, int row) {
    return samples.intensity[static_cast<std::size_t>(row) * static_cast<std::size_t>(samples.columns) +
                             static_cast<std::size_t>(column)];
}

constexpr double angles[][3] = {{0, 0, 0}, {90, 0, 0}, {0, -90, 0}, {33, 21, -47}, {-128, 64, 5}, {45, 45, 90}};

TEST(PlaneSampling, ALinearFieldIsReadExactlyInAnyPlane) {
    const VolumeGeometry geometry = anisotropic();
    const Vec3 slope{0.011, 0.017, -0.029};
    const auto field = [&](const Vec3& mm) { return 0.4 + slope.dot(mm); };
    std::vector<float> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x)
                voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] =
                    static_cast<float>(field(geometry.gridMmFromVoxel(
                        {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)})));
    const Volume volume(geometry, Voxels(voxels), 1.0);
    const Vec3 last = geometry.gridMmFromVoxel({18, 22, 16});
    for (const auto& angle : angles) {
        const PlaneGrid grid = oblique(geometry, angle[0], angle[1], angle[2]);
        const PlaneSamples samples = sampledPlane(volume, grid);
        double worst = 0.0;
        int inside = 0;
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const Vec3 mm = placeOf(grid, column, row);
                const bool amongCentres =
                    mm[0] >= 0 && mm[1] >= 0 && mm[2] >= 0 && mm[0] <= last[0] && mm[1] <= last[1] && mm[2] <= last[2];
                if (!amongCentres) continue;
                ++inside;
                worst = std::max(worst, std::abs(static_cast<double>(at(samples, column, row)) - field(mm)));
            }
        EXPECT_GT(inside, 500);
        EXPECT_LT(worst, 1e-5) << angle[0];
    }
}

template <typename Voxel>
Volume speckled(bool withMask) {
    const VolumeGeometry geometry = anisotropic();
    std::mt19937 random(7);
    std::vector<Voxel> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (Voxel& voxel : voxels) voxel = static_cast<Voxel>(random() % 256);
    const Volume volume(geometry, Voxels(voxels), 200.0);
    if (!withMask) return volume;
    std::vector<std::uint8_t> mask(voxels.size());
    for (std::uint8_t& data : mask) data = random() % 4 != 0;
    return volume.withDataMask(mask);
}

void expectLikeThePlainSampler(const Volume& volume) {
    const VolumeSampler sampler(volume);
    for (const auto& angle : angles) {
        const PlaneGrid grid = oblique(volume.geometry(), angle[0], angle[1], angle[2]);
        const PlaneSamples samples = sampledPlane(volume, grid);
        int wrong = 0, nothing = 0;
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const Vec3 voxel = volume.geometry().voxelFromGridMm(placeOf(grid, column, row));
                const auto expected = inBox(volume.geometry(), voxel) ? sampler.intensityAt(voxel) : std::nullopt;
                const auto got = static_cast<double>(at(samples, column, row));
                nothing += !expected;
                wrong += expected ? !(std::abs(got - *expected) < 1e-6) : !std::isnan(got);
            }
        EXPECT_EQ(wrong, 0) << volume.typeName() << " " << angle[0];
        EXPECT_GT(nothing, 0) << "the plane reaches beyond the box";
    }
}

TEST(PlaneSampling, EveryTypeIsReadAsByThePlainSampler) {
    expectLikeThePlainSampler(speckled<std::uint8_t>(false));
    expectLikeThePlainSampler(speckled<std::uint16_t>(false));
    expectLikeThePlainSampler(speckled<float>(false));
}

TEST(PlaneSampling, VoxelsWithoutDataAreLeftOutAsByThePlainSampler) {
    expectLikeThePlainSampler(speckled<std::uint8_t>(true));
    expectLikeThePlainSampler(speckled<float>(true));
}

TEST(PlaneSampling, AVolumeOfOneVoxelIsReadToItsFaces) {
    VolumeGeometry geometry;
    geometry.spacing = {2, 2, 2};
    const Volume volume(geometry, Voxels(std::vector<std::uint8_t>{51}), 255.0);
    const PlaneSamples samples = sampledPlane(volume, {{-1.5, 0, 0}, {0.5, 0, 0}, {0, 1, 0}, 7, 2});
    for (int column = 1; column <= 5; ++column) EXPECT_NEAR(at(samples, column, 1), 0.2, 1e-6) << column;
    EXPECT_TRUE(std::isnan(at(samples, 0, 0)));
    EXPECT_TRUE(std::isnan(at(samples, 6, 0)));
    EXPECT_TRUE(sampledPlane(volume, {}).intensity.empty());
}

}  // namespace
}  // namespace echolucent
