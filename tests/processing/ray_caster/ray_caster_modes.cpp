// What a ray shows of its samples: largest, smallest, mean; depth and colouring by depth; and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

constexpr RenderMode extremes[] = {RenderMode::maximum, RenderMode::minimum, RenderMode::mean};

/// The layers lie along z, each one step thick; they are more than one run of the kernel deep.
template <typename Voxel>
Volume layers() {
    return volumeOf<Voxel>({12, 12, 200}, {1, 1, 1}, [](auto, auto, auto z) {
        return z == 133 ? 0.9 : z == 90 ? 0.05 : 0.1 + 0.5 * static_cast<double>((z * 7) % 19) / 19;
    });
}

template <typename Voxel>
void expectLayersInClosedForm() {
    const Volume volume = layers<Voxel>();
    double sum = 0.0, largest = 0.0, smallest = 2.0;
    for (std::int64_t z = 0; z < 200; ++z) {
        const double value = volume.normalisedIntensity(volume.geometry().offset(5, 5, z));
        sum += value / 200;
        largest = std::max(largest, value);
        smallest = std::min(smallest, value);
    }
    for (const ColourMap map : {ColourMap::sepia, ColourMap::grey, ColourMap::ice})
        for (const RenderMode mode : extremes) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{}, 9, 7);
            settings.camera.heightMm = 8;
            settings.colourMap = map;
            settings.mode = mode;
            settings.findDepth = true;
            const auto picture = castRays(volume, everywhere(0.0), settings);  // the curve plays no part
            const Vec3 colour = colourOf(map, mode == RenderMode::maximum   ? largest
                                              : mode == RenderMode::minimum ? smallest
                                                                            : sum);
            for (int row = 0; row < 7; ++row)
                for (int column = 0; column < 9; ++column) {
                    for (int channel = 0; channel < 3; ++channel)
                        ASSERT_NEAR(pixelAt(*picture, column, row)[channel], colour[channel], 2e-5) << nameOf(mode);
                    ASSERT_EQ(pixelAt(*picture, column, row)[3], 1.0f);
                    // Steps are of one voxel from the box's face on, so samples are voxel centres.
                    const double depth = mode == RenderMode::maximum ? 133.0 : mode == RenderMode::minimum ? 90.0 : 0.0;
                    ASSERT_NEAR(picture->depthMm[static_cast<std::size_t>(row * 9 + column)], depth, 1e-4)
                        << nameOf(mode);
                }
        }
}
TEST(RayCasterModes, LayersOfBytesInClosedForm) { expectLayersInClosedForm<std::uint8_t>(); }
TEST(RayCasterModes, LayersOfWordsInClosedForm) { expectLayersInClosedForm<std::uint16_t>(); }
TEST(RayCasterModes, LayersOfFloatsInClosedForm) { expectLayersInClosedForm<float>(); }

/// The largest, the smallest or the mean of all samples of the slow reference; in a mean a cut step counts with its
/// length.
double bruteForce(const std::vector<ReferenceCaster::Sample>& samples, RenderMode mode) {
    double value = mode == RenderMode::minimum ? 2.0 : 0.0, steps = 0.0;
    for (const auto& sample : samples) {
        if (mode == RenderMode::maximum) value = std::max(value, sample.intensity);
        if (mode == RenderMode::minimum) value = std::min(value, sample.intensity);
        if (mode == RenderMode::mean) value += sample.intensity * sample.length;
        steps += sample.length;
    }
    return mode == RenderMode::mean ? value / steps : value;
}

