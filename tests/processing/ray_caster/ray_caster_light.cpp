// Shading, and how voxels without data are treated.
#include <gtest/gtest.h>

#include <cmath>

#include "processing/ray_caster/ray_caster.h"
#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

/// Fluid (0) outside, tissue (200) inside a ball, over a ramp of 4 voxels.
Volume ball() {
    VolumeGeometry geometry;
    geometry.size = {48, 48, 48};
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (std::int64_t z = 0; z < 48; ++z)
        for (std::int64_t y = 0; y < 48; ++y)
            for (std::int64_t x = 0; x < 48; ++x) {
                const double radius = length(Vec3(x - 23.5, y - 23.5, z - 23.5));
                voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] =
                    static_cast<std::uint8_t>(200 * std::clamp((18 - radius) / 4 + 0.5, 0.0, 1.0));
            }
    return Volume(geometry, voxels);
}

const OpacityCurve surfaceCurve = LinearCurve{0.2, 1.5, 1.0};

TEST(RayCasterLight, ShadingChangesColourAndNeverOpacity) {
    const Volume volume = ball();
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 64, 64);
    const auto plain = castRays(volume, surfaceCurve, settings);
    settings.shading = Shading{};
    const auto shaded = castRays(volume, surfaceCurve, settings);
    bool differs = false;
    for (std::size_t i = 0; i < plain->rgba.size(); ++i) {
        if (i % 4 == 3)
            EXPECT_NEAR(plain->rgba[i], shaded->rgba[i], 1e-6f);
        else {
            EXPECT_LE(shaded->rgba[i], shaded->rgba[i / 4 * 4 + 3] + 1e-6f) << "premultiplied";
            differs = differs || plain->rgba[i] != shaded->rgba[i];
        }
    }
    EXPECT_TRUE(differs);
}

TEST(RayCasterLight, LightComesFromWhereItIsSaid) {
    const Volume volume = ball();
    for (const BeamAxis beam : {BeamAxis::plusZ, BeamAxis::minusX, BeamAxis::plusY}) {
        Viewpoint view;
        view.beamAxis = beam;
        RayCastSettings settings = settingsFor(volume, view, 64, 64);
        const auto brightnessAt = [&](const Vec3& light, int column, int row) {
            settings.shading = Shading{.towardsLight = light, .specular = 0.0};
            return pixelAt(*castRays(volume, surfaceCurve, settings), column, row)[0];
        };
        EXPECT_GT(brightnessAt({-1, 0, -0.5}, 20, 32), 1.3f * brightnessAt({-1, 0, -0.5}, 44, 32)) << "from the left";
        EXPECT_GT(brightnessAt({0, -1, -0.5}, 32, 20), 1.3f * brightnessAt({0, -1, -0.5}, 32, 44)) << "from above";
        EXPECT_GT(brightnessAt({0, 0, -1}, 32, 32), 1.3f * brightnessAt({0, 0, 1}, 32, 32)) << "from the viewer";
        EXPECT_GT(brightnessAt({-0.45, -0.55, -0.7}, 26, 26), brightnessAt({-0.45, -0.55, -0.7}, 42, 42))
            << "upper left by default";
    }
}

/// A gap of 12 units that the curve makes transparent, and then tissue; both are of nearly one intensity.
Volume behindAGap() {
    VolumeGeometry geometry;
    geometry.size = {20, 20, 40};
    std::vector<std::uint8_t> voxels(20 * 20 * 40, 120);
    std::fill_n(voxels.begin(), 20 * 20 * 12, 124);
    return Volume(geometry, std::move(voxels));
}
const OpacityCurve gapIsClear = ManualCurve{{{0, 0.3}, {0.475, 0.3}, {0.48, 0}, {1, 0}}};

TEST(RayCasterLight, WhereThereIsNoSurfaceLightIsEven) {
    const Volume volume = behindAGap();
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 20, 20);
    settings.camera.heightMm = 18;
    settings.colourMap = ColourMap::grey;  // whose shadows have no tint
    const auto plain = castRays(volume, gapIsClear, settings);
    const Shading shading{.gradientFloor = 1e9};
    settings.shading = shading;
    const auto shaded = castRays(volume, gapIsClear, settings);
    const double factor = shading.ambient + shading.diffuse * shading.evenLight;
    for (std::size_t i = 0; i < plain->rgba.size(); ++i)
        EXPECT_NEAR(shaded->rgba[i], plain->rgba[i] * (i % 4 == 3 ? 1.0 : factor), 1e-4)
            << "behind the gap nothing is left of the box's face";
}

