// Presets as JSON: nothing is lost, and what is wrong is refused by its key.
#include "io/document/preset_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/study/study.h"
#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

/// Presets whose numbers have no short decimal text.
std::vector<Preset> unusualPresets() {
    std::vector<Preset> presets(standardPresets().begin(), standardPresets().end());
    Preset preset{.name = "Größe \"1/3\"", .curve = CurveKind::linear};
    preset.curves.linear = {1.0 / 3.0, 2.0 / 3.0, 0.7};
    preset.curves.adjustment = {-1.0 / 3.0, 0.1};
    preset.look.light.azimuthDegrees = 100.0 / 3.0;
    presets.push_back(preset);
    preset.name = "with a method";
    preset.curve = CurveKind::adaptive;
    preset.method = MethodChoice{};
    preset.method->initial = InitialKind::manual;
    preset.method->initialScale = 1.0 / 7.0;
    preset.method->config.curve = ProductRule{.strength = 20.0 / 3.0};
    presets.push_back(preset);
    return presets;
}

TEST(PresetFile, ReadsBackWhatItWroteBitForBit) {
    for (const std::vector<Preset>& presets : {std::vector<Preset>{}, unusualPresets()}) {
        const std::string text = jsonOf(presets);
        const auto read = presetsFromJson(text);
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_EQ(*read, presets);
        EXPECT_EQ(jsonOf(*read), text);
    }
}

TEST(PresetFile, GoesToAFileAndBack) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writePresets(folder.file("mine.json"), unusualPresets()));
    EXPECT_EQ(readPresets(folder.file("mine.json")).value(), unusualPresets());
    EXPECT_FALSE(readPresets(folder.file("absent.json")));
    EXPECT_FALSE(writePresets(folder.file("no folder/mine.json"), unusualPresets()));
}

TEST(PresetFile, NoFileIsWrittenThatIsTooLargeToBeReadAgain) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writePresets(folder.file("mine.json"), unusualPresets()));
    Preset large{.name = "large", .curve = CurveKind::manual};
    large.curves.manual.nodes.clear();
    for (int i = 0; i < 60000; ++i) large.curves.manual.nodes.push_back({i / 60000.0, 1.0 / 3.0});
    const auto written = writePresets(folder.file("mine.json"), {large});
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().sentence().find("too large to be opened again"), std::string::npos);
    EXPECT_EQ(readPresets(folder.file("mine.json")).value(), unusualPresets()) << "those before are still there";
}

TEST(PresetFile, WhatIsWrongIsRefusedByItsKey) {
    struct Wrong {
        const char* place;
        nlohmann::ordered_json value;
        const char* key;
    };
    const std::string text = jsonOf({standardPresets()[0], standardPresets()[1]});
    for (const Wrong& wrong :
         {Wrong{"/presets/0/name", "", "presets[0].name"},
          Wrong{"/presets/1/name", std::string(61, 'x'), "presets[1].name"},
          Wrong{"/presets/1/name", standardPresets()[0].name, "presets[1].name"},
          Wrong{"/presets/1/curve", "cubic", "presets[1].curve"},
          Wrong{"/presets/0/look/brightness", 0, "presets[0].look.brightness"},
          Wrong{"/presets/0/curves/adjustment/threshold", 0.6, "presets[0].curves.adjustment.threshold"},
          Wrong{"/presets", 3, "presets"}}) {
        auto object = nlohmann::ordered_json::parse(text);
        object[nlohmann::ordered_json::json_pointer(wrong.place)] = wrong.value;
        const auto read = presetsFromJson(object.dump(), "mine.json");
        ASSERT_FALSE(read) << wrong.place;
        EXPECT_EQ(read.error().element, wrong.key);
        EXPECT_EQ(read.error().file, "mine.json");
    }
    EXPECT_FALSE(presetsFromJson("{\"format\": \"echolucent-document\", \"version\": 1}"));
    EXPECT_FALSE(presetsFromJson("no JSON"));
}

TEST(PresetFile, OpenedAsAVolumeSaysWhatItIs) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writePresets(folder.file("mine.json"), unusualPresets()));
    const auto study = readStudy(folder.file("mine.json"));
    ASSERT_FALSE(study);
    EXPECT_TRUE(study.error().presets);
    EXPECT_EQ(study.error().problem, "holds presets, not a volume");
}

}  // namespace
}  // namespace echolucent
