// Views of a document that are rendered with an OTF designer.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "processing/designers/designer.h"
#include "processing/document/document.h"
#include "processing/document/preset.h"
#include "processing/document/view_caster.h"
#include "processing/document/view_picture.h"
#include "processing/phantom/phantom.h"
#include "processing/picture/converged.h"
#include "processing/ray_caster.h"

namespace echolucent {
namespace {

std::shared_ptr<const Volume> smallFetus() {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    config.size = {48, 48, 48};
    return std::make_shared<const Volume>(*makePhantom(config));
}

TEST(Designs, AViewHasTheDesignThatItWasGivenLast) {
    Document document;
    EXPECT_EQ(designOf(document, 1), nullptr);
    document = withDesign(document, 1, OtsuConfig{});
    ASSERT_NE(designOf(document, 1), nullptr);
    EXPECT_EQ(*designOf(document, 1), DesignerConfig(OtsuConfig{}));
    document = withDesign(document, 1, EchoRampConfig{.threshold = 0.3});
    EXPECT_EQ(*designOf(document, 1), DesignerConfig(EchoRampConfig{.threshold = 0.3}));
    EXPECT_EQ(document.designs.size(), 1U);
    EXPECT_EQ(problemOf(document), "");
    document = withCurve(document, 1, CurveKind::linear);
    EXPECT_EQ(designOf(document, 1), nullptr);
    EXPECT_EQ(viewOf(document, 1).curve, CurveKind::linear);
    EXPECT_TRUE(document.designs.empty());
}

TEST(Designs, ViewsThatShareADesignChangeTogether) {
    Document document = withDesign({}, 1, OtsuConfig{});
    document.views.push_back(View{.id = 2, .design = viewOf(document, 1).design});
    document = withDesign(document, 2, PercentileConfig{});
    EXPECT_EQ(*designOf(document, 1), DesignerConfig(PercentileConfig{}));
    document = withCurve(document, 1, CurveKind::adaptive);
    EXPECT_EQ(*designOf(document, 2), DesignerConfig(PercentileConfig{}));
}

TEST(Designs, WhatIsWrongIsNamed) {
    Document document = withDesign({}, 1, EchoRampConfig{.threshold = 2.0});
    EXPECT_NE(problemOf(document).find("designs[0]: the threshold must be 0 to 1"), std::string::npos)
        << problemOf(document);
    document = withDesign({}, 1, OtsuConfig{});
    viewOf(document, 1).design = 7;
    EXPECT_EQ(problemOf(document), "views[0].design names no design");
    KindlmannConfig drawn;
    drawn.drawn = {{1.0, 0.5}};
    EXPECT_NE(problemOf(withDesign({}, 1, drawn)).find("2 to 64 nodes"), std::string::npos);
}

TEST(Designs, TubeCoresOfAViewAreLeftOutBesideThoseOfTheMethod) {
    Document document;
    document.method.config.grid.withoutTubes = {3, 9};
    viewOf(document, 1).withoutTubes = {224, 3, 225, 1};
    EXPECT_EQ(configOf(document, 1).grid.withoutTubes, (std::vector<int>{1, 3, 9, 224}));
    EXPECT_EQ(configOf(document).grid.withoutTubes, (std::vector<int>{3, 9}));
    EXPECT_TRUE(viewOf(openedDocument(document, {}), 1).withoutTubes.empty());
}

TEST(Designs, APresetOfACurveTakesTheDesignsPlace) {
    const Document document = withDesign({}, 1, OtsuConfig{});
    const Preset preset{.name = "manual", .curve = CurveKind::manual, .look = lookOf(document, 1)};
    EXPECT_FALSE(isMadeBy(document, 1, preset));
    const Document next = withPreset(document, 1, preset);
    EXPECT_EQ(designOf(next, 1), nullptr);
    EXPECT_TRUE(isMadeBy(next, 1, preset));
}

TEST(Designs, TheViewsPictureIsThatOfItsDesign) {
    const auto scan = smallFetus();
    const std::vector<std::shared_ptr<const Volume>> scans{scan};
    for (const DesignerConfig& config : {DesignerConfig(LevoyConfig{}), DesignerConfig(OtsuConfig{})}) {
        Document document = withDesign({}, 1, config);
        document.curves.adjustment.transparency = 0.5;
        const auto shown = viewPicture(document, 1, scans, 40, 32);
        const Volume quiet = *quietVolume(*scan, lookOf(document, 1).reduction);
        const Design made = *design(config, designerInputOf(document, 1, *scan, quiet, lookOf(document, 1).reduction));
        const Classification expected = adjustedClassification(made.classification, document.curves.adjustment);
        EXPECT_EQ(shown->classification, expected);
        EXPECT_EQ(shown->picture.rgba, castRays(quiet, expected, shown->cast)->rgba);
        EXPECT_GT(*std::ranges::max_element(shown->picture.rgba), 0.1f);
    }
}

TEST(Designs, AMaximumAsksNoDesigner) {
    Document document = withDesign({}, 1, LevoyConfig{});
    EXPECT_TRUE(needsComputedOtf(document, 1));
    lookOf(document, 1).mode = RenderMode::maximum;
    EXPECT_FALSE(needsComputedOtf(document, 1));
}

}  // namespace
}  // namespace echolucent
