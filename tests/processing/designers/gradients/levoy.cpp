#include "processing/designers/gradients/levoy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "processing/sampling/gradient_magnitude.h"
#include "processing/volume/filled_volume.h"
#include "tests/processing/designers/designer_volumes.h"

namespace echolucent {
namespace {

/// Levels that lie on nodes of the table: multiples of 1/1020.
LevoyConfig givenLevels(LevoyForm form) {
    LevoyConfig config;
    config.form = form;
    config.levels = LevoyLevels::given;
    config.fluidLevel = 0.2;
    config.tissueLevel = 0.6;
    config.fluidOpacity = 0.0;
    config.tissueOpacity = 0.0;
    config.surfaceOpacity = 0.9;
    config.surfaceShare = 0.5;
    config.transitionWidth = 2.0;
    return config;
}

/// Intensity as a function of the position in grid mm.
Volume painted(const VolumeGeometry& grid, const std::function<float(const Vec3&)>& intensityAt) {
    std::vector<float> voxels;
    for (std::int64_t z = 0; z < grid.size[2]; ++z)
        for (std::int64_t y = 0; y < grid.size[1]; ++y)
            for (std::int64_t x = 0; x < grid.size[0]; ++x)
                voxels.push_back(intensityAt(grid.gridMmFromVoxel(
                    Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)))));
    return Volume(grid, std::move(voxels), 1.0);
}

/// Calls use(place in grid mm, intensity, gradient magnitude) for every voxel, as a picture finds them there.
template <typename Use>
void forEachIntensityAndGradient(const Volume& volume, const Use& use) {
    const VolumeGeometry& grid = volume.geometry();
    const Volume filled = filledVoxels(volume);
    const GradientMagnitude gradients(filled);
    std::vector<float> row(static_cast<std::size_t>(grid.size[0]));
    for (std::int64_t z = 0; z < grid.size[2]; ++z)
        for (std::int64_t y = 0; y < grid.size[1]; ++y) {
            gradients.row(y, z, row);
            for (std::int64_t x = 0; x < grid.size[0]; ++x)
                use(grid.gridMmFromVoxel(Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z))),
                    volume.normalisedIntensity(grid.offset(x, y, z)),
                    static_cast<double>(row[static_cast<std::size_t>(x)]));
        }
}

/// A ramp that rises by `slope` per unit along a slanted direction, on grids that are alike along all axes or not.
struct Ramp {
    VolumeGeometry grid;
    double slope;
    Vec3 normal = normalized(Vec3(0.5, 0.4, 0.77));

    [[nodiscard]] double at(const Vec3& mm) const { return 0.1 + slope * normal.dot(mm) / grid.unit(); }
    [[nodiscard]] Volume make() const {
        return painted(grid, [this](const Vec3& mm) { return static_cast<float>(at(mm)); });
    }
};
std::vector<Ramp> ramps() {
    return {{gridOf(20, 20, 20), 0.02},
            {gridOf(24, 20, 22, {0.5, 0.8, 1.3}), 0.01},
            {gridOf(9, 8, 30, {3.0, 2.0, 0.7}), 0.015}};
}

/// On a ramp the distance from the surface is |f - f_v| / g: the contour is a tent over it, r units to either side.
TEST(Levoy, AContourOnARampIsATentOfTheGivenWidthInUnits) {
    for (const Ramp& ramp : ramps())
        for (const double width : {1.0, 2.0, 5.0}) {
            const Volume volume = ramp.make();
            LevoyConfig config = givenLevels(LevoyForm::isovalues);
            config.transitionWidth = width;
            const Design design = designed(config, volume);
            // The table's own error: a node distance of the intensity, 1/1020.
            const double bound = 0.9 * (1.0 / 1020) / (width * ramp.slope);
            int within = 0;
            forEachIntensityAndGradient(volume, [&](const Vec3& mm, double f, double g) {
                EXPECT_NEAR(g, ramp.slope, 1e-5);
                const double units = std::abs(ramp.at(mm) - 0.4) / ramp.slope;
                within += units < width ? 1 : 0;
                EXPECT_NEAR(opacityAt(design.classification, f, g), 0.9 * std::max(0.0, 1 - units / width), bound);
            });
            EXPECT_GT(within, 100);
            EXPECT_EQ(factOf(design, "transition_width"), width);
            EXPECT_NEAR(factOf(design, "largest_gradient"), ramp.slope, 1e-5);
            EXPECT_TRUE(design.message.empty());
        }
}

