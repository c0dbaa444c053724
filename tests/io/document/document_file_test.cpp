// Documents as JSON: nothing is lost, and what is wrong is refused by its key.
#include "io/document/document_file.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/study/named_study.h"
#include "processing/adaptive/method_reading.h"
#include "tests/io/document/unusual_document.h"
#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

std::string changed(const std::string& text, const std::string& pointer, const nlohmann::ordered_json& value) {
    auto object = nlohmann::ordered_json::parse(text);
    object[nlohmann::ordered_json::json_pointer(pointer)] = value;
    return object.dump();
}

TEST(DocumentFile, ReadsBackWhatItWroteBitForBit) {
    Document simulated;
    simulated.study = SimulatedScan{PhantomScene::shapes, {72, 68, 70}, std::numeric_limits<std::uint64_t>::max()};
    for (const Document& document : {Document{}, unusualDocument(), simulated}) {
        const std::string text = jsonOf(document);
        const auto read = documentFromJson(text);
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_TRUE(*read == document);
        EXPECT_EQ(jsonOf(*read), text);
    }
    EXPECT_NE(jsonOf(unusualDocument()), jsonOf(Document{}));
}

TEST(DocumentFile, OnlyStudiesWhoseBlackIsNotZeroSaySo) {
    Document document;
    document.study = StudyFile{.path = "a.mha", .options = {}, .checksum = {}};
    const auto ofData = nlohmann::ordered_json::parse(jsonOf(document));
    EXPECT_EQ(ofData["study"]["file"]["black_from_data"], true);
    auto old = ofData;
    old["study"]["file"].erase("black_from_data");
    const auto read = documentFromJson(old.dump());
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(std::get<StudyFile>(read->study).options.blackAtZero);
    EXPECT_EQ(jsonOf(*read), old.dump(2) + "\n") << "what an older program wrote stays as it is";
    EXPECT_FALSE(documentFromJson(changed(jsonOf(document), "/study/file/black_from_data", 1)));

    Study study;
    VolumeGeometry one;
    study.phases.push_back(std::make_shared<const Volume>(one, std::vector<std::uint8_t>{7}));
    const StudyFile file = std::get<StudyFile>(document.study);
    EXPECT_TRUE(asOpened(file, study).options.blackAtZero);
    study.phases.front() =
        std::make_shared<const Volume>(study.phases.front()->withValueScale({.black = -60.0, .factor = 1.0}));
    EXPECT_TRUE(asOpened(file, study) == file);
}

TEST(DocumentFile, AMeasurementWithoutNameAndCommentIsWrittenAsItEverWas) {
    const auto object = nlohmann::ordered_json::parse(jsonOf(unusualDocument()));
    const auto keysOf = [](const nlohmann::ordered_json& entry) {
        std::vector<std::string> keys;
        for (const auto& [key, value] : entry.items()) keys.push_back(key);
        return keys;
    };
    const std::vector<std::string> ever{"id", "kind", "ground", "places_mm", "phase"};
    EXPECT_EQ(keysOf(object["measurements"][1]), ever);
    EXPECT_EQ(object["measurements"][0]["name"], "AO∠");
    const auto read = documentFromJson(object.dump());
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->measurements[0].comment, "beside the \"spine\"\nagain in 2 weeks");
    EXPECT_EQ(read->measurements[1].name, "");
}

TEST(DocumentFile, SaysWhichTubeCoresAreNeverPlacedOnlyWhereThereAreAny) {
    const nlohmann::ordered_json::json_pointer place("/method/parameters/without_tubes");
    EXPECT_FALSE(nlohmann::ordered_json::parse(jsonOf(Document{})).contains(place));
    auto object = nlohmann::ordered_json::parse(jsonOf(unusualDocument()));
    EXPECT_EQ(object.at(place), (nlohmann::ordered_json{0, 17, 464}));
    object.at(place.parent_pointer()).erase("without_tubes");
    const auto read = documentFromJson(object.dump());
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_TRUE(read->method.config.grid.withoutTubes.empty());
}

