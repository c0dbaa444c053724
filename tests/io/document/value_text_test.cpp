// Values that settings remember: what is written comes back, and what makes no sense is passed over.
#include "io/document/value_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "processing/adaptive/method_reading.h"

namespace echolucent {
namespace {

TEST(ValueText, EveryDigitComesBackInOneLine) {
    Look look = lookAtStart();
    look.mode = RenderMode::mean;
    look.light = {71.123456789, -12.5};
    look.step = 0.1 + 0.2;
    MethodChoice method;
    method.initial = InitialKind::quartic;
    method.initialScale = 1.0 / 3.0;
    method.config.detection = VarianceRule{.significance = 0.123456789};
    method.config.curve = ProductRule{2.0 / 3.0};
    const MotionChoice motion{.axis = MotionAxis::x, .pingPong = false, .phaseRange = PhaseRange{2, 5}, .speed = 0.7};
    for (const std::string& text : {textOf(look), textOf(method), textOf(motion)})
        EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_EQ(lookFromText(textOf(look)), look);
    EXPECT_EQ(methodFromText(textOf(method)), method);
    EXPECT_EQ(motionFromText(textOf(motion)), motion);
}

TEST(ValueText, RowsThatAreMissingHaveTheirDefaults) {
    Look grey = lookAtStart();
    grey.colourMap = ColourMap::grey;
    EXPECT_EQ(lookFromText(R"({"colour_map": "grey", "of_another_version": 1})"), grey);
}

TEST(ValueText, WhatMakesNoSenseGivesTheDefault) {
    for (const char* text : {"", "{", "[]", "7", "null", "{}", R"({"colour_map": "mauve"})", R"({"brightness": 5})"}) {
        EXPECT_EQ(lookFromText(text), lookAtStart()) << text;
        EXPECT_EQ(methodFromText(text), MethodChoice{}) << text;
        EXPECT_EQ(motionFromText(text), MotionChoice{}) << text;
    }
    for (const char* text : {R"({"parameters": 7})", R"({"initial": 2, "initial_scale": -1})",
                             R"({"parameters": {"significance": 0.3, "cell_size": "5", "aim": 2}})"})
        EXPECT_EQ(methodFromText(text), MethodChoice{}) << text;
    // Parameters from before the aim mean the curve of that version.
    EXPECT_EQ(methodFromText(R"({"parameters": {"significance": 0.3, "cell_size": "5"}})").config,
              configOf(MethodReading::firstVersion));
}

TEST(ValueText, ARowThatMakesNoSenseLeavesItsNeighboursAlone) {
    Look grey = lookAtStart();
    grey.colourMap = ColourMap::grey;
    for (const char* wrong : {R"("brightness": 5)", R"("brightness": "2")", R"("mode": "mauve")", R"("shadow": null)"})
        EXPECT_EQ(lookFromText(std::string(R"({"colour_map": "grey", )") + wrong + "}"), grey) << wrong;

    MethodChoice method;
    method.initial = InitialKind::linear;
    method.config.grid.columns = 11;
    method.config.detection = VarianceRule{.coarsestScale = 6};
    const char* choice =
        R"({"initial": "linear", "initial_scale": -1, "parameters": {"cell_size": 99, "tube_columns": 11,
        "interface_function": "variance", "coarsest_scale": 6, "false_alarm": 3, "form": "cubic", "aim": 0.5}})";
    EXPECT_EQ(methodFromText(choice), method);

    std::string motion = textOf(MotionChoice{.axis = MotionAxis::x, .pingPong = false, .speed = 2.0});
    motion.replace(motion.find("2.0"), 3, "1e9");
    EXPECT_EQ(motionFromText(motion), (MotionChoice{.axis = MotionAxis::x, .pingPong = false}));
}

TEST(ValueText, OfRowsThatCannotBeTogetherTheConfigIsTheDefault) {
    MethodChoice method;
    method.initial = InitialKind::quartic;
    EXPECT_EQ(methodFromText(R"({"initial": "quartic", "parameters": {"interface_function": "variance",
        "coarsest_scale": 3, "finest_scale": 5, "tube_columns": 11, "aim": 0.5}})"),
              method);
}

}  // namespace
}  // namespace echolucent
