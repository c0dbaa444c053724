// Panes of a document that are rendered with an OTF designer.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "processing/designers/choice/designer.h"
#include "processing/document/document.h"
#include "processing/document/preset.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/pane_picture/pane_picture.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/converged.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent {
namespace {

std::shared_ptr<const Volume> smallFetus() {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    config.size = {48, 48, 48};
    return std::make_shared<const Volume>(*makePhantom(config));
}

TEST(Designs, APaneHasTheDesignerThatItWasGivenLast) {
    Document document;
    EXPECT_EQ(designerConfigOf(document, firstPane), nullptr);
    document = withDesigner(document, firstPane, OtsuConfig{});
    ASSERT_NE(designerConfigOf(document, firstPane), nullptr);
    EXPECT_EQ(*designerConfigOf(document, firstPane), DesignerConfig(OtsuConfig{}));
    document = withDesigner(document, firstPane, EchoRampConfig{.threshold = 0.3});
    EXPECT_EQ(*designerConfigOf(document, firstPane), DesignerConfig(EchoRampConfig{.threshold = 0.3}));
    EXPECT_EQ(problemOf(document), "");
    document = withCurve(document, firstPane, CurveKind::linear);
    EXPECT_EQ(designerConfigOf(document, firstPane), nullptr);
    EXPECT_EQ(document.panes.at(firstPane).curve, CurveKind::linear);
}

TEST(Designs, WhatIsWrongIsNamed) {
    Document document = withDesigner({}, firstPane, EchoRampConfig{.threshold = 2.0});
    EXPECT_NE(problemOf(document).find("panes[0].designer: the threshold must be 0 to 1"), std::string::npos)
        << problemOf(document);
    KindlmannConfig drawn;
    drawn.drawn = {{1.0, 0.5}};
    EXPECT_NE(problemOf(withDesigner({}, firstPane, drawn)).find("2 to 64 nodes"), std::string::npos);
}

TEST(Designs, TubeCoresOfAViewAreLeftOutBesideThoseOfTheMethod) {
    Document document;
    document.method.config.grid.withoutTubes = {3, 9};
    document.panes.at(firstPane).withoutTubes = {224, 3, 225, 1};
    EXPECT_EQ(configOf(document, firstPane).grid.withoutTubes, (std::vector<int>{1, 3, 9, 224}));
    EXPECT_EQ(configOf(document).grid.withoutTubes, (std::vector<int>{3, 9}));
    EXPECT_TRUE(openedDocument(document, {}).panes.at(firstPane).withoutTubes.empty());
}

TEST(Designs, APresetOfACurveTakesTheDesignsPlace) {
    const Document document = withDesigner({}, firstPane, OtsuConfig{});
    const Preset preset{.name = "manual", .curve = CurveKind::manual, .look = document.scene.look};
    EXPECT_FALSE(isMadeBy(document, firstPane, preset));
    const Document next = withPreset(document, firstPane, preset);
    EXPECT_EQ(designerConfigOf(next, firstPane), nullptr);
    EXPECT_TRUE(isMadeBy(next, firstPane, preset));
}

TEST(Designs, TheViewsPictureIsThatOfItsDesign) {
    const auto scan = smallFetus();
    const std::vector<std::shared_ptr<const Volume>> scans{scan};
    for (const DesignerConfig& config : {DesignerConfig(LevoyConfig{}), DesignerConfig(OtsuConfig{})}) {
        Document document = withDesigner({}, firstPane, config);
        document.curves.adjustment.transparency = 0.5;
        const auto shown = panePicture(document, firstPane, scans, 40, 32);
        const Volume quiet = *quietVolume(*scan, document.scene.look.reduction);
        const Design made =
            *design(config, designerInputOf(document, firstPane, *scan, quiet, document.scene.look.reduction));
        const Classification expected = adjustedClassification(made.classification, document.curves.adjustment);
        EXPECT_EQ(shown->classification, expected);
        EXPECT_EQ(shown->picture.rgba, castRays(quiet, expected, shown->cast)->rgba);
        EXPECT_GT(*std::ranges::max_element(shown->picture.rgba), 0.1f);
    }
}

TEST(Designs, AMaximumAsksNoDesigner) {
    Document document = withDesigner({}, firstPane, LevoyConfig{});
    EXPECT_TRUE(needsComputedOtf(document, firstPane));
    document.scene.look.mode = RenderMode::maximum;
    EXPECT_FALSE(needsComputedOtf(document, firstPane));
}

}  // namespace
}  // namespace echolucent
