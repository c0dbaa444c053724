// Compositing: closed forms, and an independent reference on random volumes.
#include "processing/ray_caster/ray_caster.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

Volume wideSlab(std::int64_t depth, std::uint8_t value) {
    VolumeGeometry geometry;
    geometry.size = {24, 24, depth};
    return Volume(geometry, std::vector<std::uint8_t>(static_cast<std::size_t>(geometry.voxelCount()), value));
}

// Petersch 2005, section 4: intensity c2 up to k*, c1 behind; eq. 2 voxel by voxel from the back, and eq. 3 summed up.
TEST(RayCaster, TwoIntensityModelFollowsEquations2And3) {
    constexpr int depth = 30, front = 11;
    constexpr std::uint8_t c2 = 51, c1 = 204;
    VolumeGeometry geometry;
    geometry.size = {12, 12, depth};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), c1);
    std::fill_n(voxels.begin(), 12 * 12 * front, c2);
    const Volume volume(geometry, voxels);
    for (const int exponent : {1, 2, 4}) {
        const OpacityCurve curve = PowerCurve{exponent, 0.3};
        RayCastSettings settings = settingsFor(volume, Viewpoint{}, 9, 9);
        settings.camera.heightMm *= 1.5;
        settings.interpolation = Interpolation::nearest;
        settings.colourMap = ColourMap::grey;
        const Vec3 background{0.1, 0.5, 0.9};
        const auto picture = castRays(volume, curve, settings);
        const double low = 0.2, high = 0.8;
        const double lowAlpha = 0.3 * std::pow(low, exponent), highAlpha = 0.3 * std::pow(high, exponent);
        double recursive = background[2];
        for (int k = depth - 1; k >= 0; --k) {
            const double alpha = k < front ? lowAlpha : highAlpha, colour = k < front ? low : high;
            recursive = recursive * (1 - alpha) + colour * alpha;
        }
        const double throughFront = std::pow(1 - lowAlpha, front),
                     throughAll = throughFront * std::pow(1 - highAlpha, depth - front);
        const double summed =
            low * (1 - throughFront) + high * (throughFront - throughAll) + background[2] * throughAll;
        EXPECT_NEAR(recursive, summed, 1e-12);
        EXPECT_NEAR(centreOf(*picture)[2] + background[2] * (1 - static_cast<double>(centreOf(*picture)[3])), summed,
                    1e-5);
        const auto rgb = overBackground(*picture, background);
        const std::size_t centre = (static_cast<std::size_t>(picture->height / 2) * 9 + 4) * 3;
        EXPECT_EQ(rgb[centre + 2], std::lround(255 * summed));
        EXPECT_EQ(rgb[0], 26) << "beside the volume: the background alone";
        EXPECT_EQ(rgb[1], 128);
        EXPECT_EQ(rgb[2], 230);
    }
}

struct Setting {
    const char* name;
    Viewpoint view;
    Vec3 spacing;
    Interpolation interpolation;
    Projection projection;
    double step;
};

/// The view behind a front that was made for another one.
Viewpoint behindFrontOf(Viewpoint view, const Viewpoint& other) {
    view.frontPlane = other.frontPlane;
    return view;
}

const Setting settingsTried[] = {
    {"along z", {}, {1, 1, 1}, Interpolation::trilinear, Projection::parallel, 0.73},
    {"along -x", {BeamAxis::minusX, 0, 0, 0}, {0.7, 1.1, 0.4}, Interpolation::trilinear, Projection::parallel, 1.0},
    {"oblique", {BeamAxis::plusZ, 33, -21, 10}, {1, 1.7, 0.6}, Interpolation::trilinear, Projection::parallel, 0.41},
    {"oblique, cut",
     withFrontAcross({BeamAxis::plusY, -52, 17, 0}, 5.3),
     {1.3, 0.9, 1.1},
     Interpolation::trilinear,
     Projection::parallel,
     1.6},
    {"nearest", {BeamAxis::plusX, 12, 37, -80}, {1, 1.2, 0.8}, Interpolation::nearest, Projection::parallel, 0.57},
    {"perspective",
     {BeamAxis::minusZ, 24, -18, 0},
     {0.8, 0.5, 1.4},
     Interpolation::trilinear,
     Projection::perspective,
     0.77},
    {"perspective, cut",
     withFrontAcross({BeamAxis::minusY, -9, 41, 0}, 4.1),
     {1, 1, 1},
     Interpolation::nearest,
     Projection::perspective,
     0.9},
    {"front of another view",
     behindFrontOf({BeamAxis::plusZ, 33, -21, 10}, withFrontAcross({BeamAxis::plusZ, -14, 5, 0}, 6.1)),
     {1, 0.9, 0.7},
     Interpolation::trilinear,
     Projection::parallel,
     0.8},
    {"front from behind, perspective",
     behindFrontOf({BeamAxis::plusX, 5, 12, 0}, withFrontAcross({BeamAxis::minusX, 8, 0, 0}, 4.4)),
     {1, 1.2, 0.8},
     Interpolation::trilinear,
     Projection::perspective,
     0.9},
    {"thick slices", {BeamAxis::plusZ, 40, 25, 0}, {0.3, 0.3, 6}, Interpolation::trilinear, Projection::parallel, 1.0},
};

