// Where things are in the picture: orientation, near plane, camera; and extremes of size, spacing and value.
#include <gtest/gtest.h>

#include <cmath>

#include "processing/ray_caster/ray_caster.h"
#include "ray_caster_reference.h"

namespace echolucent {
namespace {

const OpacityCurve opaqueAboveHalf = ManualCurve{{{0.0, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {1.0, 1.0}}};

/// A volume of zeros but for one opaque block.
Volume block(const std::array<std::int64_t, 3>& first, const std::array<std::int64_t, 3>& last) {
    VolumeGeometry geometry;
    geometry.size = {30, 40, 50};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 0);
    for (std::int64_t z = first[2]; z <= last[2]; ++z)
        for (std::int64_t y = first[1]; y <= last[1]; ++y)
            for (std::int64_t x = first[0]; x <= last[0]; ++x)
                voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] = 255;
    return Volume(geometry, voxels);
}

struct Where {
    double column = 0, row = 0, pixels = 0;
};

Where opaquePixels(const Picture& picture) {
    Where where;
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column)
            if (pixelAt(picture, column, row)[3] > 0.5f) {
                where.column += column;
                where.row += row;
                where.pixels += 1;
            }
    where.column /= where.pixels;
    where.row /= where.pixels;
    return where;
}

// This tells what lies at high x, low y and low z. Right and down of the picture along grid axes are found by hand from
// the definition R_y(azimuth) R_x(elevation) and the turn that brings +z onto the beam axis.
TEST(RayCasterPlaces, EachBeamAxisShowsTheBlockWhereItIs) {
    const Volume volume = block({24, 4, 5}, {26, 6, 7});
    const Vec3 centre = volume.geometry().centreMm(), place{25, 5, 6};
    struct Case {
        BeamAxis beam;
        Vec3 right, down;
    };
    const Case cases[] = {{BeamAxis::plusZ, {1, 0, 0}, {0, 1, 0}},  {BeamAxis::minusZ, {-1, 0, 0}, {0, 1, 0}},
                          {BeamAxis::plusX, {0, 0, -1}, {0, 1, 0}}, {BeamAxis::minusX, {0, 0, 1}, {0, 1, 0}},
                          {BeamAxis::plusY, {1, 0, 0}, {0, 0, -1}}, {BeamAxis::minusY, {1, 0, 0}, {0, 0, 1}}};
    for (const Case& c : cases)
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            Viewpoint view;
            view.beamAxis = c.beam;
            RayCastSettings settings = settingsFor(volume, view, 200, 160);
            settings.camera.projection = projection;
            settings.camera.distanceMm = 1e6;  // so far that both projections agree
            settings.camera.viewAngleDegrees =
                2 * std::atan(settings.camera.heightMm / 2 / 1e6) * 180 / std::numbers::pi;
            settings.interpolation = Interpolation::nearest;
            const Where where = opaquePixels(*castRays(volume, opaqueAboveHalf, settings));
            const double pixel = settings.camera.heightMm / 160;
            EXPECT_NEAR(where.column + 0.5, 100 + (place - centre).dot(c.right) / pixel, 0.51) << nameOf(c.beam);
            EXPECT_NEAR(where.row + 0.5, 80 + (place - centre).dot(c.down) / pixel, 0.51) << nameOf(c.beam);
            EXPECT_NEAR(where.pixels, 9 / (pixel * pixel), 0.2 * 9 / (pixel * pixel)) << nameOf(c.beam);
        }
}

TEST(RayCasterPlaces, WhatIsInFrontHidesWhatIsBehind) {
    VolumeGeometry geometry;
    geometry.size = {10, 10, 10};
    std::vector<std::uint8_t> voxels(1000, 0);
    std::fill_n(voxels.begin(), 200, std::uint8_t{153});        // z = 0, 1
    std::fill_n(voxels.begin() + 800, 200, std::uint8_t{255});  // z = 8, 9
    const Volume volume(geometry, voxels);
    Viewpoint view;
    RayCastSettings settings = settingsFor(volume, view, 21, 21);
    settings.colourMap = ColourMap::grey;
    settings.interpolation = Interpolation::nearest;
    EXPECT_NEAR(pixelAt(*castRays(volume, opaqueAboveHalf, settings), 10, 10)[0], 0.6f, 1e-6f);
    settings.camera.frame = frameOf(Viewpoint{BeamAxis::minusZ, 0, 0, 0});
    settings.front.reset();
    EXPECT_NEAR(pixelAt(*castRays(volume, opaqueAboveHalf, settings), 10, 10)[0], 1.0f, 1e-6f);
}

