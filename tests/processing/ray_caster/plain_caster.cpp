// The plain route: closed forms, an independent reference, and what each setting means.
#include "processing/ray_caster/plain/plain_caster.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <opencv2/core/cvdef.h>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "app/measuring/measures/compositing_precision.h"
#include "plain_caster_volumes.h"

namespace echolucent {
namespace {

TEST(PlainCaster, HomogeneousSlabHasTheClosedFormTransmittanceForEveryStep) {
    const Volume volume = slab(40, 100);
    for (const double opacity : {0.0, 1e-12, 1e-6, 1e-3, 0.03, 0.2, 0.9, 1.0 - 1e-7, 1.0})
        for (const double step : {1e-3, 0.01, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) {
            RayCastSettings settings = greySettings(volume);
            settings.step = step;
            const Picture picture = cast(volume, everywhere(opacity), settings);
            const double expected = -std::expm1(40 * std::log1p(-opacity));
            EXPECT_NEAR(centreOf(picture)[3], expected, floatError) << opacity << " at step " << step;
            EXPECT_NEAR(centreOf(picture)[1], expected * 100 / 255, floatError) << opacity << " at step " << step;
        }
}

// Petersch 2005, section 4: the layers' share of the light follows from eq. 2 and 3 as powers.
TEST(PlainCaster, TwoLayersFollowEquations2And3) {
    std::vector<std::uint8_t> layers(30, 204);
    std::fill_n(layers.begin(), 11, std::uint8_t{51});
    const Volume volume = layered(layers);
    for (const int exponent : {1, 2, 4}) {
        RayCastSettings settings = greySettings(volume);
        settings.interpolation = Interpolation::nearest;
        const Picture picture = cast(volume, PowerCurve{exponent, 0.3}, settings);
        const double low = 51.0 / 255, high = 204.0 / 255;
        const double throughFront = std::pow(1 - 0.3 * std::pow(low, exponent), 11);
        const double throughAll = throughFront * std::pow(1 - 0.3 * std::pow(high, exponent), 19);
        EXPECT_NEAR(centreOf(picture)[0], low * (1 - throughFront) + high * (throughFront - throughAll), floatError);
        EXPECT_NEAR(centreOf(picture)[3], 1 - throughAll, floatError);
    }
}

/// A bright voxel in the midst of 5 x 5 x 5 dark ones, and a picture whose pixels are a quarter of a voxel wide.
struct OneVoxel {
    Volume volume;
    RayCastSettings settings;
};
OneVoxel oneVoxel() {
    VolumeGeometry geometry;
    geometry.size = {5, 5, 5};
    std::vector<float> voxels(125, 0.0f);
    voxels[static_cast<std::size_t>(geometry.offset(2, 2, 2))] = 1.0f;
    const Volume volume(geometry, voxels, 1.0);
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 20, 20);
    settings.camera.heightMm = 5.0;
    settings.colourMap = ColourMap::grey;
    settings.findDepth = true;
    return {volume, settings};
}

TEST(PlainCaster, OneOpaqueVoxelIsASquareOfItsSize) {
    auto [volume, settings] = oneVoxel();
    settings.interpolation = Interpolation::nearest;
    const Picture picture = cast(volume, between(0.5, 2.0, 1.0), settings);
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 20; ++column) {
            const bool inside = column / 4 == 2 && row / 4 == 2;
            EXPECT_EQ(pixelAt(picture, column, row)[3], inside ? 1.0f : 0.0f) << column << ", " << row;
            EXPECT_EQ(pixelAt(picture, column, row)[2], inside ? 1.0f : 0.0f);
            const float depth = picture.depthMm[static_cast<std::size_t>(row * 20 + column)];
            EXPECT_EQ(depth, inside ? 2.0f : INFINITY) << "its centre's";
        }
}

TEST(PlainCaster, OneVoxelBetweenItsNeighboursHasTheClosedFormOpacity) {
    auto [volume, settings] = oneVoxel();
    constexpr double scale = 0.9;
    // Opacity scale * s, s a tent of height w along the ray: the integral of -log(1 - scale s) over both its sides.
    const auto expected = [&](double w) {
        const double u = scale * w;
        return u > 0 ? -std::expm1(-2 * ((1 - u) * std::log1p(-u) + u) / u) : 0.0;
    };
    settings.step = 0.005;
    const Picture picture = cast(volume, PowerCurve{1, scale}, settings);
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 20; ++column) {
            const auto weight = [](int pixel) { return std::max(0.0, 1.0 - std::abs((pixel + 0.5) / 4 - 0.5 - 2.0)); };
            EXPECT_NEAR(pixelAt(picture, column, row)[3], expected(weight(column) * weight(row)), 2e-5)
                << column << ", " << row;
        }
}

