// The true first interface along a ray against marches through voxels, and what the scenes promise about it.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "processing/phantom/phantom.h"
#include "processing/viewpoint/viewpoint.h"
#include "tests/processing/phantom/bare_phantom.h"

namespace echolucent {
namespace {

/// Sides of unequal length.
PhantomConfig bareCuboid(PhantomScene scene) {
    PhantomConfig config = barePhantom(scene, {120, 116, 118});
    config.spacing = {0.8, 0.8, 0.8};
    return config;
}

/// Depth (units) of the first change from at least 8 units of fluid, by small steps through `isFluid(point in mm)`.
template <typename IsFluid>
std::optional<double> marched(const VolumeGeometry& geometry, const Vec3& origin, const Vec3& forward,
                              const IsFluid& isFluid) {
    const double step = 0.02 * geometry.unit();
    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
    std::optional<double> entry;
    double fluidSince = 0;
    bool wasFluid = false;
    for (double t = -400; t < 400; t += step) {
        const Vec3 p = origin + forward * t;
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) inside = inside && p[axis] > low[axis] && p[axis] < high[axis];
        if (!inside && entry) break;
        if (!inside) continue;
        if (!entry) entry = t;
        const bool fluid = isFluid(p);
        if (fluid && !wasFluid) fluidSince = t;
        if (!fluid && wasFluid && t - fluidSince >= 8 * geometry.unit()) return (t - *entry) / geometry.unit();
        wasFluid = fluid;
    }
    return std::nullopt;
}

struct Counts {
    int rays = 0, withInterface = 0, different = 0;
};

template <typename IsFluid>
Counts compare(const PhantomConfig& config, const VolumeGeometry& geometry, const Viewpoint& view, double tolerance,
               int grid, const IsFluid& isFluid) {
    const PhantomTruth truth(config);
    const ViewFrame frame = frameOf(view);
    Counts counts;
    for (int row = 0; row < grid; ++row)
        for (int column = 0; column < grid; ++column) {
            const double pitch = 88.0 / grid;
            const int across = column - grid / 2, down = row - grid / 2;
            const Vec3 origin =
                geometry.centreMm() + frame.right * ((across + 0.13) * pitch) + frame.down * ((down + 0.07) * pitch);
            const auto closed = truth.firstInterface(origin, frame.forward);
            const auto brute = marched(geometry, origin, frame.forward, isFluid);
            ++counts.rays;
            counts.withInterface += closed.has_value();
            const bool same =
                closed.has_value() == brute.has_value() && (!closed || std::abs(*closed - *brute) <= tolerance);
            counts.different += !same;
        }
    return counts;
}

class PhantomTruthOf : public testing::TestWithParam<PhantomScene> {};

TEST_P(PhantomTruthOf, AgreesWithAMarchThroughTheVoxels) {
    const PhantomConfig config = bareCuboid(GetParam());
    const Volume volume = *makePhantom(config);
    const VolumeGeometry& geometry = volume.geometry();
    const auto isFluid = [&](const Vec3& p) {
        const Vec3 v = geometry.voxelFromGridMm(p);
        const auto nearest = [&](int axis) {
            return std::clamp<std::int64_t>(std::llround(v[axis]), 0,
                                            geometry.size[static_cast<std::size_t>(axis)] - 1);
        };
        return volume.storedValue(geometry.offset(nearest(0), nearest(1), nearest(2))) == 14;
    };
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 25, .elevationDegrees = -15}}) {
        const Counts counts = compare(config, geometry, view, 2.5, 20, isFluid);
        EXPECT_GT(counts.withInterface, counts.rays / 3);
        // Rays that graze a surface meet it elsewhere between voxels.
        EXPECT_LE(counts.different, counts.rays * 4 / 100);
    }
}

TEST_P(PhantomTruthOf, AgreesWithAMarchThroughTheSharpMaterials) {
    const PhantomConfig config = bareCuboid(GetParam());
    const PhantomTruth truth(config);
    VolumeGeometry geometry;
    geometry.size = config.size;
    geometry.spacing = config.spacing;
    const Viewpoint view{.azimuthDegrees = -20, .elevationDegrees = 10};
    const Counts counts =
        compare(config, geometry, view, 0.05, 9, [&](const Vec3& p) { return truth.echoAt(p) == config.fluid; });
    EXPECT_LE(counts.different, 1);
}
INSTANTIATE_TEST_SUITE_P(All, PhantomTruthOf, testing::Values(PhantomScene::shapes, PhantomScene::fetus));