template <typename Voxel>
void comparePictures(bool shaded) {
    unsigned seed = 1;
    for (const auto& size : {std::array<std::int64_t, 3>{19, 23, 17}, {41, 9, 12}, {9, 30, 21}})
        for (const Setting& setting : settingsTried) {
            const Volume volume = randomVolume<Voxel>(size, setting.spacing, ++seed);
            RayCastSettings settings = settingsFor(volume, setting.view, 37, 29);
            settings.interpolation = setting.interpolation;
            settings.camera.projection = setting.projection;
            settings.step = setting.step;
            if (shaded) settings.shading = Shading{};
            // The second curve is 0 over a range: whole bricks are left out.
            const OpacityCurve curves[] = {PowerCurve{2, 0.6}, LinearCurve{0.7, 0.8, 0.95}};
            for (const OpacityCurve& curve : curves)
                EXPECT_LT(largestDifference(volume, curve, settings), noiseTolerance(volume, shaded))
                    << setting.name << ", curve " << curve.index() << ", seed " << seed;
        }
}

TEST(RayCaster, AgreesWithASlowReferenceOnBytes) { comparePictures<std::uint8_t>(false); }
TEST(RayCaster, AgreesWithASlowReferenceOnWords) { comparePictures<std::uint16_t>(false); }
TEST(RayCaster, AgreesWithASlowReferenceOnFloats) { comparePictures<float>(false); }
TEST(RayCaster, AgreesWithASlowReferenceOnBytesShaded) { comparePictures<std::uint8_t>(true); }
TEST(RayCaster, AgreesWithASlowReferenceOnWordsShaded) { comparePictures<std::uint16_t>(true); }
TEST(RayCaster, AgreesWithASlowReferenceOnFloatsShaded) { comparePictures<float>(true); }

TEST(RayCaster, SamePixelsForAnyNumberOfThreads) {
    const Volume volume = randomVolume<std::uint8_t>({31, 27, 29}, {1, 0.8, 1.2}, 5);
    Viewpoint view;
    view.azimuthDegrees = 20;
    RayCastSettings settings = settingsFor(volume, view, 150, 130);
    settings.shading = Shading{};
    const OpacityCurve curve = PowerCurve{2, 0.5};
    std::vector<float> alone;
    tbb::task_arena(1).execute([&] { alone = castRays(volume, curve, settings)->rgba; });
    tbb::task_arena(2).execute([&] { EXPECT_EQ(castRays(volume, curve, settings)->rgba, alone); });
    EXPECT_EQ(castRays(volume, curve, settings)->rgba, alone) << "and run after run";
}

TEST(RayCaster, EarlyTerminationErrsByLessThanItsShareOfWhite) {
    const Volume volume = randomVolume<std::uint8_t>({40, 40, 40}, {1, 1, 1}, 8);
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 60, 60);
    const OpacityCurve curve = PowerCurve{2, 0.8};
    const auto whole = castRays(volume, curve, settings);
    settings.terminationTransmittance = 1.0 / 64;
    const auto ended = castRays(volume, curve, settings);
    double largest = 0;
    for (std::size_t i = 0; i < whole->rgba.size(); ++i)
        largest =
            std::max(largest, std::abs(static_cast<double>(whole->rgba[i]) - static_cast<double>(ended->rgba[i])));
    EXPECT_LT(largest, 1.0 / 64);
    EXPECT_GT(largest, 1.0 / 640) << "and rays do end early";
}

TEST(RayCaster, StopsWhenCancelledAndReportsTheShareDone) {
    const Volume volume = wideSlab(20, 90);
    const RayCastSettings settings = settingsFor(volume, Viewpoint{}, 200, 200);
    std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(castRays(volume, everywhere(0.1), settings, progress).has_value());
    cancel = false;
    double last = 0.0;
    progress.report = [&](double share) {
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
        last = share;
        if (share > 0.3) cancel = true;
    };
    tbb::task_arena(1).execute(
        [&] { EXPECT_FALSE(castRays(volume, everywhere(0.1), settings, progress).has_value()); });
    EXPECT_GT(last, 0.3);
    EXPECT_LT(last, 1.0) << "rows of tiles after the cancel were not cast";
}

TEST(RayCaster, RefusesRequestsThatMakeNoSense) {
    const Volume volume = wideSlab(3, 90);
    const RayCastSettings good = settingsFor(volume, Viewpoint{}, 8, 8);
    const auto throws = [&](auto change) {
        RayCastSettings settings = good;
        change(settings);
        EXPECT_THROW((void)castRays(volume, everywhere(0.1), settings), std::invalid_argument);
    };
    throws([](RayCastSettings& s) { s.width = 0; });
    throws([](RayCastSettings& s) { s.height = -1; });
    throws([](RayCastSettings& s) { s.step = 0.0; });
    throws([](RayCastSettings& s) { s.step = std::nan(""); });
    throws([](RayCastSettings& s) { s.camera.heightMm = 0.0; });
    throws([](RayCastSettings& s) { s.camera.focalPoint[1] = INFINITY; });
    throws([](RayCastSettings& s) { s.front = CuttingFace{s.camera.frame.forward, std::nan("")}; });
    throws([](RayCastSettings& s) {
        s.camera.projection = Projection::perspective;
        s.camera.viewAngleDegrees = 180.0;
    });
    throws([](RayCastSettings& s) { s.shading = Shading{.gradientReach = 0.0}; });
}

}  // namespace
}  // namespace echolucent
