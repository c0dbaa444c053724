// Rays whose surface is known: the truth of simulated scans, and what tube cores find.
#include "processing/comparison/surface_rays.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "processing/comparison/classification_measures.h"
#include "tests/processing/comparison/small_volumes.h"
#include "tests/processing/tube_core/plane_detection.h"

namespace echolucent {
namespace {

Vec3 surfaceOf(const SurfaceRay& ray, const Vec3& forward) {
    return ray.pointMm + forward * (ray.surfaceDepthMm - forward.dot(ray.pointMm));
}

TEST(SurfaceRays, OfTheTruthLieOnTheFirstInterfaceIntoWhatIsAsked) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const VolumeGeometry geometry = makePhantom(config)->geometry();
    const Viewpoint view{.azimuthDegrees = 12};
    const Vec3 forward = frameOf(view).forward;
    const auto objects = trueSurfaces(geometry, truth, view, InterfaceInto::object);
    const auto walls = trueSurfaces(geometry, truth, view, InterfaceInto::tissue);
    ASSERT_GT(objects.size(), 100U);
    ASSERT_GT(walls.size(), 100U);
    const auto check = [&](const std::vector<SurfaceRay>& rays, PhantomMaterial material) {
        for (std::size_t i = 0; i < rays.size(); i += 37) {
            const Vec3 surface = surfaceOf(rays[i], forward);
            EXPECT_EQ(truth.materialAt(surface - forward * 0.01), PhantomMaterial::fluid);
            EXPECT_EQ(truth.materialAt(surface + forward * 1e-4), material);
            EXPECT_NEAR(truth.fluidDistance(surface), 0.0, 1e-9);
        }
    };
    check(objects, PhantomMaterial::object);
    check(walls, PhantomMaterial::tissue);
    EXPECT_EQ(trueSurfaces(geometry, truth, view, InterfaceInto::objectOrTissue).size(), objects.size() + walls.size());
    PhantomConfig nothing = config;
    nothing.scene = PhantomScene::empty;
    EXPECT_TRUE(trueSurfaces(geometry, PhantomTruth(nothing), view, InterfaceInto::objectOrTissue).empty());
}

TEST(SurfaceRays, OfTheTruthLieAsFarApartAsAsked) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const VolumeGeometry geometry = makePhantom(config)->geometry();
    const auto each = trueSurfaces(geometry, truth, {}, InterfaceInto::objectOrTissue);
    const auto second = trueSurfaces(geometry, truth, {}, InterfaceInto::objectOrTissue, 2.0);
    EXPECT_NEAR(static_cast<double>(second.size()), static_cast<double>(each.size()) / 4,
                0.05 * static_cast<double>(each.size()));
    for (const SurfaceRay& ray : second) EXPECT_TRUE(std::ranges::find(each, ray) != each.end());
    EXPECT_THROW((void)trueSurfaces(geometry, truth, {}, InterfaceInto::object, 0.0), std::invalid_argument);
    EXPECT_THROW((void)trueSurfaces(geometry, truth, {}, InterfaceInto::object, NAN), std::invalid_argument);
}

/// A bowed front that is flat at a depth.
CutSurface flatSurface(const Viewpoint& view, float depthMm) {
    return {.frame = frameOf(view),
            .firstRightMm = -100,
            .firstDownMm = -100,
            .spacingMm = 300,
            .columns = 2,
            .rows = 2,
            .depthMm = {depthMm, depthMm, depthMm, depthMm}};
}

TEST(SurfaceRays, OfTheTruthBeginBehindTheFrontAndWithinTheBox) {
    PhantomConfig config = smallShapes();
    config.spacing = Vec3(1, 1, 1);
    const PhantomTruth truth(config);
    const VolumeGeometry geometry = makePhantom(config)->geometry();
    const auto whole = trueSurfaces(geometry, truth, {}, InterfaceInto::objectOrTissue, 2.0);
    const auto depthBetween = [](const std::vector<SurfaceRay>& rays, double from, double to) {
        return std::ranges::all_of(
            rays, [&](const SurfaceRay& ray) { return ray.surfaceDepthMm > from && ray.surfaceDepthMm <= to; });
    };
    ASSERT_FALSE(depthBetween(whole, 20.0, 100.0)) << "something lies before the cuts";
    Viewpoint bowed, boxed;
    bowed.cutSurface = flatSurface({}, 20.0f);
    boxed.box = OrientedBox{.centreMm = {32, 30, 35}, .sizeMm = {30, 28, 30}};  // from 20 to 50 along z
    for (const Viewpoint& view : {withFrontAcross({}, 20.5), bowed, boxed}) {
        const auto rays = trueSurfaces(geometry, truth, view, InterfaceInto::objectOrTissue, 2.0);
        ASSERT_GT(rays.size(), 10U);
        EXPECT_TRUE(depthBetween(rays, 20.0, view.box ? 50.0 : 100.0));
        for (const SurfaceRay& ray : rays) EXPECT_TRUE(!view.box || view.box->contains(surfaceOf(ray, {0, 0, 1})));
    }
}

