#include "processing/document/panes.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "processing/adaptive/method_reading.h"
#include "processing/document/preset.h"

namespace echolucent {
namespace {

Document compared() {
    const Document alone;
    return withPanes(alone, standardPanes());
}

TEST(Panes, TheStandardOnesAreFourWithAnOtfEach) {
    const Document document = compared();
    EXPECT_EQ(problemOf(document), "");
    EXPECT_TRUE(isCompared(document));
    const Document alone;
    EXPECT_FALSE(isCompared(alone));
    EXPECT_EQ(document.panes, standardPanes());
    EXPECT_EQ(document.panes.at(firstPane), Pane{});
    ASSERT_NE(designerConfigOf(document, 3), nullptr);
    EXPECT_EQ(*designerConfigOf(document, 3), DesignerConfig(LevoyConfig{}));
}

TEST(Panes, AreAddedAndRemoved) {
    Document document = compared();
    const Pane choice{.designer = OtsuConfig{}, .phase = 3};
    document = withPane(document, 3, choice);
    EXPECT_EQ(problemOf(document), "");
    EXPECT_EQ(document.panes[3], choice);
    EXPECT_EQ(phaseOf(document, firstPane), 0);
    EXPECT_EQ(phaseOf(document, 3), 3);
    document.comparison.first = 3;
    document = withPaneCount(document, 2);
    EXPECT_EQ(problemOf(document), "");
    const std::vector<Pane> standard = standardPanes();
    EXPECT_EQ(document.panes, std::vector<Pane>(standard.begin(), standard.begin() + 2));
    EXPECT_NE(document.comparison.first, document.comparison.second);
    document = withPaneCount(document, 4);
    EXPECT_EQ(document.panes[2], standardPanes()[2]);
    EXPECT_EQ(document.panes[3], standardPanes()[3]);
    EXPECT_EQ(withPaneCount(document, 1).panes.size(), 1U);
    const Document chosen = withDesigner({}, firstPane, OtsuConfig{.opacity = 0.5});
    EXPECT_EQ(withPaneCount(chosen, 2).panes[0].designer, DesignerConfig(OtsuConfig{.opacity = 0.5}))
        << "who begins to compare keeps what the first pane shows";
    EXPECT_THROW((void)withPanes(document, {}), std::invalid_argument);
    EXPECT_THROW((void)withPanes(document, std::vector<Pane>(5)), std::invalid_argument);
}

TEST(Panes, TheFirstShowsThePhaseOfTheSceneAndTheOtfOfTheMotion) {
    const Document document =
        withPane(compared(), firstPane, {.curve = CurveKind::linear, .phase = 2, .motionOtf = MotionOtf::eachView});
    EXPECT_EQ(document.panes[0], (Pane{.curve = CurveKind::linear}));
}

TEST(Panes, OnePaneReadsAsPublished) {
    const Document before = compared();
    Document document =
        withPane(before, 1, {.withoutTubes = {7, 999'999}, .method = configOf(MethodReading::asPublished)});
    document.method.config.grid.withoutTubes = {3};
    document.method.initial = InitialKind::linear;
    EXPECT_EQ(problemOf(document), "");
    EXPECT_EQ(configOf(document, 0), configOf(document)) << "the others keep the document's";
    AdaptiveOtfConfig expected = configOf(MethodReading::asPublished);
    expected.grid.withoutTubes = {3, 7};
    expected.initial = document.curves.linear;
    EXPECT_EQ(configOf(document, 1), expected);
    EXPECT_EQ(withPane(before, firstPane, {.method = AdaptiveOtfConfig{}}).panes[0], Pane{})
        << "the first pane has the document's";
}

TEST(Panes, APaneKeepsALinearCurveOfItsOwn) {
    const LinearCurve own{0, 1, 1}, other{0.2, 0.4, 0.8};
    Document document = withPane(compared(), 0, {.curve = CurveKind::linear, .linear = own});
    document = withPane(document, 1, {.curve = CurveKind::linear});
    EXPECT_EQ(opacityAt(curveOf(document, 0, {}), 0.5), 0.5);
    EXPECT_EQ(curveOf(document, 1, {}), OpacityCurve(LinearCurve{}));
    CurveSet edited = curvesOf(document, 0);
    EXPECT_EQ(edited.linear, own);
    edited.linear = other;
    edited.quartic.scale = 3;
    const Document changed = withCurves(document, 0, edited);
    EXPECT_EQ(curvesOf(changed, 0), edited);
    EXPECT_EQ(changed.curves.linear, LinearCurve{}) << "the document keeps its own";
    EXPECT_EQ(changed.curves.quartic.scale, 3);
    EXPECT_EQ(withCurves(document, 1, edited).curves.linear, other);
    EXPECT_EQ(withCurve(document, 0, CurveKind::linear).panes[0], document.panes[0]);
    Document figure6 = withPane(compared(), 0, {.curve = CurveKind::adaptive, .linear = own});
    EXPECT_EQ(withCurve(figure6, 0, CurveKind::linear).panes[0].linear, own) << "the curve that was drawn beside it";
    EXPECT_FALSE(withCurve(figure6, 0, CurveKind::quartic).panes[0].linear);
    EXPECT_EQ(withCurve(document, 0, CurveKind::manual).panes[0], (Pane{.curve = CurveKind::manual}));
    EXPECT_FALSE(openedDocument(document, SimulatedScan{}).panes[0].linear) << "the next scan has the person's";
    const Preset preset = presetOf(document, 0, "own");
    EXPECT_EQ(preset.curves.linear, own);
    EXPECT_TRUE(isMadeBy(document, 0, preset));
    EXPECT_TRUE(isMadeBy(withPreset(compared(), 0, preset), 0, preset));
}

TEST(Panes, OnePaneLeavesATubeCoreOut) {
    Document document = withPane(compared(), 2, {.designer = AdaptiveConfig{}, .withoutTubes = {112}});
    EXPECT_EQ(configOf(document, 2).grid.withoutTubes, std::vector{112});
    EXPECT_TRUE(configOf(document, firstPane).grid.withoutTubes.empty());
    document = withPane(document, 2, {.curve = CurveKind::adaptive});
    EXPECT_TRUE(configOf(document, 2).grid.withoutTubes.empty());
}

TEST(Panes, ThePhaseOfAPaneIsAChoiceAndThatOfTheSceneIsShown) {
    const Document before = compared();
    const Document own = withPane(before, 1, {.curve = CurveKind::linear, .phase = 2});
    EXPECT_EQ(withShown(own, before), own);
    EXPECT_NE(withShown(withPane(own, 1, {.curve = CurveKind::linear, .phase = 4}), own), own);
    EXPECT_EQ(withShown(before, own), before);
}

TEST(Panes, AnotherStudyKeepsThemFromItsFirstPhaseOn) {
    const Document before = withPane(compared(), 1, {.withoutTubes = {3}, .phase = 2});
    const Document opened = openedDocument(before, SimulatedScan{});
    EXPECT_EQ(opened.panes, withPane(compared(), 1, {.phase = 0}).panes);
    EXPECT_EQ(opened.comparison, before.comparison);
    EXPECT_EQ(problemOf(opened), "");
}

TEST(Panes, WhatADocumentMayNotHoldIsNamed) {
    const auto problemAfter = [](const auto& change) {
        Document document = compared();
        change(document);
        return problemOf(document);
    };
    EXPECT_EQ(problemAfter([](Document& d) { d.panes.clear(); }), "panes must hold 1 to 4 panes");
    EXPECT_EQ(problemAfter([](Document& d) { d.panes.resize(5); }), "panes must hold 1 to 4 panes");
    EXPECT_EQ(problemAfter([](Document& d) { d.panes[0].phase = 1; }),
              "panes[0].phase must be missing: it is that of the scene");
    EXPECT_EQ(problemAfter([](Document& d) { d.panes[2].withoutTubes = {-1}; }),
              "panes[2].without_tubes must hold numbers from 0 on");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.second = 0; }), "comparison.first and second must differ");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.first = 4; }), "comparison.first must be one of the panes");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.wipe = 1.1; }), "comparison.wipe must be from 0 to 1");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.amplification = 0; }),
              "comparison.amplification must be from 1 to 32");
}

}  // namespace
}  // namespace echolucent