template <typename Voxel>
void expectBruteForce() {
    const Volume whole = randomVolume<Voxel>({21, 24, 19}, {1, 0.8, 1.3}, 51);
    for (const Volume& volume : {whole, sectorOf(whole)})
        for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::trilinear})
            for (const Projection projection : {Projection::parallel, Projection::perspective})
                for (const RenderMode mode : extremes) {
                    RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::minusX, 23, 31, 5}, 37, 33);
                    settings.camera.projection = projection;
                    settings.interpolation = interpolation;
                    settings.mode = mode;
                    settings.step = 0.57;
                    settings.box = RenderBox{{2, 0, 1}, {17, 90, 90}};
                    const auto picture = castRays(volume, everywhere(0.3), settings);
                    const OpacityCurve none = everywhere(0.0);
                    const ReferenceCaster reference(volume, none, settings);
                    int undecided = 0, seen = 0;
                    for (int row = 0; row < 33; ++row)
                        for (int column = 0; column < 37; ++column) {
                            const auto samples = reference.samplesOf(column, row);
                            if (reference.undecided() && ++undecided < 12) continue;
                            seen += samples.empty() ? 0 : 1;
                            ASSERT_EQ(pixelAt(*picture, column, row)[3], samples.empty() ? 0.0f : 1.0f);
                            const Vec3 colour = samples.empty()
                                                    ? Vec3(0, 0, 0)
                                                    : colourOf(settings.colourMap, bruteForce(samples, mode));
                            for (int channel = 0; channel < 3; ++channel)
                                ASSERT_NEAR(pixelAt(*picture, column, row)[channel], colour[channel],
                                            std::max(4e-4, noiseTolerance(volume, false)))
                                    << nameOf(mode) << " " << column << "," << row;
                        }
                    EXPECT_GT(seen, 200);
                }
}
TEST(RayCasterModes, BytesAgreeWithBruteForce) { expectBruteForce<std::uint8_t>(); }
TEST(RayCasterModes, WordsAgreeWithBruteForce) { expectBruteForce<std::uint16_t>(); }
TEST(RayCasterModes, FloatsAgreeWithBruteForce) { expectBruteForce<float>(); }

TEST(RayCasterModes, WhereThereIsNoDataNothingIsShown) {
    const Volume full = constantVolume<float>({9, 9, 9}, 0.5);
    const Volume volume = full.withDataMask(std::vector<std::uint8_t>(729, 0));
    for (const RenderMode mode : {RenderMode::direct, RenderMode::maximum, RenderMode::minimum, RenderMode::mean}) {
        RayCastSettings settings = settingsFor(volume, Viewpoint{}, 11, 11);
        settings.mode = mode;
        settings.findDepth = true;
        const auto picture = castRays(volume, everywhere(1.0), settings);
        for (const float value : picture->rgba) EXPECT_EQ(value, 0.0f);
        for (const float depth : picture->depthMm) EXPECT_EQ(depth, INFINITY);
        settings.findDepth = false;
        EXPECT_TRUE(castRays(volume, everywhere(1.0), settings)->depthMm.empty());
    }
}

// Next comes the depth.

TEST(RayCasterModes, DepthOfASurfaceIsThatOfItsFirstSample) {
    // All that is behind a plane across the view is opaque.
    const Volume volume =
        volumeOf<std::uint8_t>({40, 40, 90}, {1, 1, 1}, [](auto, auto, auto z) { return z >= 71 ? 1.0 : 0.0; });
    for (const Projection projection : {Projection::parallel, Projection::perspective})
        for (const double step : {0.05, 0.5, 1.7}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{}, 20, 16);
            settings.camera.projection = projection;
            settings.camera.heightMm = 30;
            settings.camera.distanceMm = 120;
            settings.camera.viewAngleDegrees = 10;
            settings.front.reset();
            settings.interpolation = Interpolation::nearest;
            settings.findDepth = true;
            settings.step = step;
            const auto picture = castRays(volume, ManualCurve{{{0.5, 0.0}, {0.5, 1.0}}}, settings);
            ASSERT_EQ(picture->depthMm.size(), 20u * 16u);
            for (const float depth : picture->depthMm) {
                EXPECT_GE(depth, 70.5 - 1e-4);
                EXPECT_LE(depth, 70.5 + step + 1e-4);
            }
        }
}