/// Contours combine as 1 - (1 - a)(1 - b)...
TEST(Levoy, SeveralContoursOnARampCombine) {
    const Ramp ramp = ramps().front();
    const Volume volume = ramp.make();
    LevoyConfig config = givenLevels(LevoyForm::isovalues);
    config.fluidOpacity = 0.3;
    config.tissueOpacity = 0.5;
    config.transitionWidth = 12.0;
    const Design design = designed(config, volume);
    forEachIntensityAndGradient(volume, [&](const Vec3& mm, double f, double g) {
        const auto tent = [&](double level) { return std::max(0.0, 1 - std::abs(ramp.at(mm) - level) / 0.02 / 12); };
        const double expected = 1 - (1 - 0.3 * tent(0.2)) * (1 - 0.9 * tent(0.4)) * (1 - 0.5 * tent(0.6));
        EXPECT_NEAR(opacityAt(design.classification, f, g), expected, 0.01);
    });
}

/// At a step both sides see half of it as their gradient; away from it there is none, and only the level itself shows.
TEST(Levoy, AtAStepBothSidesOfTheContourAreAsFarAsTheStepSays) {
    // Bytes lie on nodes of the table.
    constexpr int fluid = 40, tissue = 160;
    const Volume volume = [] {
        std::vector<std::uint8_t> voxels(20 * 6 * 6);
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = i % 20 < 10 ? fluid : tissue;
        return Volume(gridOf(20, 6, 6, {0.5, 1, 1}), std::move(voxels));
    }();
    LevoyConfig config = givenLevels(LevoyForm::isovalues);
    config.fluidLevel = fluid / 255.0;
    config.tissueLevel = tissue / 255.0;
    config.tissueOpacity = 0.6;
    const Design design = designed(config, volume);
    forEachIntensityAndGradient(volume, [&](const Vec3& mm, double f, double g) {
        const double opacity = opacityAt(design.classification, f, g);
        if (mm[0] < 4.25) {
            EXPECT_EQ(opacity, 0.0) << "flat fluid";
        }
        // g is half the step per voxel of one unit, and half the step lies to the surface: 1 - 1/r is left.
        if (std::abs(mm[0] - 4.5) < 0.1) {
            EXPECT_NEAR(opacity, 0.9 * 0.5, 0.02);
        }
        if (std::abs(mm[0] - 5.0) < 0.1) {
            EXPECT_NEAR(opacity, 1 - (1 - 0.9 * 0.5) * (1 - 0.6), 0.02);
        }
        if (mm[0] > 5.25) {
            EXPECT_NEAR(opacity, 0.6, 1e-6) << "flat tissue";
        }
    });
}

TEST(Levoy, BoundariesOnARampRiseFromLevelToLevel) {
    for (const Ramp& ramp : ramps()) {
        const Volume volume = ramp.make();
        LevoyConfig config = givenLevels(LevoyForm::boundaries);
        config.fluidOpacity = 0.1;
        config.tissueOpacity = 0.8;
        for (const auto scale : {LevoyGradientScale::largest, LevoyGradientScale::quantile}) {
            config.gradientScale = scale;
            const Design design = designed(config, volume);
            EXPECT_NEAR(factOf(design, "gradient_scale"), ramp.slope, 5e-5);
            forEachIntensityAndGradient(volume, [&](const Vec3&, double f, double g) {
                const double inside = std::clamp(f, 0.2, 0.6);
                const double expected = (0.8 * (inside - 0.2) + 0.1 * (0.6 - inside)) / 0.4;
                // The quantile is known to 3e-5, which is a share of the gradient.
                EXPECT_NEAR(opacityAt(design.classification, f, g), expected, 1e-3 + 3e-5 / ramp.slope);
            });
        }
    }
}

