// Rays that begin at a curved cut.
#include <gtest/gtest.h>

#include <cmath>

#include "processing/ray_caster/plain/plain_caster.h"
#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

/// A surface over the z axis whose nodes stand at depth(x, y).
template <typename Depth>
CutSurface surfaceOf(const Depth& depth) {
    CutSurface surface;
    surface.frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    surface.firstRightMm = surface.firstDownMm = -4.0;
    surface.spacingMm = 2.0;
    surface.columns = surface.rows = 30;
    for (int row = 0; row < surface.rows; ++row)
        for (int column = 0; column < surface.columns; ++column)
            surface.depthMm.push_back(static_cast<float>(depth(-4.0 + 2.0 * column, -4.0 + 2.0 * row)));
    return surface;
}

TEST(RayCasterCutSurface, AFlatOneIsAClippingPlane) {
    const Volume volume = speckledShell<std::uint16_t>({41, 37, 45}, {1, 1.2, 0.8}, 5);
    for (const Projection projection : {Projection::parallel, Projection::perspective})
        for (const double turn : {0.0, 40.0, 160.0}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, turn, 13, 0}, 61, 53);
            settings.camera.projection = projection;
            settings.shading = Shading{};
            settings.cutSurface = surfaceOf([](double x, double) { return 9.0 + 0.25 * x; });
            const auto curved = castRays(volume, PowerCurve{2, 0.6}, settings);
            settings.cutSurface.reset();
            settings.clippingPlanes = {{{0, 0, 9}, {-0.25, 0, 1}}};
            const auto flat = castRays(volume, PowerCurve{2, 0.6}, settings);
            EXPECT_LT(apart(*curved, *flat).largest, 0.1) << turn;
            settings.clippingPlanes.clear();
            EXPECT_GT(apart(*flat, *castRays(volume, PowerCurve{2, 0.6}, settings)).largest, 10.0) << "it cuts";
        }
}

TEST(RayCasterCutSurface, OpacityBehindACurvedOneIsThatOfWhatIsLeft) {
    const Volume volume = constantVolume<std::uint8_t>({40, 40, 60}, 0.5);
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 30, 30);
    settings.camera.heightMm = 30;
    const CutSurface surface = surfaceOf([](double x, double y) { return 20.0 + 0.02 * x * x - 0.01 * y * y; });
    settings.cutSurface = surface;
    for (const double step : {0.3, 1.0, 2.5}) {
        settings.step = step;
        const auto picture = castRays(volume, everywhere(0.02), settings);
        for (int row = 0; row < 30; ++row)
            for (int column = 0; column < 30; ++column) {
                const Vec3 at{19.5 + column - 14.5, 19.5 + row - 14.5, 0.0};
                const double left = 59.5 - surface.depthAt(at);
                // A hundredth of a voxel is 2e-4 of opacity.
                EXPECT_NEAR(pixelAt(*picture, column, row)[3], 1.0 - std::pow(0.98, left), 2e-4) << step;
            }
    }
}

TEST(RayCasterCutSurface, BothRoutesShowItsFaceAlike) {
    const Volume volume = sectorOf(speckledShell<float>({31, 37, 35}, {1, 1, 1}, 9));
    RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 25, -12, 0}, 51, 47);
    settings.shading = Shading{.reaching = {0.7, 0.7, 0.3}};
    settings.cutSurface = surfaceOf([](double x, double y) { return 12.0 + 2.0 * std::sin(0.3 * x) + 0.1 * y; });
    const auto fast = castRays(volume, PowerCurve{2, 0.8}, settings);
    const auto slow = castRaysPlainly(volume, PowerCurve{2, 0.8}, settings, {.leastLitOpacity = 1.0 / 128});
    EXPECT_LT(apart(*fast, *slow).rootMeanSquare, 0.1);
}

TEST(RayCasterCutSurface, AWrongOneIsRefused) {
    const Volume volume = constantVolume<std::uint8_t>({8, 8, 8}, 0.5);
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 4, 4);
    settings.cutSurface = CutSurface{};
    EXPECT_THROW((void)castRays(volume, everywhere(0.5), settings), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
