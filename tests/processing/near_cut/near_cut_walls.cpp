// The search for the near cut where walls slant and bulge, at any resolution, and where there is no fluid.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "processing/near_cut/near_cut.h"
#include "processing/near_cut/smooth_echo.h"
#include "processing/near_cut/tissue_level.h"
#include "processing/near_cut/tube_echo.h"

namespace echolucent {
namespace {

using Material = std::function<double(const Vec3& mm)>;  ///< stored value, 0 ... 255

VolumeGeometry cubeGeometry(std::array<std::int64_t, 3> size, const Vec3& spacing) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    return geometry;
}

/// A volume with multiplicative speckle two voxels wide.
Volume painted(const VolumeGeometry& geometry, const Material& material, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    std::vector<double> speckle((voxels.size() + 7) / 4);
    for (double& value : speckle)
        value = std::sqrt(-4.0 / std::numbers::pi * std::log((random() + 0.5) / 4294967296.0));  // Rayleigh, mean 1
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const std::int64_t coarse =
                    x / 2 + geometry.size[0] / 2 * (y / 2 + (geometry.size[1] / 2 + 1) * (z / 2));
                const double grain = speckle[static_cast<std::size_t>(coarse) % speckle.size()];
                const double value = material(geometry.gridMmFromVoxel(Vec3(
                                         static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)))) *
                                     grain;
                voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] =
                    static_cast<std::uint8_t>(std::min(255.0, value));
            }
    return {geometry, std::move(voxels)};
}

constexpr double fluid = 14, tissue = 85, cubeEdge = 48;  // mm, of the cube

/// Where a wall ends that ends at 15 mm in the middle of the cube.
double flatWall(double, double) { return 15; }
double slantedWall(double x, double) { return 20 + (x - cubeEdge / 2) * std::tan(30 * std::numbers::pi / 180); }
double bulgingWall(double x, double y) {
    const double aside = std::hypot(x - cubeEdge / 2, y - cubeEdge / 2);
    return 6 + 14 * std::exp(-aside * aside / (2 * 13 * 13));
}

/// A wall, 10 mm of fluid behind it, and tissue.
Material behindWall(double (*wall)(double, double)) {
    return [wall](const Vec3& mm) {
        const double behind = mm[2] - wall(mm[0], mm[1]);
        return behind >= 0 && behind < 10 ? fluid : tissue;
    };
}

const VolumeGeometry cube = cubeGeometry({96, 96, 96}, {0.5, 0.5, 0.5});

/// The share of lines along z, away from the cube's sides, that are in fluid where a depth says.
double shareInFluid(const Material& material, const std::function<double(const Vec3&)>& depthOf) {
    int lines = 0, inFluid = 0;
    for (double x = 2; x < cubeEdge - 2; x += 1)
        for (double y = 2; y < cubeEdge - 2; y += 1) {
            const double depth = depthOf({x, y, 0});
            ++lines;
            inFluid += material({x, y, depth}) == fluid;
        }
    return static_cast<double>(inFluid) / lines;
}

TEST(NearCutWalls, TheCurvedCutOpensFluidBehindWallsThatSlantAndBulge) {
    struct Case {
        const char* name;
        double (*wall)(double, double);
        double leastFlat, leastCurved, mostFlat;
    };
    for (const Case& one :
         {Case{"flat", flatWall, 0.97, 0.97, 1.0}, Case{"slanted by 30 degrees", slantedWall, 0.15, 0.95, 0.6},
          Case{"bulging", bulgingWall, 0.3, 0.95, 0.8}}) {
        const Material material = behindWall(one.wall);
        const auto found = *findNearCut(painted(cube, material), {});
        ASSERT_EQ(found.answer, NearCutAnswer::wallBeforeFluid) << one.name;
        ASSERT_TRUE(found.surface) << one.name;
        EXPECT_EQ(problemOf(*found.surface), "");
        const double flat = shareInFluid(material, [&](const Vec3&) { return found.nearCutMm - 0.25; });
        const double curved = shareInFluid(material, [&](const Vec3& place) { return found.surface->depthAt(place); });
        std::printf("%s: %.3f of the lines in fluid behind the flat cut at %.2f mm, %.3f behind the curved one\n",
                    one.name, flat, found.nearCutMm, curved);
        EXPECT_GE(flat, one.leastFlat) << one.name;
        EXPECT_LE(flat, one.mostFlat) << one.name;
        EXPECT_GE(curved, one.leastCurved) << one.name;
        EXPECT_TRUE(found.sure) << one.name;
    }
}

