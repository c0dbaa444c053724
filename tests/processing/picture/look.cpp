// The table of the look: every member of Look has a row, and a row says what it holds.
#include "processing/picture/look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace echolucent {
namespace {

TEST(Look, EveryRowReadsWhatItWrote) {
    std::set<std::string_view> names;
    Look changed;
    for (const Parameter<Look>& row : lookParameters()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        const ParameterValue standard = *row.get(Look{});
        ParameterValue other = standard;
        if (const auto* flag = std::get_if<bool>(&standard)) other = !*flag;
        if (std::holds_alternative<std::string>(standard)) {
            EXPECT_EQ(standard, ParameterValue(std::string(row.choices.front().name))) << row.name;
            other = std::string(row.choices.back().name);
        }
        if (const auto number = numberOf(standard)) {
            EXPECT_TRUE(inRange(*number, row.range)) << row.name;
            other = row.range.largest;
        }
        ASSERT_NE(other, standard) << row.name;
        ASSERT_TRUE(row.set(changed, other)) << row.name;
        EXPECT_EQ(*row.get(changed), other) << row.name;
    }
    EXPECT_TRUE(problemIn(lookParameters(), changed).empty());
    // No member is without a row: a new one does not compile here until it stands in these names and in a line below.
    [[maybe_unused]] const auto& [mode, mixing, mixedMode, reduction, lighting, light, softness, reaching,
                                  depthColoured, map, brightness, projection, interpolation, step] = changed;
    [[maybe_unused]] const auto& [azimuth, elevation] = light;
    [[maybe_unused]] const auto& [shadow, occlusion, translucency] = reaching;
    EXPECT_NE(changed.mode, Look{}.mode);
    EXPECT_NE(changed.mixing, Look{}.mixing);
    EXPECT_NE(changed.mixedMode, Look{}.mixedMode);
    EXPECT_NE(changed.brightness, Look{}.brightness);
    EXPECT_NE(changed.reduction, Look{}.reduction);
    EXPECT_NE(changed.lighting, Look{}.lighting);
    EXPECT_NE(changed.light.azimuthDegrees, Look{}.light.azimuthDegrees);
    EXPECT_NE(changed.light.elevationDegrees, Look{}.light.elevationDegrees);
    EXPECT_NE(changed.lightSoftness, Look{}.lightSoftness);
    EXPECT_NE(changed.reaching.shadow, Look{}.reaching.shadow);
    EXPECT_NE(changed.reaching.occlusion, Look{}.reaching.occlusion);
    EXPECT_NE(changed.reaching.translucency, Look{}.reaching.translucency);
    EXPECT_NE(changed.depthColoured, Look{}.depthColoured);
    EXPECT_NE(changed.colourMap, Look{}.colourMap);
    EXPECT_NE(changed.projection, Look{}.projection);
    EXPECT_NE(changed.interpolation, Look{}.interpolation);
    EXPECT_NE(changed.step, Look{}.step);
}

TEST(Look, WhatIsNotUnderstoodChangesNothing) {
    Look look;
    for (const Parameter<Look>& row : lookParameters()) {
        const bool isNumber = numberOf(*row.get(look)).has_value();
        EXPECT_FALSE(row.set(look, isNumber ? ParameterValue(std::string("mauve")) : ParameterValue(0.5))) << row.name;
        if (!row.choices.empty()) {
            EXPECT_FALSE(row.set(look, std::string("mauve"))) << row.name;
        }
    }
    EXPECT_EQ(look, Look{});
}

TEST(Look, OutOfRangeIsSaid) {
    Look look;
    look.step = 101;
    EXPECT_EQ(problemIn(lookParameters(), look), "the step must be 0.001 to 100");
    look.step = 1;
    look.light.elevationDegrees = std::nan("");
    EXPECT_EQ(problemIn(lookParameters(), look), "the elevation of the light must be -90 to 90");
}

TEST(Look, SettingsHoldWhatPlaysAPart) {
    Look look;
    look.lighting = Lighting::surface;
    look.depthColoured = true;
    look.projection = Projection::perspective;
    look.light = {60, 20};
    const RayCastSettings direct = rayCastSettings(look);
    ASSERT_TRUE(direct.shading && direct.depthColouring);
    EXPECT_EQ(direct.shading->towardsLight, towardsLight(look.light));
    EXPECT_EQ(direct.camera.projection, Projection::perspective);
    look.mode = RenderMode::maximum;
    EXPECT_FALSE(rayCastSettings(look).shading || rayCastSettings(look).depthColouring);
    EXPECT_FALSE(playsAPart(*parameterNamed(lookParameters(), "lighting"), look));
    EXPECT_TRUE(playsAPart(*parameterNamed(lookParameters(), "colour_map"), look));
}

TEST(Look, TheUsualLightIsUpperLeftInFrontOfTheViewer) {
    EXPECT_LT(length(towardsLight(Look{}.light) - normalized(Vec3(-0.45, -0.55, -0.7))), 1e-15);
    EXPECT_EQ(lookAtStart().light, (LightDirection{-33, 33}));
}

TEST(Look, CamelCaseOfNames) {
    EXPECT_EQ(camelCase("colour_map"), "colourMap");
    EXPECT_EQ(camelCase("mode"), "mode");
}

}  // namespace
}  // namespace echolucent
