// Pre-integrated steps: what a curve shows between two samples is not stepped over.
#include <gtest/gtest.h>

#include <cmath>

#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

/// Intensity rises along z from 0 to 1; the slope of a voxel is 1 / (depth - 1).
template <typename Voxel>
Volume ramp(std::int64_t depth) {
    return volumeOf<Voxel>({12, 12, depth}, {1, 1, 1},
                           [&](auto, auto, auto z) { return static_cast<double>(z) / static_cast<double>(depth - 1); });
}

RayCastSettings throughRamp(const Volume& volume, const Viewpoint& view, double step, bool preIntegrated) {
    RayCastSettings settings = settingsFor(volume, view, 6, 6);
    settings.camera.heightMm = 6;
    settings.step = step;
    settings.preIntegrated = preIntegrated;
    settings.colourMap = ColourMap::grey;
    return settings;
}

/// The pixel of a ramp in closed form: the integral of the extinction over intensities, colour along the way.
std::array<double, 2> alphaAndGrey(const OpacityCurve& curve, double depth, bool fromTheBack) {
    constexpr int parts = 200000;
    double optical = 0.0, grey = 0.0;
    for (int i = 0; i < parts; ++i) {
        const double along = (i + 0.5) / parts, intensity = fromTheBack ? 1.0 - along : along;
        const double thickness = -std::log1p(-std::min(opacityAt(curve, intensity), 1 - 1e-15)) * (depth - 1) / parts;
        grey += std::exp(-optical) * -std::expm1(-thickness) * intensity;
        optical += thickness;
    }
    return {-std::expm1(-optical), grey};
}

/// Of a depth for which stored values rise by whole numbers.
template <typename Voxel>
void expectRampInClosedForm(std::int64_t depth, double tolerance) {
    const Volume volume = ramp<Voxel>(depth);
    // The half voxels before and behind the ramp have the intensities 0 and 1: curves are 0 there.
    const OpacityCurve curves[] = {onlyBetween(0.3, 0.8, 0.05), onlyBetween(0.45, 0.5, 0.5),
                                   onlyBetween(0.1, 0.11, 0.9), SampledCurve{{0, 0.02, 0, 0.05, 0.01, 0.03, 0}}};
    for (const OpacityCurve& curve : curves)
        for (const BeamAxis beam : {BeamAxis::plusZ, BeamAxis::minusZ})
            for (const double step : {0.5, 1.0, 2.0, 4.0}) {
                Viewpoint view;
                view.beamAxis = beam;
                const auto picture = castRays(volume, curve, throughRamp(volume, view, step, true));
                const auto [alpha, grey] = alphaAndGrey(curve, static_cast<double>(depth), beam == BeamAxis::minusZ);
                for (int pixel = 0; pixel < 36; ++pixel) {
                    ASSERT_NEAR(pixelAt(*picture, pixel % 6, pixel / 6)[3], alpha, tolerance) << "step " << step;
                    // Attenuation within a step is left out of its colour.
                    ASSERT_NEAR(pixelAt(*picture, pixel % 6, pixel / 6)[0], grey, tolerance + 0.004 * step)
                        << "step " << step;
                }
            }
}
TEST(RayCasterPreIntegrated, ARampOfBytesIsTheClosedForm) { expectRampInClosedForm<std::uint8_t>(86, 2e-3); }
TEST(RayCasterPreIntegrated, ARampOfWordsIsTheClosedForm) { expectRampInClosedForm<std::uint16_t>(92, 2e-3); }
TEST(RayCasterPreIntegrated, ARampOfFloatsIsTheClosedForm) { expectRampInClosedForm<float>(101, 2e-3); }

TEST(RayCasterPreIntegrated, FaintTissueBesideSomethingOpaqueKeepsItsOpacity) {
    // What is dark is opaque; the haze above it is a hundred thousand times fainter.
    const Volume volume = volumeOf<float>({12, 12, 300}, {1, 1, 1}, [](auto, auto, auto z) {
        return 0.5 + 0.4 * static_cast<double>(z) / 299 + 0.003 * std::sin(static_cast<double>(z));
    });
    for (const double faint : {1e-2, 1e-3, 1e-4}) {
        const OpacityCurve curve = ManualCurve{{{0.0, 1.0}, {0.4, 1.0}, {0.45, faint}, {1.0, faint}}};
        for (const double step : {0.5, 1.0, 2.0}) {
            const auto picture = castRays(volume, curve, throughRamp(volume, Viewpoint{}, step, true));
            const double alpha = -std::expm1(300 * std::log1p(-faint));
            EXPECT_NEAR(pixelAt(*picture, 3, 3)[3], alpha, 0.02 * alpha + 1e-5) << faint << " at step " << step;
        }
    }
}

TEST(RayCasterPreIntegrated, AThinShellBetweenSamplesIsNotMissed) {
    // Intensity falls with the distance from a centre; only a shell a third of a voxel thick shows.
    const Volume volume = volumeOf<float>({60, 60, 60}, {1, 1, 1}, [](auto x, auto y, auto z) {
        const double radius =
            length(Vec3(static_cast<double>(x) - 29.5, static_cast<double>(y) - 29.5, static_cast<double>(z) - 29.5));
        return std::clamp(1.0 - radius / 40, 0.0, 1.0);
    });
    const OpacityCurve shell = onlyBetween(0.5, 0.508, 0.95);
    RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 21, 17, 0, 0}, 40, 40);
    settings.step = 0.01;
    const auto converged = castRays(volume, shell, settings);
    ASSERT_GT(largestAlpha(*converged), 0.3f);
    for (const double step : {1.0, 2.0, 4.0}) {
        settings.step = step;
        settings.preIntegrated = false;
        const Apart points = apart(*castRays(volume, shell, settings), *converged);
        settings.preIntegrated = true;
        const auto picture = castRays(volume, shell, settings);
        const Apart segments = apart(*picture, *converged);
        EXPECT_LT(segments.rootMeanSquare, 0.25 * points.rootMeanSquare) << "step " << step;
        for (int row = 14; row < 26; ++row)
            for (int column = 14; column < 26; ++column)
                EXPECT_GT(pixelAt(*picture, column, row)[3], 0.8f * pixelAt(*converged, column, row)[3])
                    << "no holes, step " << step;
    }
}

TEST(RayCasterPreIntegrated, OnSmallStepsItIsThePictureOfPoints) {
    for (const bool masked : {false, true}) {
        const Volume whole = speckledShell<std::uint8_t>({34, 31, 36}, {1, 1.1, 0.9}, 5);
        const Volume volume = masked ? sectorOf(whole) : whole;
        for (const Projection projection : {Projection::parallel, Projection::perspective}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 21, 17, 0, 0}, 40, 40);
            settings.camera.projection = projection;
            settings.step = 0.05;
            const auto points = castRays(volume, PowerCurve{2, 0.3}, settings);
            settings.preIntegrated = true;
            const Apart difference = apart(*points, *castRays(volume, PowerCurve{2, 0.3}, settings));
            EXPECT_LT(difference.rootMeanSquare, masked ? 0.3 : 0.05);
            expectSound(*castRays(volume, PowerCurve{2, 0.3}, settings), "pre-integrated");
        }
    }
}

}  // namespace
}  // namespace echolucent
