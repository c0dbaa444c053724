// The designer that puts a ramp where isosurfaces are steepest.
#include "processing/designers/gradients/contour_spectrum.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "processing/designers/gradients/isovalue_spectrum.h"
#include "processing/phantom/phantom.h"
#include "tests/processing/designers/designer_volumes.h"
#include "tests/processing/designers/gradients/spectrum_volumes.h"

namespace echolucent {
namespace {

PhantomConfig small(PhantomScene scene) {
    PhantomConfig config;
    config.scene = scene;
    config.size = {96, 96, 96};
    config.spacing = {1, 1, 1};
    return config;
}

/// Samples of the curve are opacities, and not all are clear.
void expectVisibleRamp(const Design& design) {
    double largest = 0.0;
    for (const double opacity : sampledOpacities(design.classification.curve(), 256)) {
        EXPECT_TRUE(opacity >= 0.0 && opacity <= 1.0);
        largest = std::max(largest, opacity);
    }
    EXPECT_GT(largest, 0.0);
}

TEST(ContourSpectrum, TheRampStandsBetweenFluidAndTissueOfQuietPhantoms) {
    for (const PhantomScene scene : {PhantomScene::fetus, PhantomScene::shapes}) {
        const PhantomConfig config = small(scene);
        const Volume quiet = *quietVolume(*makePhantom(config), SpeckleReduction::medium);
        const Design found = designed(ContourSpectrumConfig{}, quiet);
        EXPECT_TRUE(found.message.empty()) << found.message;
        EXPECT_GT(factOf(found, "threshold"), 1.5 * config.fluid / 255.0);
        EXPECT_LT(factOf(found, "threshold"), 0.9 * config.tissue / 255.0);
        EXPECT_EQ(factOf(found, "threshold"), factOf(found, "maximum_1"));
        EXPECT_FALSE(found.explanation.empty());
    }
}

/// What is rare and bright is steep in speckle, because there are few voxels and their speckle is strong.
TEST(ContourSpectrum, RareBrightSpeckleIsNotTakenForTheSteepestSurface) {
    const Volume raw = *makePhantom(small(PhantomScene::shapes));
    EXPECT_LT(factOf(designed(ContourSpectrumConfig{}, raw), "threshold"), 0.3);
    ContourSpectrumConfig all;
    all.leastArea = 0.003;
    EXPECT_GT(factOf(designed(all, raw), "threshold"), 0.6);
}

TEST(ContourSpectrum, TheRampRisesAroundItsThreshold) {
    const Volume volume(VolumeGeometry{}, std::vector<std::uint8_t>{3});
    ContourSpectrumConfig config;
    config.choice = IsovalueChoice::given;
    config.threshold = 0.4;
    config.halfWidth = 0.1;
    config.opacity = 0.8;
    const OpacityCurve ramp = designed(config, volume).classification.curve();
    EXPECT_EQ(opacityAt(ramp, 0.29), 0.0);
    EXPECT_NEAR(opacityAt(ramp, 0.35), 0.2, 1e-12);
    EXPECT_NEAR(opacityAt(ramp, 0.4), 0.4, 1e-12);
    EXPECT_EQ(opacityAt(ramp, 0.51), 0.8);
    config.halfWidth = 0.0;
    const OpacityCurve step = designed(config, volume).classification.curve();
    EXPECT_EQ(opacityAt(step, 0.399), 0.0);
    EXPECT_EQ(opacityAt(step, 0.4), 0.8);
}

TEST(ContourSpectrum, WhatOfTheRampLiesBeyondBlackAndWhiteIsCutOff) {
    const Volume volume(VolumeGeometry{}, std::vector<std::uint8_t>{3});
    ContourSpectrumConfig config;
    config.choice = IsovalueChoice::given;
    config.halfWidth = 0.2;
    config.opacity = 0.5;
    for (const double threshold : {0.0, 0.05, 0.95, 1.0}) {
        config.threshold = threshold;
        const Design found = designed(config, volume);
        for (const CurveNode& node : std::get<ManualCurve>(found.classification.curve()).nodes) {
            EXPECT_GE(node.intensity, 0.0);
            EXPECT_LE(node.intensity, 1.0);
        }
        for (const double x : {0.0, 0.1, 0.9, 1.0})
            EXPECT_NEAR(opacityAt(found.classification.curve(), x),
                        0.5 * std::clamp((x - threshold + 0.2) / 0.4, 0.0, 1.0), 1e-12);
    }
}

TEST(ContourSpectrum, FactsAndPlotsAreThoseOfTheSpectrum) {
    VolumeGeometry geometry;
    geometry.size = {48, 48, 48};
    geometry.spacing = {0.5, 0.5, 0.5};
    const Ball ball{{11.7, 11.9, 11.8}, 11.0};
    ContourSpectrumConfig config;
    config.choice = IsovalueChoice::given;
    config.threshold = 102.0 / 255.0;
    const Volume volume = ball.volume(geometry);
    const Design found = designed(config, volume);
    EXPECT_NEAR(factOf(found, "area"), ball.area(0.4), 0.04 * ball.area(0.4)) << "mm²";
    EXPECT_NEAR(factOf(found, "volume_above"), ball.content(0.4), 0.04 * ball.content(0.4)) << "mm³";
    EXPECT_NEAR(factOf(found, "mean_gradient"), 0.5 / 11.0, 0.001) << "per unit";
    ASSERT_EQ(found.plots.size(), 4U);
    EXPECT_EQ(found.plots[0].unit, "mm²");
    EXPECT_EQ(found.plots[0].values[102], factOf(found, "area"));
    EXPECT_EQ(found.plots[0].intensities[102], config.threshold);

    geometry.spacingKnown = false;
    const Design unknown = designed(config, ball.volume(geometry));
    EXPECT_EQ(unknown.plots[0].unit, "units²");
    EXPECT_NEAR(factOf(unknown, "area"), 4.0 * factOf(found, "area"), 1e-9 * factOf(unknown, "area"));
    EXPECT_NEAR(factOf(unknown, "volume_above"), 8.0 * factOf(found, "volume_above"), 1e-6);
}

TEST(ContourSpectrum, MaximaCanBeClicked) {
    const Volume quiet = *quietVolume(*makePhantom(small(PhantomScene::shapes)), SpeckleReduction::medium);
    const auto maxima = maximaOf(*contourSpectrum(quiet), 0.01);
    ASSERT_GE(maxima.size(), 2U);
    ContourSpectrumConfig config;
    config.leastArea = 0.01;
    config.choice = IsovalueChoice::given;
    config.threshold = maxima[1].isovalue;
    const Design clicked = designed(config, quiet);
    EXPECT_EQ(factOf(clicked, "threshold"), maxima[1].isovalue);
    EXPECT_EQ(factOf(clicked, "maximum_1"), maxima[0].isovalue);
    EXPECT_EQ(factOf(clicked, "maximum_2"), maxima[1].isovalue);
}

TEST(ContourSpectrum, WithoutASteepestIsovalueThereIsAMessageAndSomethingIsShown) {
    VolumeGeometry geometry;
    geometry.size = {6, 6, 6};
    const Volume constant(geometry, std::vector<std::uint8_t>(216, 80));
    const Volume zero(geometry, std::vector<std::uint8_t>(216, 0));
    const Volume none = constant.withDataMask(std::vector<std::uint8_t>(216, std::uint8_t{0}));
    const Volume single(VolumeGeometry{}, std::vector<std::uint16_t>{7});
    const Volume noise = *makePhantom(small(PhantomScene::empty));
    for (const Volume* volume : {&constant, &zero, &none, &single, &noise}) {
        const Design found = designed(ContourSpectrumConfig{}, *volume);
        EXPECT_FALSE(found.message.empty());
        EXPECT_EQ(found.classification, Classification(PowerCurve{2, 0.6}));
        expectVisibleRamp(found);
    }
    EXPECT_NE(designed(ContourSpectrumConfig{}, none).message, designed(ContourSpectrumConfig{}, constant).message);
    EXPECT_NE(designed(ContourSpectrumConfig{}, constant).message, designed(ContourSpectrumConfig{}, noise).message);

    ContourSpectrumConfig given;
    given.choice = IsovalueChoice::given;
    EXPECT_FALSE(designed(given, constant).message.empty());
    EXPECT_TRUE(designed(given, noise).message.empty());
    expectVisibleRamp(designed(given, constant));
}

TEST(ContourSpectrum, BrokenContractsThrow) {
    VolumeGeometry geometry, other;
    geometry.size = {2, 2, 2};
    const Volume volume(geometry, std::vector<std::uint8_t>(8, 80)), another(other, std::vector<std::uint8_t>{1});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto expectThrow = [&](double ContourSpectrumConfig::*member, double value) {
        ContourSpectrumConfig config;
        config.choice = IsovalueChoice::given;
        config.*member = value;
        EXPECT_THROW((void)designed(config, volume), std::invalid_argument) << value;
    };
    for (const double value : {-0.1, 1.1, nan}) {
        expectThrow(&ContourSpectrumConfig::threshold, value);
        expectThrow(&ContourSpectrumConfig::halfWidth, value);
        expectThrow(&ContourSpectrumConfig::opacity, value);
        expectThrow(&ContourSpectrumConfig::leastArea, value);
    }
    EXPECT_THROW((void)design(ContourSpectrumConfig{}, DesignerInput{volume, another}), std::invalid_argument);
}

TEST(ContourSpectrum, IsEmptyWhereItWasCancelled) {
    const Volume volume(VolumeGeometry{}, std::vector<std::uint8_t>{1});
    const std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(design(ContourSpectrumConfig{}, DesignerInput{volume, volume}, progress).has_value());
}

TEST(ContourSpectrum, RowsReadAndSetTheirOwnValue) {
    ContourSpectrumConfig config;
    const auto table = parametersOf(config);
    EXPECT_TRUE(problemIn(table, config).empty());
    const auto* threshold = parameterNamed(table, "threshold");
    ASSERT_NE(threshold, nullptr);
    EXPECT_FALSE(threshold->get(config).has_value()) << "nobody gives a threshold";
    EXPECT_FALSE(threshold->set(config, 0.5));
    EXPECT_EQ(std::get<double>(defaultOf(table, *threshold)), ContourSpectrumConfig{}.threshold);
    EXPECT_FALSE(parameterNamed(table, "isovalue")->set(config, std::string("nonsense")));
    EXPECT_TRUE(parameterNamed(table, "isovalue")->set(config, std::string("given")));
    double value = 0.11;
    for (const auto& row : table) {
        if (!row.choices.empty()) continue;
        EXPECT_TRUE(row.set(config, value)) << row.name;
        EXPECT_FALSE(row.set(config, std::string("text"))) << row.name;
        value += 0.1;
    }
    value = 0.11;
    for (const auto& row : table) {
        if (!row.choices.empty()) continue;
        EXPECT_EQ(std::get<double>(*row.get(config)), value) << row.name;
        value += 0.1;
    }
}

}  // namespace
}  // namespace echolucent