TEST(DocumentFile, FromBeforeTheAimOpensWithTheCurveOfBrightSurfaces) {
    auto object = nlohmann::ordered_json::parse(jsonOf(Document{}));
    const nlohmann::ordered_json::json_pointer place("/method/parameters/aim");
    EXPECT_EQ(object.at(place), 0.5);
    object.at(place.parent_pointer()).erase("aim");
    const auto read = documentFromJson(object.dump());
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(readingOf(configOf(read->method, read->curves)), MethodReading::firstVersion);
    EXPECT_EQ(std::get<RampRule>(read->method.config.curve).aim, 0.0);
}

TEST(DocumentFile, SaysWhichAxisOfTheFilesGridWasTurnedRoundOnlyWhereOneWas) {
    const nlohmann::ordered_json::json_pointer place("/study/file/turned_axis");
    EXPECT_FALSE(nlohmann::ordered_json::parse(jsonOf(unusualDocument())).contains(place));
    Document turned = unusualDocument();
    std::get<StudyFile>(turned.study).turnedAxis = GridAxis::y;
    const std::string text = jsonOf(turned);
    EXPECT_EQ(nlohmann::ordered_json::parse(text).at(place), "y");
    EXPECT_EQ(documentFromJson(changed(text, "/study/file/turned_axis", "w")).error().element,
              "study.file.turned_axis");
    EXPECT_EQ(documentFromJson(text).value(), turned);
}

TEST(DocumentFile, AxesOfOlderProgramsKeepTheirViewsAndPlanesThatTurnNothingSayNothing) {
    Document document;
    document.scene.pose.direction = {.azimuth = 10, .elevation = -40, .roll = 20};
    document.scene.motionAngle = 30;
    for (const MotionAxis axis : {MotionAxis::x, MotionAxis::y, MotionAxis::z}) {
        document.motion.axis = axis;
        const auto read = documentFromJson(changed(jsonOf(Document{}), "/motion/axis", nameOf(axis)));
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_EQ(read->motion.axis, axis);
        EXPECT_TRUE(viewpointOf(documentFromJson(jsonOf(document)).value()) == viewpointOf(document));
    }
    EXPECT_EQ(nlohmann::ordered_json::parse(jsonOf(Document{}))["motion"]["axis"], "screen_vertical");
    EXPECT_FALSE(nlohmann::ordered_json::parse(jsonOf(Document{}))["scene"]["planes"].contains("turns_view"));
    document.scene.planes.turnsView = true;
    EXPECT_TRUE(documentFromJson(jsonOf(document)).value() == document);
    EXPECT_FALSE(documentFromJson(changed(jsonOf(document), "/scene/planes/turns_view", 1)));
}

TEST(DocumentFile, OnlyComparisonsWithColoursSaySo) {
    EXPECT_FALSE(nlohmann::ordered_json::parse(jsonOf(Document{}))["comparison"].contains("colours"));
    EXPECT_FALSE(documentFromJson(jsonOf(unusualDocument())).value().comparison.colours);
    Document document = unusualDocument();
    document.comparison.colours = true;
    EXPECT_TRUE(documentFromJson(jsonOf(document)).value() == document);
    EXPECT_FALSE(documentFromJson(changed(jsonOf(document), "/comparison/colours", 1)));
}

TEST(DocumentFile, OnlyPanesWithAMethodOrALinearCurveOfTheirOwnSaySo) {
    Document document = unusualDocument();
    const std::string before = jsonOf(document);
    const auto object = nlohmann::ordered_json::parse(before);
    for (const auto& pane : object["panes"])
        EXPECT_FALSE(pane.contains("method") || pane.contains("linear")) << pane.dump();
    const std::size_t second = 1;
    document.panes.resize(std::max(document.panes.size(), fewestPanes));
    document.panes[second] = {.method = configOf(MethodReading::asPublished)};
    document.panes[firstPane].linear = LinearCurve{1.0 / 7.0, 2.0 / 3.0, 0.9};
    const std::string text = jsonOf(document);
    EXPECT_TRUE(documentFromJson(text).value() == document);
    EXPECT_EQ(jsonOf(documentFromJson(text).value()), text);
    EXPECT_FALSE(documentFromJson(changed(text, "/panes/0/linear/lower", 1.5)));
    EXPECT_FALSE(documentFromJson(changed(text, "/panes/1/method/cell_size", -1)));
    document.panes[firstPane].method = AdaptiveOtfConfig{};
    const auto refused = documentFromJson(jsonOf(document));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("panes[0].method"), std::string::npos) << refused.error().sentence();
}

