// Compositing over many steps: the closed form of a homogeneous slab, and that no light is lost or made.
#include <gtest/gtest.h>

#include <cmath>

#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

constexpr int slabDepth = 200;
constexpr double stepsTried[] = {1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 4.0};
constexpr double opacitiesTried[] = {0.0, 1e-12, 1e-6, 1e-3, 0.03, 0.3, 0.9, 1.0 - 1e-7, 1.0};

/// All pixels look through the whole slab.
RayCastSettings throughSlab(const Volume& volume, double step) {
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 4, 4);
    settings.camera.heightMm = 2.0;
    settings.step = step;
    settings.colourMap = ColourMap::grey;
    return settings;
}

void expectClosedForm(const Volume& volume, double intensity) {
    for (const double opacity : opacitiesTried)
        for (const double step : stepsTried) {
            RayCastSettings settings = throughSlab(volume, step);
            const auto picture = castRays(volume, everywhere(opacity), settings);
            const double alpha = -std::expm1(slabDepth * std::log1p(-opacity));
            for (std::size_t i = 0; i < picture->rgba.size(); ++i)
                ASSERT_NEAR(picture->rgba[i], i % 4 == 3 ? alpha : alpha * intensity, 1e-5)
                    << opacity << " at step " << step << (i % 4 == 3 ? ", alpha" : ", colour");
        }
}

TEST(RayCasterSlab, TransmittanceAndColourAreTheClosedFormForEveryStep) {
    expectClosedForm(constantVolume<std::uint8_t>({4, 4, slabDepth}, 100.0 / 255), 100.0 / 255);
}

TEST(RayCasterSlab, TheClosedFormHoldsForEveryVoxelTypeAndProjection) {
    const Volume volumes[] = {constantVolume<std::uint8_t>({6, 6, slabDepth}, 0.6),
                              constantVolume<std::uint16_t>({6, 6, slabDepth}, 0.6),
                              constantVolume<float>({6, 6, slabDepth}, 0.6)};
    for (const Volume& volume : volumes)
        for (const Projection projection : {Projection::parallel, Projection::perspective})
            for (const bool shaded : {false, true}) {
                RayCastSettings settings = throughSlab(volume, 0.05);
                settings.camera.projection = projection;
                settings.camera.distanceMm = 1e5;  // rays all but parallel: the path is that of the slab's depth
                settings.camera.viewAngleDegrees = 1e-3;
                settings.front.reset();
                const Shading bright{.ambient = 1.0, .diffuse = 0.0, .specular = 0.0};
                if (shaded) settings.shading = bright;  // a light that changes nothing
                const auto picture = castRays(volume, everywhere(0.01), settings);
                const double alpha = -std::expm1(slabDepth * std::log1p(-0.01));
                const double intensity = volume.normalisedIntensity(0);
                EXPECT_NEAR(pixelAt(*picture, 2, 2)[3], alpha, 1e-5) << volume.typeName();
                EXPECT_NEAR(pixelAt(*picture, 2, 2)[0], alpha * intensity, 1e-5) << volume.typeName();
            }
}

TEST(RayCasterSlab, HalvingTheStepLeavesTheTransmittanceOfASpeckledVolume) {
    // The opacities follow intensity: the sum over a ray converges, and each halving with its correction stays near.
    const Volume volume = speckledShell<std::uint8_t>({40, 40, 40}, {1, 1, 1}, 5);
    RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 20, 10, 0}, 32, 32);
    settings.step = 0.02;
    const auto converged = castRays(volume, PowerCurve{2, 0.5}, settings);
    double before = 1e30;
    for (const double step : {1.0, 0.5, 0.25, 0.125}) {
        settings.step = step;
        const Apart difference = apart(*converged, *castRays(volume, PowerCurve{2, 0.5}, settings));
        EXPECT_LT(difference.rootMeanSquare, 0.75 * before) << step;
        before = difference.rootMeanSquare;
    }
    EXPECT_LT(before, 0.3);
}

TEST(RayCasterSlab, AWhiteFurnaceStaysWhite) {
    // Every sample, however dim, is lit until it is white: before a white background nothing can be seen.
    const Volume volume = randomVolume<std::uint8_t>({60, 50, 70}, {1, 0.8, 1.1}, 6);
    for (const double step : {0.01, 0.3, 1.0, 4.0})
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusY, 25, -13, 0}, 24, 20);
            settings.shading = Shading{.ambient = 1e6};
            settings.step = step;
            settings.camera.projection = projection;
            const auto picture = castRays(volume, PowerCurve{2, 0.3}, settings);
            EXPECT_GT(largestAlpha(*picture), 0.5f);
            for (std::size_t i = 0; i < picture->rgba.size(); ++i)
                ASSERT_NEAR(picture->rgba[i] + (1.0 - static_cast<double>(picture->rgba[i / 4 * 4 + 3])), 1.0, 1e-5)
                    << "step " << step;
        }
}

TEST(RayCasterSlab, NoColourIsBrighterThanItsAlpha) {
    for (const std::uint8_t value : {std::uint8_t{255}, std::uint8_t{254}, std::uint8_t{3}})
        for (const ColourMap map : {ColourMap::grey, ColourMap::ice, ColourMap::sepia})
            for (const double opacity : opacitiesTried)
                for (const double step : {0.01, 0.7, 4.0})
                    for (const bool shaded : {false, true}) {
                        const Volume volume = constantVolume<std::uint8_t>({4, 4, slabDepth}, value / 255.0);
                        RayCastSettings settings = throughSlab(volume, step);
                        settings.colourMap = map;
                        if (shaded) settings.shading = Shading{};
                        expectSound(*castRays(volume, everywhere(opacity), settings), "slab");
                    }
}

}  // namespace
}  // namespace echolucent
