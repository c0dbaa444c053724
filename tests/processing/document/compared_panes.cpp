#include "processing/document/compared_panes.h"

#include <gtest/gtest.h>

#include "processing/document/view_caster.h"
#include "processing/phantom/phantom.h"

namespace echolucent {
namespace {

Document compared() { return comparing(Document{}, standardPanes()); }

TEST(ComparedPanes, TheStandardOnesAreFourViewsThatShareAllButTheirOtf) {
    const Document document = compared();
    EXPECT_EQ(problemOf(document), "");
    EXPECT_EQ(document.comparison.panes, (std::vector{1, 2, 3, 4}));
    EXPECT_EQ(viewOf(document, 1).curve, CurveKind::adaptive);
    ASSERT_NE(designOf(document, 4), nullptr);
    EXPECT_EQ(designerOf(*designOf(document, 4)), Designer::levoy);
    for (std::size_t place = 0; place < 4; ++place)
        EXPECT_EQ(paneChoiceOf(document, place), standardPanes()[place]) << place;
    for (const int view : document.comparison.panes) {
        EXPECT_EQ(viewOf(document, view).pose, 1);
        EXPECT_EQ(viewOf(document, view).phase, 1);
    }
}

TEST(ComparedPanes, TheirCamerasAreEqualToTheBit) {
    Document document = compared();
    poseOf(document, 1) = {{12.3, 4.56, 7.8}, {1.0 / 3, 0.1, -2.0}, 1.7};
    document.motionAngle = 11.0;
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {24, 22, 23};
    const Volume volume = *makePhantom(config);
    const RayCastSettings first = castSettingsOf(document, 1, volume.geometry(), volume.dataBox(), 301, 207);
    for (const int view : document.comparison.panes)
        EXPECT_EQ(castSettingsOf(document, view, volume.geometry(), volume.dataBox(), 301, 207), first);
}

TEST(ComparedPanes, AreAddedAndRemovedWithTheirDesignsAndPhases) {
    Document document = compared();
    PaneChoice choice{.design = defaultConfigOf(Designer::otsu), .phase = 3};
    document = withPane(document, 3, choice);
    EXPECT_EQ(problemOf(document), "");
    EXPECT_EQ(paneChoiceOf(document, 3), choice);
    EXPECT_EQ(phaseOf(document, 1), 0);
    EXPECT_EQ(document.phases.size(), 2U);
    EXPECT_EQ(document.designs.size(), 1U);
    document.comparison.first = 3;
    document = withPaneCount(document, 2);
    EXPECT_EQ(problemOf(document), "");
    EXPECT_EQ(document.comparison.panes, (std::vector{1, 2}));
    EXPECT_EQ(document.views.size(), 2U);
    EXPECT_TRUE(document.designs.empty());
    EXPECT_EQ(document.phases.size(), 1U);
    EXPECT_NE(document.comparison.first, document.comparison.second);
    document = withPaneCount(document, 4);
    EXPECT_EQ(paneChoiceOf(document, 2), standardPanes()[2]);
    EXPECT_EQ(paneChoiceOf(document, 3), standardPanes()[3]);
    Document chosen;
    chosen = withDesign(std::move(chosen), 1, OtsuConfig{.opacity = 0.5});
    EXPECT_EQ(paneChoiceOf(withPaneCount(chosen, 2), 0).design, DesignerConfig(OtsuConfig{.opacity = 0.5}))
        << "who begins to compare keeps what view 1 shows";
    EXPECT_THROW((void)comparing(document, {PaneChoice{}}), std::invalid_argument);
}

TEST(ComparedPanes, OnePaneLeavesATubeCoreOut) {
    Document document = withPane(compared(), 2, {.design = AdaptiveConfig{}, .withoutTubes = {112}});
    EXPECT_EQ(configOf(document, 3).grid.withoutTubes, std::vector{112});
    EXPECT_TRUE(configOf(document, 1).grid.withoutTubes.empty());
    document = withPane(document, 2, {.curve = CurveKind::adaptive});
    EXPECT_TRUE(configOf(document, 3).grid.withoutTubes.empty());
}

TEST(ComparedPanes, ShowingAnotherPhaseKeepsThoseThatOnlyOneDocumentHas) {
    const Document before = compared();
    const Document own = withPane(before, 1, {.curve = CurveKind::linear, .phase = 2});
    EXPECT_EQ(withShown(own, before), own);
    EXPECT_NE(withShown(withPane(own, 1, {.curve = CurveKind::linear, .phase = 4}), own), own)
        << "the phase of a pane is a choice";
    EXPECT_EQ(withShown(before, own), before);
    EXPECT_EQ(problemOf(withShown(own, before)), "");
}

TEST(ComparedPanes, AnotherStudyKeepsThem) {
    const Document opened = openedDocument(compared(), SimulatedScan{});
    EXPECT_EQ(opened.comparison, compared().comparison);
    EXPECT_EQ(problemOf(opened), "");
}

TEST(ComparedPanes, WhatADocumentMayNotHoldIsNamed) {
    const auto problemAfter = [](const auto& change) {
        Document document = compared();
        change(document);
        return problemOf(document);
    };
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.panes = {1}; }),
              "comparison.panes must hold 2 to 4 views, or none");
    EXPECT_EQ(problemAfter([](Document& d) {
                  d.comparison.panes = {1, 1};
              }),
              "comparison.panes must hold each view once");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.panes = {1, 9}; }), "comparison.panes names no view");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.second = 0; }), "comparison.first and second must differ");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.first = 4; }), "comparison.first must be one of the panes");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.wipe = 1.1; }), "comparison.wipe must be from 0 to 1");
    EXPECT_EQ(problemAfter([](Document& d) { d.comparison.amplification = 0; }),
              "comparison.amplification must be from 1 to 32");
    EXPECT_EQ(problemAfter([](Document& d) {
                  d.poses.push_back({2, {}});
                  d.views[1].pose = 2;
              }),
              "comparison.panes must name views that share pose, cut, look, box, planes and strokes");
}

}  // namespace
}  // namespace echolucent
