// render --document: the converged picture of a view, as processing makes it.
#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "io/document/session_file.h"
#include "io/study/study.h"
#include "io/study/study_checksum.h"
#include "io/writers/meta_image_writer.h"
#include "processing/document/panes.h"
#include "processing/document/turned_document.h"
#include "processing/pane_picture/pane_frames.h"
#include "processing/pane_picture/pane_measures.h"
#include "processing/pane_picture/pane_picture.h"
#include "program.h"

namespace echolucent {
namespace {

/// A document of the shapes with a pose, a cut, a box and a stroke, and a second view from behind.
Document everything(const std::string& study) {
    Document document;
    document.study = StudyFile{.path = study, .options = {}, .checksum = {}};
    document.scene.pose.direction = {.azimuth = 20, .elevation = -8, .roll = 3};
    document.scene.front.depthMm = 4;
    document.scene.box = {.on = true, .direction = {.azimuth = 12}, .centreMm = {27, 25, 30}, .sizeMm = {36, 34, 44}};
    ScalpelStroke stroke{.tool = ScalpelTool::eraser, .places = {{-0.2, 0.1}, {0.2, -0.1}}, .radius = 0.06};
    stroke.camera = {{27, 25, 30}, frameOf(Viewpoint{.azimuthDegrees = 10}), Projection::parallel, 60, 30, 100};
    document.scene.strokes.push_back(stroke);
    document.panes.push_back({.curve = CurveKind::parabolic});
    return document;
}

cv::Mat pictureOf(const std::string& options, const Folder& folder) {
    const std::string path = folder / "picture.png";
    const Outcome outcome = runProgram("render " + options + " --size 70x52 -o \"" + path + "\"");
    EXPECT_EQ(outcome.status, 0) << options << ": " << outcome.errors;
    return cv::imread(path, cv::IMREAD_COLOR);
}

/// The number of bytes that differ from the view's picture over black.
int apart(const cv::Mat& picture, const Document& document, std::size_t pane) {
    const auto study = readStudy(shapesFile());
    const auto expected = panePicture(document, pane, study->phases, 70, 52);
    const std::vector<std::uint8_t> rgb = overBackground(expected->picture, {0, 0, 0});
    if (picture.cols != 70 || picture.rows != 52) return -1;
    int differing = 0;
    for (int pixel = 0; pixel < 70 * 52; ++pixel)
        for (int channel = 0; channel < 3; ++channel)
            differing += picture.data[pixel * 3 + 2 - channel] != rgb[static_cast<std::size_t>(pixel * 3 + channel)];
    return differing;
}

TEST(CompareDocument, MeasuresEachPaneAsProcessingDoes) {
    const Folder folder;
    Document document = withPaneCount(everything(shapesFile()), 4);
    document = withPane(std::move(document), 2,
                        {.designer = AdaptiveConfig{}, .withoutTubes = {96, 97, 98, 111, 112, 113, 126, 127, 128}});
    ASSERT_TRUE(writeDocument(folder / "compared.json", document));
    const Outcome outcome = runProgram("compare \"" + folder / "compared.json" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto measured = measuresOfPanes(document, {.scans = readStudy(shapesFile())->phases});
    std::string expected =
        "pane,kind,otf,without_tubes,phase,right_percent,early_percent,late_percent,never_percent,cnr_s,"
        "light_near_surfaces\n";
    const std::array cells{"1,curve,adaptive,,0", "2,curve,parabolic,,0",
                           "3,designer,adaptive,96 97 98 111 112 113 126 127 128,0", "4,designer,levoy,,0"};
    for (std::size_t place = 0; place < 4; ++place) {
        const ClassificationMeasures& measures = (*measured)[place]->measures;
        const ShownDepth& depth = measures.depth;
        expected += cells[place];
        for (const int count : {depth.right, depth.early, depth.late, depth.never})
            expected += fmt::format(",{}", 100.0 * (static_cast<double>(count) / depth.rays()));
        expected += fmt::format(",{},{}\n", *measures.contrast.contrastToNoise(), measures.light.meanShare);
    }
    EXPECT_EQ(outcome.output, expected);
    EXPECT_NE((*measured)[0]->measures.contrast.contrastToNoise(), (*measured)[2]->measures.contrast.contrastToNoise());
    EXPECT_EQ((*measured)[0]->from, SurfacesFrom::tubeCores);
    EXPECT_TRUE(outcome.errors.ends_with(std::string(surfacesSentence(SurfacesFrom::tubeCores)) + "\n"))
        << outcome.errors;
    Document simulated = withPaneCount({}, 2);
    simulated.study = SimulatedScan{.scene = PhantomScene::shapes, .size = {40, 40, 40}, .seed = 2};
    ASSERT_TRUE(writeDocument(folder / "simulated.json", simulated));
    const Outcome known = runProgram("compare \"" + folder / "simulated.json" + "\"");
    EXPECT_TRUE(known.errors.ends_with("Surfaces are the true ones of the simulated scan.\n")) << known.errors;
    document.panes.resize(1);
    ASSERT_TRUE(writeDocument(folder / "alone.json", document));
    const Outcome alone = runProgram("compare \"" + folder / "alone.json" + "\"");
    EXPECT_EQ(alone.status, 2);
    EXPECT_NE(alone.errors.find("compares nothing"), std::string::npos) << alone.errors;
}

TEST(RenderDocument, IsTheConvergedPictureOfTheView) {
    const Folder folder;
    const Document document = everything(shapesFile());
    ASSERT_TRUE(writeDocument(folder / "document.json", document));
    const std::string given = "--document \"" + folder / "document.json" + "\"";
    const cv::Mat first = pictureOf(given, folder), second = pictureOf(given + " --view 2", folder);
    EXPECT_EQ(apart(first, document, firstPane), 0);
    EXPECT_EQ(apart(second, document, 1), 0);
    EXPECT_NE(apart(second, document, firstPane), 0);
    EXPECT_GT(cv::mean(first)[1], 3.0) << "there is something to compare";
    Document unlimited = document;
    unlimited.scene.box.on = false;
    EXPECT_NE(apart(first, unlimited, firstPane), 0);
    unlimited = document;
    unlimited.scene.strokes.clear();
    EXPECT_NE(apart(first, unlimited, firstPane), 0);
}

TEST(RenderDocument, AFrontThatIsFixedInTheVolumeStaysThere) {
    const Folder folder;
    Document document = everything(shapesFile());
    document.scene.front = frontAcross({.azimuth = -30}, 30);
    ASSERT_TRUE(writeDocument(folder / "fixed.json", document));
    const cv::Mat picture = pictureOf("--document \"" + folder / "fixed.json" + "\"", folder);
    EXPECT_EQ(apart(picture, document, firstPane), 0);
    document.scene.front.direction = document.scene.pose.direction;
    EXPECT_NE(apart(picture, document, firstPane), 0) << "it does not lie across the pose";
}

TEST(RenderDocument, OfALeftHandedGridStaysOnTheAnatomyAlsoIfItWasMadeOnTheFilesOwnGrid) {
    const Folder folder;
    const auto shapes = readStudy(shapesFile());
    ASSERT_TRUE(shapes);
    const Volume& scan = *shapes->phases.front();
    VolumeGeometry mirrored = scan.geometry();
    for (int row = 0; row < 3; ++row) mirrored.direction(row, 2) *= -1;
    const auto& voxels = std::get<VoxelArray<std::uint8_t>>(scan.voxels());
    std::vector<std::uint8_t> slices;
    const std::int64_t slice = mirrored.size[0] * mirrored.size[1];
    for (std::int64_t z = mirrored.size[2] - 1; z >= 0; --z)
        slices.insert(slices.end(), voxels.begin() + z * slice, voxels.begin() + (z + 1) * slice);
    ASSERT_TRUE(
        writeMetaImage(folder / "left.mha", {std::make_shared<const Volume>(mirrored, slices, scan.whiteLevel())}));

    const Document document = everything(shapesFile());
    // Of the file's own grid, as it was shown before left-handed grids were turned round.
    Document old = turnedRound(document, GridAxis::z, scan.geometry());
    old.study = StudyFile{.path = folder / "left.mha", .options = {}, .checksum = {}};
    Document now = document;
    now.study = StudyFile{.path = folder / "left.mha", .options = {}, .checksum = {}, .turnedAxis = GridAxis::z};
    const auto rendered = [&](const Document& saved, const std::string& volume = {}) {
        EXPECT_TRUE(writeDocument(folder / "saved.json", saved));
        return pictureOf(volume + " --document \"" + folder / "saved.json" + "\"", folder);
    };
    const cv::Mat expected = rendered(document);
    EXPECT_LE(cv::norm(rendered(old), expected, cv::NORM_INF), 1.0);
    // The mark of the document holds for the volume on the command line too.
    EXPECT_LE(cv::norm(rendered(now, "\"" + folder / "left.mha" + "\""), expected, cv::NORM_INF), 1.0);
}

TEST(RenderDocument, FindsTheStudyBesideTheDocumentOrOnTheCommandLine) {
    const Folder folder;
    std::filesystem::copy_file(shapesFile(), folder / "scan.mha");
    const Document document = everything("scan.mha");
    ASSERT_TRUE(writeDocument(folder / "document.json", document));
    EXPECT_EQ(apart(pictureOf("--document \"" + folder / "document.json" + "\"", folder), document, firstPane), 0);
    Document elsewhere = everything("/nowhere/scan.mha");
    ASSERT_TRUE(writeDocument(folder / "elsewhere.json", elsewhere));
    const std::string given = "--document \"" + folder / "elsewhere.json" + "\"";
    const std::string named = "\"" + shapesFile() + "\" " + given;
    EXPECT_EQ(apart(pictureOf(named, folder), document, firstPane), 0);
    EXPECT_EQ(apart(pictureOf(named + " --study-memory 64 --conversion-memory 64 --raw-header-bytes 0", folder),
                    document, firstPane),
              0);
    EXPECT_EQ(runProgram("render " + given + " -o \"" + folder / "p.png" + "\"").status, 3);
}

TEST(RenderDocument, IsEachFrameOfTheDocumentsMotion) {
    const Folder folder;
    const std::string file = phantomFile("moving.mha", "--size 56 --phases 3 --seed 4");
    Document document;
    document.study = StudyFile{.path = file, .options = {}, .checksum = {}};
    document.scene.pose.direction = {.azimuth = 20, .elevation = -8};
    document.motion.otfPhase = 1;
    const auto study = readStudy(file);
    ASSERT_TRUE(study);
    for (const MotionScenario scenario : {MotionScenario::object, MotionScenario::both})
        for (const MotionOtf otf : {MotionOtf::oneOtf, MotionOtf::eachView}) {
            document.motion.scenario = scenario;
            document.motion.otf = otf;
            PaneFrames frames(document, firstPane, {.scans = study->phases});
            ASSERT_TRUE(writeDocument(folder / "frame.json", frames.documentOf(2)));
            const cv::Mat rendered = pictureOf("--document \"" + folder / "frame.json" + "\"", folder);
            std::vector<std::uint8_t> rgb = overBackground(frames.picture(2, 70, 52)->picture, {0, 0, 0});
            cv::Mat frame(52, 70, CV_8UC3, rgb.data()), channels;
            cv::cvtColor(frame, channels, cv::COLOR_RGB2BGR);
            EXPECT_EQ(cv::norm(rendered, channels, cv::NORM_INF), 0.0) << nameOf(scenario) << ' ' << nameOf(otf);
        }
}

TEST(RenderDocument, SaysWhatItCannotDo) {
    const Folder folder;
    Document document = everything(shapesFile());
    ASSERT_TRUE(writeDocument(folder / "document.json", document));
    const std::string given = "--document \"" + folder / "document.json" + "\" -o \"" + folder / "p.png" + "\" ";
    const auto refused = [&](const std::string& options, const std::string& word) {
        const Outcome outcome = runProgram("render " + options);
        EXPECT_EQ(outcome.status, 2) << options << ": " << outcome.errors;
        EXPECT_NE(outcome.errors.find(word), std::string::npos) << outcome.errors;
    };
    refused("-o \"" + folder / "p.png" + "\"", "VOLUME");
    refused("--view 1 -o \"" + folder / "p.png" + "\"", "--document");
    refused(given + "--view 7", "none is number 7");
    refused(given + "--mode maximum", "--mode");
    refused(given + "--near 3", "--near");
    // VOLUME takes its options, and says itself what is wrong with them.
    const std::string named = "\"" + shapesFile() + "\" " + given;
    refused(named + "--series 1", "names a series of a folder");
    for (const char* polar :
         {"--raw-polar linear", "--raw-range 0,1", "--raw-lines 0,1", "--raw-planes 0,1", "--raw-radius 1"})
        refused(named + polar, "--raw-size is missing");
    refused(named + "--phase 0", "--phase plays no part beside --document.");
    for (const char* option : {"--series 1", "--study-memory 64", "--all-voxels"})
        refused(given + option, "plays no part beside --document without VOLUME");
    refused("--document \"" + folder / "document.json" + "\" -o \"" + folder / "document.json" + "\"", "document.json");
    document.scene.phase = 3;
    ASSERT_TRUE(writeDocument(folder / "late.json", document));
    refused("--document \"" + folder / "late.json" + "\" -o \"" + folder / "p.png" + "\"", "phase 3");
    document = everything({});
    document.study = {};
    ASSERT_TRUE(writeDocument(folder / "nothing.json", document));
    refused("--document \"" + folder / "nothing.json" + "\" -o \"" + folder / "p.png" + "\"", "no study");
    write(folder / "broken.json", "{");
    EXPECT_EQ(runProgram("render --document \"" + folder / "broken.json" + "\" -o \"" + folder / "p.png" + "\"").status,
              3);
}

TEST(RenderDocument, ASessionsVolumeThatMovedIsFoundAndOneThatChangedIsSaid) {
    const Folder folder;
    std::filesystem::create_directories(folder / "volumes");
    const std::string volume = folder / "volumes/shapes.mha", session = folder / "shapes.session.json";
    std::filesystem::copy_file(shapesFile(), volume);
    SavedSession saved{.document = everything(volume)};
    saved.document.study =
        withChecksum(std::get<StudyFile>(saved.document.study), checksumOf(readStudy(volume)->files).value());
    saved.snapshots = {{"one", saved.document}};
    ASSERT_TRUE(writeSession(session, asNamedFrom(session, saved)));
    const std::string render = "render --document \"" + session + "\" --size 70x52 -o \"" + folder / "p.png" + "\"";
    const auto errors = [&] {
        const Outcome outcome = runProgram(render);
        EXPECT_EQ(outcome.status, 0) << outcome.errors;
        EXPECT_EQ(apart(cv::imread(folder / "p.png", cv::IMREAD_COLOR), saved.document, firstPane), 0);
        return outcome.errors;
    };
    EXPECT_EQ(errors(), "");
    std::filesystem::create_directories(folder / "elsewhere");
    std::filesystem::rename(volume, folder / "elsewhere/renamed.mha");
    EXPECT_NE(errors().find("its bytes were found in"), std::string::npos);
    std::filesystem::rename(folder / "elsewhere/renamed.mha", volume);
    std::ofstream(volume, std::ios::app) << " ";
    EXPECT_NE(errors().find("bytes, and had"), std::string::npos);
    std::filesystem::remove(volume);
    EXPECT_EQ(runProgram(render).status, 3);
}

}  // namespace
}  // namespace echolucent
