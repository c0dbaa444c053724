#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <string>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/designers/gradients/levoy.h"
#include "processing/designers/otsu.h"
#include "processing/intensity/intensity_counts.h"
#include "processing/intensity/no_data.h"
#include "processing/phantom/phantom.h"
#include "processing/sampling/gradient_magnitude.h"
#include "processing/speckle_reduction/speckle_reduction.h"
#include "tests/processing/designers/designer_volumes.h"
#include "tests/processing/tube_core/plane_volume.h"

namespace echolucent {
namespace {

TEST(LevoyLevels, TubeCoresGiveTheLevelsBeforeAndBehindTheSurface) {
    PlaneVolume plane;
    plane.size = {60, 60, 80};
    plane.distanceMm = 45;
    const Volume volume = plane.make();
    LevoyConfig config;
    config.levels = LevoyLevels::tubeCores;
    for (const auto form : {LevoyForm::isovalues, LevoyForm::boundaries}) {
        config.form = form;
        const Design design = designed(config, volume);
        EXPECT_NEAR(factOf(design, "fluid_level"), 14 / 255.0, 0.005);
        EXPECT_NEAR(factOf(design, "tissue_level"), 120 / 255.0, 0.02);
        EXPECT_GT(factOf(design, "surfaces_with_weight"), 0.0);
        EXPECT_TRUE(design.message.empty());
        EXPECT_TRUE(design.classification.isTwoDimensional());
        // The fluid is clear whatever its noise, and the middle of the ramp, which rises by a third of the step, is
        // not.
        for (const double noise : {0.0, 0.004, 0.01})
            EXPECT_LT(opacityAt(design.classification, 14 / 255.0, noise), 0.02);
        EXPECT_GT(opacityAt(design.classification, 67 / 255.0, 106 / 255.0 / 3), 0.4);
    }
}

TEST(LevoyLevels, OtsuGivesTheMeansOfItsClasses) {
    for (const Volume& volume : twoClassVolumes(2)) {
        LevoyConfig config;
        config.levels = LevoyLevels::otsu;
        const auto classes = otsuClasses(intensityCounts(volume)).value();
        const Design design = designed(config, volume);
        EXPECT_EQ(factOf(design, "fluid_level"), classes.dark.mean);
        EXPECT_EQ(factOf(design, "tissue_level"), classes.bright.mean);
        EXPECT_TRUE(design.message.empty());
    }
}

TEST(LevoyLevels, WhereTubeCoresFindNothingOtsuStandsInAndItIsSaid) {
    PhantomConfig scan = defaultPhantom(PhantomScene::empty);
    scan.size = {48, 48, 48};
    const Volume volume = makePhantom(scan).value();
    LevoyConfig config;
    config.levels = LevoyLevels::tubeCores;
    Design fallen = designed(config, volume);
    EXPECT_NE(fallen.message.find("tube core"), std::string::npos);
    EXPECT_NE(fallen.message.find("Otsu"), std::string::npos);
    config.levels = LevoyLevels::otsu;
    const Design otsu = designed(config, volume);
    EXPECT_EQ(fallen.classification, otsu.classification);
    EXPECT_EQ(fallen.facts, otsu.facts);
    // So it does where the levels given are one.
    config.levels = LevoyLevels::given;
    config.fluidLevel = config.tissueLevel = 0.3;
    fallen = designed(config, volume);
    EXPECT_NE(fallen.message.find("Otsu"), std::string::npos);
    EXPECT_EQ(fallen.classification, otsu.classification);
}

/// Before a surface at which the data begin lies no fluid, whatever its level is.
TEST(LevoyLevels, WhereTheDataBeginIsNoFluid) {
    const PlaneVolume plane;
    std::vector<std::uint8_t> voxels = plane.voxels<std::uint8_t>();
    for (std::size_t i = 0; i < voxels.size(); ++i)
        if (i < voxels.size() / 2) voxels[i] = i * 2654435761 % 1009 == 0 ? 40 : 0;
    const Volume all(plane.geometry(), voxels), guessed = all.withDataMask(guessDataMask(all));
    ASSERT_TRUE(adaptOpacity(guessed, {}, {})->surfacesWhereDataBegin);
    LevoyConfig config;
    const Design design = designed(config, guessed);
    EXPECT_NE(design.message.find("Otsu"), std::string::npos);
    config.levels = LevoyLevels::otsu;
    EXPECT_EQ(designed(config, guessed).classification, design.classification);
}

/// Tube cores read the voxels that were measured, the gradients are those of the voxels that are shown.
TEST(LevoyLevels, TubeCoresReadWhatWasMeasuredAndGradientsWhatIsShown) {
    PlaneVolume plane;
    plane.size = {60, 60, 80};
    plane.distanceMm = 45;
    plane.noise = 12;
    const Volume raw = plane.make();
    const Volume quiet = quietVolume(raw, SpeckleReduction::light).value();
    const auto both = design(LevoyConfig{}, DesignerInput{raw, quiet, SpeckleReduction::light}).value();
    const MeanInterface mean =
        meanInterfaceOf(adaptOpacity(raw, {}, {}, {}, {&quiet, SpeckleReduction::light}).value());
    EXPECT_EQ(factOf(both, "fluid_level"), mean.low);
    EXPECT_EQ(factOf(both, "tissue_level"), mean.high);
    EXPECT_EQ(factOf(both, "largest_gradient"), gradientRange(quiet, quiet)->largest);
    EXPECT_LT(factOf(both, "largest_gradient"), 0.8 * factOf(designed(LevoyConfig{}, raw), "largest_gradient"));
    LevoyConfig otsu;
    otsu.levels = LevoyLevels::otsu;
    const auto shown = design(otsu, DesignerInput{raw, quiet, SpeckleReduction::light}).value();
    EXPECT_EQ(factOf(shown, "tissue_level"), otsuClasses(intensityCounts(quiet))->bright.mean);
}

/// Configs of both forms with levels from everywhere.
std::vector<LevoyConfig> everyFormAndLevels() {
    std::vector<LevoyConfig> configs;
    for (const auto form : {LevoyForm::isovalues, LevoyForm::boundaries})
        for (const auto levels : {LevoyLevels::tubeCores, LevoyLevels::otsu, LevoyLevels::given}) {
            configs.emplace_back();
            configs.back().form = form;
            configs.back().levels = levels;
        }
    return configs;
}

TEST(LevoyLevels, WithoutABoundaryItSaysSoAndShowsTheSquare) {
    for (const Volume& volume : volumesWithoutContrast())
        for (const LevoyConfig& config : everyFormAndLevels()) {
            const Design design = designed(config, volume);
            EXPECT_NE(design.message.find("x^2"), std::string::npos);
            EXPECT_EQ(design.classification.curve(), OpacityCurve(PowerCurve{2, 1.0}));
            expectSound(design.classification);
        }
}

TEST(LevoyLevels, IsSoundOnSmallVolumesOfEveryType) {
    std::vector<Volume> volumes = twoClassVolumes(5);
    volumes.push_back(bytesOf({0, 255}));
    volumes.push_back(Volume(gridOf(1, 1, 3), std::vector<std::uint16_t>{0, 7, 9}));
    volumes.push_back(Volume(gridOf(2, 2, 1), std::vector<float>{0.0F, 1e-20F, NAN, 1e-3F}));
    // Almost all voxels are flat: 99 % of them have no gradient.
    std::vector<std::uint8_t> flat(20 * 20 * 20, 50);
    flat[4210] = 200;
    volumes.push_back(Volume(gridOf(20, 20, 20), flat));
    for (const Volume& volume : volumes)
        for (const LevoyConfig& config : everyFormAndLevels()) {
            const Design design = designed(config, volume);
            expectSound(design.classification);
            for (const DesignFact& fact : design.facts) EXPECT_TRUE(std::isfinite(fact.value)) << fact.name;
        }
}

TEST(LevoyLevels, VoxelsWithoutDataMoveNothing) {
    const Volume volume = twoClassVolumes(6).front();
    std::vector<std::uint8_t> mask(13 * 11 * 7, 1), voxels, other;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (i % 13 > 9) mask[i] = 0;
        voxels.push_back(static_cast<std::uint8_t>(volume.storedValue(static_cast<std::int64_t>(i))));
        other.push_back(mask[i] != 0 ? voxels[i] : static_cast<std::uint8_t>(i * 7));
    }
    const Volume one = masked(Volume(volume.geometry(), voxels), mask);
    const Volume same = masked(Volume(volume.geometry(), other), mask);
    for (const auto form : {LevoyForm::isovalues, LevoyForm::boundaries})
        for (const auto levels : {LevoyLevels::tubeCores, LevoyLevels::otsu}) {
            LevoyConfig config;
            config.form = form;
            config.levels = levels;
            EXPECT_EQ(designed(config, one).classification, designed(config, same).classification);
            EXPECT_EQ(designed(config, one).facts, designed(config, same).facts);
        }
}

TEST(LevoyLevels, TheTableOfParametersFollowsWhatIsChosen) {
    LevoyConfig config;
    const auto table = parametersOf(config);
    const auto isSetIn = [&](std::string_view name) { return parameterNamed(table, name)->get(config).has_value(); };
    ASSERT_TRUE(parameterNamed(table, "form")->set(config, std::string("boundaries")));
    ASSERT_TRUE(parameterNamed(table, "levels")->set(config, std::string("otsu")));
    EXPECT_EQ(config.form, LevoyForm::boundaries);
    EXPECT_EQ(config.levels, LevoyLevels::otsu);
    EXPECT_TRUE(isSetIn("gradient_scale"));
    EXPECT_FALSE(isSetIn("transition_width") || isSetIn("surface_opacity") || isSetIn("fluid_level"));
    EXPECT_FALSE(parameterNamed(table, "transition_width")->set(config, 3.0));
    ASSERT_TRUE(parameterNamed(table, "form")->set(config, std::string("isovalues")));
    ASSERT_TRUE(parameterNamed(table, "levels")->set(config, std::string("given")));
    EXPECT_FALSE(isSetIn("gradient_scale"));
    ASSERT_TRUE(parameterNamed(table, "transition_width")->set(config, 3.0));
    ASSERT_TRUE(parameterNamed(table, "tissue_level")->set(config, 0.7));
    EXPECT_EQ(config.transitionWidth, 3.0);
    EXPECT_EQ(config.tissueLevel, 0.7);
    EXPECT_FALSE(parameterNamed(table, "form")->set(config, std::string("tents")));
    for (const Parameter<LevoyConfig>& row : table) {
        // The scope says what the functions do.
        const ParameterValue standard = defaultOf(table, row);
        LevoyConfig one;
        if (!row.scope.parameter.empty()) {
            ASSERT_TRUE(parameterNamed(table, row.scope.parameter)->set(one, std::string(row.scope.choice)));
        }
        EXPECT_TRUE(row.set(one, standard)) << row.name;
        EXPECT_EQ(row.get(one), standard) << row.name;
        if (!row.scope.parameter.empty())
            for (const auto& [choice, label] : parameterNamed(table, row.scope.parameter)->choices) {
                LevoyConfig other;
                ASSERT_TRUE(parameterNamed(table, row.scope.parameter)->set(other, std::string(choice)));
                EXPECT_EQ(row.get(other).has_value(), choice == row.scope.choice) << row.name;
            }
    }
}

TEST(LevoyLevels, HasTheSameBitsOnAnyNumberOfThreadsAndKeepsTheContract) {
    PlaneVolume plane;
    plane.size = {50, 40, 60};
    plane.distanceMm = 35;
    const Volume volume = plane.make();
    for (const LevoyConfig& config : everyFormAndLevels()) {
        const Design design = designed(config, volume);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(designed(config, volume).classification, design.classification);
        EXPECT_EQ(designed(config, volume).facts, design.facts);
        expectContract(config);
    }
}

}  // namespace
}  // namespace echolucent
