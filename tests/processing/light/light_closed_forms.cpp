// Light whose amount is known in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/measuring/measures/reference_light.h"
#include "tests/processing/light/lit_volumes.h"

namespace echolucent {
namespace {

using namespace light_test;

TEST(LightClosedForms, AnEmptyCurveLetsAllLightThrough) {
    VolumeGeometry geometry = cubeGeometry(21);
    geometry.spacing = {0.5, 0.7, 1.1};
    const auto volume = volumeOf(geometry, [](const Vec3& voxel) { return std::fmod(voxel[0], 3.0) < 1.0; });
    LightSweep sweep(volume);
    for (const int coarseness : {1, 2, 3}) {
        LightScene scene;
        scene.towardsKey = {-0.4, 0.5, -0.7};
        scene.coarseness = coarseness;
        const auto light = *sweep.lightVolume(ManualCurve{}, scene);
        EXPECT_TRUE(std::all_of(light.reaching.begin(), light.reaching.end(), [](int byte) { return byte == 255; }));
    }
}

/// exp(-extinction * slant path): through the slab `thickness` units thick, along each axis from both sides.
TEST(LightClosedForms, ASlabAttenuatesByItsSlantPath) {
    constexpr int edge = 25, middle = edge / 2, first = 10, last = 12;
    constexpr double opacity = 0.3;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (const auto& slant : {std::array{0.0, 0.0}, std::array{0.3, -0.2}, std::array{-0.5, 0.4}}) {
                const auto volume = volumeOf(
                    cubeGeometry(edge), [&](const Vec3& voxel) { return voxel[axis] >= first && voxel[axis] <= last; });
                Vec3 towards{0, 0, 0};
                towards[axis] = side;
                towards[(axis + 1) % 3] = slant[0];
                towards[(axis + 2) % 3] = slant[1];
                const auto light = *LightSweep(volume).lightVolume(rising(opacity), keyAlong(towards));
                std::array<int, 3> behind{middle, middle, middle};
                behind[static_cast<std::size_t>(axis)] = side < 0.0 ? last + 3 : first - 3;
                const double path = (last - first + 1) * length(towards);
                EXPECT_NEAR(keyAt(light, behind[0], behind[1], behind[2]), 255.0 * std::pow(1.0 - opacity, path), 1.5)
                    << "axis " << axis << ", side " << side << ", slant " << slant[0];
            }
}

TEST(LightClosedForms, OpacityIsPerUnitWhereVoxelsAreNoCubes) {
    VolumeGeometry geometry;
    geometry.size = {30, 24, 18};
    geometry.spacing = {0.4, 0.5, 1.0};
    const auto volume = volumeOf(geometry, [](const Vec3& voxel) { return voxel[2] == 8.0; });
    const Vec3 towards{0.2, 0.1, -1.0};
    for (const int coarseness : {1, 2}) {
        LightScene scene = keyAlong(towards);
        scene.coarseness = coarseness;
        const auto light = *LightSweep(volume).lightVolume(rising(0.4), scene);
        const Vec3 behindMm = geometry.gridMmFromVoxel({15, 12, 11});
        const double unitsThrough = 1.0 * length(towards) / 0.4;  // the slab is 1 mm thick
        EXPECT_NEAR(255.0 * reachingAt(light, behindMm).key, 255.0 * std::pow(0.6, unitsThrough), 2.0);
    }
}

TEST(LightClosedForms, WithinTissueALightFadesByTheWayIntoThePlace) {
    const auto volume = volumeOf(cubeGeometry(9), [](const Vec3&) { return true; });
    const auto light = *LightSweep(volume).lightVolume(rising(0.2), keyAlong({0, 0, -1}));
    for (int z = 0; z < 9; ++z)
        EXPECT_NEAR(keyAt(light, 4, 4, z), 255.0 * std::pow(0.8, z + 0.25), 1.0) << "slice " << z;
}

/// The wall fills half of space; at its foot half of the hemisphere is seen.
TEST(LightClosedForms, AtAWallsFootHalfOfTheLightAroundIsLeft) {
    constexpr int edge = 64, wall = 32;
    const auto volume = volumeOf(cubeGeometry(edge), [](const Vec3& voxel) { return voxel[0] < wall; });
    LightScene scene;
    scene.coarseness = 1;
    scene.towardsViewer = {0, 0.02, -1};
    scene.aroundDirections = light::DirectionRule::twelve;
    const OpacityCurve opaque = rising(1.0);
    const auto light = *LightSweep(volume).lightVolume(opaque, scene);
    EXPECT_NEAR(aroundAt(light, wall, edge / 2, edge - 1), 127.5, 20.0) << "twelve directions";
    EXPECT_LE(aroundAt(light, wall - 4, edge / 2, edge - 1), 1) << "within the wall";
    EXPECT_GT(aroundAt(light, edge - 4, edge / 2, edge - 1), 200) << "far from it";

    const light::ReferenceLight reference(*volume, opaque, scene, 6);
    EXPECT_NEAR(reference.at({wall + 0.5, edge / 2.0, edge - 1.0}).around, 0.5, 0.05);
}

/// Behind a sphere of radius r, a light of half-angle h leaves at distance d a full shadow up to r - d tan h, and full
/// light from r + d tan h on.
TEST(LightClosedForms, ASpheresShadowHasItsUmbraAndPenumbra) {
    constexpr int edge = 96;
    constexpr double radius = 14.0, halfAngle = 12.0, centre = (edge - 1) / 2.0, height = 20.0, distance = 40.0;
    const auto volume = volumeOf(
        cubeGeometry(edge), [](const Vec3& voxel) { return length(voxel - Vec3(centre, centre, height)) <= radius; });
    LightScene scene = keyAlong({0, 0, -1});
    scene.keyHalfAngleDegrees = halfAngle;
    scene.keyDirections = light::DirectionRule::twelve;
    const OpacityCurve opaque = rising(1.0);
    const auto light = *LightSweep(volume).lightVolume(opaque, scene);
    const light::ReferenceLight reference(*volume, opaque, scene, 5);
    const double softness = distance * std::tan(halfAngle * std::numbers::pi / 180.0);
    const auto swept = [&](double aside) { return reachingAt(light, {centre + aside, centre, height + distance}).key; };
    const auto marched = [&](double aside) { return reference.at({centre + aside, centre, height + distance}).key; };
    EXPECT_LT(swept(radius - softness - 3.0), 0.1) << "umbra";
    EXPECT_LT(marched(radius - softness - 1.0), 0.02);
    EXPECT_GT(swept(radius + softness + 4.0), 0.9) << "full light";
    EXPECT_GT(marched(radius + softness + 1.0), 0.98);
    for (double aside = 0.0; aside < radius + softness + 6.0; aside += 1.0) {
        EXPECT_LE(swept(aside), swept(aside + 1.0) + 0.005) << "no rings, at " << aside;
        EXPECT_NEAR(swept(aside), marched(aside), 0.13) << "at " << aside;
    }
}

TEST(LightClosedForms, OpacityOneLeavesNothingBehindTheFirstLayer) {
    const auto volume = volumeOf(cubeGeometry(12), [](const Vec3&) { return true; });
    const auto light = *LightSweep(volume).lightVolume(rising(1.0), keyAlong({0.3, -0.4, -1}));
    for (int z = 1; z < 11; ++z)
        for (int y = 1; y < 11; ++y)
            for (int x = 1; x < 11; ++x) {
                EXPECT_EQ(keyAt(light, x, y, z), 0);
                EXPECT_EQ(aroundAt(light, x, y, z), 0);
            }
}

TEST(LightClosedForms, AShareOfTheExtinctionAttenuates) {
    const auto volume = volumeOf(cubeGeometry(9), [](const Vec3&) { return true; });
    LightScene scene = keyAlong({0, 0, -1});
    scene.attenuation = 0.25;
    const auto light = *LightSweep(volume).lightVolume(rising(0.2), scene);
    EXPECT_NEAR(keyAt(light, 4, 4, 6), 255.0 * std::pow(0.8, 6.25 * 0.25), 1.0);
}

TEST(LightClosedForms, AVolumeOfOneVoxelIsPassedToAQuarter) {
    VolumeGeometry geometry;
    const auto one = volumeOf(geometry, [](const Vec3&) { return true; });
    EXPECT_NEAR(keyAt(*LightSweep(one).lightVolume(rising(0.5), keyAlong({0, 0, -1})), 0, 0, 0),
                255.0 * std::pow(0.5, 0.25), 1.0);
    geometry.size = {7, 1, 5};
    LightScene coarse;
    coarse.towardsKey = {1, -2, 0.5};
    coarse.coarseness = 3;
    const auto flat =
        *LightSweep(volumeOf(geometry, [](const Vec3&) { return true; })).lightVolume(rising(0.5), coarse);
    EXPECT_EQ(flat.size, (std::array{3, 1, 2}));
    EXPECT_TRUE(
        std::all_of(flat.reaching.begin(), flat.reaching.end(), [](int byte) { return byte > 0 && byte < 255; }));
}

}  // namespace
}  // namespace echolucent