/// Share of a dense grid of rays along +z for which `holds` is true of (x share, y share, depth).
template <typename Holds>
double shareOfRays(const PhantomConfig& config, const Holds& holds) {
    const PhantomTruth truth(config);
    int yes = 0;
    for (int row = 0; row < 30; ++row)
        for (int column = 0; column < 30; ++column) {
            const Vec3 origin((column + 0.5) / 30 * 96 - 0.4, (row + 0.5) / 30 * 92.8 - 0.4, 0);
            yes += holds(origin, truth.firstInterface(origin, {0, 0, 1}));
        }
    return yes / 900.0;
}

TEST(PhantomTruth, ShapesShowFluidFirstInTheWindowAndTissueBesideIt) {
    const PhantomConfig config = bareCuboid(PhantomScene::shapes);
    const PhantomTruth truth(config);
    EXPECT_GT(shareOfRays(config, [](const Vec3&, const auto& depth) { return depth.has_value(); }), 0.5);
    EXPECT_GT(shareOfRays(config, [](const Vec3&, const auto& depth) { return !depth.has_value(); }), 0.2);
    // The ray goes through the middle of "sphere 1": fluid reaches from the probe's face to the sphere, 0.315 of 92.8
    // mm.
    const double scale = 92.8;
    const Vec3 origin(0.66 * scale + 1.6 - 0.4, 0.27 * scale - 0.4, 0);
    EXPECT_NEAR(truth.firstInterface(origin, {0, 0, 1}).value(), (0.40 - 0.085) * scale / 0.8, 1e-3);
    EXPECT_FALSE(truth.firstInterface({93, 50, 0}, {0, 0, 1}));
}

TEST(PhantomTruth, TheFetusIsSeenThroughFluid) {
    const PhantomConfig config = bareCuboid(PhantomScene::fetus);
    EXPECT_GT(shareOfRays(config, [](const Vec3&, const auto& depth) { return depth.has_value(); }), 0.75);
    const PhantomTruth truth(config);
    for (double y = 30; y < 70; y += 4)
        for (double x = 25; x < 70; x += 4)
            EXPECT_LT(truth.fluidDistance({x, y, -0.3}), 0) << "nothing between the probe and the fetus";
}

TEST(PhantomTruth, EmptyHasNoInterfaceOnAnyRay) {
    EXPECT_EQ(
        shareOfRays(bareCuboid(PhantomScene::empty), [](const Vec3&, const auto& depth) { return depth.has_value(); }),
        0);
}

TEST(PhantomTruth, FrontWallPutsTissueFirst) {
    for (const auto scene : {PhantomScene::shapes, PhantomScene::fetus}) {
        PhantomConfig config = bareCuboid(scene);
        const PhantomConfig open = config;
        config.frontWall = true;
        const Volume volume = *makePhantom(config);
        for (std::int64_t z = 0; z < 20; ++z)
            for (std::int64_t i = 0; i < 120 * 116; ++i)
                ASSERT_EQ(volume.storedValue(120 * 116 * z + i), config.tissue);
        const PhantomTruth truth(config), truthOpen(open);
        int same = 0, met = 0;
        shareOfRays(open, [&](const Vec3& origin, const auto& depth) {
            const auto behind = truth.firstInterface(origin, {0, 0, 1});
            EXPECT_GT(behind.value_or(1e9), 28);
            if (depth && *depth > 40) {
                ++met;
                same += behind && std::abs(*behind - *depth) < 1e-6;
            }
            return false;
        });
        EXPECT_EQ(same, met) << "the wall changes nothing behind it";
        EXPECT_GT(met, 300);
    }
}