TEST(RayCasterModes, DepthIsWhereHalfTheOpacityIsReached) {
    const Volume volume = constantVolume<std::uint16_t>({10, 10, 400}, 0.4);
    for (const double opacity : {0.0016, 0.0021, 0.01, 0.05, 0.3, 0.49, 0.51, 1.0})
        for (const double step : {0.25, 1.0, 2.0}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{}, 5, 5);
            settings.camera.heightMm = 5;
            settings.findDepth = true;
            settings.step = step;
            settings.terminationTransmittance = 1.0 / 512;
            const double perStep = opacityForStep(opacity, step);
            const double samples = perStep >= 1.0 ? 1.0 : std::ceil(std::log(0.5) / std::log1p(-perStep));
            const bool reached = samples * step <= 400;
            const auto picture = castRays(volume, everywhere(opacity), settings);
            for (const float depth : picture->depthMm) {
                if (reached)
                    ASSERT_NEAR(depth, -0.5 + (samples - 0.5) * step, 1e-3) << opacity << " at step " << step;
                else
                    ASSERT_EQ(depth, INFINITY) << "half is never reached with " << opacity << " at step " << step;
            }
        }
}

TEST(RayCasterModes, DepthOfExtremesIsThatOfTheSampleShown) {
    const Volume volume = randomVolume<float>({21, 24, 19}, {1, 0.8, 1.3}, 52);
    for (const Projection projection : {Projection::parallel, Projection::perspective})
        for (const RenderMode mode : extremes) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::minusX, 23, 31, 5}, 31, 27);
            settings.camera.projection = projection;
            settings.mode = mode;
            settings.findDepth = true;
            const auto picture = castRays(volume, everywhere(0.3), settings);
            const OpacityCurve none = everywhere(0.0);
            const ReferenceCaster reference(volume, none, settings);
            int elsewhere = 0, seen = 0;
            for (int row = 0; row < 27; ++row)
                for (int column = 0; column < 31; ++column) {
                    const double depth =
                        static_cast<double>(picture->depthMm[static_cast<std::size_t>(row * 31 + column)]);
                    double expected = INFINITY, best = 0.0;
                    for (const auto& sample : reference.samplesOf(column, row)) {
                        const double value = mode == RenderMode::minimum ? -sample.intensity : sample.intensity;
                        const bool better = std::isinf(expected) || (mode != RenderMode::mean && value > best);
                        if (!better) continue;
                        best = value;
                        expected = sample.depthMm;
                    }
                    seen += std::isfinite(expected) ? 1 : 0;
                    elsewhere += depth == expected || std::abs(depth - expected) < 1e-3 ? 0 : 1;
                }
            EXPECT_GT(seen, 200);
            EXPECT_LE(elsewhere, 3) << nameOf(mode) << ": but for two samples that are equal to rounding";
        }
}

// Last comes the colouring by depth.

TEST(RayCasterModes, TintsAreThoseOfFrontAndBackAndLinearBetween) {
    const Volume volume = volumeOf<std::uint8_t>({30, 30, 60}, {1, 1, 1.5}, [](auto, auto, auto) { return 1.0; });
    const DepthColouring colouring{{0.9, 0.7, 0.5}, {0.2, 0.4, 1.0}};
    for (const double opaqueFrom : {-0.75, 20.0, 55.5, 88.0})
        for (const double nearPlane : {-1e30, 10.0}) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{}, 8, 8);
            settings.camera.heightMm = 20;
            settings.colourMap = ColourMap::grey;
            settings.depthColouring = colouring;
            settings.front = CuttingFace{settings.camera.frame.forward, nearPlane};
            settings.step = 0.1;
            settings.findDepth = true;
            settings.box = RenderBox{{-1, -1, opaqueFrom}, {100, 100, 100}};
            const double front = std::max(-0.75, nearPlane), back = 59 * 1.5 + 0.75;
            const auto picture = castRays(volume, everywhere(1.0), settings);
            const double depth = static_cast<double>(picture->depthMm[27]);
            EXPECT_NEAR(depth, std::max(opaqueFrom, front) + 0.05, 0.051);
            const double share = (depth - front) / (back - front);
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(pixelAt(*picture, 3, 3)[channel],
                            colouring.nearTint[channel] * (1 - share) + colouring.farTint[channel] * share, 1e-4)
                    << opaqueFrom;
        }
}