TEST(RayCasterPlaces, TheNearPlaneCutsThere) {
    VolumeGeometry geometry;
    geometry.size = {10, 10, 20};
    geometry.spacing = {1, 1, 0.5};
    std::vector<std::uint8_t> voxels(2000, 102);
    std::fill_n(voxels.begin(), 1000, std::uint8_t{255});  // z = 0 ... 9, 5 mm
    const Volume volume(geometry, voxels);
    const OpacityCurve opaqueFront = ManualCurve{{{0.0, 0.02}, {0.4, 0.02}, {0.41, 1.0}, {1.0, 1.0}}};
    const auto alphaAt = [&](double cut, Projection projection) {
        Viewpoint view;
        view = withFrontAcross(view, cut);
        RayCastSettings settings = settingsFor(volume, view, 11, 11);
        settings.camera.projection = projection;
        settings.interpolation = Interpolation::nearest;
        return static_cast<double>(pixelAt(*castRays(volume, opaqueFront, settings), 5, 5)[3]);
    };
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        EXPECT_NEAR(alphaAt(0.0, projection), 1.0, 1e-6);
        EXPECT_NEAR(alphaAt(4.7, projection), 1.0, 1e-6) << "0.3 mm of the front half are left";
        EXPECT_NEAR(alphaAt(5.0, projection), 1.0 - std::pow(0.98, 10), 1e-6) << "just the front half is gone";
        EXPECT_NEAR(alphaAt(7.5, projection), 1.0 - std::pow(0.98, 5), 1e-6);
        EXPECT_EQ(alphaAt(10.0, projection), 0.0);
        EXPECT_EQ(alphaAt(1000.0, projection), 0.0);
    }
}

TEST(RayCasterPlaces, DefaultCameraHoldsTheWholeBoxTightly) {
    for (const Vec3& spacing : {Vec3{1, 1, 1}, Vec3{0.3, 0.3, 2.0}})
        for (const double aspect : {0.4, 1.0, 2.5})
            for (const Viewpoint& view : {Viewpoint{}, withFrontAcross(Viewpoint{BeamAxis::plusY, 0, 0, 0}, 3),
                                          Viewpoint{BeamAxis::minusX, 30, -40, 70}}) {
                VolumeGeometry geometry;
                geometry.size = {60, 50, 40};
                geometry.spacing = spacing;
                const Camera camera = defaultCamera(geometry, view, aspect);
                EXPECT_EQ(camera.projection, Projection::parallel);
                double widest = 0, perspectiveWidest = 0;
                for (int corner = 0; corner < 8; ++corner) {
                    const Vec3 low = geometry.boxMinMm(), high = geometry.boxMaxMm();
                    const Vec3 point{corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
                                     corner & 4 ? high[2] : low[2]};
                    const Vec3 seen = point - camera.focalPoint;
                    const double u = std::abs(seen.dot(camera.frame.right)) / aspect,
                                 v = std::abs(seen.dot(camera.frame.down));
                    widest = std::max({widest, u / (camera.heightMm / 2), v / (camera.heightMm / 2)});
                    const double tangent = std::tan(camera.viewAngleDegrees / 2 * std::numbers::pi / 180);
                    const double depth = camera.distanceMm + seen.dot(camera.frame.forward);
                    perspectiveWidest = std::max({perspectiveWidest, u / (depth * tangent), v / (depth * tangent)});
                }
                EXPECT_NEAR(widest, 1 / 1.04, 1e-9);
                EXPECT_LE(perspectiveWidest, 1.0);
                EXPECT_GT(perspectiveWidest, 0.5);
            }
}

/// Every pixel is a number in [0,1], and as the reference has it.
void expectSoundPictures(const Volume& volume, const RayCastSettings& settings, const std::string& what) {
    for (const OpacityCurve& curve : {OpacityCurve{PowerCurve{2, 0.7}}, OpacityCurve{LinearCurve{0.3, 1.0, 1.0}}}) {
        const auto picture = castRays(volume, curve, settings);
        for (const float value : picture->rgba) ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << what;
        EXPECT_LT(largestDifference(volume, curve, settings), std::max(3e-3, noiseTolerance(volume, false))) << what;
    }
}