TEST(DocumentFile, GoesToAFileAndBack) {
    const TemporaryFolder folder;
    const std::string path = folder.file("session.json");
    ASSERT_TRUE(writeDocument(path, unusualDocument()));
    EXPECT_TRUE(readDocument(path).value() == unusualDocument());
    EXPECT_FALSE(readDocument(folder.file("absent.json")));
    const auto nowhere = writeDocument(folder.file("no folder/session.json"), unusualDocument());
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().kind, FailureKind::unwritable);
}

struct WrongPart {
    const char* place;  ///< JSON pointer
    nlohmann::ordered_json value;
    const char* key;  ///< in the sentence
    const char* problem;
};

class WrongDocument : public testing::TestWithParam<WrongPart> {};

TEST_P(WrongDocument, IsRefusedByItsKey) {
    const auto read =
        documentFromJson(changed(jsonOf(unusualDocument()), GetParam().place, GetParam().value), "session.json");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().element, GetParam().key);
    EXPECT_NE(read.error().problem.find(GetParam().problem), std::string::npos) << read.error().problem;
    EXPECT_EQ(read.error().sentence().find("session.json: "), 0u) << read.error().sentence();
}

INSTANTIATE_TEST_SUITE_P(
    DocumentFile, WrongDocument,
    testing::Values(
        WrongPart{"/format", "echolucent-opacity-curve", "format", "echolucent-document"},
        WrongPart{"/version", 3, "version", "must be from 1 to 2, not 3"},
        WrongPart{"/version", 0, "version", "must be from 1 to 2"},
        WrongPart{"/version", "1", "version", "must be from 1 to 2"}, WrongPart{"/panes", 3, "panes", "list"},
        WrongPart{"/panes", nlohmann::ordered_json::array(), "", "panes must hold 1 to 4 panes"},
        WrongPart{"/panes/0/phase", 1, "", "panes[0].phase must be missing"},
        WrongPart{"/panes/0/curve", "sigmoid", "panes[0].curve", "must not be \"sigmoid\""},
        WrongPart{"/scene/pose/magnification", 0, "scene.pose.magnification", "above 0"},
        WrongPart{"/scene/pose/magnification", nullptr, "scene.pose.magnification", "must be a number"},
        WrongPart{"/scene/pose/offset_mm", {1, 2}, "scene.pose.offset_mm", "three numbers"},
        WrongPart{"/scene/pose/direction/elevation", 90.5, "scene.pose.direction.elevation", "-90 to 90"},
        WrongPart{"/scene/pose/direction", 1, "scene.pose.direction", "object"},
        WrongPart{"/scene/side/elevation", -91, "scene.side.elevation", "-90 to 90"},
        WrongPart{"/scene/front/depth_mm", -1, "scene.front.depth_mm", "0 or more"},
        WrongPart{"/scene/front/source", "search", "scene.front.source", "must not be \"search\""},
        WrongPart{"/scene/front/surface/spacing_mm", 0, "", "scene.front.surface "},
        WrongPart{"/scene/look/mode", 1, "scene.look.mode", "must not be 1"},
        WrongPart{"/scene/look/light_elevation", 91, "scene.look.light_elevation", "-90 to 90"},
        WrongPart{"/scene/phase", 1.5, "scene.phase", "whole number"},
        WrongPart{"/scene/phase", -1, "scene.phase", "0 to"},
        WrongPart{"/curves/manual/1/opacity", 1.01, "curves.manual[1].opacity", "0 to 1"},
        WrongPart{"/curves/manual/2/intensity", 0.2, "curves.manual[2].intensity", "before"},
        WrongPart{"/curves/manual", nlohmann::ordered_json::array(), "curves.manual", "at least one"},
        WrongPart{"/curves/linear/upper", 0.2, "curves.linear.upper", "to 1"},
        WrongPart{"/curves/adjustment/threshold", 0.51, "curves.adjustment.threshold", "-0.5 to 0.5"},
        WrongPart{"/method/initial", "cubic", "method.initial", "cubic"},
        WrongPart{"/method/parameters/tube_columns", 0, "method.parameters.tube_columns", "must be 1 to"},
        WrongPart{"/method/parameters/without_tubes", {3, 465}, "method.parameters", "0 to 464, not 465"},
        WrongPart{"/method/parameters/without_tubes", {3, 3}, "method.parameters", "once"},
        WrongPart{"/method/parameters/without_tubes", {3, -1}, "method.parameters.without_tubes", "from 0 to"},
        WrongPart{"/method/parameters/without_tubes", {3.5}, "method.parameters.without_tubes", "whole numbers"},
        WrongPart{"/method/parameters/without_tubes", 3, "method.parameters.without_tubes", "list"},
        WrongPart{"/method/parameters/form", "sigmoid", "method.parameters.form", "sigmoid"},
        WrongPart{"/method/parameters/ramp_begin", 0.3, "method.parameters.ramp_begin", "must not be"},
        WrongPart{"/scene/motion_angle", 46, "scene.motion_angle", "-45 to 45"},
        WrongPart{"/motion/ping_pong", 1, "motion.ping_pong", "true or false"},
        WrongPart{"/beam/axis", "up", "beam.axis", "up"},
        WrongPart{"/measurements/0/name", 3, "measurements[0].name", "text"},
        WrongPart{"/measurements/0/name", "a\nb", "", "measurements[0].name must be one line"},
        WrongPart{"/measurements/0/comment", std::string(501, 'a'), "", "measurements[0].comment must have at most"},
        WrongPart{"/comparison/second", 1, "", "comparison.first and second must differ"},
        WrongPart{"/comparison/wipe", 1.5, "comparison.wipe", "0 to 1"},
        WrongPart{"/scene/box/size_mm", {1, 0, 1}, "", "scene.box has a size that is not above 0"},
        WrongPart{"/scene/planes/window", 0, "scene.planes.window", "to 4"},
        WrongPart{"/scene/planes/crops/B/magnification", 0, "scene.planes.crops.B.magnification", "above 0"},
        WrongPart{"/scene/strokes/1/places", {{1, 2}, {3}}, "scene.strokes[1].places", "pairs"},
        WrongPart{"/scene/strokes/1/places", {{1, 2}, {3, 4}}, "", "fewer than three places"},
        WrongPart{"/scene/strokes/0/radius", 0, "", "a radius that is not above 0"},
        WrongPart{"/scene/strokes/0/camera/height_mm", 0, "", "a camera that has a height"},
        WrongPart{"/scene/strokes/0/camera/frame/down", {0, 0, 1}, "", "orthonormal"},
        WrongPart{"/panes/1/without_tubes", {1, -2}, "panes[1].without_tubes", "whole numbers"},
        WrongPart{"/panes/2/designer/designer", "sakas", "panes[2].designer.designer", "must not be \"sakas\""},
        WrongPart{"/panes/2/designer/parameters/tissue_opacity", -1, "panes[2].designer.parameters.tissue_opacity",
                  "0 to 1"},
        WrongPart{"/panes/3/designer/reference/histogram/3", 0.5, "panes[3].designer.reference", "sum of 1"},
        WrongPart{"/panes/3/designer/reference/curve/kind", "cubic", "panes[3].designer.reference.curve.kind",
                  "manual"},
        WrongPart{
            "/panes/3/designer/reference/curve/opacities", {0.5}, "panes[3].designer.reference.curve.opacities", "two"},
        WrongPart{"/panes/1/designer/drawn", {{1, 2}}, "", "panes[1].designer: "},
        WrongPart{"/study/file/raw_layout/size", {0, 1, 1}, "study.file.raw_layout.size", "whole numbers"},
        WrongPart{"/study/file/path", 5, "study.file.path", "text"}));

