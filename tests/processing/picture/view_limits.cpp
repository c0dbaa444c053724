// What a viewpoint's box leaves of a volume: rays, light, the search for the near cut, and what fits the picture.
#include "processing/picture/view_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "processing/light/light_sweep.h"
#include "processing/near_cut/near_cut.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/picture_place.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/ray_caster/ray_caster.h"
#include "processing/scene/box.h"
#include "processing/scene/pose.h"
#include "tests/processing/grids.h"

namespace echolucent {
namespace {

Volume plainVolume(std::array<std::int64_t, 3> size = {40, 50, 44}, Vec3 spacing = {1, 0.8, 1.2}) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    return Volume(geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()), 128));
}

OrientedBox obliqueBox(const Volume& volume, const Vec3& size) {
    return {volume.geometry().centreMm() + Vec3(1.3, -0.7, 2.1),
            frameOf(Viewpoint{.azimuthDegrees = 27, .elevationDegrees = -18, .rollDegrees = 40}), size};
}

RayCastSettings settingsOf(const Volume& volume, const Viewpoint& view, int edge,
                           Projection projection = Projection::parallel) {
    RayCastSettings settings;
    settings.width = settings.height = edge;
    settings.camera = cameraFor(fittedPose(volume.dataBox(), view, projection, 1.0));
    settings.terminationTransmittance = 0.0;
    return limitedTo(view, volume.geometry(), settings);
}

TEST(ViewLimits, AnObliqueBoxHoldsWhatARaySamplesAndNothingElse) {
    const Volume volume = plainVolume();
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        Viewpoint view{.azimuthDegrees = -12, .elevationDegrees = 33};
        view.box = obliqueBox(volume, {14, 11, 9});
        const RayCastSettings settings = settingsOf(volume, view, 41, projection);
        EXPECT_FALSE(settings.box);
        EXPECT_EQ(settings.clippingPlanes.size(), 6U);
        RayCastSettings unlimited = settings;
        unlimited.clippingPlanes.clear();
        int inside = 0, rays = 0;
        for (int pixel = 0; pixel < 41 * 41; pixel += 7) {
            const auto limited = samplesAlongRay(volume, settings, pixel % 41, pixel / 41);
            const auto all = samplesAlongRay(volume, unlimited, pixel % 41, pixel / 41);
            rays += limited.empty() ? 0 : 1;
            double length = 0.0, expected = 0.0;
            for (const RaySample& sample : limited) {
                EXPECT_TRUE(view.box->contains(volume.geometry().gridMmFromVoxel(sample.voxel)));
                length += sample.length;
                inside += 1;
            }
            for (const RaySample& sample : all)
                expected += view.box->contains(volume.geometry().gridMmFromVoxel(sample.voxel)) ? sample.length : 0.0;
            EXPECT_NEAR(length, expected, 1.0) << "half a step may be cut at either end";
        }
        EXPECT_GT(inside, 300);
        EXPECT_GT(rays, 50);
    }
}

/// What the rays of a parallel picture pass through, mm^3.
double renderedVolume(const Volume& volume, const RayCastSettings& settings) {
    const double pixel = settings.camera.heightMm / settings.height, step = settings.step * volume.geometry().unit();
    double steps = 0.0;
    for (int row = 0; row < settings.height; ++row)
        for (int column = 0; column < settings.width; ++column)
            for (const RaySample& sample : samplesAlongRay(volume, settings, column, row)) steps += sample.length;
    return steps * step * pixel * pixel;
}

TEST(ViewLimits, AsMuchIsRenderedAsTheBoxHolds) {
    const Volume volume = plainVolume();
    Viewpoint view{.azimuthDegrees = -12, .elevationDegrees = 33};
    view.box = obliqueBox(volume, {14, 11, 9});
    const double found = renderedVolume(volume, settingsOf(volume, view, 160));
    std::printf("an oblique box of %g mm^3 renders %.1f mm^3\n", 14.0 * 11 * 9, found);
    EXPECT_NEAR(found, 14.0 * 11 * 9, 0.01 * 14 * 11 * 9);
    // Half of a box that sticks out of the volume is left.
    view.box = OrientedBox{.centreMm = {-0.5, 20, 20}, .sizeMm = {10, 11, 9}};
    EXPECT_NEAR(renderedVolume(volume, settingsOf(volume, view, 160)), 5.0 * 11 * 9, 0.02 * 5 * 11 * 9);
}