/// Half as steep is half as opaque, and what is steeper than the scale counts as the scale.
TEST(Levoy, BoundariesAreAsOpaqueAsTheyAreSteep) {
    // Along x the slope is 0.02, then 0.01; one voxel in two hundred is a spike.
    const VolumeGeometry grid = gridOf(40, 20, 20);
    std::vector<float> voxels;
    for (std::int64_t i = 0; i < grid.voxelCount(); ++i) {
        const auto x = static_cast<double>(i % 40);
        voxels.push_back(static_cast<float>(x < 20 ? 0.2 + 0.01 * x : 0.4 + 0.005 * (x - 20)));
    }
    const Volume smooth(grid, voxels, 1.0);
    voxels[static_cast<std::size_t>(grid.offset(20, 10, 10))] = 1.0F;
    const Volume spiked(grid, voxels, 1.0);
    LevoyConfig config = givenLevels(LevoyForm::boundaries);
    config.tissueOpacity = 1.0;
    config.gradientScale = LevoyGradientScale::largest;
    const Design bySteepest = designed(config, smooth);
    EXPECT_NEAR(opacityAt(bySteepest.classification, 0.3, 0.01), 0.25, 1e-4);
    EXPECT_NEAR(opacityAt(bySteepest.classification, 0.5, 0.005), 0.375, 1e-4);
    EXPECT_NEAR(opacityAt(bySteepest.classification, 0.3, 0.5), 0.25, 1e-4) << "steeper than any voxel";
    EXPECT_EQ(opacityAt(bySteepest.classification, 0.3, 0.0), 0.0);
    // The spike makes everything else clear where the largest gradient counts, and moves nothing where the quantile
    // does.
    EXPECT_LT(opacityAt(designed(config, spiked).classification, 0.3, 0.01), 0.01);
    config.gradientScale = LevoyGradientScale::quantile;
    EXPECT_NEAR(opacityAt(designed(config, spiked).classification, 0.3, 0.01), 0.25, 2e-3);
}

/// One voxel in eight thousand and its neighbours have a gradient: 99 % have none, and the largest one scales.
TEST(Levoy, WhereTheQuantileIsNoGradientTheLargestOneScales) {
    std::vector<std::uint8_t> voxels(20 * 20 * 20, 51);
    voxels[4210] = 153;
    LevoyConfig config = givenLevels(LevoyForm::boundaries);
    config.tissueOpacity = 0.8;
    const Design design = designed(config, Volume(gridOf(20, 20, 20), voxels));
    EXPECT_LT(factOf(design, "gradient_quantile"), 3e-5);
    EXPECT_NEAR(factOf(design, "gradient_scale"), 0.2, 1e-6) << "half of the spike, seen from a voxel beside it";
    EXPECT_NEAR(opacityAt(design.classification, 0.6, 0.2), 0.8, 1e-6);
    EXPECT_NEAR(opacityAt(design.classification, 0.6, 0.1), 0.4, 1e-6);
}

/// With the levels' places exchanged nothing changes but their names.
TEST(Levoy, BoundariesDoNotAskWhichLevelIsTheDarkerOne) {
    const Volume volume = ramps().front().make();
    LevoyConfig config = givenLevels(LevoyForm::boundaries), exchanged = config;
    config.fluidOpacity = exchanged.tissueOpacity = 0.3;
    config.tissueOpacity = exchanged.fluidOpacity = 0.7;
    std::swap(exchanged.fluidLevel, exchanged.tissueLevel);
    EXPECT_EQ(designed(config, volume).classification, designed(exchanged, volume).classification);
}