TEST(RayCasterLight, TheFaceOfACutShowsGreyValuesAsTheyAre) {
    const Volume volume = randomVolume<std::uint8_t>({30, 30, 30}, {1, 1, 1}, 4);
    RayCastSettings settings = settingsFor(volume, withFrontAcross({}, 11.3), 40, 40);
    settings.camera.heightMm = 25;
    const OpacityCurve opaque = ManualCurve{{{0, 0.999}, {1, 0.999}}};
    const auto plain = castRays(volume, opaque, settings);
    settings.shading = Shading{.reaching = {1.0, 1.0, 0.0}};
    const Apart difference = apart(*plain, *castRays(volume, opaque, settings));
    EXPECT_LT(difference.largest, 0.05 * 255) << "of an opaque cut only the first step is seen, a 32nd of it lit";
    EXPECT_LT(difference.rootMeanSquare, 4.5);
}

TEST(RayCasterLight, ALightVolumeFollowsAllThatItDependsOn) {
    const auto volume =
        std::make_shared<const Volume>(sectorOf(speckledShell<std::uint16_t>({33, 31, 35}, {1, 1.2, 0.8}, 5)));
    RayCaster caster(volume);
    RayCastSettings settings = settingsFor(*volume, Viewpoint{BeamAxis::plusZ, 20, 10, 0}, 40, 40);
    settings.shading = Shading{.reaching = {1.0, 1.0, 0.4}};
    OpacityCurve curve = PowerCurve{2, 0.9};
    const auto expectFollowed = [&](const char* what) {
        const auto expected = castRays(*volume, curve, settings);
        // The second picture of a view keeps its samples, and the third one reads them.
        for (int picture = 0; picture < 3; ++picture)
            EXPECT_LT(apart(*caster.cast(curve, settings), *expected).rootMeanSquare, 0.1) << what << picture;
    };
    expectFollowed("first");
    curve = PowerCurve{1, 0.6};
    expectFollowed("curve");
    settings.shading->towardsLight = {0.8, 0.3, -0.2};
    expectFollowed("light");
    settings.lightCoarseness = 16;
    expectFollowed("coarseness");
    settings.front = CuttingFace{settings.camera.frame.forward, 9.0};
    expectFollowed("near plane");
    settings.box = RenderBox{{3, 4, 5}, {25, 30, 22}};
    expectFollowed("box");
    settings.shading->reaching = {0.0, 0.0, 0.0};
    expectFollowed("none");
    settings.shading->reaching.shadow = 1.0;
    expectFollowed("again");
}

/// Half of a homogeneous volume carries no data; its stored values are 0.
Volume halfEmpty() {
    VolumeGeometry geometry;
    geometry.size = {32, 32, 32};
    std::vector<std::uint8_t> voxels(32 * 32 * 32, 120), mask(32 * 32 * 32, 1);
    for (std::int64_t z = 0; z < 32; ++z)
        for (std::int64_t y = 0; y < 32; ++y)
            for (std::int64_t x = 0; x < 32; ++x)
                if (x + z < 32) {
                    voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] = 0;
                    mask[static_cast<std::size_t>(geometry.offset(x, y, z))] = 0;
                }
    return Volume(geometry, voxels).withDataMask(mask);
}