TEST(ViewLimits, ABoxAlongTheGridIsOneAlsoWhereItsSidesAreTurnedRound) {
    const Volume volume = plainVolume();
    for (const BeamAxis beam : {BeamAxis::plusZ, BeamAxis::minusX, BeamAxis::plusY}) {
        Viewpoint view;
        view.box = OrientedBox{{20, 18, 25}, frameOf(Viewpoint{.beamAxis = beam, .rollDegrees = 90}), {6, 8, 10}};
        const RayCastSettings settings = settingsOf(volume, view, 16);
        ASSERT_TRUE(settings.box);
        EXPECT_TRUE(settings.clippingPlanes.empty());
        for (const Vec3& corner : view.box->corners())
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_TRUE(std::abs(corner[axis] - settings.box->low[axis]) < 1e-12 ||
                            std::abs(corner[axis] - settings.box->high[axis]) < 1e-12);
        for (int axis = 0; axis < 3; ++axis) EXPECT_LT(settings.box->low[axis], settings.box->high[axis]);
    }
}

TEST(ViewLimits, ABoxAroundEverythingLimitsNothingAndChangesNoBit) {
    const Volume volume = *makePhantom(defaultPhantom(PhantomScene::fetus));
    const Viewpoint open{.azimuthDegrees = 20};
    RayCastSettings settings = settingsOf(volume, open, 48);
    settings.shading = Shading{};
    settings.shading->reaching = ReachingLight{};
    for (const bool turned : {false, true}) {
        Viewpoint boxed = open;
        boxed.box =
            orientedBoxOf(wholeBox({.direction = {.azimuth = turned ? 33.0 : 0.0}}, BeamAxis::plusZ, volume.geometry()),
                          BeamAxis::plusZ);
        RayCastSettings limited = limitedTo(boxed, volume.geometry(), settings);
        EXPECT_EQ(limited, settings);
        EXPECT_EQ(findNearCut(volume, boxed)->message, findNearCut(volume, open)->message);
    }
}

TEST(ViewLimits, LightPassesWhatABoxCutsOff) {
    // An opaque sheet of voxels above the place in question: with it out of the box, all light reaches the place.
    VolumeGeometry geometry;
    geometry.size = {32, 32, 32};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 0);
    for (std::int64_t y = 0; y < 32; ++y)
        for (std::int64_t x = 0; x < 32; ++x) voxels[static_cast<std::size_t>(geometry.offset(x, y, 8))] = 255;
    const auto volume = std::make_shared<const Volume>(geometry, voxels);
    const OpacityCurve curve = LinearCurve{0.2, 0.8, 1.0};
    LightSweep sweep(volume);
    const auto keyAt = [&](const std::optional<OrientedBox>& box) {
        Viewpoint view;
        view.box = box;
        RayCastSettings settings = settingsOf(*volume, view, 16);
        settings.shading = Shading{.towardsLight = {0, 0, -1}, .keyHalfAngleDegrees = 0};
        return reachingAt(*sweep.lightVolume(curve, lightSceneOf(settings, geometry)), {16, 16, 20}).key;
    };
    const ViewFrame axes = frameOf(Viewpoint{.rollDegrees = 30});
    EXPECT_LT(keyAt(std::nullopt), 0.7);
    EXPECT_GT(keyAt(OrientedBox{{16, 16, 21}, axes, {40, 40, 16}}), 0.99);
    EXPECT_LT(keyAt(OrientedBox{{16, 16, 16}, axes, {40, 40, 30}}), 0.7);
}

TEST(ViewLimits, ThinBoxesAreSlabsOfEveryMode) {
    // Intensity is 4 z: in a slab of a voxel around z = 20 all modes show about the same, in the whole they do not.
    VolumeGeometry geometry;
    geometry.size = {24, 24, 40};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::uint8_t>(4 * (i / (24 * 24)));
    const Volume volume(geometry, voxels);
    for (const double roll : {0.0, 30.0})
        for (const double thickness : {1.0, 0.01}) {
            Viewpoint view;
            view.box = OrientedBox{{11.5, 11.5, 20}, frameOf(Viewpoint{.rollDegrees = roll}), {10, 10, thickness}};
            for (const RenderMode mode : {RenderMode::maximum, RenderMode::minimum, RenderMode::mean}) {
                RayCastSettings settings = settingsOf(volume, view, 21);
                settings.mode = mode;
                settings.colourMap = ColourMap::grey;
                settings.step = 0.1;
                const auto picture = castRays(volume, PowerCurve{}, settings);
                const float* middle = &picture->rgba[(10 * 21 + 10) * 4];
                EXPECT_EQ(middle[3], 1.0F);
                const Vec3 expected = colourOf(ColourMap::grey, 80.0 / 255);
                EXPECT_NEAR(static_cast<double>(middle[0]), expected[0], 3.0 / 255) << nameOf(mode) << thickness;
            }
        }
}

