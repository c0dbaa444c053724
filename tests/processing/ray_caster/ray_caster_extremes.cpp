// Sizes, spacings, values, steps, cameras and pictures at the ends of what is allowed.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "processing/ray_caster/kernel_job.h"
#include "ray_caster_scenes.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

const Viewpoint oblique{BeamAxis::plusZ, 27, -16, 5};

/// The picture is as the slow reference has it, bytes of noise but for their shares' 7 bits; and it is sound.
void expectReference(const Picture& picture, const Volume& volume, const OpacityCurve& curve,
                     const RayCastSettings& settings, const std::string& what) {
    expectSound(picture, what);
    const double tolerance = std::max(4e-4, noiseTolerance(volume, settings.shading.has_value()));
    EXPECT_LT(largestDifference(picture, volume, curve, settings), tolerance) << what;
}
void expectReference(const Volume& volume, const OpacityCurve& curve, const RayCastSettings& settings,
                     const std::string& what) {
    expectReference(*castRays(volume, curve, settings), volume, curve, settings, what);
}

std::string nameOf(const std::array<std::int64_t, 3>& size) {
    return std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" + std::to_string(size[2]);
}

template <typename Voxel>
void expectSmallAndThinVolumes() {
    unsigned seed = 20;
    for (const std::array<std::int64_t, 3>& size : std::initializer_list<std::array<std::int64_t, 3>>{
             {1, 1, 1}, {1, 7, 9}, {8, 1, 5}, {7, 8, 1}, {1, 1, 15}, {2, 2, 2}, {8, 8, 8}, {7, 16, 9}})
        for (const Vec3& spacing : {Vec3{1, 1, 1}, Vec3{1, 1, 50}, Vec3{50, 1, 1}, Vec3{0.02, 1, 0.3}})
            for (const Projection projection : {Projection::parallel, Projection::perspective}) {
                const Volume volume = randomVolume<Voxel>(size, spacing, ++seed);
                RayCastSettings settings = settingsFor(volume, oblique, 13, 11);
                settings.camera.projection = projection;
                settings.step = std::max(1.0, spacing[2] / volume.geometry().unit() / 8);
                if (seed % 3 == 0) settings.shading = Shading{};
                expectReference(
                    volume, PowerCurve{2, 0.4}, settings,
                    nameOf(size) + " spacing " + std::to_string(spacing[0]) + ":" + std::to_string(spacing[2]));
            }
}
TEST(RayCasterExtremes, SmallAndThinVolumesOfBytes) { expectSmallAndThinVolumes<std::uint8_t>(); }
TEST(RayCasterExtremes, SmallAndThinVolumesOfWords) { expectSmallAndThinVolumes<std::uint16_t>(); }
TEST(RayCasterExtremes, SmallAndThinVolumesOfFloats) { expectSmallAndThinVolumes<float>(); }

/// There are 32768 voxels in a row, bright and dark in pieces of 100.
template <typename Voxel>
Volume rod(int axis, double spacingAlong = 1.0) {
    std::array<std::int64_t, 3> size{1, 1, 1};
    Vec3 spacing{1, 1, 1};
    size[static_cast<std::size_t>(axis)] = 32768;
    spacing[axis] = spacingAlong;
    return volumeOf<Voxel>(size, spacing, [](auto x, auto y, auto z) {
        return 0.1 + 0.8 * static_cast<double>((x + y + z) / 100 * 37 % 100) / 100;
    });
}

TEST(RayCasterExtremes, ARodSeenAlongItself) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double step : {0.25, 1.0, 100.0}) {
            if (takesSomeInputs && step < 1.0) continue;
            const Volume volume = rod<std::uint8_t>(axis);
            Viewpoint view;
            view.beamAxis = axis == 0 ? BeamAxis::plusX : axis == 1 ? BeamAxis::plusY : BeamAxis::minusZ;
            RayCastSettings settings = settingsFor(volume, view, 3, 3);
            settings.step = step;
            expectReference(volume, PowerCurve{2, 3e-4}, settings, "along axis " + std::to_string(axis));
        }
}