TEST(SurfaceRays, AnOpaqueStepOverExactLayersShowsAllTrueSurfacesRight) {
    const PhantomConfig config = smallShapes();
    const PhantomTruth truth(config);
    const VolumeGeometry geometry = makePhantom(config)->geometry();
    std::vector<std::uint8_t> voxels;
    for (std::int64_t z = 0; z < config.size[2]; ++z)
        for (std::int64_t y = 0; y < config.size[1]; ++y)
            for (std::int64_t x = 0; x < config.size[0]; ++x) {
                const Vec3 mm = geometry.gridMmFromVoxel(
                    Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)));
                voxels.push_back(truth.materialAt(mm) == PhantomMaterial::fluid ? 0 : 255);
            }
    const Volume exact(geometry, voxels);
    const std::vector<Classification> curves{ManualCurve{{{0.5, 0.0}, {0.5, 1.0}}}, constantOpacity(0.0),
                                             constantOpacity(1.0)};
    for (const InterfaceInto into : {InterfaceInto::object, InterfaceInto::tissue}) {
        const auto rays = trueSurfaces(geometry, truth, {}, into);
        const int count = static_cast<int>(rays.size());
        ASSERT_GT(count, 100);
        const auto measures = *measuresOf(exact, {}, rays, curves);
        // The edge of an object may be thinner than a voxel, and lie between two voxel centres.
        EXPECT_GE(measures[0].depth.right, count - 1);
        EXPECT_EQ(measures[0].depth.rays(), count);
        EXPECT_EQ(measures[0].depth.early + measures[0].depth.never, 0);
        EXPECT_EQ(measures[1].depth, ShownDepth{.never = count});
        EXPECT_EQ(measures[2].depth, ShownDepth{.early = count}) << "there are 8 units of fluid before each surface";
    }
}

TEST(SurfaceRays, OfTubeCoresAreThoseWithASurfaceAndAWeightAndLieOnIt) {
    PlaneVolume plane;
    plane.normal = normalized(Vec3(0.2, -0.15, 1.0));
    plane.distanceMm = plane.normal.dot(plane.geometry().centreMm());
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 12, .elevationDegrees = -9}}) {
        AdaptiveOtf otf = adapted(plane.make(), view);
        std::size_t weighing = 0;
        for (const TubeCore& tube : otf.tubes) weighing += tube.d > 0.0 ? 1 : 0;
        ASSERT_GT(weighing, 100u);
        const Vec3 forward = frameOf(view).forward;
        const auto rays = tubeCoreRays(plane.geometry(), otf);
        ASSERT_EQ(rays.size(), weighing);
        std::size_t onPlane = 0;
        for (const SurfaceRay& ray : rays)
            onPlane += std::abs(plane.normal.dot(surfaceOf(ray, forward)) - plane.distanceMm) < 3.0 ? 1 : 0;
        EXPECT_GT(onPlane, weighing * 9 / 10);
        std::ranges::find_if(otf.tubes, [](const TubeCore& tube) { return tube.d > 0.0; })->surfaceVoxel.reset();
        EXPECT_EQ(tubeCoreRays(plane.geometry(), otf).size(), weighing - 1);
        for (TubeCore& tube : otf.tubes) tube.d = 0.0;
        EXPECT_TRUE(tubeCoreRays(plane.geometry(), otf).empty());
    }
}

TEST(SurfaceRays, ThatAreFoundLieOnThePlaneAndAreMany) {
    PlaneVolume plane;
    plane.normal = normalized(Vec3(0.2, -0.15, 1.0));
    plane.distanceMm = plane.normal.dot(plane.geometry().centreMm());
    const Volume volume = plane.make();
    const Viewpoint view{.azimuthDegrees = 12, .elevationDegrees = -9};
    const Vec3 forward = frameOf(view).forward;
    const auto rays = foundSurfaces(volume, view);
    ASSERT_TRUE(rays);
    EXPECT_GT(rays->size(), 250U);
    const auto onPlane = std::ranges::count_if(*rays, [&](const SurfaceRay& ray) {
        return std::abs(plane.normal.dot(surfaceOf(ray, forward)) - plane.distanceMm) < 2.0;
    });
    EXPECT_GT(static_cast<double>(onPlane), 0.9 * static_cast<double>(rays->size()));
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return *foundSurfaces(volume, view); });
    };
    EXPECT_EQ(with(1), *rays);
    EXPECT_EQ(with(5), *rays);
    // They stand in the rows and columns of the tube cores.
    const auto spaced = *spacedSurfaces(volume, view);
    EXPECT_EQ(spaced.rays, *rays);
    const ViewFrame frame = frameOf(view);
    for (const SurfaceRay& ray : *rays) {
        const Vec3 from = ray.pointMm - rays->front().pointMm;
        const double column = frame.right.dot(from) / (spaced.apartUnits[0] * volume.geometry().unit());
        const double row = frame.down.dot(from) / (spaced.apartUnits[1] * volume.geometry().unit());
        EXPECT_NEAR(column, std::round(column), 1e-9);
        EXPECT_NEAR(row, std::round(row), 1e-9);
    }
    const std::atomic<bool> raised = true;
    EXPECT_FALSE(foundSurfaces(volume, view, {{}, &raised}));
}

TEST(SurfaceRays, ThatAreFoundLieBehindTheFront) {
    const PlaneVolume plane;  // across z at 50 mm
    const auto whole = foundSurfaces(plane.make(), {});
    ASSERT_GT(whole->size(), 250U);
    Viewpoint bowed;
    bowed.cutSurface = flatSurface({}, 60.0f);
    for (const Viewpoint& view : {withFrontAcross({}, 60.5), bowed}) {
        const auto rays = foundSurfaces(plane.make(), view);
        for (const SurfaceRay& ray : *rays) EXPECT_GT(ray.surfaceDepthMm, 60.0);
    }
}

}  // namespace
}  // namespace echolucent
