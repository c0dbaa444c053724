#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <vector>

#include "io/study/study.h"
#include "processing/document/opening_finds.h"
#include "processing/pane_picture/pane_frames.h"
#include "processing/pane_picture/pane_picture.h"

#include "otf_of.h"
#include "program.h"
#include "tables.h"

namespace echolucent {
namespace {

using nlohmann::json;

std::vector<double> opacitiesOf(const std::vector<std::string>& row) {
    std::vector<double> opacities;
    for (std::size_t i = 5; i < row.size(); ++i) opacities.push_back(std::stod(row[i]));
    return opacities;
}

std::vector<std::vector<std::string>> sweptRows(const std::string& arguments) {
    const Outcome outcome = runProgram("sweep " + arguments + " --reduction off --csv -");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return rowsOf(outcome.output);
}

/// The path stands in quotes for the shell; it is appended piece by piece, since GCC 12 sees an overlap in "\"" + path
/// that is not there.
std::string quoted(const std::string& path) {
    std::string text(1, '"');
    text += path;
    text += '"';
    return text;
}

std::string movingFile() { return phantomFile("moving.mha", "--size 56 --phases 3 --seed 4"); }

TEST(SweepCsv, HoldsAFrameARowWithTheOtfOfItsView) {
    const auto rows =
        sweptRows(quoted(shapesFile()) + " --beam-axis +z --axis x --from -10 --to 10 --step 5 --smoothing none");
    ASSERT_EQ(rows.size(), 6u);
    ASSERT_EQ(rows[0].size(), 5u + 256);
    EXPECT_EQ(rows[0][0], "frame");
    EXPECT_EQ(rows[0][3], "sum_of_d");
    EXPECT_EQ(rows[0].back(), "opacity_255");
    for (const std::size_t row : {1, 4}) {
        ASSERT_EQ(rows[row].size(), 5u + 256);
        const json otf = otfOf(shapesFile(), "--view-elevation " + rows[row][1]);
        EXPECT_EQ(opacitiesOf(rows[row]), otf["otf"]["opacity"].get<std::vector<double>>());
        double sumOfD = 0;
        for (const json& tube : otf["tubes"]) sumOfD += tube["d"].get<double>();
        EXPECT_EQ(std::stod(rows[row][3]), sumOfD);
    }
    EXPECT_EQ(rows[1][1], "-10");
    EXPECT_EQ(rows[5][1], "10");
}

TEST(SweepCsv, SmoothingIsThatOfItsName) {
    const std::string sweep = quoted(shapesFile()) + " --from 0 --to 4 --smoothing ";
    const auto raw = sweptRows(sweep + "none"), mean = sweptRows(sweep + "mean");
    for (std::size_t sample = 5; sample < raw[0].size(); ++sample) {
        double sum = 0;
        for (std::size_t row = 1; row <= 5; ++row) sum += std::stod(raw[row][sample]);
        EXPECT_NEAR(std::stod(mean[5][sample]), sum / 5, 1e-14);
        EXPECT_EQ(mean[1][sample], raw[1][sample]);
    }
    EXPECT_EQ(sweptRows(quoted(shapesFile()) + " --from 0 --to 4"),
              sweptRows(quoted(shapesFile()) + " --from 0 --to 4 --static"));
}

TEST(SweepCsv, StaticShowsTheOtfOfTheGivenView) {
    const auto rows = sweptRows(quoted(shapesFile()) + " --from -2 --to 2 --static --view-azimuth 7");
    const auto expected = otfOf(shapesFile(), "--view-azimuth 7")["otf"]["opacity"].get<std::vector<double>>();
    for (std::size_t row = 1; row < rows.size(); ++row) EXPECT_EQ(opacitiesOf(rows[row]), expected);
}

TEST(SweepCsv, CoversThePapersThreeScenarios) {
    const auto phasesAndAngles = [](const std::string& options) {
        std::vector<std::pair<std::string, std::string>> found;
        for (const auto& row : sweptRows(quoted(movingFile()) + " --from 0 --to 4 " + options))
            if (row[0] != "frame") found.emplace_back(row[2], row[1]);
        return found;
    };
    using Expected = std::vector<std::pair<std::string, std::string>>;
    EXPECT_EQ(phasesAndAngles("--probe moving --object still --phase 1"),
              (Expected{{"1", "0"}, {"1", "1"}, {"1", "2"}, {"1", "3"}, {"1", "4"}}));
    EXPECT_EQ(phasesAndAngles("--probe still"), (Expected{{"0", "0"}, {"1", "0"}, {"2", "0"}, {"0", "0"}, {"1", "0"}}));
    const Expected both{{"2", "0"}, {"0", "1"}, {"1", "2"}, {"2", "3"}, {"0", "4"}};
    EXPECT_EQ(phasesAndAngles("--probe moving --phase 2"), both);
    EXPECT_EQ(phasesAndAngles("--phase 2"), both) << "angles move the probe";
}

TEST(SweepCsv, AnAxisMovesTheProbe) {
    const auto still = sweptRows(quoted(movingFile())), turned = sweptRows(quoted(movingFile()) + " --axis x");
    EXPECT_EQ(still.size(), 1u + 3) << "the object's phases";
    EXPECT_EQ(turned, sweptRows(quoted(movingFile()) + " --axis x --probe moving"));
    EXPECT_EQ(turned[1][1], "-45");
    const Outcome refused = runProgram("sweep " + quoted(movingFile()) + " --axis x --probe still");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.errors.find("--axis plays no part beside --probe still"), std::string::npos) << refused.errors;
}

TEST(SweepCsv, IsTheSameOnAnyNumberOfThreads) {
    const std::string sweep = quoted(movingFile()) + " --probe moving --smoothing least-flicker --step 15 --threads ";
    EXPECT_EQ(sweptRows(sweep + "1"), sweptRows(sweep + "5"));
}

/// RMS of the second temporal difference of the table's opacities.
double flickerOf(const std::vector<std::vector<std::string>>& rows) {
    double squares = 0;
    std::size_t count = 0;
    for (std::size_t row = 3; row < rows.size(); ++row) {
        const auto now = opacitiesOf(rows[row]), before = opacitiesOf(rows[row - 1]),
                   second = opacitiesOf(rows[row - 2]);
        for (std::size_t i = 0; i < now.size(); ++i, ++count)
            squares += std::pow(now[i] - 2 * before[i] + second[i], 2);
    }
    return std::sqrt(squares / static_cast<double>(count));
}

TEST(SweepJson, HoldsFramesGainsAndFlicker) {
    const Folder folder;
    const std::string sweep = quoted(shapesFile()) + " --from -15 --to 15 ";
    const Outcome outcome = runProgram(
        "sweep " + sweep + "--reduction off --smoothing least-flicker --json - --csv \"" + folder / "shown.csv" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const json report = json::parse(outcome.output);
    EXPECT_EQ(report["smoothing"], "least-flicker");
    EXPECT_EQ(report["gains"]["delay_frames"], 2.0);
    EXPECT_NEAR(report["gains"]["flicker_gain"].get<double>(), 0.081, 1e-3);
    EXPECT_EQ(report["motion"]["axis"], "screen_vertical");
    EXPECT_TRUE(report["picture_flicker"].is_null());
    ASSERT_EQ(report["frames"].size(), 31u);
    EXPECT_EQ(report["frames"][3]["degrees"], -12.0);
    EXPECT_GT(report["frames"][3]["sum_of_d"].get<double>(), 0.1);
    EXPECT_GT(report["frames"][3]["tubes_with_surface"].get<int>(), 10);
    const json& flicker = report["otf_flicker"];
    EXPECT_NEAR(flicker["shown"].get<double>(), flickerOf(rowsOf(contentsOf(folder / "shown.csv"))), 1e-12);
    EXPECT_NEAR(flicker["unsmoothed"].get<double>(), flickerOf(sweptRows(sweep + "--smoothing none")), 1e-12);
    EXPECT_LE(flicker["ratio"].get<double>(), 0.25);
}

TEST(SweepJson, PicturesFlickerLessToo) {
    const Outcome outcome = runProgram(
        "sweep \"" + shapesFile() +
        "\" --from -45 --smoothing least-flicker --reduction off --picture-flicker --lighting flat --size 32x32 "
        "--json -");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const json report = json::parse(outcome.output);
    EXPECT_GT(report["picture_flicker"]["unsmoothed"].get<double>(), 0.0);
    // The paper's moving least squares leaves three quarters.
    EXPECT_LE(report["picture_flicker"]["ratio"].get<double>(), 0.3);
    EXPECT_LT(report["picture_change"]["ratio"].get<double>(), 0.7);
}

TEST(LongSweepOfRealData, FlickerOfTheHeartFallsToAQuarter) {
    const std::string file = ECHOLUCENT_SOURCE_DIR "/../shared/data/volumes/fetal_heart_4d_128x128x128x20.nrrd";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the shared volumes are not here";
    for (const std::string options : {"--probe moving --object still", "--probe moving", "--probe still"}) {
        const Outcome outcome = runProgram("sweep \"" + file +
                                           "\" --beam-axis +y --near 110 --reduction off --smoothing least-flicker "
                                           "--from -45 --json - " +
                                           options);
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        const json flicker = json::parse(outcome.output)["otf_flicker"];
        EXPECT_GT(flicker["unsmoothed"].get<double>(), 1e-4);
        EXPECT_LE(flicker["ratio"].get<double>(), 0.25) << options;
    }
}

/// The document with which the window opens a file, with fresh settings, in a picture of this shape.
Document windowsDocument(const Study& study, double aspect) {
    const Volume& first = *study.phases.front();
    return openedDocuments(
               {},
               {.box = first.dataBox(), .phases = static_cast<int>(study.phases.size()), .finds = findOnOpening(first)},
               aspect)
        .found;
}

/// The frames of a movie, as OpenCV reads them.
std::vector<cv::Mat> framesOf(const std::string& movie) {
    cv::VideoCapture capture(movie, cv::CAP_FFMPEG);
    std::vector<cv::Mat> frames;
    for (cv::Mat frame; capture.read(frame);) frames.push_back(frame.clone());
    return frames;
}

cv::Mat imageOf(const Picture& picture) {
    std::vector<std::uint8_t> rgb = overBackground(picture, {0, 0, 0});
    cv::Mat image;
    cv::cvtColor(cv::Mat(picture.height, picture.width, CV_8UC3, rgb.data()), image, cv::COLOR_RGB2BGR);
    return image;
}

TEST(SweepMovie, HoldsTheWindowsMotion) {
    const Folder folder;
    const auto study = readStudy(movingFile());
    ASSERT_TRUE(study);
    const std::string sweep = "sweep " + quoted(movingFile()) + " --size 64x48 --movie " + quoted(folder / "m.mkv");
    for (const std::string smoothing : {"", " --smoothing least-flicker"}) {
        const Outcome outcome = runProgram(sweep + smoothing);
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        Document document = windowsDocument(*study, 64.0 / 48.0);
        if (!smoothing.empty()) document.motion.otf = MotionOtf::leastFlicker;
        PaneFrames window(document, firstPane, {.scans = study->phases});
        const std::vector<cv::Mat> frames = framesOf(folder / "m.mkv");
        ASSERT_EQ(static_cast<int>(frames.size()), window.count()) << "the object of a 4D study moves";
        for (int i = 0; i < window.count(); ++i) {
            const cv::Mat expected = imageOf(window.picture(i, 64, 48)->picture);
            EXPECT_GT(cv::mean(expected)[1], 3.0) << "there is something to compare";
            EXPECT_EQ(cv::norm(frames[static_cast<std::size_t>(i)], expected, cv::NORM_INF), 0.0) << smoothing << i;
        }
    }
}

TEST(SweepMovie, HoldsTheRenderedFrames) {
    const Folder folder;
    const auto study = readStudy(shapesFile());
    Document document = windowsDocument(*study, 96.0 / 64.0);
    document.scene.motionAngle = 30;
    document.panes.front().motionOtf = MotionOtf::eachView;
    const cv::Mat rendered = imageOf(panePicture(document, firstPane, study->phases, 96, 64)->picture);
    // The bounds of docs/cli-sweep.md, levels.
    for (const auto& [ending, rmse] : {std::pair(".avi", 8.0), {".mp4", 10.0}, {".mkv", 0.0}}) {
        const std::string path = folder / (std::string("m") + ending);
        const Outcome outcome = runProgram("sweep \"" + shapesFile() +
                                           "\" --from 0 --to 30 --step 10 --smoothing none "
                                           "--size 96x64 --frame-rate 12.5 --movie \"" +
                                           path + "\"");
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        EXPECT_EQ(outcome.output, "");
        EXPECT_NEAR(cv::VideoCapture(path, cv::CAP_FFMPEG).get(cv::CAP_PROP_FPS), 12.5, 1e-3) << ending;
        const std::vector<cv::Mat> frames = framesOf(path);
        ASSERT_EQ(frames.size(), 4u) << ending;
        const cv::Mat& last = frames.back();
        ASSERT_EQ(last.size(), cv::Size(96, 64));
        EXPECT_LE(cv::norm(rendered, last, cv::NORM_L2) / std::sqrt(static_cast<double>(last.total() * 3)), rmse)
            << ending;
    }
}

TEST(SweepMovie, ShowsItsFramesOverAndOver) {
    const Folder folder;
    const std::string path = folder / "m.mkv";
    const std::string sweep = "sweep " + quoted(movingFile()) + " --size 48x32 --movie " + quoted(path);
    const std::size_t phases = readStudy(movingFile())->phases.size();
    const auto expectLoops = [&](const std::string& options, std::size_t pictures) {
        const Outcome outcome = runProgram(sweep + options);
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        const std::vector<cv::Mat> frames = framesOf(path);
        ASSERT_EQ(frames.size(), pictures) << options;
        for (std::size_t i = 0; i < pictures; ++i)
            EXPECT_EQ(cv::norm(frames[i], frames[i % phases], cv::NORM_INF), 0.0) << options << ' ' << i;
        EXPECT_GT(cv::norm(frames[0], frames[1], cv::NORM_INF), 0.0) << options;
    };
    expectLoops(" --loops 3", 3 * phases);
    expectLoops(" --seconds 0.7 --frame-rate 10", 7);
}

TEST(SweepMovie, FailsInOneSentenceAndLeavesNothing) {
    const Folder folder;
    const Outcome outcome =
        runProgram("sweep \"" + shapesFile() + "\" --to -44 --size 16x16 --movie \"" + folder / "none/m.avi" + "\"");
    EXPECT_EQ(outcome.status, 4);
    EXPECT_NE(outcome.errors.find("m.avi: could not be written"), std::string::npos) << outcome.errors;
    std::filesystem::create_symlink("/dev/full", folder / "full.mp4");
    const Outcome full =
        runProgram("sweep \"" + shapesFile() + "\" --to -44 --size 16x16 --movie \"" + folder / "full.mp4" + "\"");
    EXPECT_EQ(full.status, 4);
    EXPECT_NE(full.errors.find("full.mp4"), std::string::npos) << full.errors;
}

TEST(SweepSummary, IsPrintedWhereNoFileIsAskedFor) {
    const Outcome outcome = runProgram("sweep \"" + shapesFile() + "\" --from 0 --to 2");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.output.find("3 frames, static"), std::string::npos) << outcome.output;
}

TEST(SweepUsage, AMovieOfTooManyPicturesIsRefusedBeforeAnythingIsMade) {
    const Folder folder;
    const Outcome outcome = runProgram("sweep " + quoted(shapesFile()) + " --movie \"" + folder / "m.mkv" +
                                       "\" --csv \"" + folder / "m.csv" + "\" --seconds 3600 --frame-rate 250");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.errors.find("more than 100000 pictures"), std::string::npos) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "m.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "m.mkv"));
}

