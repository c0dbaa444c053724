// Flicker of any classification, and the plain pictures that it is measured on.
#include "processing/comparison/plain_frames.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/processing/comparison/small_volumes.h"

namespace echolucent {
namespace {

using Phases = std::vector<std::shared_ptr<const Volume>>;

Phases layers() { return {std::make_shared<const Volume>(twoLayers(51, 204))}; }

/// The light of a ray through both layers, from a slice on.
double lightThrough(double opacity, int first = 0, int last = depth - 1) {
    double light = 0.0;
    for (int k = first; k <= last; ++k) light += std::pow(1 - opacity, k - first) * opacity * (k < 20 ? 0.2 : 0.8);
    return light;
}

TEST(PlainFrames, APixelIsTheSeriesOfItsRay) {
    const auto render = plainFrameRenderer(layers());
    const Picture picture = *render({}, constantOpacity(0.07));
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(picture.height, width);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(picture.rgba[i + c], lightThrough(0.07), 1e-6);
        EXPECT_NEAR(picture.rgba[i + 3], 1.0 - std::pow(0.93, depth), 1e-6);
    }
    const Picture step = *render({}, opacityOfGradient(0.6));
    for (std::size_t i = 0; i < step.rgba.size(); i += 4) EXPECT_NEAR(step.rgba[i], 0.1 + 0.25 * 0.8, 1e-6);
}

TEST(PlainFrames, KeepWhatTheViewCutsOff) {
    const auto render = plainFrameRenderer(layers());
    SweepFrame cut, boxed;
    cut.view = withFrontAcross(cut.view, 15);
    boxed.view.box = OrientedBox{.centreMm = {2.5, 2.5, 19.5}, .sizeMm = {3, 2, 20}};  // slices 10 to 29
    EXPECT_NEAR(render(cut, constantOpacity(0.07))->rgba[0], lightThrough(0.07, 15), 1e-6);
    const Picture picture = *render(boxed, constantOpacity(0.07));
    EXPECT_EQ(picture.width, 3);
    EXPECT_EQ(picture.height, 2);
    EXPECT_NEAR(picture.rgba[0], lightThrough(0.07, 10, 29), 1e-6);
}

TEST(PlainFrames, ARayThatMeetsNothingIsClear) {
    SweepFrame turned;
    turned.view.azimuthDegrees = 45;
    turned.view.rollDegrees = 30;
    const Picture picture = *plainFrameRenderer(layers())(turned, constantOpacity(0.5));
    EXPECT_GT(picture.width, width);
    int clear = 0, lit = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        ASSERT_TRUE(std::isfinite(picture.rgba[i]));
        (picture.rgba[i + 3] == 0.0f ? clear : lit) += 1;
    }
    EXPECT_GT(clear, 10);
    EXPECT_GT(lit, 100);
}

TEST(PlainFrames, SpareRaysWhereTheyStandFartherApart) {
    const Picture picture = *plainFrameRenderer(layers(), 2.0)({}, constantOpacity(0.07));
    EXPECT_EQ(picture.width, 3);
    EXPECT_NEAR(picture.rgba[4], lightThrough(0.07), 1e-6);
    for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1.0 / 0.0})
        EXPECT_THROW((void)plainFrameRenderer(layers(), wrong), std::invalid_argument);
}

TEST(PlainFrames, AFrameShowsItsPhaseAndEndsWhereCancelled) {
    const Phases phases{std::make_shared<const Volume>(twoLayers(51, 204)),
                        std::make_shared<const Volume>(twoLayers(0, 255))};
    SweepFrame second;
    second.phase = 1;
    const auto step = Classification(ManualCurve{{{0.5, 0.0}, {0.5, 1.0}}});
    const auto render = plainFrameRenderer(phases);
    EXPECT_NEAR(render({}, step)->rgba[0], 0.8, 1e-6);
    EXPECT_NEAR(render(second, step)->rgba[0], 1.0, 1e-6);
    const std::atomic<bool> raised = true;
    EXPECT_FALSE(plainFrameRenderer(phases, 1.0, {{}, &raised})(second, step));
}

TEST(ClassificationFlicker, IsTheSecondDifferenceOfThePictures) {
    const std::vector<double> opacities{0.05, 0.2, 0.2, 0.1};
    const std::vector<SweepFrame> frames(4);
    std::vector<Classification> otfs;
    for (const double opacity : opacities) otfs.emplace_back(constantOpacity(opacity));
    const auto flicker = pictureFlicker(frames, otfs, plainFrameRenderer(layers()));
    ASSERT_TRUE(flicker);
    double changes = 0.0, flickers = 0.0;
    for (std::size_t k = 1; k < 4; ++k) {
        const double change = lightThrough(opacities[k]) - lightThrough(opacities[k - 1]);
        changes += change * change;
        if (k == 1) continue;
        const double second = change - (lightThrough(opacities[k - 1]) - lightThrough(opacities[k - 2]));
        flickers += second * second;
    }
    EXPECT_NEAR(flicker->change, std::sqrt(changes / 3), 1e-6);
    EXPECT_NEAR(flicker->flicker, std::sqrt(flickers / 2), 1e-6);
}

TEST(ClassificationFlicker, OfTwoKindsThatSayTheSameIsTheSame) {
    const std::vector<SweepFrame> frames(3);
    std::vector<Classification> curves, tables;
    for (const double opacity : {0.125, 0.25, 0.0625}) {
        curves.emplace_back(constantOpacity(opacity));
        tables.emplace_back(tabulated(4, 3, 1.0, [&](double, double) { return opacity; }));
    }
    const auto one = pictureFlicker(frames, curves, plainFrameRenderer(layers()));
    const auto other = pictureFlicker(frames, tables, plainFrameRenderer(layers()));
    EXPECT_GT(one->flicker, 0.01);
    EXPECT_NEAR(one->flicker, other->flicker, 1e-7);
    EXPECT_NEAR(one->change, other->change, 1e-7);
}

TEST(ClassificationFlicker, OfOneForAllFramesIsNothingAndRendersNothing) {
    int rendered = 0;
    const ClassificationRenderer counting = [&](const SweepFrame&, const Classification&) {
        ++rendered;
        return std::optional(emptyPicture(2, 2));
    };
    const std::vector<SweepFrame> frames(5);
    const auto none = pictureFlicker(frames, std::vector<Classification>(5, opacityOfGradient(0.5)), counting);
    EXPECT_EQ(none->change, 0.0);
    EXPECT_EQ(none->flicker, 0.0);
    EXPECT_EQ(rendered, 0);
    EXPECT_THROW((void)pictureFlicker(frames, std::vector<Classification>(4, PowerCurve{}), counting),
                 std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
