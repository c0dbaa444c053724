#include "processing/document/preset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace echolucent {
namespace {

Document changedDocument() {
    Document document;
    document.curves.manual.nodes = {{0.2, 0.0}, {0.4, 0.7}};
    document.curves.linear.slope = 0.7;
    document.curves.quartic.scale = 0.3;
    document.curves.adjustment = {0.1, -0.2};
    document.method.initialScale = 0.4;
    document.scene.side.azimuth = 33;
    document.scene.look.colourMap = ColourMap::ice;
    document.scene.look.step = 0.25;
    return document;
}

TEST(Preset, GivesBackThePictureItWasMadeOf) {
    for (const CurveKind kind : allCurveKinds)
        for (const InitialKind initial : {InitialKind::parabolic, InitialKind::linear, InitialKind::manual}) {
            Document document = changedDocument();
            document.panes.at(firstPane).curve = kind;
            document.method.initial = initial;
            const Preset preset = presetOf(document, firstPane, "mine");
            EXPECT_EQ(withPreset(document, firstPane, preset), document) << nameOf(kind);
            EXPECT_TRUE(isMadeBy(document, firstPane, preset));
            EXPECT_FALSE(isMadeBy(Document{}, firstPane, preset));
            const Document other = withPreset(Document{}, firstPane, preset);
            const SampledCurve adaptive{{0.0, 0.5, 1.0}};
            EXPECT_EQ(curveOf(other, firstPane, adaptive), curveOf(document, firstPane, adaptive)) << nameOf(kind);
            if (kind == CurveKind::adaptive) {
                EXPECT_EQ(configOf(other), configOf(document)) << nameOf(initial);
            }
            EXPECT_EQ(presetOf(other, firstPane, "mine"), preset) << nameOf(kind);
        }
}

TEST(Preset, LeavesTubeCoresThatAreNeverPlacedAloneUntilTheGridIsAnother) {
    Document document = changedDocument();
    document.method.config.grid.withoutTubes = {2, 7};
    Preset preset = presetOf(document, firstPane, "mine");
    EXPECT_TRUE(preset.method->config.grid.withoutTubes.empty()) << "they belong to a volume";
    EXPECT_EQ(withPreset(document, firstPane, preset), document);
    EXPECT_TRUE(isMadeBy(document, firstPane, preset));
    EXPECT_TRUE(withPreset(Document{}, firstPane, preset).method.config.grid.withoutTubes.empty());
    preset.method->config.grid.columns = 9;
    EXPECT_TRUE(withPreset(document, firstPane, preset).method.config.grid.withoutTubes.empty());
}

TEST(Preset, LeavesWhatPlaysNoPartInItsPicture) {
    const Document document = changedDocument();
    Preset preset{.name = "parabola", .curve = CurveKind::parabolic};
    preset.curves.parabolic.scale = 0.123;
    preset.look.step = 4;
    const Document next = withPreset(document, firstPane, preset);
    EXPECT_EQ(next.curves.parabolic.scale, 0.123);
    EXPECT_EQ(next.curves.manual, document.curves.manual);
    EXPECT_EQ(next.curves.quartic, document.curves.quartic);
    EXPECT_EQ(next.method, document.method);
    EXPECT_EQ(next.scene.look.step, 0.25);
    EXPECT_EQ(next.scene.look.colourMap, ColourMap::sepia);
    EXPECT_EQ(next.curves.adjustment, CurveAdjustment{});
    preset.look.mode = RenderMode::maximum;
    const Document maximum = withPreset(document, firstPane, preset);
    EXPECT_EQ(maximum.curves, document.curves);
    EXPECT_EQ(maximum.panes, document.panes);
    EXPECT_EQ(maximum.scene.look.mode, RenderMode::maximum);
}

TEST(Preset, OfOnePaneLeavesTheCurvesOfOthers) {
    Document document;
    document.panes.push_back({.curve = CurveKind::linear});
    const Preset preset{.name = "grey", .curve = CurveKind::manual, .look = Look{}};
    const Document next = withPreset(document, 1, preset);
    EXPECT_EQ(next.panes.at(firstPane).curve, CurveKind::adaptive);
    EXPECT_EQ(next.panes.at(1).curve, CurveKind::manual);
    EXPECT_EQ(next.scene.look, Look{});
    EXPECT_EQ(problemOf(next), "");
}

TEST(Preset, TheProgramsOwnHaveNamesAndDiffer) {
    std::set<std::string> names;
    std::vector<Document> documents;
    for (const Preset& preset : standardPresets()) {
        EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
        EXPECT_LE(preset.name.size(), longestPresetName);
        EXPECT_EQ(freePresetName(preset.name, {}), preset.name);
        const Document document = withPreset(Document{}, firstPane, preset);
        EXPECT_EQ(problemOf(document), "");
        EXPECT_EQ(std::ranges::find(documents, document), documents.end()) << preset.name;
        documents.push_back(document);
    }
    EXPECT_EQ(documents.front(), Document{}) << "the first is what the program starts with";
}

TEST(Preset, SlicersFetalCurveIsAmongThem) {
    const auto slicer =
        std::ranges::find_if(standardPresets(), [](const Preset& preset) { return preset.curve == CurveKind::manual; });
    ASSERT_NE(slicer, standardPresets().end());
    const ManualCurve fetal{{{60.0 / 255.0, 0.0}, {120.0 / 255.0, 0.6}, {1.0, 0.8}}};
    EXPECT_EQ(slicer->curves.manual, fetal);
    EXPECT_NE(slicer->name.find("Slicer"), std::string::npos);
}

TEST(Preset, FreeNamesAreTrimmedNumberedAndWholeCharacters) {
    EXPECT_EQ(freePresetName("  Skin\n", {}), "Skin");
    EXPECT_EQ(freePresetName(" \t ", {}), "Preset");
    EXPECT_EQ(freePresetName("Skin", {"Skin", "Skin (2)"}), "Skin (3)");
    std::string umlauts;
    for (int i = 0; i < 40; ++i) umlauts += "ü";  // two bytes each
    const std::string first = freePresetName("x" + umlauts, {});
    EXPECT_EQ(first.size(), 59U);
    EXPECT_EQ(freePresetName(std::string(59, 'x') + " y", {}), std::string(59, 'x'));
    const std::string second = freePresetName("x" + umlauts, {first});
    EXPECT_LE(second.size(), longestPresetName);
    EXPECT_TRUE(second.ends_with("ü (2)")) << second;
}

}  // namespace
}  // namespace echolucent