TEST(RayCasterModes, TintsDoNotMoveWithAnEyeInsideTheBox) {
    const Volume volume = volumeOf<std::uint8_t>({30, 30, 60}, {1, 1, 1.5}, [](auto, auto, auto) { return 1.0; });
    const DepthColouring colouring{{0.9, 0.7, 0.5}, {0.2, 0.4, 1.0}};
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 9, 9);
    settings.camera.projection = Projection::perspective;
    settings.colourMap = ColourMap::grey;
    settings.depthColouring = colouring;
    settings.step = 0.1;
    const double front = -0.75, back = 59 * 1.5 + 0.75, middle = (front + back) / 2;
    for (const double distance : {40.0, 20.0, 5.0}) {
        settings.camera.distanceMm = distance;
        const auto picture = castRays(volume, everywhere(1.0), settings);
        // The eye looks at the middle of the box, and the first step begins at the eye.
        const double share = (middle - distance + 0.05 - front) / (back - front);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(pixelAt(*picture, 4, 4)[channel],
                        colouring.nearTint[channel] * (1 - share) + colouring.farTint[channel] * share, 1e-3)
                << distance;
    }
}

TEST(RayCasterModes, ATintedSlabIsTheSumOfItsSteps) {
    const Volume volume = constantVolume<std::uint16_t>({30, 30, 150}, 1.0);
    const DepthColouring colouring{{0.9, 0.7, 0.5}, {0.2, 0.4, 1.0}};
    for (const bool shaded : {false, true}) {
        RayCastSettings settings = settingsFor(volume, Viewpoint{}, 8, 8);
        settings.camera.heightMm = 20;
        settings.colourMap = ColourMap::grey;
        settings.depthColouring = colouring;
        if (shaded) settings.shading = Shading{.ambient = 1.0, .diffuse = 0.0, .specular = 0.0};
        Vec3 sum{0, 0, 0};
        double transmittance = 1.0;
        for (int z = 0; z < 150; ++z, transmittance *= 0.98)
            sum += (colouring.nearTint * (1 - (z + 0.5) / 150) + colouring.farTint * ((z + 0.5) / 150)) *
                   (0.02 * transmittance);
        const auto picture = castRays(volume, everywhere(0.02), settings);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(pixelAt(*picture, 3, 3)[channel], sum[channel], 2e-5) << shaded;
    }
}

TEST(RayCasterModes, RefusesRequestsThatMakeNoSense) {
    const Volume volume = constantVolume<std::uint8_t>({3, 3, 3}, 0.5);
    const RayCastSettings good = settingsFor(volume, Viewpoint{}, 8, 8);
    RayCaster caster(std::make_shared<const Volume>(volume));
    const auto throws = [&](const char* what, auto change) {
        RayCastSettings settings = good;
        change(settings);
        EXPECT_THROW((void)castRays(volume, everywhere(0.1), settings), std::invalid_argument) << what;
        EXPECT_THROW((void)caster.cast(everywhere(0.1), settings), std::invalid_argument) << what;
    };
    using Settings = RayCastSettings;
    throws("infinite step", [](Settings& s) { s.step = INFINITY; });
    throws("negative step", [](Settings& s) { s.step = -1.0; });
    throws("box", [](Settings& s) { s.box = RenderBox{{0, std::nan(""), 0}, {1, 1, 1}}; });
    throws("endless box", [](Settings& s) { s.box = RenderBox{{0, 0, 0}, {1, INFINITY, 1}}; });
    throws("plane without a normal", [](Settings& s) { s.clippingPlanes = {{{0, 0, 0}, {0, 0, 0}}}; });
    throws("plane nowhere", [](Settings& s) { s.clippingPlanes = {{{0, std::nan(""), 0}, {0, 0, 1}}}; });
    throws("reach", [](Settings& s) { s.shading = Shading{.gradientReach = std::nan("")}; });
    throws("no light", [](Settings& s) { s.shading = Shading{.towardsLight = {0, 0, 0}}; });
    throws("termination", [](Settings& s) { s.terminationTransmittance = std::nan(""); });
    throws("angle", [](Settings& s) {
        s.camera.projection = Projection::perspective;
        s.camera.viewAngleDegrees = 0.0;
    });
    throws("distance", [](Settings& s) {
        s.camera.projection = Projection::perspective;
        s.camera.distanceMm = -1.0;
    });
    EXPECT_TRUE(caster.cast(everywhere(0.1), good).has_value()) << "and goes on afterwards";
}

}  // namespace
}  // namespace echolucent