TEST(ViewLimits, ABoxThatMissesEverythingLeavesAnEmptyPicture) {
    const Volume volume = plainVolume();
    for (const double turn : {0.0, 20.0}) {
        Viewpoint view;
        view.box = OrientedBox{{500, 0, 0}, frameOf(Viewpoint{.azimuthDegrees = turn}), {3, 4, 5}};
        const auto picture = castRays(volume, PowerCurve{}, settingsOf(volume, view, 9));
        for (const float value : picture->rgba) EXPECT_EQ(value, 0.0F);
        const auto found = findNearCut(volume, view);
        EXPECT_EQ(found->answer, NearCutAnswer::noFluid);
        EXPECT_EQ(found->tubes, 0);
    }
}

TEST(ViewLimits, TheNearCutIsSoughtInTheBoxAndCountedFromTheVolumesFront) {
    // Tissue with a dark chamber from 30 to 60 mm; behind it another wall and another chamber.
    VolumeGeometry geometry;
    geometry.size = {64, 64, 128};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 160);
    for (std::int64_t z = 0; z < 128; ++z)
        for (std::int64_t y = 8; y < 56; ++y)
            for (std::int64_t x = 8; x < 56; ++x)
                if ((z > 30 && z < 60) || (z > 84 && z < 114))
                    voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] = 6;
    const Volume volume(geometry, voxels);
    Viewpoint behind;
    behind.box = OrientedBox{{31.5, 31.5, 97}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {64, 64, 61}};
    const auto found = findNearCut(volume, behind);
    ASSERT_EQ(found->answer, NearCutAnswer::wallBeforeFluid) << found->message;
    std::printf("%s\n", found->message.c_str());
    EXPECT_GT(found->nearCutMm, 84.0) << "the first chamber lies before the box";
    EXPECT_LT(found->nearCutMm, 114.0);
}

TEST(ViewLimits, ABoxFitsIntoThePictureWithAllItsCorners) {
    const Volume volume = plainVolume();
    Viewpoint view{.azimuthDegrees = 25, .elevationDegrees = 10, .rollDegrees = 5};
    view.box = obliqueBox(volume, {14, 6, 9});
    for (const double aspect : {0.6, 1.0, 1.8})
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            const CameraPose fitted = fittedPose(volume.dataBox(), view, projection, aspect);
            EXPECT_LT(length(fitted.focalPoint - view.box->centreMm), 1e-12);
            double widest = 0.0;
            for (const Vec3& corner : view.box->corners()) {
                const auto place = placeInPicture(cameraFor(fitted), corner);
                ASSERT_TRUE(place);
                widest = std::max({widest, std::abs((*place)[0]) / aspect, std::abs((*place)[1])});
            }
            EXPECT_LE(widest, 0.5 / 1.04 + 1e-12);
            if (projection == Projection::parallel) {
                EXPECT_NEAR(widest, 0.5 / 1.04, 1e-12);
            }
            const Pose pose = wholeVolumePose(volume.dataBox(), view, projection, aspect);
            const CameraPose again = cameraPoseOf(pose, view.beamAxis, volume.dataBox(), projection, aspect);
            EXPECT_LT(length(again.focalPoint - fitted.focalPoint), 1e-9);
            EXPECT_NEAR(again.heightMm, fitted.heightMm, 1e-9);
        }
}

TEST(ViewLimits, DepthsAreColouredFromWhatTheFrontLeaves) {
    const VolumeGeometry geometry = gridOf({40, 40, 40});
    RayCastSettings settings;
    settings.camera.frame = frameOf(Viewpoint{});
    EXPECT_DOUBLE_EQ(nearestDepthMm(settings, geometry), -0.5);
    settings.front = CuttingFace{{0, 0, 1}, 12};
    EXPECT_DOUBLE_EQ(nearestDepthMm(settings, geometry), 12);
    settings.front = CuttingFace{{0, 0, -1}, -12};  // seen from behind
    EXPECT_DOUBLE_EQ(nearestDepthMm(settings, geometry), -0.5);
    // x + z >= 40 leaves nothing of the box before z = 0.5, where x = 39.5.
    settings.front = CuttingFace{normalized(Vec3(1, 0, 1)), 40 * std::sqrt(0.5)};
    EXPECT_NEAR(nearestDepthMm(settings, geometry), 0.5, 1e-9);
    settings.front = CuttingFace{{0, 0, 1}, 1e300};
    EXPECT_EQ(nearestDepthMm(settings, geometry), 1e300) << "nothing is left";
}

}  // namespace
}  // namespace echolucent
