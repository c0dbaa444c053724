// otf --document and sweep --document: what panes of a saved document are rendered with, and their motion.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "io/document/session_file.h"
#include "io/study/study.h"
#include "io/study/study_checksum.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/pane_picture/pane_frames.h"
#include "program.h"
#include "tables.h"

namespace echolucent {
namespace {

using nlohmann::json;

/// A document of the shapes with a pose, a side, a cut, a box, a stroke and sliders, and a second pane with a designer.
Document everything() {
    Document document;
    document.study = StudyFile{.path = shapesFile(), .options = {}, .checksum = {}};
    document.beam.source = BeamSource::echo;
    document.scene.pose.direction = {.azimuth = 20, .elevation = -8, .roll = 3};
    document.scene.side = {.azimuth = 12, .elevation = 4};
    document.scene.front.depthMm = 4;
    document.scene.box = {.on = true, .direction = {.azimuth = 12}, .centreMm = {27, 25, 30}, .sizeMm = {36, 34, 44}};
    ScalpelStroke stroke{.tool = ScalpelTool::eraser, .places = {{-0.2, 0.1}, {0.2, -0.1}}, .radius = 0.06};
    stroke.camera = {{27, 25, 30}, frameOf(Viewpoint{.azimuthDegrees = 10}), Projection::parallel, 60, 30, 100};
    document.scene.strokes.push_back(stroke);
    document.curves.adjustment = {.threshold = 0.05, .transparency = 0.3};
    document.panes.push_back({.designer = OtsuConfig{}});
    document.panes.push_back({.withoutTubes = {96, 97, 98, 111, 112, 113, 126, 127, 128}});
    document.panes.push_back({.curve = CurveKind::quartic});
    return document;
}

/// The document in a file, as an option.
std::string given(const Folder& folder, const Document& document) {
    EXPECT_TRUE(writeDocument(folder / "d.json", document));
    return " --document \"" + folder / "d.json" + "\" ";
}

std::string outputOf(const std::string& command) {
    const Outcome outcome = runProgram(command);
    EXPECT_EQ(outcome.status, 0) << command << ": " << outcome.errors;
    return outcome.output;
}

/// What a pane is rendered with, at the intensities of the report.
std::vector<double> renderedOpacities(const Document& document, std::size_t pane) {
    PaneCaster caster({.scans = readStudy(shapesFile())->phases});
    const Classification rendered = classificationOf(document, pane, *caster.otf(document, pane));
    std::vector<double> opacities;
    for (int i = 0; i < 256; ++i) opacities.push_back(opacityAt(rendered.curve(), i / 255.0));
    return opacities;
}

void expectIsRendered(const std::vector<double>& reported, const Document& document, std::size_t pane) {
    const std::vector<double> rendered = renderedOpacities(document, pane);
    ASSERT_EQ(reported.size(), rendered.size());
    for (std::size_t i = 0; i < rendered.size(); ++i) ASSERT_NEAR(reported[i], rendered[i], 1e-15) << pane << ' ' << i;
}

TEST(OtfDocument, IsTheOtfThatThePaneIsRenderedWith) {
    const Folder folder;
    Document document = everything();
    const std::string otf = "otf" + given(folder, document) + "--json - ";
    std::vector<std::vector<double>> panes;
    for (const std::size_t pane : {0u, 1u, 2u}) {
        const json report = json::parse(outputOf(otf + "--view " + std::to_string(pane + 1)));
        panes.push_back(report["otf"]["opacity"].get<std::vector<double>>());
        expectIsRendered(panes.back(), document, pane);
        EXPECT_EQ(report["view"]["azimuth"], 12.0) << "the side, not the pose";
        EXPECT_EQ(report["parameters"]["transparency"], 0.3);
        EXPECT_EQ(report["beam"], (json{{"axis", "+z"}, {"source", "echo"}, {"confidence", nullptr}}));
    }
    EXPECT_NE(panes[0], panes[1]);
    EXPECT_NE(panes[0], panes[2]);
    Document uncut = document;
    uncut.scene.strokes.clear();
    EXPECT_NE(renderedOpacities(uncut, firstPane), panes[0]) << "the stroke plays a part";
    document.curves.adjustment = {};
    const auto rows = namedRowsOf(outputOf("otf" + given(folder, document) + "--csv -"));
    ASSERT_EQ(rows.size(), 256u);
    const std::vector<double> plain = renderedOpacities(document, firstPane);
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(std::stod(rows[i].at("opacity")), plain[i]);
}

TEST(OtfDocument, SaysTheDocumentAndTheStudyThatItWasMadeOf) {
    const Folder folder;
    const Document document = everything();
    const std::string option = given(folder, document);
    for (const std::string command : {"otf", "sweep --from 0 --to 1"}) {
        const json made = json::parse(outputOf(command + option + "--view 3 --json -"))["made_of"];
        EXPECT_EQ(made["document"]["file"], "d.json");
        EXPECT_EQ(made["document"]["checksum"], checksumOf({folder / "d.json"})->text);
        EXPECT_EQ(made["document"]["pane"], 3);
        EXPECT_EQ(made["study"]["file"], "shapes.mha");
        EXPECT_EQ(made["study"]["checksum"], checksumOf({shapesFile()})->text);
        EXPECT_TRUE(made["found"].is_null()) << "nothing is looked for";
    }
    // VOLUME takes the place of the document's study.
    std::filesystem::copy_file(shapesFile(), folder / "other.mha");
    const json other = json::parse(outputOf("otf \"" + folder / "other.mha" + "\"" + option + "--json -"))["made_of"];
    EXPECT_EQ(other["study"]["file"], "other.mha");
    EXPECT_TRUE(json::parse(outputOf("otf \"" + shapesFile() + "\" --json -"))["made_of"]["document"].is_null());
    Document simulated;
    simulated.study = SimulatedScan{.scene = PhantomScene::shapes, .size = {40, 41, 42}, .seed = 9};
    const json scan = json::parse(outputOf("otf" + given(folder, simulated) + "--json -"))["made_of"]["study"];
    EXPECT_EQ(scan, (json{{"scene", "shapes"}, {"size", {40, 41, 42}}, {"seed", 9}, {"phase", 0}}));
}

TEST(OtfDocument, TakesASessionAndAPhase) {
    const Folder folder;
    SavedSession session;
    session.document.study =
        StudyFile{.path = phantomFile("moving.mha", "--size 56 --phases 3 --seed 4"), .options = {}, .checksum = {}};
    session.document.scene.phase = 2;
    session.document.motion.otf = MotionOtf::eachView;
    session.snapshots = {{"one", session.document}};
    ASSERT_TRUE(writeSession(folder / "s.json", session));
    const json report = json::parse(outputOf("otf --document \"" + folder / "s.json" + "\" --json -"));
    EXPECT_EQ(report["made_of"]["study"]["phase"], 2);
    const std::string file = std::get<StudyFile>(session.document.study).path;
    const json same = json::parse(outputOf("otf \"" + file + "\" --phase 2 --near 0 --beam-axis +z --json -"));
    EXPECT_EQ(report["otf"], same["otf"]);
}

TEST(OtfDocument, ExplainsInDirectRenderingWhateverModeIsShown) {
    const Folder folder;
    Document document = everything();
    document.study =
        StudyFile{.path = phantomFile("moving.mha", "--size 56 --phases 3 --seed 4"), .options = {}, .checksum = {}};
    document.scene.look.mode = RenderMode::maximum;
    document.motion.otfPhase = 1;
    const std::string page = folder / "core.html";
    outputOf("otf" + given(folder, document) + "--explain 112 --page \"" + page + "\"");
    const std::string text = contentsOf(page);
    std::vector<std::string> pictures;
    const std::string begin = "data:image/png;base64,";
    for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
        pictures.push_back(text.substr(at, text.find('"', at) - at));
    ASSERT_EQ(pictures.size(), 3u);
    EXPECT_NE(pictures[0], pictures[2]) << "a tube core alone makes another picture than all";
    for (const char* row :
         {"<td>Phase</td><td>2 of 3</td>",
          "<td>Render box</td><td>36.0 x 34.0 x 44.0 mm around (27.0, 25.0, 30.0) mm of the grid</td>"})
        EXPECT_NE(text.find(row), std::string::npos) << row;
}

/// The frames of a movie that a sweep of the document writes, 64 by 48 pixels.
std::vector<cv::Mat> sweptFrames(const Folder& folder, const Document& document, const std::string& options = {}) {
    const std::string movie = folder / "m.mkv";
    outputOf("sweep" + given(folder, document) + options + " --size 64x48 --movie \"" + movie + "\"");
    cv::VideoCapture capture(movie, cv::CAP_FFMPEG);
    std::vector<cv::Mat> frames;
    for (cv::Mat frame; capture.read(frame);) frames.push_back(frame.clone());
    return frames;
}

cv::Mat rendered(const Folder& folder, const Document& document, const std::string& options = {}) {
    outputOf("render" + given(folder, document) + options + " --size 64x48 -o \"" + folder / "p.png" + "\"");
    return cv::imread(folder / "p.png", cv::IMREAD_COLOR);
}

TEST(SweepDocument, HoldsThePictureOfEachFrameAtRest) {
    const Folder folder;
    Document document = everything();
    document.study =
        StudyFile{.path = phantomFile("moving.mha", "--size 56 --phases 3 --seed 4"), .options = {}, .checksum = {}};
    document.scene.box.centreMm = {14, 14, 14};
    document.scene.box.sizeMm = {25, 24, 26};
    document.motion.otfPhase = 1;
    document.motion.scenario = MotionScenario::object;
    document.panes[2].phase = 2;
    const auto study = readStudy(std::get<StudyFile>(document.study).path);
    for (const std::size_t pane : {0u, 2u})
        for (const MotionOtf otf : {MotionOtf::oneOtf, MotionOtf::eachView}) {
            document.motion.otf = otf;
            const std::string view = "--view " + std::to_string(pane + 1);
            const PaneFrames window(document, pane, {.scans = study->phases});
            const std::vector<cv::Mat> frames = sweptFrames(folder, document, view);
            ASSERT_EQ(static_cast<int>(frames.size()), window.count());
            for (const int frame : {0, 1}) {
                const cv::Mat expected = rendered(folder, window.documentOf(frame), view);
                EXPECT_GT(cv::mean(expected)[1], 1.0) << "there is something to compare";
                EXPECT_EQ(cv::norm(frames[static_cast<std::size_t>(frame)], expected, cv::NORM_INF), 0.0)
                    << nameOf(otf) << ' ' << pane << ' ' << frame;
            }
        }
}

TEST(SweepDocument, TurnsTheProbeAndSmoothsAsTheDocumentSays) {
    const Folder folder;
    Document document = everything();
    document.panes.front().designer = AdaptiveConfig{};
    document.motion = {.axis = MotionAxis::x, .scenario = MotionScenario::probe, .pingPong = false};
    document.scene.motionAngle = 7;
    const PaneFrames window(document, firstPane, {.scans = readStudy(shapesFile())->phases});
    const std::vector<cv::Mat> frames = sweptFrames(folder, document);
    ASSERT_EQ(frames.size(), 91u);
    EXPECT_EQ(cv::norm(frames[0], rendered(folder, window.documentOf(0)), cv::NORM_INF), 0.0);
    document.panes.front().designer.reset();
    document.motion.otf = MotionOtf::leastFlicker;
    const json report = json::parse(outputOf("sweep" + given(folder, document) + "--from -2 --to 2 --json -"));
    EXPECT_EQ(report["smoothing"], "least-flicker");
    EXPECT_EQ(report["motion"], (json{{"axis", "x"}, {"probe", "moving"}, {"object", "still"}}));
    ASSERT_EQ(report["frames"].size(), 5u);
    EXPECT_EQ(report["frames"][0]["degrees"], -2.0);
    EXPECT_EQ(report["view"]["azimuth"], 20.0) << "the pose, before the motion turned it";
}

TEST(OtfDocument, SaysWhatItCannotDo) {
    const Folder folder;
    const std::string option = given(folder, everything());
    struct Row {
        std::string command, says;
    };
    for (const Row& row : {Row{"otf --json -", "VOLUME is required"}, Row{"sweep --json -", "VOLUME is required"},
                           Row{"otf --view 2", "--document"}, Row{"otf" + option + "--view 9", "none is number 9"},
                           Row{"otf" + option + "--near 3", "--near plays no part beside --document"},
                           Row{"otf" + option + "--strength 3", "--strength plays no part beside --document"},
                           Row{"otf" + option + "--reduction off", "--reduction plays no part beside --document"},
                           Row{"otf" + option + "--designer levoy", "--designer plays no part beside --document"},
                           Row{"otf" + option + "--all-voxels", "plays no part beside --document without VOLUME"},
                           Row{"otf" + option + "--view 2 --tubes-csv -", "a document that renders with otsu"},
                           Row{"otf" + option + "--view 4", "renders pane 4 with the curve quartic"},
                           Row{"sweep" + option + "--view 2", "renders pane 2 with otsu"},
                           Row{"sweep" + option + "--view 4", "renders pane 4 with quartic"},
                           Row{"sweep" + option + "--axis x", "--axis plays no part beside --document"},
                           Row{"sweep" + option + "--probe still", "--probe plays no part beside --document"},
                           Row{"sweep" + option + "--smoothing mean", "--smoothing plays no part beside --document"},
                           Row{"sweep" + option + "--lighting flat", "--lighting plays no part beside --document"}}) {
        const Outcome outcome = runProgram(row.command);
        EXPECT_EQ(outcome.status, 2) << row.command << ": " << outcome.errors;
        EXPECT_NE(outcome.errors.find(row.says), std::string::npos) << row.command << ": " << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    }
}

}  // namespace
}  // namespace echolucent