TEST(RayCasterPlaces, ExtremeSizesAndSpacings) {
    const std::array<std::int64_t, 3> sizes[] = {{1, 1, 1}, {1, 6, 5},   {7, 1, 4},   {6, 9, 1},
                                                 {2, 2, 2}, {300, 1, 1}, {1, 1, 300}, {3, 3, 3}};
    for (const auto& size : sizes)
        for (const Vec3& spacing : {Vec3{1, 1, 1}, Vec3{0.1, 5, 0.7}})
            for (const bool shaded : {false, true}) {
                const Volume volume = randomVolume<std::uint8_t>(size, spacing, 3);
                RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 25, 15, 0}, 25, 19);
                if (shaded) settings.shading = Shading{};
                settings.step = 2.3;
                expectSoundPictures(volume, settings,
                                    std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" +
                                        std::to_string(size[2]) + (shaded ? " shaded" : ""));
            }
}

TEST(RayCasterPlaces, OneVoxelIsOneBox) {
    VolumeGeometry geometry;
    const Volume volume(geometry, std::vector<std::uint8_t>{255});
    const RayCastSettings settings = settingsFor(volume, Viewpoint{}, 104, 104);
    const auto picture = castRays(volume, ManualCurve{{{0, 0.25}}}, settings);
    int inside = 0;
    for (std::size_t i = 3; i < picture->rgba.size(); i += 4) {
        if (picture->rgba[i] == 0.0f) continue;
        EXPECT_NEAR(picture->rgba[i], 0.25f, 1e-6f);
        ++inside;
    }
    EXPECT_EQ(inside, 100 * 100);
}

TEST(RayCasterPlaces, NotFiniteVoxelsAreTransparentWithOrWithoutAMask) {
    const Volume random = randomVolume<float>({17, 12, 14}, {1, 1, 1}, 4);
    auto voxels = std::get<VoxelArray<float>>(random.voxels()).toVector();
    std::mt19937 dice(9);
    for (float& voxel : voxels)
        if (const auto roll = dice() % 12; roll < 3)
            voxel = roll == 0 ? std::nanf("") : roll == 1 ? INFINITY : -INFINITY;
    const Volume volume(random.geometry(), voxels, 3.5);
    for (const bool shaded : {false, true})
        for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::trilinear}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 31, -13, 5}, 41, 31);
            settings.interpolation = interpolation;
            if (shaded) settings.shading = Shading{};
            expectSoundPictures(volume, settings, "masked");
            expectSoundPictures(volume.withDataMask(std::vector<std::uint8_t>{}), settings, "mask forgotten");
        }
    const Volume nothing(random.geometry(), std::vector<float>(voxels.size(), std::nanf("")));
    const auto picture = castRays(nothing, ManualCurve{{{0, 1.0}}}, settingsFor(nothing, Viewpoint{}, 20, 20));
    for (const float value : picture->rgba) EXPECT_EQ(value, 0.0f);
}

TEST(RayCasterPlaces, CameraInsideOnTheFaceAndBehind) {
    const Volume volume = randomVolume<std::uint8_t>({15, 16, 17}, {1, 1, 1}, 11);
    RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 10, 20, 0}, 33, 33);
    settings.camera.projection = Projection::perspective;
    settings.camera.viewAngleDegrees = 100;
    settings.front.reset();
    const Vec3 forward = settings.camera.frame.forward;
    settings.camera.distanceMm = 0.0;  // the eye in the centre
    expectSoundPictures(volume, settings, "inside");
    settings.camera = defaultCamera(volume.geometry(), Viewpoint{}, 1.0);
    settings.camera.projection = Projection::perspective;
    settings.camera.distanceMm = 8.5;
    expectSoundPictures(volume, settings, "on the face");
    settings.camera.focalPoint = volume.geometry().centreMm() + forward * 100.0;
    settings.camera.distanceMm = 1.0;
    const auto behind = castRays(volume, PowerCurve{2, 1.0}, settings);
    for (const float value : behind->rgba) EXPECT_EQ(value, 0.0f) << "behind";
}

}  // namespace
}  // namespace echolucent