TEST(RayCasterLight, NoDataIsTransparentWhateverTheCurveSaysOfZero) {
    const Volume volume = halfEmpty();
    const OpacityCurve curve = ManualCurve{{{0, 0.9}, {0.3, 0.9}, {0.4, 0.02}, {1, 0.02}}};
    for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::trilinear}) {
        RayCastSettings settings = settingsFor(volume, Viewpoint{}, 32, 32);
        settings.camera.heightMm = 32;  // a pixel a voxel
        settings.interpolation = interpolation;
        const auto picture = castRays(volume, curve, settings);
        // The smoothed border is as far on the one side of the plane as on the other, but at the corners of the box,
        // beyond which the outermost voxels are repeated.
        const bool nearest = interpolation == Interpolation::nearest;
        for (int column = 3; column < 29; ++column)
            EXPECT_NEAR(pixelAt(*picture, column, 16)[3], 1 - std::pow(0.98, column),
                        nearest                     ? 1e-5
                        : column > 6 && column < 26 ? 1e-3
                                                    : 3e-3)
                << "column " << column << " has that many voxels with data, none mixed with the zeros beside them";
    }
}

TEST(RayCasterLight, TheBorderOfTheSectorMakesNoRelief) {
    const Volume volume = halfEmpty();
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{BeamAxis::plusX, 15, 10, 0}}) {
        RayCastSettings settings = settingsFor(volume, view, 40, 40);
        const OpacityCurve curve = ManualCurve{{{0, 0.3}}};
        settings.shading = Shading{.towardsLight = {-1, 0, -0.3}};
        const auto fromLeft = castRays(volume, curve, settings);
        settings.shading = Shading{.towardsLight = {0, 1, -0.3}};
        EXPECT_LT(apart(*fromLeft, *castRays(volume, curve, settings)).largest, 0.01);
    }
}

template <typename Voxel>
void compareMasked() {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const Volume whole = randomVolume<Voxel>({27, 19, 23}, {1, 0.7, 1.2}, seed);
        std::vector<std::uint8_t> mask(static_cast<std::size_t>(whole.geometry().voxelCount()), 1);
        std::mt19937 dice(seed);
        // The mask holds a sector's outside, and holes.
        for (std::int64_t z = 0; z < 23; ++z)
            for (std::int64_t y = 0; y < 19; ++y)
                for (std::int64_t x = 0; x < 27; ++x)
                    if (std::abs(static_cast<double>(x) - 13) > 2 + 0.6 * static_cast<double>(z) || dice() % 20 == 0)
                        mask[static_cast<std::size_t>(whole.geometry().offset(x, y, z))] = 0;
        const Volume volume = whole.withDataMask(mask);
        for (const bool shaded : {false, true})
            for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::trilinear}) {
                RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 28, -16, 3}, 41, 37);
                settings.interpolation = interpolation;
                settings.step = 0.83;
                if (shaded) settings.shading = Shading{.reaching = {0.8, 0.6, 0.5}};
                EXPECT_LT(largestDifference(volume, PowerCurve{2, 0.6}, settings), noiseTolerance(volume, shaded))
                    << "seed " << seed << (shaded ? " shaded" : "")
                    << (interpolation == Interpolation::nearest ? " nearest" : " trilinear");
            }
    }
}

TEST(RayCasterLight, MaskedBytesAgreeWithASlowReference) { compareMasked<std::uint8_t>(); }
TEST(RayCasterLight, MaskedWordsAgreeWithASlowReference) { compareMasked<std::uint16_t>(); }
TEST(RayCasterLight, MaskedFloatsAgreeWithASlowReference) { compareMasked<float>(); }

TEST(RayCasterLight, ColourMapsRiseFromDarkToBright) {
    for (const ColourMap map : {ColourMap::sepia, ColourMap::grey, ColourMap::ice}) {
        double last = -1.0;
        for (int i = 0; i <= 100; ++i) {
            const Vec3 colour = colourOf(map, i / 100.0);
            const double luma = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
            EXPECT_GT(luma, last);
            for (int channel = 0; channel < 3; ++channel) EXPECT_TRUE(colour[channel] >= 0 && colour[channel] <= 1);
            last = luma;
        }
        EXPECT_GT(last, 0.9);
        EXPECT_EQ(colourOf(map, -1), colourOf(map, 0));
        EXPECT_EQ(colourOf(map, std::nan("")), colourOf(map, 0));
        EXPECT_EQ(colourOf(map, 7), colourOf(map, 1));
    }
    EXPECT_EQ(colourOf(ColourMap::grey, 0.3), Vec3(0.3, 0.3, 0.3)) << "grey shows intensity: eq. 2 in intensities";
}

}  // namespace
}  // namespace echolucent