/// Whether the key at a place may be missing: a parameter of the method, of a designer or of a look, and all of a raw
/// layout but its size, have defaults; most panes have a curve alone.
bool mayBeMissing(const std::string& place) {
    if (place.starts_with("/scene/look/")) return true;
    if (place.starts_with("/study/file/raw_layout/")) return !place.ends_with("/size");
    for (const char* optional : {"/study/file/bytes", "/study/file/files", "/study/file/conversion_mebibytes",
                                 "/study/file/study_mebibytes", "/study/file/black_from_data"})
        if (place == optional) return true;
    if (place.starts_with("/measurements/")) return place.ends_with("/name") || place.ends_with("/comment");
    if (place.starts_with("/panes/")) {
        for (const char* ending : {"/without_tubes", "/phase", "/motion_otf", "/drawn", "/reference"})
            if (place.ends_with(ending)) return true;
        return (place.ends_with("/designer") && !place.ends_with("/designer/designer")) ||
               place.find("/designer/parameters") != std::string::npos;
    }
    return place == "/scene/planes/turns_view" || place.starts_with("/method/parameters/");
}

/// Adds the places of all keys below a place that must be there.
void addNeeded(const nlohmann::ordered_json& value, const nlohmann::ordered_json::json_pointer& place,
               std::vector<nlohmann::ordered_json::json_pointer>& needed) {
    for (const auto& [key, inner] : value.items()) {
        const nlohmann::ordered_json::json_pointer at = place / key;
        if (mayBeMissing(at.to_string())) continue;
        if (value.is_object()) needed.push_back(at);
        if (inner.is_structured()) addNeeded(inner, at, needed);
    }
}

