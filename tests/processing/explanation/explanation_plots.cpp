#include "processing/explanation/explanation_plots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "processing/explanation/explanation_facts.h"
#include "processing/plots/series_style.h"
#include "tests/processing/explanation/explained_scan.h"
#include "tests/processing/grids.h"

namespace echolucent {
namespace {

const ExplanationFact& factOf(const std::vector<ExplanationFact>& facts, const std::string& key) {
    return *std::ranges::find(facts, key, &ExplanationFact::key);
}

const PlotSeries& seriesOf(const Plot& plot, const std::string& name) {
    const auto place = std::ranges::find(plot.series, name, &PlotSeries::name);
    EXPECT_NE(place, plot.series.end()) << name;
    return *place;
}

TEST(ExplanationFacts, AreTheSameRowsForEveryTubeCoreOfARun) {
    for (const ExplainedRun* run : {&publishedRun(), &defaultRun()}) {
        std::vector<std::string> first;
        for (std::size_t t = 0; t < run->otf.tubes.size(); t += 11) {
            const auto facts = explanationFacts(run->explained(static_cast<int>(t)));
            std::vector<std::string> keys;
            for (const ExplanationFact& fact : facts) {
                keys.push_back(fact.key);
                EXPECT_FALSE(fact.symbol.empty() || fact.value.empty() || fact.place.empty()) << fact.key;
                EXPECT_TRUE(fact.meaning.ends_with('.')) << fact.key;
            }
            EXPECT_EQ(std::set(keys.begin(), keys.end()).size(), keys.size()) << "each key once";
            if (first.empty()) first = keys;
            EXPECT_EQ(keys, first) << t;
        }
    }
}

TEST(ExplanationFacts, SayTheNumbersOfTheTubeCore) {
    const int number = heaviestFirst(publishedRun().otf).front();
    const TubeExplanation explained = publishedRun().explained(number);
    const auto facts = explanationFacts(explained);
    EXPECT_EQ(factOf(facts, "number").value, std::to_string(number));
    EXPECT_EQ(factOf(facts, "state").value, "weighs");
    EXPECT_EQ(factOf(facts, "surface_cell").value, std::to_string(explained.tube.surfaceCell));
    for (const auto& [key, value] : {std::pair<std::string, double>{"i_low", *explained.tube.lowIntensity},
                                     {"i_high", *explained.tube.highIntensity},
                                     {"i_low_max", *explained.tube.lowIntensityMax},
                                     {"slope", *explained.tube.slope},
                                     {"w_intensity", explained.tube.intensityWeight},
                                     {"w_slope", explained.tube.slopeWeight},
                                     {"d", explained.tube.d},
                                     {"factor_most", 1.0 + explained.tube.d}})
        EXPECT_NEAR(std::stod(factOf(facts, key).value), value, 0.006 * std::abs(value)) << key;
    EXPECT_EQ(factOf(facts, "i_low_max_rank").value, std::to_string(explained.intensityRank.rank) + " of " +
                                                         std::to_string(publishedRun().otf.tubesMeetingVolume));
    EXPECT_EQ(factOf(facts, "least_edge_to_noise").value, "no test");
    EXPECT_NE(explanationSentence(explained).find("weighs"), std::string::npos);
}

TEST(ExplanationFacts, SayWhyATubeCoreHasNoWeight) {
    int without = 0;
    for (const ExplainedRun* run : {&publishedRun(), &defaultRun()})
        for (std::size_t t = 0; t < run->otf.tubes.size(); ++t) {
            const TubeState state = stateOf(run->otf, static_cast<int>(t));
            if (state == TubeState::weighs) continue;
            if (++without > 24) break;
            const TubeExplanation explained = run->explained(static_cast<int>(t));
            const std::string says = explanationSentence(explained);
            EXPECT_TRUE(says.starts_with("Tube core " + std::to_string(t))) << says;
            EXPECT_TRUE(says.ends_with('.')) << says;
            EXPECT_EQ(says.find(": ") != std::string::npos,
                      state == TubeState::weighsNothing || state == TubeState::noSurface)
                << says;
            if (state != TubeState::weighsNothing) {
                EXPECT_EQ(factOf(explanationFacts(explained), "d").value, "none");
            }
        }
    EXPECT_GT(without, 5);
}

TEST(ExplanationFacts, SayWhichRuleOfTheRatioFails) {
    int low = 0, notFluid = 0;
    for (std::size_t t = 0; t < defaultRun().otf.tubes.size(); ++t) {
        if (stateOf(defaultRun().otf, static_cast<int>(t)) != TubeState::noSurface) continue;
        const TubeExplanation explained = defaultRun().explained(static_cast<int>(t));
        if (explained.cells.tube.empty()) continue;
        EXPECT_FALSE(explained.unreadSurface);
        const auto& contrasts = explained.tube.interfaceFunction;
        const bool enough = *std::ranges::max_element(contrasts) > *explained.leastContrast;
        const std::string says = explanationSentence(explained);
        EXPECT_NE(says.find(enough ? "leads from enough fluid to tissue" : "has a contrast above "), std::string::npos)
            << says;
        ++(enough ? notFluid : low);
    }
    EXPECT_GT(low, 0);
    EXPECT_GT(notFluid, 0);
    TubeExplanation explained = defaultRun().explained(0);
    explained.state = TubeState::noSurface;
    explained.fluidIntensity.reset();
    EXPECT_NE(explanationSentence(explained).find("no boundary of fluid"), std::string::npos);
    explained.cells.tube = {};
    EXPECT_NE(explanationSentence(explained).find("to fill a cell"), std::string::npos);
}

TEST(ExplanationFacts, SayIfNoCellLiesBeforeASurfaceOfTheRatio) {
    // Fluid of 4 slabs before tissue: the surface's cell begins in the fluid's middle, and no cell fits before it.
    std::mt19937 random(4);
    std::normal_distribution<double> speckle(1.0, 0.2);
    std::vector<std::uint8_t> voxels;
    for (int z = 0; z < 48; ++z)
        for (int i = 0; i < 48 * 48; ++i) {
            const double level = z < (i % 48 < 24 ? 4 : 16) ? 10.0 : 120.0;
            voxels.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(level * speckle(random), 1.0, 255.0))));
        }
    const Volume volume(gridOf({48, 48, 48}, {1, 1, 1}), std::move(voxels), 255.0);
    AdaptiveOtfConfig config;
    config.grid.columns = config.grid.rows = 7;
    auto& rule = std::get<RatioRule>(config.detection);
    rule.leastFluid = 3;
    rule.leastDark = 2;
    const AdaptiveOtf otf = *adaptOpacity(volume, {}, config);
    ASSERT_TRUE(otf.fluidIntensity && !otf.lengthsHalved);
    int unread = 0;
    for (int number = 0; number < 49; ++number) {
        const TubeExplanation explained = *explainTube(volume, {}, otf, number);
        if (!explained.unreadSurface) continue;
        ++unread;
        EXPECT_EQ(explained.state, TubeState::noSurface);
        EXPECT_LT(*explained.unreadSurface, config.cells.size);
        EXPECT_EQ(explanationSentence(explained),
                  "Tube core " + std::to_string(number) +
                      " found no surface: no complete cell lies before the boundary found.");
    }
    EXPECT_GT(unread, 5);
}

