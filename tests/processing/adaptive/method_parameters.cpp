// The table of the method's parameters: every member of the config stands in it, and its ranges are what is checked.
#include "processing/adaptive/method_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "processing/adaptive/method_reading.h"

namespace echolucent {
namespace {

using Row = Parameter<AdaptiveOtfConfig>;

/// A config in which the row means something, and in which its neighbours leave it its whole range.
AdaptiveOtfConfig configFor(const Row& row) {
    AdaptiveOtfConfig config;
    const bool chosen =
        row.scope.parameter.empty() ||
        parameterNamed(methodParameters(), row.scope.parameter)->set(config, std::string(row.scope.choice));
    EXPECT_TRUE(chosen);
    config.grid.columns = config.grid.rows = 1;
    if (auto* variance = std::get_if<VarianceRule>(&config.detection)) {
        if (row.name == "coarsest_scale") variance->finestScale = 0;
        if (row.name == "finest_scale") variance->coarsestScale = 10;
    }
    if (auto* ratio = std::get_if<RatioRule>(&config.detection)) {
        if (row.name == "contrast_floor") ratio->contrastCeiling = 1e6;
        if (row.name == "contrast_ceiling") ratio->contrastFloor = 0;
    }
    if (auto* ramp = std::get_if<RampRule>(&config.curve)) {
        if (row.name == "ramp_begin") ramp->end = 20;
        if (row.name == "ramp_end") ramp->begin = -10;
    }
    return config;
}

ParameterValue valueLike(const ParameterValue& known, double number) {
    if (std::holds_alternative<std::int64_t>(known)) return std::int64_t(std::llround(number));
    return number;
}

TEST(MethodParameters, EveryMemberOfEveryRuleHasARow) {
    // A new member does not compile here until it stands in these names, and then needs a row to be counted below.
    [[maybe_unused]] const auto& [grid, cells, detection, surface, weights, curve, initial] = AdaptiveOtfConfig{};
    // The tube cores that are never placed are a list, which no row holds.
    [[maybe_unused]] const auto& [columns, rows, spacing, withoutTubes] = grid;
    [[maybe_unused]] const auto& [size, sampling, precision] = cells;
    [[maybe_unused]] const auto& [coarsest, finest, sigma, kernelCut, kernelEnd, border, smoothing, significance,
                                  floorQuantile, trackingRange, coarsestMaximum, edgeToNoise] = VarianceRule{};
    [[maybe_unused]] const auto& [falseAlarm, contrastFloor, contrastCeiling, before, behind, rampSlabs, leastFluid,
                                  leastDark, leastStep, certainty, certainShare, leastRatio] = RatioRule{};
    [[maybe_unused]] const auto& [lowReach, highReach, slopeHalfStep, priorCells] = surface;
    [[maybe_unused]] const auto& [rankBins] = weights;
    [[maybe_unused]] const auto& [strength] = ProductRule{};
    [[maybe_unused]] const auto& [begin, clearSpreads, end, opacity, aim, trustedShare] = RampRule{};
    constexpr std::size_t members = 3 + 3 + 12 + 12 + 4 + 1 + 1 + 6;
    constexpr std::size_t choicesOfRules = 2;        // detection and curve
    constexpr std::size_t ofTheInitialFunction = 1;  // its scale
    EXPECT_EQ(methodParameters().size(), members + choicesOfRules + ofTheInitialFunction);
}

TEST(MethodParameters, BothEndsOfEveryRangeAreAllowedAndWhatLiesOutsideIsNamed) {
    for (const Row& row : methodParameters()) {
        if (!row.choices.empty()) continue;
        SCOPED_TRACE(row.name);
        AdaptiveOtfConfig config = configFor(row);
        const ParameterValue before = row.get(config).value();
        const bool whole = std::holds_alternative<std::int64_t>(before);
        for (const double end : {row.range.least, row.range.largest}) {
            ASSERT_TRUE(row.set(config, valueLike(before, end)));
            EXPECT_EQ(numberOf(*row.get(config)), end);
            EXPECT_EQ(problemOf(config), "");
        }
        std::string name(row.label.substr(1));
        for (const double outside : {whole ? row.range.least - 1 : std::nextafter(row.range.least, -1e300),
                                     whole ? row.range.largest + 1 : std::nextafter(row.range.largest, 1e300)}) {
            ASSERT_TRUE(row.set(config, valueLike(before, outside)));
            EXPECT_NE(problemOf(config).find(name), std::string::npos) << problemOf(config);
        }
        if (whole) continue;
        ASSERT_TRUE(row.set(config, std::nan("")));
        EXPECT_NE(problemOf(config), "");
    }
}

TEST(MethodParameters, AFloorAboveTheCeilingIsNamed) {
    AdaptiveOtfConfig config;
    std::get<RatioRule>(config.detection).contrastFloor = 5;
    EXPECT_EQ(problemOf(config), "the contrast floor must not be above the contrast ceiling");
}

TEST(MethodParameters, NamesTubeCoresThatTheGridDoesNotHaveOrThatStandTwice) {
    AdaptiveOtfConfig config;
    config.grid.columns = 4;
    config.grid.rows = 3;
    for (const auto& [left, problem] :
         {std::pair(std::vector{0, 5, 11}, ""), std::pair(std::vector{12}, "must be 0 to 11, not 12"),
          std::pair(std::vector{-1, 3}, "must be 0 to 11, not -1"), std::pair(std::vector{3, 3}, "once"),
          std::pair(std::vector{7, 3}, "must ascend")}) {
        config.grid.withoutTubes = left;
        if (std::string_view(problem).empty())
            EXPECT_EQ(problemOf(config), "");
        else
            EXPECT_NE(problemOf(config).find(problem), std::string::npos) << problemOf(config);
    }
}

TEST(MethodParameters, AnotherNumberOfTubeCoresLeavesNoneOut) {
    for (const std::string_view name : {"tube_columns", "tube_rows"}) {
        const Row& row = *parameterNamed(methodParameters(), name);
        AdaptiveOtfConfig config;
        config.grid.withoutTubes = {3, 200};
        ASSERT_TRUE(row.set(config, std::int64_t{15}));
        EXPECT_EQ(config.grid.withoutTubes, (std::vector{3, 200})) << "the same number means the same tube cores";
        EXPECT_FALSE(row.set(config, std::string("15")));
        EXPECT_EQ(config.grid.withoutTubes.size(), 2u);
        ASSERT_TRUE(row.set(config, std::int64_t{16}));
        EXPECT_TRUE(config.grid.withoutTubes.empty());
    }
}

TEST(MethodParameters, EveryChoiceCanBeMadeAndNoOther) {
    for (const Row& row : methodParameters()) {
        if (row.choices.empty()) continue;
        SCOPED_TRACE(row.name);
        AdaptiveOtfConfig config = configFor(row);
        for (const ParameterChoice& choice : row.choices) {
            ASSERT_TRUE(row.set(config, std::string(choice.name)));
            EXPECT_EQ(row.get(config), ParameterValue(std::string(choice.name)));
            EXPECT_EQ(problemOf(config), "");
        }
        const AdaptiveOtfConfig made = config;
        EXPECT_FALSE(row.set(config, std::string("nonsense")));
        EXPECT_FALSE(row.set(config, 1.0));
        EXPECT_EQ(config, made);
    }
}

TEST(MethodParameters, WhatDoesNotApplyCanNeitherBeReadNorSet) {
    for (const Row& row : methodParameters()) {
        if (row.scope.parameter.empty()) continue;
        SCOPED_TRACE(row.name);
        const Row& choice = *parameterNamed(methodParameters(), row.scope.parameter);
        for (const auto& [other, label] : choice.choices) {
            AdaptiveOtfConfig config;
            ASSERT_TRUE(choice.set(config, std::string(other)));
            EXPECT_EQ(row.get(config).has_value(), other == row.scope.choice);
            const AdaptiveOtfConfig before = config;
            EXPECT_EQ(row.set(config, defaultOf(methodParameters(), row)), other == row.scope.choice);
            EXPECT_EQ(config, before);
        }
    }
}

TEST(MethodParameters, TellEveryReadingFromTheDefault) {
    // A config is what its rows say: where it is copied row by row, nothing is lost but what belongs to no row.
    for (const MethodReading reading : {MethodReading::asPublished, MethodReading::settled, MethodReading::standard}) {
        const AdaptiveOtfConfig known = configOf(reading);
        AdaptiveOtfConfig copy;
        for (const Row& row : methodParameters()) {
            const auto value = row.get(known);
            EXPECT_TRUE(!value || row.set(copy, *value)) << row.name;
        }
        EXPECT_EQ(copy, known);
    }
}

TEST(MethodParameters, HaveNamesOfTheirOwnAndSaySomething) {
    std::set<std::string_view> names;
    for (const Row& row : methodParameters()) {
        SCOPED_TRACE(row.name);
        EXPECT_TRUE(names.insert(row.name).second);
        EXPECT_FALSE(row.label.empty());
        EXPECT_FALSE(row.source.empty());
        EXPECT_FALSE(row.meaning.empty() || row.meaning.ends_with("."));
        EXPECT_EQ(problemOf(configFor(row)), "");
        const ParameterRange offered = row.offeredRange();
        EXPECT_GE(offered.least, row.range.least);
        EXPECT_LE(offered.largest, row.range.largest);
    }
    EXPECT_EQ(optionOf("slope_half_step"), "--slope-half-step");
}

}  // namespace
}  // namespace echolucent