TEST(DocumentFile, EveryKeyButTableRowsIsNeeded) {
    Document simulated;
    simulated.study = SimulatedScan{PhantomScene::shapes, {72, 68, 70}, 1};
    for (const Document& document : {unusualDocument(), simulated}) {
        const auto object = nlohmann::ordered_json::parse(jsonOf(document));
        std::vector<nlohmann::ordered_json::json_pointer> needed;
        addNeeded(object, nlohmann::ordered_json::json_pointer(), needed);
        EXPECT_GT(needed.size(), 30u);
        for (const auto& place : needed) {
            auto without = object;
            without.at(place.parent_pointer()).erase(place.back());
            EXPECT_FALSE(documentFromJson(without.dump())) << place.to_string();
        }
    }
}

TEST(DocumentFile, AnExposureStandsOnlyWhereOpeningFoundOne) {
    Document document;
    EXPECT_FALSE(nlohmann::ordered_json::parse(jsonOf(document))["scene"].contains("exposure"));
    document.scene.exposure = 0.66;
    EXPECT_EQ(documentFromJson(jsonOf(document))->scene.exposure, 0.66);
    for (const double wrong : {0.0, -0.5, 1.5})
        EXPECT_FALSE(documentFromJson(changed(jsonOf(document), "/scene/exposure", wrong))) << wrong;
}

TEST(DocumentFile, AFlatFrontKeepsItsDirectionWhateverThePose) {
    Document document;
    document.scene.pose.direction = {30, -10, 5};
    for (const ViewDirection& direction : {ViewDirection{30, -10, 5}, ViewDirection{}, ViewDirection{-70, 20, 0}}) {
        document.scene.front = frontAcross(direction, 7);
        const auto object = nlohmann::ordered_json::parse(jsonOf(document));
        EXPECT_EQ(object["scene"]["front"]["direction"]["azimuth"], direction.azimuth);
        EXPECT_TRUE(documentFromJson(object.dump()).value() == document);
    }
}

TEST(DocumentFile, AFrontThatDoesNotCutHasNoDirection) {
    Document document;
    const auto read = documentFromJson(changed(jsonOf(document), "/scene/front/direction/azimuth", 12));
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->scene.front, Front{});
}

TEST(DocumentFile, GivesThePaneOfANumber) {
    const std::string text = jsonOf(unusualDocument());
    EXPECT_EQ(documentPaneFromJson(text, std::nullopt).value().pane, firstPane);
    EXPECT_EQ(documentPaneFromJson(text, 4).value().pane, 3U);
    for (const int number : {0, 5, -1}) {
        const auto read = documentPaneFromJson(text, number);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().kind, FailureKind::wrongUsage);
    }
}

TEST(DocumentFile, APathThatIsNotUtf8IsAFailureAndLeavesNoFile) {
    const TemporaryFolder folder;
    Document document;
    StudyFile file;
    file.path = "scan\xff.mha";
    document.study = file;
    const std::string path = folder.file("document.json");
    const auto written = writeDocument(path, document);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, FailureKind::unwritable);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(DocumentFile, TextThatIsNoJsonIsRefused) {
    for (const char* text : {"", "{", "[1]", "nonsense", "{\"format\": 1e999}"})
        EXPECT_FALSE(documentFromJson(text)) << text;
}

}  // namespace
}  // namespace echolucent