TEST(SweepUsage, EndsInOneSentence) {
    const Folder folder;
    const std::vector<std::pair<std::string, std::string>> rows{
        {"--object moving", "has one phase"},
        {"--probe still", "--object moving"},
        {"--step 0", "--step"},
        {"--step nan", "--step"},
        {"--from nan", "--from"},
        {"--step 1e-9", "100000"},
        {"--smoothing median", "--smoothing"},
        {"--static --smoothing mean", "--static"},
        {"--axis w", "--axis"},
        {"--size 0x5", "--size"},
        {"--csv - --json -", "standard output"},
        {"--csv \"" + folder / "a\" --json \"" + folder / "a\"", "named twice"},
        {"--frame-rate 0", "--frame-rate"},
        {"--loops 3", "--movie"},
        {"--movie \"" + folder / "m.mkv\" --loops 0", "--loops must be 1 to 1000"},
        {"--movie \"" + folder / "m.mkv\" --seconds -1", "--seconds must be above 0"},
        {"--movie \"" + folder / "m.mkv\" --seconds 1 --loops 2", "excludes"}};
    for (const auto& [options, says] : rows) {
        const Outcome outcome = runProgram("sweep \"" + shapesFile() + "\" " + options);
        EXPECT_EQ(outcome.status, 2) << options << "\n" << outcome.errors;
        EXPECT_NE(outcome.errors.find(says), std::string::npos) << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    }
}

