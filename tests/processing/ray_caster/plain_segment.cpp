// Pre-integration by the plain route: what it finds, where its segments lie.
#include "processing/ray_caster/plain/plain_segment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plain_caster_volumes.h"

namespace echolucent {
namespace {

/// Intensities 0 ... 1 over 41 layers: 1/40 a voxel.
Volume ramp() {
    std::vector<float> layers;
    for (int i = 0; i <= 40; ++i) layers.push_back(static_cast<float>(i) / 40.0f);
    return layered(layers, 1.0);
}

TEST(PlainSegment, MissesNoThinRangeOfTheCurve) {
    const Volume volume = ramp();
    // 0.3 of a voxel of opacity 0.8 per unit.
    const double low = 20.1 / 40, high = 20.4 / 40;
    const OpacityCurve curve = between(low, high, 0.8);
    const double expected = 1 - std::pow(0.2, 0.3);
    for (const double step : {0.1, 0.37, 1.0, 2.0, 4.0}) {
        RayCastSettings settings = greySettings(volume);
        settings.step = step;
        settings.preIntegrated = true;
        const Picture picture = cast(volume, curve, settings);
        EXPECT_NEAR(centreOf(picture)[3], expected, 1e-6) << "step " << step;
        if (step < 1.0) continue;
        // From 1 on one segment holds the whole range.
        EXPECT_NEAR(centreOf(picture)[0], expected * 0.5 * (low + high), 1e-6) << "step " << step;
        settings.preIntegrated = false;
        EXPECT_EQ(centreOf(cast(volume, curve, settings))[3], 0.0f) << "samples step over it";
    }
}

TEST(PlainSegment, SegmentsBeginHalfAStepBeforeTheSample) {
    const Volume volume = ramp();
    RayCastSettings settings = greySettings(volume);
    settings.preIntegrated = true;
    settings.step = 4.0;
    // Box from -0.5: the third segment reaches from voxel 7.5 to 11.5. Each curve is opaque at one of these ends only.
    for (const double end : {7.5, 11.5})
        for (const double offset : {-0.02, 0.02}) {
            const double place = end + offset;
            settings.nearPlaneDepthMm = -0.5;
            settings.box = RenderBox{{-1, -1, 7.5}, {99, 99, 11.5}};
            const Picture picture = cast(volume, between((place - 0.01) / 40, (place + 0.01) / 40, 0.9), settings);
            const bool inside = place > 7.5 && place < 11.5;
            EXPECT_EQ(centreOf(picture)[3] > 0.0f, inside) << place;
        }
}

TEST(PlainSegment, TakesOpacityOneAsOpaque) {
    const Volume volume = ramp();
    RayCastSettings settings = greySettings(volume);
    settings.preIntegrated = true;
    const Picture picture = cast(volume, LinearCurve{0.25, 4.0, 1.0}, settings);
    EXPECT_NEAR(centreOf(picture)[3], 1.0, floatError);
}

TEST(PlainSegment, HalvesTheStepAtTheEdgeOfTheData) {
    const Volume whole = slab(3, 100);
    std::vector<std::uint8_t> mask(144 * 3, 1);
    std::fill_n(mask.begin(), 144, std::uint8_t{0});
    const Volume volume = whole.withDataMask(mask);
    RayCastSettings settings = greySettings(volume);
    settings.interpolation = Interpolation::nearest;
    settings.preIntegrated = true;
    settings.box = RenderBox{{-1, -1, -1}, {99, 99, 1.5}};  // one step, from -0.5 to 1.5, whose ends are voxels 0 and 2
    settings.step = 2.0;
    EXPECT_NEAR(centreOf(cast(volume, everywhere(0.3), settings))[3], 0.3, floatError) << "one unit of two";
    EXPECT_NEAR(centreOf(cast(whole, everywhere(0.3), settings))[3], 1 - 0.7 * 0.7, floatError);
}

// By hand: tau = -log(1 - s) for opacity s; its mean over [a, b] from the integral (1 - s) log(1 - s) + s.
TEST(PlainSegment, MeanExtinctionIsThatOfTheClosedForm) {
    const plain_casting::SegmentIntegral segments(PowerCurve{1, 1.0});
    const auto integral = [](double s) { return (1 - s) * std::log1p(-s) + s; };
    for (const auto& [a, b] : {std::pair(0.0, 0.5), std::pair(0.2, 0.9), std::pair(0.9, 0.2), std::pair(0.3, 0.3001),
                               std::pair(0.50001, 0.50002), std::pair(0.25, 0.25 + 1.0 / 4096)}) {
        const double expected = (integral(b) - integral(a)) / (b - a);
        EXPECT_NEAR(segments.between(a, b).mean, expected, 1e-9) << a << " to " << b;
    }
    EXPECT_NEAR(segments.between(0.4, 0.4).mean, -std::log(0.6), 1e-15);
    EXPECT_NEAR(segments.between(0.4, 0.4).intensity, 0.4, 1e-15);
    EXPECT_EQ(segments.between(0.0, 0.0).mean, 0.0);
    EXPECT_EQ(segments.between(1.0, 1.0).mean, 40.0);
}

}  // namespace
}  // namespace echolucent