TEST(PhantomTruth, TheNearCutMovesTheEntry) {
    const PhantomConfig config = bareCuboid(PhantomScene::shapes);
    const PhantomTruth truth(config);
    const Vec3 origin(0.66 * 92.8 + 1.2, 0.27 * 92.8 - 0.4, 0);
    const double whole = truth.firstInterface(origin, {0, 0, 1}).value();
    EXPECT_NEAR(truth.firstInterface(origin, {0, 0, 1}, -0.4 + 8).value(), whole - 10, 1e-6);
    // The cut is so near the sphere that less than 8 units of fluid remain: the next interface counts.
    const auto next = truth.firstInterface(origin, {0, 0, 1}, -0.4 + (whole - 7) * 0.8);
    EXPECT_TRUE(!next || *next > 20);
    const Vec3 surface = truth.firstInterfacePoint(origin, {0, 0, 5}, -0.4 + 8).value();
    EXPECT_NEAR(surface[2], -0.4 + whole * 0.8, 1e-6);
    EXPECT_NEAR(truth.fluidDistance(surface), 0, 1e-6);
}

TEST(PhantomTruth, RaysBesideTheBoxMeetNothing) {
    const PhantomTruth truth(bareCuboid(PhantomScene::shapes));
    EXPECT_FALSE(truth.firstInterface({-5, 40, 0}, {0, 0, 1}));
    EXPECT_FALSE(truth.firstInterface({40, 40, -50}, {1, 0, 0.01}));
}

TEST(PhantomMotion, OnlyAnArmAndTheHeartMove) {
    PhantomConfig still = bareCuboid(PhantomScene::fetus), moved = still;
    still.speckle = moved.speckle = 0.5;
    moved.phase = 0.25;
    const auto one = PhantomTruth(still).primitives(), two = PhantomTruth(moved).primitives();
    ASSERT_EQ(one.size(), two.size());
    std::set<std::string> movers;
    std::vector<std::pair<Vec3, double>> balls;
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].name, two[i].name);
        if (one[i].parameters == two[i].parameters) continue;
        movers.insert(one[i].name);
        for (const auto& primitive : {one[i], two[i]}) {
            const auto& p = primitive.parameters;
            balls.emplace_back(Vec3(p[0], p[1], p[2]), primitive.kind == "round cone" ? p[6] : p[3]);
            if (primitive.kind == "round cone")
                for (double t = 0.1; t <= 1; t += 0.1)
                    balls.emplace_back(Vec3(p[0], p[1], p[2]) * (1 - t) + Vec3(p[3], p[4], p[5]) * t,
                                       std::max(p[6], p[7]));
        }
    }
    EXPECT_EQ(movers, (std::set<std::string>{"finger", "forearm, far side", "heart", "palm, far side", "thumb"}));
    const Volume before = *makePhantom(still), after = *makePhantom(moved);
    int changed = 0, elsewhere = 0;
    for (std::int64_t z = 0; z < 118; ++z)
        for (std::int64_t y = 0; y < 116; ++y)
            for (std::int64_t x = 0; x < 120; ++x) {
                const auto offset = before.geometry().offset(x, y, z);
                if (before.storedValue(offset) == after.storedValue(offset)) continue;
                ++changed;
                const Vec3 at = before.geometry().gridMmFromVoxel(Vec3(x, y, z));
                bool near = false;
                for (const auto& [centre, radius] : balls) near = near || length(at - centre) < radius + 4;
                elsewhere += !near;
            }
    EXPECT_GT(changed, 500);
    EXPECT_EQ(elsewhere, 0);
}

TEST(PhantomMotion, IsPeriodicAndStillWhereNothingMoves) {
    PhantomConfig config = bareCuboid(PhantomScene::fetus);
    const Vec3 forearm(60, 30, 60);
    const auto at = [&](double phase) {
        config.phase = phase;
        return PhantomTruth(config).primitives();
    };
    const auto start = at(0), turn = at(1);
    for (std::size_t i = 0; i < start.size(); ++i)
        for (std::size_t k = 0; k < start[i].parameters.size(); ++k)
            ASSERT_NEAR(start[i].parameters[k], turn[i].parameters[k], 1e-9);
    PhantomConfig shapes = bareCuboid(PhantomScene::shapes), later = shapes;
    later.phase = 0.4;
    EXPECT_EQ(std::get<VoxelArray<std::uint8_t>>(makePhantom(shapes)->voxels()),
              std::get<VoxelArray<std::uint8_t>>(makePhantom(later)->voxels()));
}

}  // namespace
}  // namespace echolucent