TEST(RayCasterExtremes, ARodSeenAcrossShowsEachPieceInItsPlace) {
    for (int axis = 0; axis < 3; ++axis)
        for (const int pixels : {4, 8, 64, 1024}) {
            const Volume volume = rod<std::uint16_t>(axis);
            Viewpoint view;
            view.beamAxis = axis == 2 ? BeamAxis::plusX : BeamAxis::plusZ;
            RayCastSettings settings = settingsFor(volume, view, pixels, 1);
            settings.camera.heightMm = 32768.0 / pixels;
            if (axis == 1) {  // along the picture's columns
                std::swap(settings.width, settings.height);
                settings.camera.heightMm = 32768.0;
            }
            expectReference(volume, PowerCurve{1, 0.9}, settings, std::to_string(pixels) + " pixels");
            EXPECT_GT(largestAlpha(*castRays(volume, PowerCurve{1, 0.9}, settings)), 0.5f);
        }
}

/// Looks nearly along the rod: rays of neighbouring pixels meet it thousands of voxels apart.
RayCastSettings grazing(const Volume& volume, int width, int height) {
    Viewpoint view;
    view.beamAxis = BeamAxis::plusZ;
    view.azimuthDegrees = 89.9;
    RayCastSettings settings = settingsFor(volume, view, width, height);
    settings.camera.heightMm = 57.0 * height / width;
    return settings;
}

TEST(RayCasterExtremes, RaysOfOnePacketFarApart) {
    for (const int pixels : {4, 9, 40})
        for (const double step : {0.5, 3.0})
            for (const bool shaded : {false, true}) {
                const Volume volume = rod<std::uint8_t>(0);
                RayCastSettings settings = grazing(volume, pixels, 1);
                settings.step = step;
                settings.camera.heightMm = 57.0 / pixels;
                if (shaded) settings.shading = Shading{};
                const OpacityCurve curves[] = {PowerCurve{2, 0.01}, onlyBetween(0.5, 0.7, 0.05)};
                for (const OpacityCurve& curve : curves)
                    expectReference(volume, curve, settings, std::to_string(pixels) + " pixels grazing");
            }
}

// The slices are so large that a packet's rays are too far apart for offsets of 32 bits: each ray goes its own way.
TEST(RayCasterExtremes, RaysAloneJumpOverWhatIsEmptyAndNoFarther) {
    constexpr std::int64_t length = 84000;
    std::mt19937 dice(8);
    std::vector<double> along(length);
    for (std::size_t y = 60; y + 4 < along.size(); y += 90 + dice() % 130)
        std::fill_n(along.begin() + static_cast<std::ptrdiff_t>(y), 4, 0.6);
    const Volume volume = volumeOf<std::uint8_t>(
        {80, length, 1}, {1, 1, 1}, [&](auto, auto y, auto) { return along[static_cast<std::size_t>(y)]; });
    Viewpoint view;
    view.beamAxis = BeamAxis::plusY;
    RayCastSettings settings = settingsFor(volume, view, 4, 1);
    settings.camera.heightMm = 26.2;
    settings.step = 1.15;
    for (const bool skip : {false, true}) {
        settings.skipEmptySpace = skip;
        expectReference(volume, onlyBetween(0.3, 0.9, 5e-4), settings, skip ? "jumping" : "not jumping");
    }
}

// The steps are as long as what the kernel's 32 bits hold of such slices: runs are of a sample or two, and some lie
// wholly before the box.
TEST(RayCasterExtremes, LargeSlicesAndLargeSteps) {
    const auto volume = std::make_shared<const Volume>(volumeOf<std::uint8_t>(
        {3000, 2900, 1}, {1, 1, 1}, [](auto x, auto y, auto) { return static_cast<double>((x + 2 * y) % 512) / 512; }));
    RayCaster caster(volume);
    for (const bool skip : {false, true})
        for (const BeamAxis beam :
             {BeamAxis::plusX, BeamAxis::minusX, BeamAxis::plusY, BeamAxis::minusY, BeamAxis::minusZ})
            for (const double step : {4.0, 40.0, 100.0}) {
                Viewpoint view = oblique;
                view.beamAxis = beam;
                RayCastSettings settings = settingsFor(*volume, view, 21, 13);
                settings.step = step;
                settings.skipEmptySpace = skip;
                const OpacityCurve curve = LinearCurve{0.4, 0.004, 1.0};
                expectReference(*caster.cast(curve, settings), *volume, curve, settings,
                                "step " + std::to_string(step));
            }
    Viewpoint along;
    along.beamAxis = BeamAxis::minusX;
    RayCastSettings settings = settingsFor(*volume, along, 9, 1);
    settings.camera.heightMm = 320;
    settings.step = 100.0;
    expectReference(*caster.cast(PowerCurve{1, 0.01}, settings), *volume, PowerCurve{1, 0.01}, settings, "along it");
}