TEST(SweepMessage, SaysInHowManyFramesThereIsNoSurface) {
    const Folder folder;
    writeConstantVolume(folder / "constant.mha", 40, 77);
    const Outcome outcome = runProgram("sweep \"" + folder / "constant.mha" + "\" --from 0 --to 4 --json -");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.errors.ends_with("\nNo surface found in 5 of 5 frames: the initial function is used there.\n"));
    EXPECT_EQ(json::parse(outcome.output)["otf_flicker"]["unsmoothed"], 0.0);
    EXPECT_TRUE(json::parse(outcome.output)["otf_flicker"]["ratio"].is_null());
}

TEST(LongStudyMotion, WritesAPageAndTables) {
    const Folder folder;
    const Outcome outcome = runProgram("study motion \"" + movingFile() +
                                       "\" --from -4 --to 4 --picture-size 32 -o \"" + folder / "out" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const std::string page = contentsOf(folder / "out/motion.html");
    for (const std::string name : {"static", "none", "mean", "mls", "least-flicker", "Fig. 10", "the object moves"})
        EXPECT_NE(page.find(name), std::string::npos) << name;
    EXPECT_EQ(page.find(">nan<"), std::string::npos);
    const auto rows = rowsOf(contentsOf(folder / "out/motion.csv"));
    ASSERT_EQ(rows.size(), 1u + 3 * 5) << "three scenarios, five modes";
    EXPECT_EQ(rows[1][0], "volume_probe");
    EXPECT_EQ(rows[1][1], "static");
    EXPECT_EQ(std::stod(rows[1][3]), 0.0);
    EXPECT_EQ(rowsOf(contentsOf(folder / "out/otfs_volume_both_none.csv")).size(), 10u);
    EXPECT_EQ(runProgram("study motion -o /dev/null").status, 4);
}

}  // namespace
}  // namespace echolucent