double largestDifferenceFromReference(const Volume& volume, const OpacityCurve& curve,
                                      const RayCastSettings& settings) {
    const Picture picture = cast(volume, curve, settings, {.leastLitOpacity = std::min(1.0, settings.step) / 128});
    const ReferenceCaster reference(volume, curve, settings);
    double largest = 0.0;
    for (int row = 0; row < settings.height; ++row)
        for (int column = 0; column < settings.width; ++column) {
            const ReferencePixel expected = reference.pixel(column, row);
            for (std::size_t channel = 0; channel < 4; ++channel) {
                const double difference =
                    std::abs(expected[channel] - static_cast<double>(pixelAt(picture, column, row)[channel]));
                largest = difference <= largest ? largest : difference;  // a NaN counts as largest
            }
        }
    return largest;
}

template <typename Voxel>
void compareWithReference() {
    for (const bool masked : {false, true})
        for (const bool shaded : {false, true})
            for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::trilinear})
                for (const Projection projection : {Projection::parallel, Projection::perspective}) {
                    Volume volume = randomVolume<Voxel>({17, 13, 11}, {1, 0.7, 1.3}, 7);
                    if (masked) {
                        std::vector<std::uint8_t> mask(17 * 13 * 11, 1);
                        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i % 17 < 3 || i % 23 == 0 ? 0 : 1;
                        volume = volume.withDataMask(mask);
                    }
                    RayCastSettings settings =
                        settingsFor(volume, withFrontAcross(Viewpoint{BeamAxis::plusY, 31, -17, 5}, 2), 29, 23);
                    settings.camera.projection = projection;
                    settings.interpolation = interpolation;
                    settings.step = 0.83;
                    if (shaded) settings.shading = Shading{};
                    EXPECT_LT(largestDifferenceFromReference(volume, PowerCurve{2, 0.6}, settings), 1e-6)
                        << (masked ? "masked " : "") << (shaded ? "shaded " : "") << static_cast<int>(interpolation)
                        << static_cast<int>(projection);
                }
}
TEST(PlainCaster, AgreesWithABackToFrontReferenceOnBytes) { compareWithReference<std::uint8_t>(); }
TEST(PlainCaster, AgreesWithABackToFrontReferenceOnWords) { compareWithReference<std::uint16_t>(); }
TEST(PlainCaster, AgreesWithABackToFrontReferenceOnFloats) { compareWithReference<float>(); }

TEST(PlainCaster, LightsEverySampleUnlessToldOtherwise) {
    const Volume volume = randomVolume<std::uint8_t>({20, 20, 20}, {1, 1, 1}, 3);
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 21, 21);
    settings.shading = Shading{};
    settings.step = 0.02;  // no sample adds 1/128
    const OpacityCurve curve = PowerCurve{2, 0.3};
    const Picture lit = cast(volume, curve, settings);
    const Picture even = cast(volume, curve, settings, {.leastLitOpacity = 1.0 / 128});
    settings.shading->gradientFloor = 1e9;
    const Picture withoutSurfaces = cast(volume, curve, settings);
    double largest = 0.0;
    for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
        EXPECT_NEAR(even.rgba[i], withoutSurfaces.rgba[i], 1e-6);
        largest = std::max(largest, std::abs(static_cast<double>(lit.rgba[i]) - static_cast<double>(even.rgba[i])));
    }
    EXPECT_GT(largest, 0.05);
}

TEST(PlainCaster, ModesShowWhatTheyAreNamedFor) {
    const Volume volume = layered(std::vector<std::uint8_t>{50, 90, 200, 90, 20, 90, 200});
    RayCastSettings settings = greySettings(volume);
    const auto shown = [&](RenderMode mode) {
        settings.mode = mode;
        const Picture picture = cast(volume, everywhere(0.0), settings);
        EXPECT_EQ(centreOf(picture)[3], 1.0f);
        return std::pair(static_cast<double>(centreOf(picture)[0]) * 255, centreDepth(picture));
    };
    EXPECT_NEAR(shown(RenderMode::maximum).first, 200, 1e-4);
    EXPECT_EQ(shown(RenderMode::maximum).second, 2) << "the first of two equal ones";
    EXPECT_NEAR(shown(RenderMode::minimum).first, 20, 1e-4);
    EXPECT_EQ(shown(RenderMode::minimum).second, 4);
    EXPECT_NEAR(shown(RenderMode::mean).first, 740.0 / 7, 1e-4);
    EXPECT_EQ(shown(RenderMode::mean).second, 0);
    settings.mode = RenderMode::maximum;
    const Picture picture = cast(volume.withDataMask(std::vector<std::uint8_t>(144 * 7, 0)), everywhere(1.0), settings);
    EXPECT_EQ(centreOf(picture)[3], 0.0f) << "no data, nothing to show";
    EXPECT_EQ(centreDepth(picture), INFINITY);
}