TEST(RayCasterExtremes, EveryStepFromAThousandthToAHundred) {
    const Volume volume = randomVolume<std::uint8_t>({11, 12, 13}, {1, 1, 1}, 2);
    for (const double step : {1e-3, 0.03, 0.77, 4.0, 7.0, 100.0})
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            RayCastSettings settings = settingsFor(volume, oblique, 5, 4);
            settings.camera.projection = projection;
            settings.step = step;
            expectReference(volume, PowerCurve{2, 0.3}, settings, "step " + std::to_string(step));
        }
}

TEST(RayCasterExtremes, NotFiniteHugeAndTinyFloats) {
    VolumeGeometry geometry;
    geometry.size = {13, 11, 12};
    const float odd[] = {std::nanf(""), INFINITY, -INFINITY, 1e30f, -1e30f, 3.4e38f, -3.4e38f, 1e-42f, -0.0f};
    std::mt19937 dice(4);
    std::vector<float> voxels(static_cast<std::size_t>(geometry.voxelCount()));
    for (float& voxel : voxels) voxel = dice() % 3 == 0 ? odd[dice() % 9] : static_cast<float>(dice() % 100) * 0.01f;
    const Volume volume(geometry, voxels, 1.0);
    for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::trilinear})
        for (const bool shaded : {false, true})
            for (const RenderMode mode :
                 {RenderMode::direct, RenderMode::maximum, RenderMode::minimum, RenderMode::mean}) {
                RayCastSettings settings = settingsFor(volume, oblique, 31, 33);
                settings.interpolation = interpolation;
                settings.mode = mode;
                settings.findDepth = true;
                if (shaded) settings.shading = Shading{};
                const auto picture = castRays(volume, PowerCurve{2, 0.5}, settings);
                expectSound(*picture, "odd floats");
                EXPECT_GT(largestAlpha(*picture), 0.1f);
                // Off the voxels' own lines a share of a voxel of 1e30 is never so small that only rounding sees it.
                if (mode == RenderMode::direct && !shaded && interpolation == Interpolation::nearest) {
                    EXPECT_LT(largestDifference(volume, PowerCurve{2, 0.5}, settings), 4e-4);
                }
            }
}

// The values are a pressure in some other unit: the kernel's numbers must not leave what a float can hold.
TEST(RayCasterExtremes, WhiteLevelsOfAnyMagnitude) {
    for (const double white : {1e-42, 1e-36, 1e-20, 1e20, 3e38}) {
        const Volume unit = randomVolume<float>({12, 13, 11}, {1, 1, 1}, 7);
        std::vector<float> voxels = std::get<VoxelArray<float>>(unit.voxels()).toVector();
        for (float& voxel : voxels) voxel = static_cast<float>(static_cast<double>(voxel) / 3.5 * white);
        const Volume volume(unit.geometry(), voxels, white);
        expectReference(volume, PowerCurve{2, 0.5}, settingsFor(volume, oblique, 21, 17), std::to_string(white));
    }
}

TEST(RayCasterExtremes, CameraInsideOnTheFaceAndAlongAnAxis) {
    const Volume volume = speckledShell<std::uint16_t>({25, 22, 28}, {1, 0.8, 1.3}, 3);
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{BeamAxis::minusX, 0, 0, 0}, oblique})
        for (const double distance : {0.0, 1e-9, 5.0, 1e7})
            for (const double angle : {1e-3, 40.0, 120.0, 179.0}) {
                RayCastSettings settings = settingsFor(volume, view, 15, 11);
                settings.front.reset();
                settings.camera.projection = Projection::perspective;
                settings.camera.viewAngleDegrees = angle;
                settings.camera.distanceMm = distance;
                // The eye is in the midst, on the nearest face, at a voxel, or far away.
                if (distance == 1e-9) settings.camera.focalPoint = volume.geometry().boxMinMm();
                if (distance == 5.0)
                    settings.camera.focalPoint = settings.camera.frame.forward * 5.0 + Vec3(3, 3 * 0.8, 3 * 1.3);
                settings.step = 0.9;
                expectReference(volume, PowerCurve{2, 0.3}, settings,
                                "distance " + std::to_string(distance) + " angle " + std::to_string(angle));
            }
}