TEST(ExplanationFacts, SayNoneForThePlaceOfNoChange) {
    const ExplainedRun run(configWithout({}, 40));
    const auto facts = explanationFacts(run.explained(40));
    EXPECT_EQ(factOf(facts, "change_without").value, "0");
    EXPECT_EQ(factOf(facts, "change_without_at").value, "none");
    const auto moving = explanationFacts(run.explained(heaviestFirst(run.otf).front()));
    EXPECT_NE(factOf(moving, "change_without_at").value, "none");
}

TEST(ExplanationPlots, NameHowManyOfTheFactorsTheyHold) {
    const TubeExplanation explained = publishedRun().explained(heaviestFirst(publishedRun().otf).front());
    const std::string all = std::to_string(publishedRun().otf.tubesWithWeight);
    EXPECT_EQ(factorsPlot(explained, allFactors(publishedRun().otf)).series.front().name,
              all + " tube cores with a weight");
    EXPECT_EQ(factorsPlot(explained, allFactors(publishedRun().otf, 3)).series.front().name,
              "the 3 heaviest of " + all + " tube cores with a weight");
}

TEST(ExplanationPlots, GiveCellsAndSurfaceTheSameColoursWithAndWithoutQuietVoxels) {
    std::vector<std::vector<std::size_t>> colours;
    for (const ExplainedRun* run : {&publishedRun(), &defaultRun()}) {
        const Plot plot = intensityProfilePlot(run->explained(heaviestFirst(run->otf).front()));
        const auto all = coloursOf(plot.series);
        colours.emplace_back();
        for (const char* name : {"means of cells", "surface"})
            colours.back().push_back(all[static_cast<std::size_t>(&seriesOf(plot, name) - plot.series.data())]);
        EXPECT_NE(colours.back()[0], colours.back()[1]);
    }
    EXPECT_EQ(colours[0], colours[1]);
}