TEST(PlainCaster, DepthIsWhereHalfTheOpacityIsReached) {
    const Volume volume = slab(30, 100);
    RayCastSettings settings = greySettings(volume);
    // As 0.9^6 = 0.53 and 0.9^7 = 0.48, it is the seventh sample, at depth 6.
    EXPECT_EQ(centreDepth(cast(volume, everywhere(0.1), settings)), 6);
    EXPECT_EQ(centreDepth(cast(volume, everywhere(0.01), settings)), INFINITY);
    settings.findDepth = false;
    EXPECT_TRUE(cast(volume, everywhere(0.1), settings).depthMm.empty());
}

TEST(PlainCaster, WholeStepsCountByTheirMiddles) {
    const Volume volume = slab(20, 100);
    const auto samplesSeen = [&](auto change) {
        RayCastSettings settings = greySettings(volume);
        change(settings);
        return std::log1p(
                   -static_cast<double>(centreOf(cast(volume, everywhere(0.1), settings, {.wholeSteps = true}))[3])) /
               std::log(0.9);
    };
    constexpr double few = 1e-5;
    EXPECT_NEAR(samplesSeen([](RayCastSettings&) {}), 20, few);
    EXPECT_NEAR(samplesSeen([](auto& s) { s.front = CuttingFace{s.camera.frame.forward, 4.5}; }), 15, few);
    EXPECT_NEAR(samplesSeen([](auto& s) { s.box = RenderBox{{-9, -9, 3}, {99, 99, 8}}; }), 5, few) << "3 to 7";
    EXPECT_NEAR(samplesSeen([](auto& s) { s.box = RenderBox{{7, -9, -9}, {99, 99, 99}}; }), 0, few);
    EXPECT_NEAR(samplesSeen([](auto& s) { s.clippingPlanes = {{{0, 0, 6.5}, {0, 0, 2}}}; }), 13, few);
    EXPECT_NEAR(samplesSeen([](auto& s) {
                    s.clippingPlanes = {{{0, 0, 6}, {0, 0, 1}}, {{0, 0, 9.5}, {0, 0, -3}}};
                }),
                4, few);
}

TEST(PlainCaster, CutStepsCountWithTheLengthThatIsLeft) {
    const Volume volume = slab(20, 100);
    const auto unitsSeen = [&](double step, auto change) {
        RayCastSettings settings = greySettings(volume);
        settings.step = step;
        change(settings);
        return std::log1p(-static_cast<double>(centreOf(cast(volume, everywhere(0.1), settings))[3])) / std::log(0.9);
    };
    for (const double step : {0.3, 1.0, 2.7, 50.0}) {
        EXPECT_NEAR(unitsSeen(step, [](RayCastSettings&) {}), 20, 1e-5) << step;
        EXPECT_NEAR(unitsSeen(step,
                              [](auto& s) {
                                  s.front = CuttingFace{s.camera.frame.forward, 4.2};
                              }),
                    15.3, 1e-5)
            << step;
        EXPECT_NEAR(unitsSeen(step, [](auto& s) { s.box = RenderBox{{-9, -9, 3.1}, {99, 99, 7.4}}; }), 4.3, 1e-5);
        EXPECT_NEAR(unitsSeen(step, [](auto& s) { s.clippingPlanes = {{{0, 0, 6.2}, {0, 0, 2}}}; }), 13.3, 1e-5);
        EXPECT_NEAR(unitsSeen(step, [](auto& s) { s.clippingPlanes = {{{0, 0, 6.2}, {0, 0, -1}}}; }), 6.7, 1e-5);
    }
    // Obliquely, the length of every ray within the box is found by its own arithmetic.
    RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 33, 21, 7}, 31, 31);
    settings.step = 3.3;
    const Picture picture = cast(volume, everywhere(0.1), settings);
    const Camera& camera = settings.camera;
    for (int row = 0; row < 31; ++row)
        for (int column = 0; column < 31; ++column) {
            const double pixel = camera.heightMm / 31;
            const Vec3 point = camera.focalPoint + camera.frame.right * ((column - 15) * pixel) +
                               camera.frame.down * ((row - 15) * pixel);
            double enter = -1e9, leave = 1e9;
            for (int axis = 0; axis < 3; ++axis) {
                const double low = (-0.5 - point[axis]) / camera.frame.forward[axis];
                const double high = ((axis == 2 ? 19.5 : 11.5) - point[axis]) / camera.frame.forward[axis];
                enter = std::max(enter, std::min(low, high));
                leave = std::min(leave, std::max(low, high));
            }
            EXPECT_NEAR(pixelAt(picture, column, row)[3], 1 - std::pow(0.9, std::max(0.0, leave - enter)), 1e-6);
        }
}

