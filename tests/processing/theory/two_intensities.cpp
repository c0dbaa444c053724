#include "processing/theory/two_intensities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "processing/theory/contrast_course.h"
#include "processing/theory/theory_plots.h"

namespace echolucent {
namespace {

const OpacityCurve parabola = PowerCurve{2, 1.0};
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

double differenceOf(const TwoIntensities& model, const OpacityCurve& curve) {
    return contrastOf(pixelsOf(model, curve), ContrastKind::difference).value();
}

/// Models with thicknesses up to 200 units, from a fixed seed.
class RandomModels {
public:
    TwoIntensities next() { return {share(), share(), units(), units(), share()}; }
    double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(m_random); }

private:
    std::int64_t units() { return std::uniform_int_distribution<std::int64_t>(0, 200)(m_random); }
    std::mt19937 m_random{36};
};

TEST(TwoIntensities, ClosedFormIsEquations2And3) {
    RandomModels random;
    for (int i = 0; i < 500; ++i) {
        const TwoIntensities model = random.next();
        const OpacityCurve curves[] = {PowerCurve{1, random.share()}, PowerCurve{2, 1.0}, PowerCurve{4, 3.0},
                                       LinearCurve{}, ManualCurve{{{0.2, random.share()}, {0.7, 1.0}}}};
        for (const OpacityCurve& curve : curves)
            for (const ModelRay ray : {ModelRay::throughFluid, ModelRay::intoTissue}) {
                const auto layers = layersOf(model, curve, ray);
                const double closed = inClosedForm(layers, model.background);
                EXPECT_NEAR(closed, byEquation2(layers, model.background), 1e-14);
                EXPECT_NEAR(closed, byEquation3(layers, model.background), 1e-14);
            }
    }
}

TEST(TwoIntensities, PixelsByHand) {
    // One unit of fluid of 0.2 and two of tissue of 0.5, opacity x: eq. 3 written out, before a background of 0.8.
    const TwoIntensities model{0.5, 0.2, 1, 2, 0.8};
    const ModelPixels pixels = pixelsOf(model, PowerCurve{1, 1.0});
    EXPECT_NEAR(pixels.tissue, 0.2 * 0.2 + 0.8 * (0.5 * 0.5 + 0.5 * 0.5 * 0.5 + 0.5 * 0.5 * 0.8), 1e-15);
    EXPECT_NEAR(pixels.fluid, 0.2 * (1.0 - 0.8 * 0.8 * 0.8) + 0.8 * 0.8 * 0.8 * 0.8, 1e-15);
}

TEST(TwoIntensities, LimitsOfOpacityAndThickness) {
    TwoIntensities model{0.6, 0.1, 30, 40, 0.25};
    const ModelPixels clear = pixelsOf(model, ManualCurve{});
    EXPECT_EQ(clear.tissue, 0.25) << "clear: the background shows";
    EXPECT_EQ(clear.fluid, 0.25);
    const ModelPixels opaque = pixelsOf(model, ManualCurve{{{0.0, 1.0}}});
    EXPECT_EQ(opaque.tissue, 0.1) << "opaque: the first voxel shows, fluid in both rays";
    EXPECT_EQ(opaque.fluid, 0.1);
    model.fluidUnits = 0;
    EXPECT_EQ(pixelsOf(model, ManualCurve{{{0.0, 1.0}}}).tissue, 0.6) << "no fluid: tissue shows";
    model.tissueUnits = 0;
    EXPECT_EQ(pixelsOf(model, ManualCurve{{{0.0, 1.0}}}).tissue, 0.25) << "nothing at all";
    for (const auto& byEquation : {byEquation2, byEquation3})
        EXPECT_EQ(byEquation(layersOf(model, parabola, ModelRay::intoTissue), 0.25), 0.25);
}

TEST(TwoIntensities, AMillionUnitsOfHazeHideTheTissue) {
    const TwoIntensities model{0.6, 0.01, TwoIntensities::mostUnits, TwoIntensities::mostUnits, 0.5};
    const auto layers = layersOf(model, parabola, ModelRay::intoTissue);
    const double closed = inClosedForm(layers, model.background);
    EXPECT_NEAR(closed, 0.01, 1e-15) << "1e-4 opacity a unit: the fluid is opaque";
    EXPECT_NEAR(byEquation2(layers, model.background), closed, 1e-11);
    EXPECT_NEAR(byEquation3(layers, model.background), closed, 1e-11);
    EXPECT_NEAR(differenceOf(model, parabola), 0.0, 1e-15);
    const TwoIntensities thin{0.6, 1e-6, TwoIntensities::mostUnits, 40, 0.0};
    EXPECT_NEAR(pixelsOf(thin, parabola).tissue, 0.6, 1e-6) << "1e-12 a unit: all of the tissue is seen through it";
}

TEST(TwoIntensities, EqualIntensitiesHaveNoContrast) {
    for (const double intensity : {0.0, 0.05, 0.4, 1.0}) {
        const TwoIntensities model{intensity, intensity, 30, 40, 0.0};
        EXPECT_NEAR(differenceOf(model, parabola), 0.0, 1e-15);
        TheorySetting setting;
        setting.model = model;
        EXPECT_TRUE(winnersOf(contrastsOf(setting)).empty());
    }
}

TEST(TwoIntensities, TheWinnerIsDecidedByTheDifferenceWhateverContrastIsShown) {
    TheorySetting setting;
    for (const ContrastKind kind : allContrastKinds) {
        setting.contrast = kind;
        EXPECT_EQ(winnerSentence(setting),
                  "By difference, the tissue is shown best by adaptive: 0.333 of white. The parabola beats the line at "
                  "every depth.");
    }
    // Nearly black fluid, as typed of 255: Weber contrast is up to 1e14 there, and eq. 1 has none at all.
    setting.model.fluid = 0.1 / 255.0;
    for (const ContrastKind kind : allContrastKinds) {
        setting.contrast = kind;
        EXPECT_EQ(winnerSentence(setting),
                  "By difference, the tissue is shown best by adaptive: 0.333 of white. The parabola beats the line "
                  "from 23 units of fluid on.");
    }
    ASSERT_EQ(setting.contrast, ContrastKind::weber);
    const auto contrasts = contrastsOf(setting);
    EXPECT_FALSE(contrasts[3].contrast) << "eq. 1 leaves the fluid black";
    EXPECT_GT(*contrasts[2].contrast, *contrasts[0].contrast) << "by Weber contrast x^4 would beat x";
    // Nearly clear fluid and a thick wall: all but the line let the fluid be seen through, and make the wall opaque.
    setting.model.tissueUnits = 4000;
    EXPECT_EQ(winnerSentence(setting),
              "By difference, the tissue is shown best by parabolic, x², quartic, x⁴, eq. 1 and adaptive: 0.333 of "
              "white. The parabola beats the line at every depth.");
}

TEST(TwoIntensities, RelativeContrastsOfPixels) {
    EXPECT_NEAR(contrastOf({0.1, 0.4}, ContrastKind::difference).value(), 0.3, 1e-15);
    EXPECT_NEAR(contrastOf({0.1, 0.4}, ContrastKind::michelson).value(), 0.6, 1e-15);
    EXPECT_NEAR(contrastOf({0.1, 0.4}, ContrastKind::weber).value(), 3.0, 1e-15);
    EXPECT_NEAR(contrastOf({0.4, 0.1}, ContrastKind::michelson).value(), -0.6, 1e-15);
    EXPECT_FALSE(contrastOf({0.0, 0.0}, ContrastKind::michelson)) << "black on black";
    EXPECT_FALSE(contrastOf({0.0, 0.3}, ContrastKind::weber));
}

TEST(TwoIntensities, NumbersOutOfRangeAreRefused) {
    const auto refuses = [](auto change) {
        TwoIntensities model;
        change(model);
        EXPECT_NE(problemOf(model), "");
        EXPECT_THROW(static_cast<void>(pixelsOf(model, parabola)), std::invalid_argument);
        EXPECT_THROW(static_cast<void>(adaptiveCurveOf(model)), std::invalid_argument);
    };
    EXPECT_EQ(problemOf(TwoIntensities{}), "");
    refuses([](TwoIntensities& model) { model.tissue = notANumber; });
    refuses([](TwoIntensities& model) { model.fluid = notANumber; });
    refuses([](TwoIntensities& model) { model.background = notANumber; });
    refuses([](TwoIntensities& model) { model.fluid = -0.01; });
    refuses([](TwoIntensities& model) { model.tissue = 1.01; });
    refuses([](TwoIntensities& model) { model.fluidUnits = -1; });
    refuses([](TwoIntensities& model) { model.tissueUnits = TwoIntensities::mostUnits + 1; });
    TheorySetting setting;
    setting.scale = notANumber;
    EXPECT_THROW(static_cast<void>(contrastsOf(setting)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(scaledCurve(parabola, notANumber)), std::invalid_argument);
}

/// The proof stands in docs/theory.md: D = (1 - alpha2)^n (c1 A1 - c2 A2), and alpha2 alone differs.
TEST(TwoIntensities, AtTheSameOpacityOfTissueTheParabolaIsNeverWorse) {
    RandomModels random;
    for (int i = 0; i < 500; ++i) {
        TwoIntensities model = random.next();
        if (model.fluid > model.tissue) std::swap(model.fluid, model.tissue);
        model.background = 0.0;
        TheorySetting setting{model, {}, random.share(), OpacityScaling::sameAtTissue, ContrastKind::difference};
        const auto contrasts = contrastsOf(setting);
        EXPECT_NEAR(contrasts[1].atTissue, contrasts[0].atTissue, 1e-12);
        EXPECT_GE(*contrasts[1].contrast, *contrasts[0].contrast - 1e-14) << "x^2 against x";
        EXPECT_GE(*contrasts[2].contrast, *contrasts[1].contrast - 1e-14) << "x^4 against x^2";
    }
}

TEST(TwoIntensities, FromOneThicknessOnTheParabolaBeatsTheLine) {
    TwoIntensities model{50.0 / 255.0, 14.0 / 255.0, 0, 10, 0.0};
    const OpacityCurve line = PowerCurve{1, 1.0};
    const auto units = unitsToBeat(model, parabola, line);
    ASSERT_TRUE(units);
    EXPECT_GT(*units, 1.0) << "dark and thin tissue: at first the line shows more";
    model.fluidUnits = static_cast<std::int64_t>(std::floor(*units));
    EXPECT_LT(differenceOf(model, parabola), differenceOf(model, line));
    ++model.fluidUnits;
    EXPECT_GE(differenceOf(model, parabola), differenceOf(model, line));
    model.tissue = 170.0 / 255.0;
    model.tissueUnits = 40;
    EXPECT_EQ(unitsToBeat(model, parabola, line), 0.0) << "bright and thick tissue";
    EXPECT_FALSE(unitsToBeat(model, line, parabola)) << "the line lets less through fluid";
}

TEST(TheoryCurves, TheAdaptiveCurveClearsTheFluidAndShowsTheTissue) {
    const TwoIntensities model;
    const SampledCurve curve = adaptiveCurveOf(model);
    EXPECT_EQ(opacityAt(curve, model.fluid), 0.0);
    EXPECT_GT(opacityAt(curve, model.tissue), 0.4) << "half of the mean ramp, and more of the ramp for every wall";
    EXPECT_EQ(opacityAt(curve, 1.0), curve.opacities.back());
    const TwoIntensities flat{0.3, 0.3, 30, 40, 0.0};
    EXPECT_EQ(adaptiveCurveOf(flat).opacities, sampledOpacities(PowerCurve{2, defaultOpacityScale}, 256))
        << "no rise: the initial function";
}

TEST(TheoryCurves, ScalingKeepsTheLineAndLiftsTheOthersToIt) {
    TheorySetting setting;
    setting.scale = 0.5;
    const double atTissue = 0.5 * setting.model.tissue;
    EXPECT_NEAR(contrastsOf(setting)[0].atTissue, atTissue, 1e-15);
    EXPECT_NEAR(contrastsOf(setting)[1].atTissue, atTissue * setting.model.tissue, 1e-15);
    setting.scaling = OpacityScaling::sameAtTissue;
    for (const CurveContrast& one : contrastsOf(setting)) EXPECT_NEAR(one.atTissue, atTissue, 1e-12) << one.name;
    setting.model.tissue = 15.0 / 255.0;  // below L_L
    EXPECT_EQ(contrastsOf(setting)[3].atTissue, 0.0) << "what is clear cannot be lifted";
}

TEST(ContrastCourse, ItsPlacesAreTheModelsOwn) {
    TheorySetting setting;
    const ContrastCourse depths = courseOf(setting, CourseAxis::depth);
    ASSERT_EQ(depths.places.size(), 101U);
    EXPECT_EQ(depths.places.back(), 100.0);
    const auto at = static_cast<std::size_t>(setting.model.fluidUnits);
    const auto own = contrastsOf(setting);
    for (std::size_t i = 0; i < own.size(); ++i) EXPECT_EQ(depths.contrasts[at][i].contrast, own[i].contrast);
    const ContrastCourse ratios = courseOf(setting, CourseAxis::ratio);
    EXPECT_NEAR(*ratios.contrasts.back()[0].contrast, 0.0, 1e-15) << "c2 = c1";
    for (const CurveContrast& one : ratios.contrasts.front()) EXPECT_EQ(one.pixels.fluid, 0.0) << "black fluid";
    setting.model.fluidUnits = 101;
    EXPECT_EQ(courseOf(setting, CourseAxis::depth).places.back(), 200.0);
}

}  // namespace
}  // namespace echolucent