TEST(NearCutWalls, TubeCoresThatSawNothingDoNotDentTheCurvedCut) {
    const Material whole = behindWall(slantedWall);
    // Plugs of tissue, 30 % of the area.
    const Material plugged = [&](const Vec3& mm) {
        const bool plug = std::fmod(mm[0], 12.0) < 6.6 && std::fmod(mm[1], 12.0) < 6.6;
        return plug ? tissue : whole(mm);
    };
    const auto found = *findNearCut(painted(cube, plugged), {});
    ASSERT_TRUE(found.surface);
    // The fluid that the plugs hide is known: the surface lies in it there too.
    EXPECT_GE(shareInFluid(whole, [&](const Vec3& place) { return found.surface->depthAt(place); }), 0.95);
}

TEST(NearCutWalls, SpeckleWithoutFluidIsNoFluid) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const auto found = *findNearCut(painted(
                                            cube, [](const Vec3&) { return tissue; }, seed),
                                        {});
        EXPECT_EQ(found.answer, NearCutAnswer::noFluid);
        EXPECT_EQ(found.nearCutMm, 0.0);
        EXPECT_FALSE(found.surface);
        EXPECT_EQ(found.tubesThatSaySo, found.tubes);
        EXPECT_TRUE(found.sure);
    }
}

TEST(NearCutWalls, ShadowWithoutAFarWallIsNoFluid) {
    const auto shadow = [](const Vec3& mm) { return mm[2] < 12 || mm[0] < 24 ? tissue : fluid; };
    EXPECT_EQ(findNearCut(painted(cube, shadow), {})->answer, NearCutAnswer::noFluid);
}

TEST(NearCutWalls, FluidAtTheFrontSaysSo) {
    const auto found = *findNearCut(painted(cube, [](const Vec3& mm) { return mm[2] < 20 ? fluid : tissue; }), {});
    EXPECT_EQ(found.answer, NearCutAnswer::fluidAtFront);
    EXPECT_EQ(found.nearCutMm, 0.0);
    EXPECT_GT(found.tubesThatSaySo, 0.9 * found.tubes);
    EXPECT_TRUE(found.sure);
}

TEST(NearCutWalls, NothingButNoDataIsNoFluid) {
    const Volume volume = painted(cube, behindWall(flatWall));
    const auto found =
        *findNearCut(volume.withDataMask(std::vector<std::uint8_t>(static_cast<std::size_t>(cube.voxelCount()))), {});
    EXPECT_EQ(found.answer, NearCutAnswer::noFluid);
    EXPECT_EQ(found.tubes, 0);
}

/// A ball of fluid with a smaller one beside it.
double chambers(const Vec3& mm) {
    return length(mm - Vec3(21, 25, 26)) < 9 || length(mm - Vec3(37, 22, 28)) < 5 ? fluid : tissue;
}

TEST(NearCutWalls, ResolutionDoesNotMoveTheCut) {
    const double coarse = findNearCut(painted(cube, chambers), {})->behindDataMm;
    EXPECT_GT(coarse, 17.0) << "the chamber begins there";
    EXPECT_LT(coarse, 24.0) << "most of the chamber is left";
    const VolumeGeometry others[] = {cubeGeometry({192, 192, 192}, {0.25, 0.25, 0.25}),
                                     cubeGeometry({48, 48, 48}, {1, 1, 1}),
                                     cubeGeometry({192, 160, 48}, {0.25, 0.3, 1})};
    for (const VolumeGeometry& geometry : others)
        EXPECT_NEAR(findNearCut(painted(geometry, chambers), {})->behindDataMm, coarse, 1.0);
}