TEST(PlainCaster, DepthColouringGoesFromTheNearTintToTheFarOne) {
    const Volume volume = slab(20, 255);
    RayCastSettings settings = greySettings(volume);
    settings.depthColouring = DepthColouring{{1, 0.5, 0}, {0, 0.5, 1}};
    const auto redAt = [&](double depth) {
        settings.box = RenderBox{{-9, -9, depth - 0.1}, {99, 99, depth + 0.1}};
        return static_cast<double>(centreOf(cast(volume, everywhere(1.0), settings))[0]);
    };
    EXPECT_NEAR(redAt(0), 1 - 0.5 / 20, floatError);
    EXPECT_NEAR(redAt(19), 0.5 / 20, floatError);
    settings.front = CuttingFace{settings.camera.frame.forward, 9.5};
    EXPECT_NEAR(redAt(10), 1 - 0.5 / 10, floatError) << "from the near plane on";
}

TEST(PlainCaster, CoarsePrecisionsRoundAfterEverySample) {
    const Volume volume = slab(2, 255);
    RayCastSettings settings = greySettings(volume);
    constexpr double opacity = 0.31;
    const auto rounded = [&](CompositingPrecision precision, auto round) {
        const Picture picture = cast(volume, everywhere(opacity), settings, {.rounded = roundingOf(precision)});
        const double first = round(opacity), through = round(1 - opacity);
        EXPECT_NEAR(centreOf(picture)[0], round(first + through * opacity), 1e-7);
        EXPECT_NEAR(centreOf(picture)[3], 1 - round(through * (1 - opacity)), 1e-7);
    };
    rounded(CompositingPrecision::eightBit, [](double x) { return std::round(x * 255) / 255; });
    rounded(CompositingPrecision::half,
            [](double x) { return static_cast<double>(static_cast<float>(cv::float16_t(static_cast<float>(x)))); });
    rounded(CompositingPrecision::single, [](double x) { return static_cast<double>(static_cast<float>(x)); });
    rounded(CompositingPrecision::twofold, [](double x) { return x; });
}

TEST(PlainCaster, HalfPrecisionIsThatOfTheStandardDownToItsSmallestValues) {
    const Volume volume = slab(1, 255);
    const RayCastSettings settings = greySettings(volume);
    for (double opacity = 1.0; opacity > 1e-9; opacity *= 0.73) {
        const Picture picture =
            cast(volume, everywhere(opacity), settings, {.rounded = roundingOf(CompositingPrecision::half)});
        EXPECT_EQ(centreOf(picture)[0], static_cast<float>(cv::float16_t(static_cast<float>(opacity)))) << opacity;
    }
}

TEST(PlainCaster, EightBitsLoseWhatIsFaint) {
    const Volume volume = slab(40, 255);
    const RayCastSettings settings = greySettings(volume);
    const OpacityCurve faint = everywhere(0.001);
    EXPECT_NEAR(centreOf(cast(volume, faint, settings))[3], 1 - std::pow(0.999, 40), floatError);
    EXPECT_EQ(centreOf(cast(volume, faint, settings, {.rounded = roundingOf(CompositingPrecision::eightBit)}))[3],
              0.0f);
}

TEST(PlainCaster, EndsARayWhereItIsAsked) {
    const Volume volume = slab(20, 255);
    RayCastSettings settings = greySettings(volume);
    settings.terminationTransmittance = 0.3;
    EXPECT_NEAR(centreOf(cast(volume, everywhere(0.5), settings))[3], 0.75, floatError);
}

TEST(PlainCaster, SamePixelsForAnyNumberOfThreadsAndCancelled) {
    const Volume volume = randomVolume<std::uint8_t>({19, 17, 13}, {1, 0.8, 1.2}, 5);
    const RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusX, 20, 10, 0}, 60, 50);
    const OpacityCurve curve = PowerCurve{2, 0.5};
    Picture alone;
    tbb::task_arena(1).execute([&] { alone = cast(volume, curve, settings); });
    tbb::task_arena(2).execute([&] { EXPECT_EQ(cast(volume, curve, settings).rgba, alone.rgba); });
    std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(castRaysPlainly(volume, curve, settings, {}, progress).has_value());
}

TEST(PlainCaster, RefusesWhatMakesNoSense) {
    const Volume volume = slab(3, 90);
    RayCastSettings settings = greySettings(volume);
    settings.step = 0.0;
    EXPECT_THROW((void)castRaysPlainly(volume, everywhere(0.1), settings), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
