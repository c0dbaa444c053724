// Documents as JSON: nothing is lost, and what is wrong is refused by its key.
#include "io/document/document_file.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/io/temporary_folder.h"

namespace echolucent {
namespace {

std::vector<ScalpelStroke> unusualStrokes() {
    ScalpelStroke eraser{
        .tool = ScalpelTool::eraser, .side = ScalpelSide::inside, .camera = {}, .places = {{0.1, -0.2}}};
    eraser.radius = 1.0 / 30.0;
    eraser.camera = {{1, 2, 3}, frameOf(Viewpoint{.elevationDegrees = 12.3}), Projection::perspective, 44.4, 29.9, 1e3};
    ScalpelStroke outline{.tool = ScalpelTool::polygon, .side = ScalpelSide::outside, .camera = {}, .places = {}};
    outline.places = {{0, 0}, {1.0 / 3.0, 0.1}, {0.2, 0.30000000000000004}};
    outline.depthMm = -12.000000000000002;
    return {eraser, outline};
}

/// A document in which every part differs from its default, with numbers that have no short decimal text.
Document unusual() {
    Document document;
    StudyFile file{.path = "/data/a \"study\" \\ with ümlauts.dcm", .options = {}, .checksum = "x"};
    file.options.series = "1.2.840.1";
    file.options.raw = RawLayout{{20, 21, 22}, "int16", true, 352, {0.1, 1.0 / 3.0, 2e-7}, true};
    file.options.framesAsSlices = true;
    file.options.guessNoData = false;
    document.study = file;
    document.beam = {BeamAxis::minusX, BeamSource::person};
    document.poses = {
        {7, {{std::numbers::pi * 50, -89.999999999999986, 1e-300}, {0.1 + 0.2, -1.0 / 3.0, 1e17}, 4.0 / 3.0}},
        {2, Pose{}}};
    document.cuts = {{4, {18.04000000000001}}, {5, {std::numeric_limits<double>::denorm_min()}}};
    document.cuts.front().value.source = CutSource::found;
    document.cuts.front().value.surface = CutSurface{.frame = frameOf(Viewpoint{.azimuthDegrees = 12.3}),
                                                     .firstRightMm = -1.0 / 3.0,
                                                     .firstDownMm = 0.1,
                                                     .spacingMm = 2.0 / 7.0,
                                                     .columns = 2,
                                                     .rows = 3,
                                                     .depthMm = {0.1f, -1.0f / 3.0f, 1e-30f, 4, 5, 6e20f}};
    document.looks = {{9, Look{}}};
    document.looks.front().value.mode = RenderMode::mean;
    document.looks.front().value.colourMap = ColourMap::ice;
    document.looks.front().value.depthColoured = true;
    document.looks.front().value.projection = Projection::perspective;
    document.looks.front().value.interpolation = Interpolation::nearest;
    document.looks.front().value.light = {100.0 / 3.0, -0.1};
    document.looks.front().value.step = 2.0 / 3.0;
    document.phases = {{1, 3}};
    document.boxes = {{6, {}},
                      {1, {true, {1.0 / 3.0, -2.5, 77}, {0.1, -1e-7, 1e9}, {1.0 / 7.0, 2, 3e-3}, BoxSide::far}}};
    document.planes = {{5, {}}};
    document.planes.front().value = Planes{.direction = {-170.1, 12.0 / 7.0, 0.3},
                                           .offsetMm = {0.1, 0.2, -0.3},
                                           .crops = {{{1, 2, 3}, {-0.1, 0.7, 1.0 / 9.0}, {}}},
                                           .window = 0.3,
                                           .level = -0.1,
                                           .quiet = false,
                                           .linesIn3d = true};
    document.strokes = {{1, {}}, {2, {unusualStrokes()}}};
    document.views = {{3, 7, 4, 9, 1, CurveKind::quartic, 6, 5, 2}, {8, 2, 5, 9, 1, CurveKind::manual, 1, 5, 1}};
    document.curves.manual = {{{0.0, 1.0 / 7.0}, {0.3, 0.1}, {0.3, 0.9999999999999999}}};
    document.curves.linear = {1.0 / 3.0, 2.0 / 3.0, 0.7};
    document.curves.parabolic.scale = 0.1;
    document.curves.quartic.scale = 17.3;
    document.curves.adjustment = {-1.0 / 3.0, 0.7};
    document.method.initial = InitialKind::linear;
    document.method.initialScale = 0.55;
    document.method.direction = {12.3, -4.5, 6.7};
    document.method.config.grid.columns = 31;
    document.method.config.detection = VarianceRule{};
    document.method.config.curve = ProductRule{.strength = 20.0 / 3.0};
    document.measurements = {{.id = 3,
                              .kind = MeasurementKind::angle,
                              .ground = MeasurementGround::surface,
                              .placesMm = {{0.1, 1.0 / 3.0, -2e-7}, {1e9, 0.30000000000000004, 5}, {7, 8, 9}},
                              .phase = 4},
                             {.id = 1, .placesMm = {{1, 2, 3}, {-1.0 / 7.0, 5, 6}}}};
    document.motion = {.axis = MotionAxis::z,
                       .scenario = MotionScenario::both,
                       .otf = MotionOtf::leastFlicker,
                       .pingPong = false,
                       .phasesPingPong = true,
                       .phaseRange = PhaseRange{2, 11},
                       .otfPhase = 7,
                       .speed = 1.0 / 3.0};
    document.motionAngle = -17;
    return document;
}

std::string changed(const std::string& text, const std::string& pointer, const nlohmann::ordered_json& value) {
    auto object = nlohmann::ordered_json::parse(text);
    object[nlohmann::ordered_json::json_pointer(pointer)] = value;
    return object.dump();
}

TEST(DocumentFile, ReadsBackWhatItWroteBitForBit) {
    Document simulated;
    simulated.study = SimulatedScan{PhantomScene::shapes, {72, 68, 70}, std::numeric_limits<std::uint64_t>::max()};
    for (const Document& document : {Document{}, unusual(), simulated}) {
        const std::string text = jsonOf(document);
        const auto read = documentFromJson(text);
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_TRUE(*read == document);
        EXPECT_EQ(jsonOf(*read), text);
    }
    EXPECT_NE(jsonOf(unusual()), jsonOf(Document{}));
}

TEST(DocumentFile, GoesToAFileAndBack) {
    const TemporaryFolder folder;
    const std::string path = folder.file("session.json");
    ASSERT_TRUE(writeDocument(path, unusual()));
    EXPECT_TRUE(readDocument(path).value() == unusual());
    EXPECT_FALSE(readDocument(folder.file("absent.json")));
    const auto nowhere = writeDocument(folder.file("no folder/session.json"), unusual());
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().kind, FailureKind::unwritable);
}

struct Wrong {
    const char* place;  ///< JSON pointer
    nlohmann::ordered_json value;
    const char* key;  ///< in the sentence
    const char* problem;
};

class WrongDocument : public testing::TestWithParam<Wrong> {};

TEST_P(WrongDocument, IsRefusedByItsKey) {
    const auto read = documentFromJson(changed(jsonOf(unusual()), GetParam().place, GetParam().value), "session.json");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().element, GetParam().key);
    EXPECT_NE(read.error().problem.find(GetParam().problem), std::string::npos) << read.error().problem;
    EXPECT_EQ(read.error().sentence().find("session.json: "), 0u) << read.error().sentence();
}

