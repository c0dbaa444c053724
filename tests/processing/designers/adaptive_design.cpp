// The adaptive method as a designer: what adaptOpacity() gives, said to a person.
#include "processing/designers/adaptive_design.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/designers/adaptive_words.h"
#include "processing/designers/design.h"
#include "processing/parameters/parameter.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "tests/processing/tube_core/plane_detection.h"

namespace echolucent {
namespace {

std::optional<double> factIn(const Design& design, std::string_view name) {
    const auto found = std::ranges::find(design.facts, name, &DesignFact::name);
    return found == design.facts.end() ? std::nullopt : std::optional(found->value);
}

std::string textOf(const Design& design) {
    std::string text;
    for (const std::string& sentence : design.explanation) text += sentence + '\n';
    return text;
}

/// A curve, finite and within [0,1], and sentences that explain it.
void expectExplainedCurve(const Design& design) {
    ASSERT_FALSE(design.classification.isTwoDimensional());
    for (const double opacity : sampledOpacities(design.classification.curve(), 101)) {
        EXPECT_TRUE(std::isfinite(opacity));
        EXPECT_GE(opacity, 0.0);
        EXPECT_LE(opacity, 1.0);
    }
    for (const DesignFact& fact : design.facts) EXPECT_TRUE(std::isfinite(fact.value)) << fact.name;
    EXPECT_FALSE(design.explanation.empty() && design.message.empty());
    for (const std::string& sentence : design.explanation) EXPECT_TRUE(sentence.ends_with('.')) << sentence;
}

TEST(AdaptiveDesign, IsTheAdaptiveCurveOfTheShownVoxelsWithItsFacts) {
    const Volume volume = PlaneVolume{}.make(), quiet = *quietVolume(volume, SpeckleReduction::medium);
    const Viewpoint view{.azimuthDegrees = 10};
    const DesignerInput input{.raw = volume, .shown = quiet, .reduction = SpeckleReduction::medium, .view = view};
    const Design made = *design(AdaptiveConfig{}, input);
    const AdaptiveOtf otf = *adaptOpacity(volume, view, {}, {}, {&quiet, SpeckleReduction::medium});
    EXPECT_EQ(made.classification, Classification(otf.curve));
    EXPECT_EQ(made.message, "");
    EXPECT_EQ(factIn(made, "tube_cores"), otf.tubesMeetingVolume);
    EXPECT_EQ(factIn(made, "surfaces_with_weight"), otf.tubesWithWeight);
    EXPECT_NEAR(*factIn(made, "low_intensity"), 14 / 255.0, 0.01);
    EXPECT_NEAR(*factIn(made, "high_intensity"), 120 / 255.0, 0.06);
    EXPECT_EQ(factIn(made, "trust"), otf.trust);
    EXPECT_EQ(factIn(made, "speckle_left"), otf.speckleLeft);
    EXPECT_FALSE(factIn(made, "strength"));
    EXPECT_FALSE(factIn(made, "never_placed"));
    EXPECT_NE(textOf(made).find("tube cores (columns of voxels along the view) found a surface"), std::string::npos);
    EXPECT_NE(textOf(made).find("is about 0.05"), std::string::npos) << textOf(made);
    expectExplainedCurve(made);
}

/// The number as sentences write it.
std::string hundredths(double value) { return echolucent::textOf(std::round(100.0 * value) / 100.0); }

TEST(AdaptiveDesign, SaysHowFarARampHasRisenAtItsSurface) {
    const Volume volume = PlaneVolume{}.make(), quiet = *quietVolume(volume, SpeckleReduction::medium);
    const std::string raw = textOf(*design(AdaptiveConfig{}, {.raw = volume, .shown = volume}));
    EXPECT_NE(raw.find("begins at 0.4 of the way"), std::string::npos) << raw;
    EXPECT_NE(raw.find("is full at 1.6 of the way: at its own surface it has risen to 50 % at most."),
              std::string::npos);
    EXPECT_EQ(raw.find("as they were measured"), std::string::npos) << "there are no other voxels";

    const Design made =
        *design(AdaptiveConfig{}, {.raw = volume, .shown = quiet, .reduction = SpeckleReduction::medium});
    const double left = *factIn(made, "speckle_left");
    const double begin = 0.4 + 0.16 * (1 - left), end = 1.6 - 0.5 * (1 - left);
    ASSERT_LT(left, 0.9);
    const std::string text = textOf(made);
    EXPECT_NE(text.find("begins at " + hundredths(begin) + " of the way"), std::string::npos) << text;
    EXPECT_NE(text.find("full at " + hundredths(end) + " of the way: at its own surface it has risen to " +
                        echolucent::textOf(std::round(100 * (1 - begin) / (end - begin))) + " % at most."),
              std::string::npos)
        << text;
    EXPECT_NE(
        text.find("in which " + echolucent::textOf(std::round(100 * left)) + " % of the fluid's speckle is left."),
        std::string::npos)
        << text;
    const double high = *factIn(made, "high_intensity");
    EXPECT_NE(text.find("at it about " + hundredths(high) + ", to which it gives " +
                        hundredths(opacityAt(made.classification.curve(), high)) + "."),
              std::string::npos)
        << text;

    AdaptiveOtfConfig steep;
    steep.curve = RampRule{.begin = 0.2, .end = 0.4, .opacity = 0.5};
    const std::string full = textOf(*design(AdaptiveConfig{}, {.raw = volume, .shown = volume, .method = steep}));
    EXPECT_NE(full.find("is full at 0.5 of the way. Full is an opacity of 0.5 per unit."), std::string::npos) << full;
}

TEST(AdaptiveDesign, AsPublishedTracksTheFirstSignificantMaximumAndClaimsNoSpeckle) {
    const Volume volume = PlaneVolume{}.make(), quiet = *quietVolume(volume, SpeckleReduction::medium);
    for (const MethodReading reading : {MethodReading::asPublished, MethodReading::settled}) {
        const Design made = *design(
            AdaptiveConfig{},
            {.raw = volume, .shown = quiet, .reduction = SpeckleReduction::medium, .method = configOf(reading)});
        ASSERT_TRUE(factIn(made, "low_intensity"));
        EXPECT_FALSE(factIn(made, "speckle_left")) << "detection by variance measures no speckle";
        const std::string text = textOf(made);
        EXPECT_NE(text.find("the first significant local maximum of the variance"), std::string::npos) << text;
        EXPECT_EQ(text.find("at least 40 % of the largest variance") != std::string::npos,
                  reading == MethodReading::settled)
            << text;
        EXPECT_NE(text.find("read at these surfaces in the quiet voxels."), std::string::npos) << text;
    }
}

TEST(AdaptiveDesign, AReadingSaysWhereItGoesBeyondThePaper) {
    const Volume volume = PlaneVolume{}.make(), quiet = *quietVolume(volume, SpeckleReduction::medium);
    const AdaptiveOtfConfig published = configOf(MethodReading::asPublished);
    const std::string raw = readingSentence(*adaptOpacity(volume, {}, published));
    EXPECT_NE(raw.find("eq. 5 mended"), std::string::npos) << raw;
    EXPECT_EQ(raw.find("reduction of speckle"), std::string::npos) << raw;
    const AdaptiveOtf ofQuiet = *adaptOpacity(volume, {}, published, {}, {&quiet, SpeckleReduction::medium});
    EXPECT_NE(readingSentence(ofQuiet).find("The paper knows no reduction of speckle"), std::string::npos);
    AdaptiveOtfConfig changed = published;
    changed.cells.size = 7;
    EXPECT_EQ(readingSentence(*adaptOpacity(volume, {}, changed)), "Parameters of the method were changed.");
}

TEST(AdaptiveDesign, PlotsTheInitialFunction) {
    const Volume volume = PlaneVolume{}.make();
    DesignerInput input{.raw = volume, .shown = volume};
    input.method.initial = PowerCurve{4, 0.5};
    const Design made = *design(AdaptiveConfig{}, input);
    ASSERT_EQ(made.plots.size(), 1u);
    EXPECT_EQ(made.plots[0].name, "initial");
    ASSERT_EQ(made.plots[0].values.size(), made.plots[0].intensities.size());
    for (std::size_t i = 0; i < made.plots[0].values.size(); ++i)
        EXPECT_NEAR(made.plots[0].values[i], 0.5 * std::pow(made.plots[0].intensities[i], 4), 1e-12);
}

TEST(AdaptiveDesign, OfTheProductSaysItsStrength) {
    const Volume volume = PlaneVolume{}.make();
    DesignerInput input{.raw = volume, .shown = volume};
    input.method.curve = ProductRule{.strength = 4.5};
    input.method.detection = VarianceRule{};
    const Design made = *design(AdaptiveConfig{}, input);
    EXPECT_EQ(factIn(made, "strength"), 4.5);
    EXPECT_FALSE(factIn(made, "trust"));
    double sum = 0.0;
    for (const TubeCore& tube : adapted(volume, {}, input.method).tubes) sum += tube.d;
    EXPECT_EQ(factIn(made, "sum_of_d"), sum);
    EXPECT_NE(textOf(made).find("a strength of 4.5"), std::string::npos) << textOf(made);
}

TEST(AdaptiveDesign, SaysWhichTubeCoresWereLeftOut) {
    const Volume volume = PlaneVolume{}.make();
    DesignerInput input{.raw = volume, .shown = volume};
    input.method.grid.withoutTubes = {3, 4, 5};
    const Design made = *design(AdaptiveConfig{}, input);
    EXPECT_EQ(factIn(made, "never_placed"), 3);
    EXPECT_EQ(factIn(made, "tube_cores"), 222);
    EXPECT_NE(textOf(made).find("3 tube cores were left out by hand"), std::string::npos) << textOf(made);
    input.method.grid.withoutTubes = {225};
    EXPECT_THROW((void)design(AdaptiveConfig{}, input), std::invalid_argument);
}

TEST(AdaptiveDesign, WithoutASurfaceShowsTheInitialFunctionAndSaysSo) {
    VolumeGeometry geometry;
    geometry.size = {24, 20, 40};
    const auto count = static_cast<std::size_t>(geometry.voxelCount());
    std::vector<float> holes(count, NAN);
    std::vector<Volume> volumes{Volume(VolumeGeometry{}, std::vector<std::uint8_t>{7}),
                                Volume(geometry, std::vector<std::uint8_t>(count, 0)),
                                Volume(geometry, std::vector<std::uint16_t>(count, 900), 4095.0),
                                Volume(geometry, holes), Volume(geometry, std::vector<float>(count, 0.5f), 1.0)};
    volumes.push_back(volumes[1].withDataMask(std::vector<std::uint8_t>(count, 0)));
    for (const Volume& volume : volumes) {
        const Design made = *design(AdaptiveConfig{}, {.raw = volume, .shown = volume});
        EXPECT_TRUE(made.message.ends_with("the initial function is used.")) << made.message;
        EXPECT_EQ(sampledOpacities(made.classification.curve(), 256), sampledOpacities(PowerCurve{2, 1.0}, 256));
        EXPECT_FALSE(factIn(made, "low_intensity"));
        expectExplainedCurve(made);
    }
}

TEST(AdaptiveDesign, HasNoParameterOfItsOwn) {
    EXPECT_TRUE(parametersOf(AdaptiveConfig{}).empty());
    EXPECT_EQ(AdaptiveConfig{}, AdaptiveConfig{});
}

TEST(AdaptiveDesign, RefusesOtherGridsAndEndsWhereCancelled) {
    const Volume volume = PlaneVolume{}.make(), other(VolumeGeometry{}, std::vector<std::uint8_t>{7});
    EXPECT_THROW((void)design(AdaptiveConfig{}, {.raw = volume, .shown = other}), std::invalid_argument);
    const std::atomic<bool> raised = true;
    EXPECT_FALSE(design(AdaptiveConfig{}, {.raw = volume, .shown = volume}, {{}, &raised}));
}

TEST(AdaptiveDesign, HasTheSameBitsForAnyNumberOfThreads) {
    PlaneVolume plane;
    plane.spacing = {0.5, 0.7, 1.1};
    plane.distanceMm = 55;
    const Volume volume = plane.make(), quiet = *quietVolume(volume, SpeckleReduction::light);
    const DesignerInput input{.raw = volume, .shown = quiet, .reduction = SpeckleReduction::light};
    const auto with = [&](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return *design(AdaptiveConfig{}, input); });
    };
    const Design one = with(1), many = with(5);
    EXPECT_EQ(one.classification, many.classification);
    EXPECT_EQ(one.facts, many.facts);
    EXPECT_EQ(one.explanation, many.explanation);
}

}  // namespace
}  // namespace echolucent