TEST(Levoy, TheClosedFormsHoldAtTheirEdges) {
    const LevoyLevel level{0.4, 0.8};
    EXPECT_EQ(isovalueOpacity(0.4, 0.0, level, 2), 0.8);
    EXPECT_EQ(isovalueOpacity(0.4001, 0.0, level, 2), 0.0);
    EXPECT_EQ(isovalueOpacity(0.4, 0.1, level, 2), 0.8);
    EXPECT_NEAR(isovalueOpacity(0.45, 0.05, level, 2), 0.4, 1e-12);
    EXPECT_NEAR(isovalueOpacity(0.5, 0.05, level, 2), 0.0, 1e-12);
    EXPECT_EQ(isovalueOpacity(0.6, 0.05, level, 2), 0.0);
    const std::array<LevoyLevel, 3> levels{LevoyLevel{0.1, 0.0}, LevoyLevel{0.4, 0.8}, LevoyLevel{0.8, 0.2}};
    EXPECT_EQ(boundaryOpacity(0.05, 1, levels), 0.0);
    EXPECT_NEAR(boundaryOpacity(0.25, 1, levels), 0.4, 1e-12);
    EXPECT_NEAR(boundaryOpacity(0.4, 0.5, levels), 0.4, 1e-12);
    EXPECT_NEAR(boundaryOpacity(0.6, 1, levels), 0.5, 1e-12);
    EXPECT_NEAR(boundaryOpacity(0.9, 3, levels), 0.2, 1e-12);
    EXPECT_EQ(boundaryOpacity(0.9, -1, levels), 0.0);
}

/// What the header promises of the tables, at nodes and between them.
TEST(Levoy, TheTablesErrByNoMoreThanTheirBound) {
    const Volume volume =
        painted(gridOf(40, 3, 3), [](const Vec3& mm) { return static_cast<float>(mm[0] < 20 ? 0.01 * mm[0] : 0.8); });
    LevoyConfig config = givenLevels(LevoyForm::isovalues);
    config.surfaceOpacity = 1.0;
    config.surfaceShare = 0.37;
    const double level = std::round((0.2 + 0.37 * 0.4) * 1020) / 1020;
    const Design design = designed(config, volume);
    const TwoDimensionalOtf& table = *design.classification.twoDimensional();
    const double stepF = 1.0 / (table.intensities - 1), stepG = table.largestGradient / (table.gradients - 1);
    const auto closedForm = [&](double f, double g) {
        if (f == level) return 1.0;
        return g > 0 ? std::max(0.0, 1 - std::abs(f - level) / (2 * g)) : 0.0;
    };
    for (int j = 0; j < table.gradients; ++j)
        for (int i = 0; i < table.intensities; ++i)
            ASSERT_NEAR(table.opacities[static_cast<std::size_t>(j * table.intensities + i)],
                        closedForm(static_cast<double>(i) / 1020, table.largestGradient * j / (table.gradients - 1)),
                        1e-6);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    double worst = 0.0;
    for (int n = 0; n < 2000000; ++n) {
        const double g = table.largestGradient * uniform(random);
        const double f = level + 2.2 * (g + stepF) * (2 * uniform(random) - 1);
        if (f < 0 || f > 1) continue;
        const double lower = std::floor(g / stepG) * stepG;
        const double error = std::abs(opacityAt(table, f, g) - closedForm(f, g));
        if (lower > 0) {
            ASSERT_LE(error, stepF / (2 * lower) + stepG / lower + 1e-6) << f << " " << g;
        }
        if (g >= 0.02) worst = std::max(worst, error);
        // The crest is exact at every gradient, and nothing shows beyond the contour's edge and a node.
        ASSERT_NEAR(opacityAt(table, level, g), 1.0, 1e-6);
        if (std::abs(f - level) > 2 * (g + stepG) + stepF) {
            ASSERT_EQ(opacityAt(table, f, g), 0.0);
        }
    }
    EXPECT_LT(worst, 0.04) << "at gradients that cross the step from 0.2 to 0.6 in less than 20 units";

    config = givenLevels(LevoyForm::boundaries);
    config.fluidLevel = 0.2003;
    config.tissueLevel = 0.6007;
    config.tissueOpacity = 1.0;
    config.gradientScale = LevoyGradientScale::largest;
    const Design boundaries = designed(config, volume);
    for (int n = 0; n < 100000; ++n) {
        const double f = uniform(random), g = 2 * table.largestGradient * uniform(random);
        const double expected =
            std::min(1.0, g / table.largestGradient) * (std::clamp(f, 0.2003, 0.6007) - 0.2003) / 0.4004;
        const bool beside = std::min(std::abs(f - 0.2003), std::abs(f - 0.6007)) < 1.0 / 1020;
        ASSERT_NEAR(opacityAt(boundaries.classification, f, g), expected, beside ? 1 / 0.4004 / 1020 / 4 : 1e-6);
    }
}

}  // namespace
}  // namespace echolucent