INSTANTIATE_TEST_SUITE_P(
    DocumentFile, WrongDocument,
    testing::Values(Wrong{"/format", "echolucent-opacity-curve", "format", "echolucent-document"},
                    Wrong{"/version", 2, "version", "must be 1, not 2"}, Wrong{"/version", "1", "version", "must be 1"},
                    Wrong{"/views", 3, "views", "list"}, Wrong{"/views/1/pose", 99, "", "views[1].pose names no pose"},
                    Wrong{"/views/1/id", 3, "", "views must have an id of its own each"},
                    Wrong{"/views/0/curve", "sigmoid", "views[0].curve", "must not be \"sigmoid\""},
                    Wrong{"/poses/0/magnification", 0, "poses[0].magnification", "above 0"},
                    Wrong{"/poses/0/magnification", nullptr, "poses[0].magnification", "must be a number"},
                    Wrong{"/poses/0/offset_mm", {1, 2}, "poses[0].offset_mm", "three numbers"},
                    Wrong{"/poses/1/direction/elevation", 90.5, "poses[1].direction.elevation", "-90 to 90"},
                    Wrong{"/poses/1/direction", 1, "poses[1].direction", "object"},
                    Wrong{"/cuts/0/near_cut_mm", -1, "cuts[0].near_cut_mm", "0 or more"},
                    Wrong{"/looks/0/mode", 1, "looks[0].mode", "must not be 1"},
                    Wrong{"/looks/0/light_elevation", 91, "looks[0].light_elevation", "-90 to 90"},
                    Wrong{"/phases/0/phase", 1.5, "phases[0].phase", "whole number"},
                    Wrong{"/phases/0/phase", -1, "phases[0].phase", "0 to"},
                    Wrong{"/curves/manual/1/opacity", 1.01, "curves.manual[1].opacity", "0 to 1"},
                    Wrong{"/curves/manual/2/intensity", 0.2, "curves.manual[2].intensity", "before"},
                    Wrong{"/curves/manual", nlohmann::ordered_json::array(), "curves.manual", "at least one"},
                    Wrong{"/curves/linear/upper", 0.2, "curves.linear.upper", "to 1"},
                    Wrong{"/curves/adjustment/threshold", 0.51, "curves.adjustment.threshold", "-0.5 to 0.5"},
                    Wrong{"/method/initial", "cubic", "method.initial", "cubic"},
                    Wrong{"/method/parameters/tube_columns", 0, "method.parameters.tube_columns", "must be 1 to"},
                    Wrong{"/method/parameters/form", "sigmoid", "method.parameters.form", "sigmoid"},
                    Wrong{"/method/parameters/ramp_begin", 0.3, "method.parameters.ramp_begin", "must not be"},
                    Wrong{"/motion/angle", 46, "motion.angle", "-45 to 45"},
                    Wrong{"/motion/ping_pong", 1, "motion.ping_pong", "true or false"},
                    Wrong{"/beam/axis", "up", "beam.axis", "up"},
                    Wrong{"/boxes/1/front", "front", "boxes[1].front", "must not be \"front\""},
                    Wrong{"/boxes/1/size_mm", {1, 0, 1}, "", "boxes[1] has a size that is not above 0"},
                    Wrong{"/planes/0/window", 0, "planes[0].window", "to 4"},
                    Wrong{"/planes/0/crops/B/magnification", 0, "planes[0].crops.B.magnification", "above 0"},
                    Wrong{"/strokes/1/strokes/1/places", {{1, 2}, {3}}, "strokes[1].strokes[1].places", "pairs"},
                    Wrong{"/strokes/1/strokes/1/places", {{1, 2}, {3, 4}}, "", "fewer than three places"},
                    Wrong{"/strokes/1/strokes/0/radius", 0, "", "a radius that is not above 0"},
                    Wrong{"/strokes/1/strokes/0/camera/height_mm", 0, "", "a camera that has a height"},
                    Wrong{"/strokes/1/strokes/0/camera/frame/down", {0, 0, 1}, "", "orthonormal"},
                    Wrong{"/views/1/strokes", 3, "", "views[1].strokes names no strokes"},
                    Wrong{"/study/file/raw_layout/size", {0, 1, 1}, "study.file.raw_layout.size", "whole numbers"},
                    Wrong{"/study/file/path", 5, "study.file.path", "text"}));

/// Whether the key at a place may be missing: a parameter of the method or of a look, and all of a raw layout but its
/// size, have defaults.
bool mayBeMissing(const std::string& place) {
    const std::string looks = "/looks/";
    if (place.starts_with(looks) && place.find('/', looks.size()) != std::string::npos) return !place.ends_with("/id");
    if (place.starts_with("/study/file/raw_layout/")) return !place.ends_with("/size");
    return place.starts_with("/method/parameters/");
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
    for (const Document& document : {unusual(), simulated}) {
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
