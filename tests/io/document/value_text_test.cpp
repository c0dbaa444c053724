// Values that settings remember: what is written comes back, and what makes no sense is none.
#include "io/document/value_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(ValueText, WhatMakesNoSenseIsNone) {
    for (const char* text : {"", "{", "[]", "7", R"({"colour_map": "mauve"})", R"({"brightness": 5})"})
        EXPECT_FALSE(lookFromText(text)) << text;
    for (const char* text : {"{}", R"({"initial": "cubic", "initial_scale": 1, "parameters": {}})",
                             R"({"initial": "linear", "initial_scale": 1, "parameters": {"cell_size": 99}})"})
        EXPECT_FALSE(methodFromText(text)) << text;
    std::string fast = textOf(MotionChoice{.speed = 2.0});
    fast.replace(fast.find("2.0"), 3, "1e9");
    EXPECT_FALSE(motionFromText(fast));
    EXPECT_FALSE(motionFromText("{}"));
}

}  // namespace
}  // namespace echolucent