TEST(NearCutWalls, NeighbouringViewsGiveTheSameDepth) {
    const Volume volume = painted(cube, chambers);
    const Vec3 chamber(21, 25, 26);
    for (const BeamAxis axis : {BeamAxis::plusZ, BeamAxis::minusY})
        for (const auto& [azimuth, elevation] : {std::pair{0.0, 0.0}, {10.0, 0.0}, {-10.0, 0.0}, {5.0, 10.0}}) {
            Viewpoint view{.beamAxis = axis, .azimuthDegrees = azimuth, .elevationDegrees = elevation};
            view = withFrontAcross(view, findNearCut(volume, view)->nearCutMm);
            const double before = frameOf(view).forward.dot(chamber) - nearPlaneDepthMm(view, volume.geometry());
            EXPECT_GT(before, 4.0) << azimuth << " " << elevation;
            EXPECT_LT(before, 9.0) << azimuth << " " << elevation << ": the cut lies inside the chamber of 9 mm";
        }
}

TEST(NearCutWalls, DepthCountsFromTheDataAndTheOutsideIsNoFluid) {
    const Volume whole = painted(cube, behindWall(flatWall));
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(cube.voxelCount()), 1);
    for (std::int64_t z = 0; z < 96; ++z)
        for (std::int64_t y = 0; y < 96; ++y)
            for (std::int64_t x = 0; x < 96; ++x)
                if (z < 16 || std::abs(x - 48) > z / 2 + 20) mask[static_cast<std::size_t>(cube.offset(x, y, z))] = 0;
    const auto found = *findNearCut(whole.withDataMask(mask), {});
    ASSERT_EQ(found.answer, NearCutAnswer::wallBeforeFluid);
    EXPECT_NEAR(found.nearCutMm, 17.0, 2.0);
    EXPECT_NEAR(found.nearCutMm - found.behindDataMm, 8.0, 0.6) << "16 slices of 0.5 mm hold no data";
}

TEST(NearCutWalls, TheViewsOwnCutsPlayNoPart) {
    const Volume volume = painted(cube, behindWall(slantedWall));
    const auto uncut = *findNearCut(volume, {});
    Viewpoint cut = withFrontAcross({}, 30);
    cut.cutSurface = uncut.surface;
    const auto again = *findNearCut(volume, cut);
    EXPECT_EQ(again.nearCutMm, uncut.nearCutMm);
    EXPECT_TRUE(again.surface == uncut.surface);
}

TEST(NearCutWalls, TheSameBitsForAnyNumberOfThreads) {
    const Volume volume = painted(cube, behindWall(bulgingWall));
    std::vector<NearCutFinding> found;
    for (const std::size_t threads : {1U, 3U}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        found.push_back(*findNearCut(volume, {}));
    }
    EXPECT_EQ(found[0].nearCutMm, found[1].nearCutMm);
    EXPECT_EQ(found[0].confidence, found[1].confidence);
    EXPECT_TRUE(found[0].surface && found[0].surface == found[1].surface);
}

TEST(NearCutWalls, ACancelledSearchIsEmpty) {
    const std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(findNearCut(painted(cubeGeometry({32, 32, 32}, {1, 1, 1}), chambers), {}, progress));
}

TEST(NearCutWalls, TheCoarseEchoOfAnEvenVolumeIsEven) {
    const VolumeGeometry geometry = cubeGeometry({40, 30, 70}, {0.7, 1, 0.4});
    const Volume volume(geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()), 51));
    const auto coarse = *SmoothEcho::of(volume, {});
    EXPECT_NEAR(coarse.dataExtentMm(), std::cbrt(28.0 * 30 * 28), 1e-9);
    EXPECT_NEAR(length(coarse.dataCentreMm() - geometry.centreMm()), 0.0, 1e-3);
    for (const float intensity : coarse.intensities()) EXPECT_NEAR(intensity, 0.2, 1e-5);
    EXPECT_FALSE(coarse.at(geometry.boxMaxMm() + Vec3(2, 0, 0)));
}

TEST(NearCutWalls, TissueIsTheBrighterOfTwoClasses) {
    EXPECT_NEAR(*tissueLevel({0.1F, 0.6F, 0.1F, 0.7F, 0.5F}), 0.6, 1e-6);
    EXPECT_FALSE(tissueLevel({}));
    EXPECT_FALSE(tissueLevel({0.0F, 0.0F}));
}

}  // namespace
}  // namespace echolucent