TEST(RayCasterExtremes, OneOpaqueVoxelIsSeenFromEverywhereAndOnlyThere) {
    const Volume volume = volumeOf<std::uint8_t>(
        {21, 21, 21}, {1, 1, 1}, [](auto x, auto y, auto z) { return x == 7 && y == 11 && z == 15 ? 1.0 : 0.0; });
    for (int beam = 0; beam < 6; ++beam) {
        Viewpoint view;
        view.beamAxis = static_cast<BeamAxis>(beam);
        RayCastSettings settings = settingsFor(volume, view, 105, 105);
        settings.camera.heightMm = 21;
        settings.interpolation = Interpolation::nearest;
        const auto picture = castRays(volume, everywhere(0.0), settings);
        EXPECT_EQ(largestAlpha(*picture), 0.0f);
        const auto seen = castRays(volume, ManualCurve{{{0.5, 0.0}, {1.0, 1.0}}}, settings);
        for (int row = 0; row < 105; ++row)
            for (int column = 0; column < 105; ++column) {
                const Vec3 across = settings.camera.frame.right * ((column + 0.5) / 5 - 10.5) +
                                    settings.camera.frame.down * ((row + 0.5) / 5 - 10.5);
                const Vec3 there = Vec3(7, 11, 15) - Vec3(10, 10, 10);
                const bool inside =
                    std::abs(there.dot(settings.camera.frame.right) - across.dot(settings.camera.frame.right)) < 0.5 &&
                    std::abs(there.dot(settings.camera.frame.down) - across.dot(settings.camera.frame.down)) < 0.5;
                ASSERT_EQ(pixelAt(*seen, column, row)[3], inside ? 1.0f : 0.0f) << column << "," << row;
            }
    }
}

TEST(RayCasterExtremes, PicturesOfOnePixelOneRowOneColumn) {
    const Volume volume = randomVolume<std::uint8_t>({19, 18, 17}, {1, 1, 1}, 12);
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 1}, {1, 7}, {2, 2}, {5, 33}, {5000, 1}, {1, 600}})
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            RayCastSettings settings = settingsFor(volume, oblique, width, height);
            settings.camera.heightMm = 20.0 / width * height;
            settings.camera.projection = projection;
            if (height > width) settings.camera.heightMm = 20.0;
            settings.step = 2.0;
            expectReference(volume, PowerCurve{2, 0.5}, settings, std::to_string(width) + "x" + std::to_string(height));
        }
}

TEST(RayCasterExtremes, TheWholeVolumeInOnePixelAndOneVoxelOverAllPixels) {
    const Volume volume = speckledShell<std::uint8_t>({20, 20, 20}, {1, 1, 1}, 13);
    for (const double height : {1e12, 1e6, 2000.0, 0.5, 1e-3, 1e-9})
        for (const Viewpoint& view : {Viewpoint{}, oblique}) {
            RayCastSettings settings = settingsFor(volume, view, 9, 9);
            settings.camera.heightMm = height;
            expectReference(volume, PowerCurve{2, 0.5}, settings, "height " + std::to_string(height));
        }
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 9, 9);
    settings.camera.focalPoint = {1e9, -1e9, 1e9};
    EXPECT_EQ(largestAlpha(*castRays(volume, PowerCurve{2, 0.5}, settings)), 0.0f) << "far beside it";
}

TEST(RayCasterExtremes, ShadingReachesOfAnySize) {
    const Volume volume = sectorOf(speckledShell<float>({20, 21, 9}, {1, 1, 1}, 14));
    for (const double reach : {1e-6, 0.5, 30.0, 1e6}) {
        RayCastSettings settings = settingsFor(volume, oblique, 25, 21);
        settings.shading = Shading{.gradientReach = reach};
        const auto picture = castRays(volume, PowerCurve{2, 0.5}, settings);
        expectSound(*picture, "reach " + std::to_string(reach));
        if (reach < 0.1) continue;
        EXPECT_LT(largestDifference(volume, PowerCurve{2, 0.5}, settings), 4e-3) << reach;
    }
}

}  // namespace
}  // namespace echolucent