TEST(ExplanationPlots, HoldTheValuesOfTheExplanation) {
    for (const ExplainedRun* run : {&publishedRun(), &defaultRun()}) {
        const int number = heaviestFirst(run->otf)[1];
        const TubeExplanation explained = run->explained(number);
        const double half = (explained.config.cells.size - 1) / 2.0;
        const Plot profile = intensityProfilePlot(explained);
        EXPECT_EQ(seriesOf(profile, "voxels on the axis").y, explained.axis.read);
        const PlotSeries& cells = seriesOf(profile, "means of cells");
        EXPECT_EQ(cells.x.front(), explained.cells.tube.first + half);
        EXPECT_EQ(cells.y.back(), explained.tube.cellMeans[static_cast<std::size_t>(explained.cells.tube.last)]);
        EXPECT_EQ(profile.marksX.front().value, explained.tube.surfaceCell + half);
        EXPECT_EQ(profile.bands.front().to, explained.cells.low.last + 2 * half + 0.5);

        const Plot curves = curvesPlot(explained);
        EXPECT_EQ(seriesOf(curves, "parabolic initial function").y, explained.initial);
        EXPECT_EQ(seriesOf(curves, "adaptive curve").y, run->otf.curve.opacities);
        EXPECT_EQ(seriesOf(curves, "without it").y, explained.without.curve.opacities);
        EXPECT_EQ(seriesOf(curves, "it alone").y, explained.alone.curve.opacities);

        const auto all = allFactors(run->otf);
        const Plot factors = factorsPlot(explained, all);
        EXPECT_EQ(factors.series.front().y.size(), all.size() * 257);
        EXPECT_EQ(seriesOf(factors, "tube core " + std::to_string(number)).y, all[1].values);

        const auto ranks = rankPlots(explained);
        for (const Plot& plot : ranks) {
            const PlotSeries& weights = plot.series[1];
            const PlotSeries& own = plot.series[2];
            const auto place = std::ranges::find(weights.x, own.x.front());
            ASSERT_NE(place, weights.x.end());
            EXPECT_NEAR(weights.y[static_cast<std::size_t>(place - weights.x.begin())], own.y.front(), 1e-12);
        }
        EXPECT_EQ(ranks[0].series[2].y.front(), explained.tube.intensityWeight);
        EXPECT_EQ(ranks[1].series[2].y.front(), explained.tube.slopeWeight);
    }
}

TEST(ExplanationPlots, OfTheInterfaceFunctionShowEveryScaleOrTheContrasts) {
    const int number = heaviestFirst(publishedRun().otf)[1];
    const TubeExplanation explained = publishedRun().explained(number);
    const Plot scales = interfaceFunctionPlot(explained);
    ASSERT_EQ(scales.series.size(), explained.scales.size() + 2);
    EXPECT_EQ(scales.series[0].name, "σ = 32");
    EXPECT_EQ(scales.series[5].name, "unsmoothed");
    EXPECT_EQ(scales.series[5].y, explained.scales[5].function);
    const PlotSeries& maxima = seriesOf(scales, "maximum found");
    EXPECT_EQ(maxima.x.back(), *explained.scales.back().cell + 2.0);

    const TubeExplanation byRatio = defaultRun().explained(heaviestFirst(defaultRun().otf).front());
    const Plot contrast = interfaceFunctionPlot(byRatio);
    EXPECT_EQ(contrast.series.front().y.front(),
              byRatio.tube.interfaceFunction[static_cast<std::size_t>(byRatio.contrastCells.first)]);
    EXPECT_NE(contrast.series.front().y.front(), 0.0) << "cells without a boundary are left out";
    EXPECT_NE(contrast.series.front().y.back(), 0.0);
    EXPECT_EQ(contrast.marksY.front().value, *byRatio.leastContrast);
}

}  // namespace
}  // namespace echolucent
