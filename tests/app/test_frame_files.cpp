// The frames of a real 4D study as files, without a window: bits of pictures, errors of codecs.
#include <QApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "app/motion/frame_files.h"
#include "io/study/study.h"
#include "processing/document/panes.h"
#include "processing/pane_picture/pane_picture.h"
#include "processing/sides/side_search.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/casting/picture_image.h"
#include "widgets/compare/compare_grid.h"

using namespace echolucent;

class TestFrameFiles : public QObject {
    Q_OBJECT

private slots:
    void filesAreNumberedFromOne() {
        const MovieChoice choice{.path = "/x/heart.b.png"};
        QCOMPARE(filesOf(FrameOutput::series, choice, 2),
                 (std::vector<std::string>{"/x/heart.b-0001.png", "/x/heart.b-0002.png"}));
        QCOMPARE(filesOf(FrameOutput::series, choice, 12345).front(), std::string("/x/heart.b-00001.png"));
        QCOMPARE(filesOf(FrameOutput::series, {.path = "/50%1/heart%2 %3.png"}, 1),
                 std::vector<std::string>{"/50%1/heart%2 %3-0001.png"});
        QCOMPARE(filesOf(FrameOutput::movie, choice, 5), std::vector<std::string>{"/x/heart.b.png"});
    }

    void labelsNameTheSideFromWhichThePictureIsSeen() {
        const auto scan = smallPhantom(PhantomScene::shapes, 5);
        FrameOrder order;
        order.document.motion.scenario = MotionScenario::object;
        order.document.scene.look = Look{};
        order.phases.scans = {scan, scan};
        order.output = FrameOutput::series;
        order.choice = {.path = m_out.filePath("unnamed.png"), .size = {240, 180}, .labels = true};
        QVERIFY(writeFrames(order));
        const QImage unnamed(QString::fromStdString(filesOf(order.output, order.choice, 2)[0]));
        order.sides = std::make_shared<const SidesFinding>(*findSides(*scan, {}, true));
        order.choice.path = m_out.filePath("named.png");
        QVERIFY(writeFrames(order));
        const QImage named(QString::fromStdString(filesOf(order.output, order.choice, 2)[0]));
        QVERIFY(!unnamed.isNull() && named.size() == unnamed.size());
        const QRect captionRows(0, 0, 240, 40), rest(0, 60, 240, 100);
        QVERIFY(named.copy(captionRows) != unnamed.copy(captionRows));
        QVERIFY(named.copy(rest) == unnamed.copy(rest));
    }

    void framesOfAComparisonHoldAllPanes() {
        const auto scan = smallPhantom(PhantomScene::shapes, 5);
        FrameOrder order;
        order.document.motion.scenario = MotionScenario::object;
        order.document.scene.look = Look{};
        order.document = withPanes(order.document, {{}, {.curve = CurveKind::parabolic}});
        order.phases.scans = {scan, smallPhantom(PhantomScene::shapes, 5, 0.5)};
        order.output = FrameOutput::series;
        order.compared = {{.name = "1  Adaptive"}, {.name = "2  x²"}};
        for (const bool labels : {false, true}) {
            order.choice = {.path = m_out.filePath("panes.png"), .size = {243, 180}, .labels = labels, .replace = true};
            QVERIFY(writeFrames(order));
            const QStringList names{"1  Adaptive", "2  x²"};
            const auto caption = labels ? captionLayout(names, 120, order.letters) : CaptionLayout{};
            for (int phase = 0; phase < 2; ++phase) {
                const QImage frame(
                    QString::fromStdString(filesOf(order.output, order.choice, 2)[static_cast<std::size_t>(phase)]));
                QCOMPARE(frame.size(), order.choice.size);
                Document shown = order.document;
                shown.scene.phase = phase;
                for (std::size_t pane = 0; pane < 2; ++pane) {
                    const QRect place = pictureIn(placesOfPanes(2, frame.size())[pane], caption);
                    const auto alone = panePicture(shown, pane, order.phases.scans, place.width(), place.height());
                    QCOMPARE(rgbBytesOf(frame.copy(place)), overBackground(alone->picture, {0, 0, 0}));
                }
            }
        }
    }

    /// The loop of the fetal heart, each phase with its own OTF, quiet and lit. With the variable MOVIE_EDGE the
    /// pictures have that many pixels an edge instead of 96: MOVIE_EDGE=512 prints the figures of docs/cli-sweep.md.
    void theLoopOfARealHeartIsRenderedWithinTheCodecsErrors() {
        const QString heart =
            QStringLiteral(ECHOLUCENT_SOURCE_DIR "/../shared/data/volumes/fetal_heart_4d_128x128x128x20.nrrd");
        if (!QFile::exists(heart)) QSKIP("the shared volumes are not here");
        const auto study = readStudy(heart.toStdString());
        QVERIFY(study);
        FrameOrder order;
        order.document.motion.scenario = MotionScenario::object;
        order.document.motion.otf = MotionOtf::eachView;
        order.document.beam.axis = BeamAxis::plusY;
        order.document.scene.front.depthMm = 110;
        order.phases.scans = study->phases;
        const int edge = qEnvironmentVariableIsSet("MOVIE_EDGE") ? qEnvironmentVariableIntValue("MOVIE_EDGE") : 96;
        order.choice = {.size = {edge, edge}, .framesPerSecond = 20, .labels = false};
        order.choice.path = m_out.filePath("heart.png");
        order.output = FrameOutput::series;
        QVERIFY(writeFrames(order));
        const auto paths = filesOf(order.output, order.choice, 20);
        Document thirteenth = order.document;
        thirteenth.scene.phase = 13;
        const auto alone = panePicture(thirteenth, firstPane, study->phases, edge, edge);
        QCOMPARE(rgbBytesOf(QImage(QString::fromStdString(paths[13]))), overBackground(alone->picture, {0, 0, 0}));
        std::vector<cv::Mat> expected;
        for (const std::string& path : paths) {
            std::vector<std::uint8_t> rgb = rgbBytesOf(QImage(QString::fromStdString(path)));
            cv::cvtColor(cv::Mat(edge, edge, CV_8UC3, rgb.data()), expected.emplace_back(), cv::COLOR_RGB2BGR);
        }
        order.output = FrameOutput::movie;
        for (const auto& [ending, bound] : {std::pair(".avi", 8.0), {".mp4", 10.0}, {".mkv", 0.0}}) {
            if (bound > 0 && !isLongRun()) continue;
            order.choice.path = m_out.filePath(QStringLiteral("heart") + ending);
            QElapsedTimer clock;
            clock.start();
            QVERIFY(writeFrames(order));
            const double seconds = static_cast<double>(clock.elapsed()) * 1e-3;
            cv::VideoCapture movie(order.choice.path.toStdString(), cv::CAP_FFMPEG);
            QVERIFY(std::abs(movie.get(cv::CAP_PROP_FPS) - 20) < 1e-3);
            cv::Mat frame, apart;
            double squares = 0, largest = 0;
            std::size_t count = 0;
            for (; movie.read(frame); ++count) {
                QVERIFY(count < paths.size() && frame.size() == cv::Size(edge, edge));
                // No other phase is as near as its own, so that two of them that were exchanged are seen.
                const auto nearest = std::ranges::min_element(
                    expected, {}, [&](const cv::Mat& phase) { return cv::norm(frame, phase, cv::NORM_L2SQR); });
                QCOMPARE(static_cast<std::size_t>(nearest - expected.begin()), count);
                cv::absdiff(frame, expected[count], apart);
                double most = 0;
                cv::minMaxLoc(apart.reshape(1), nullptr, &most);
                largest = std::max(largest, most);
                squares += cv::norm(apart, cv::NORM_L2SQR) / (3.0 * edge * edge);
            }
            QCOMPARE(count, paths.size());
            const double rmse = std::sqrt(squares / static_cast<double>(count));
            qInfo("%s of 20 frames of %d x %d: RMSE %.2f, largest error %.0f levels, %lld bytes a frame, %.1f s",
                  ending, edge, edge, rmse, largest, static_cast<long long>(QFileInfo(order.choice.path).size() / 20),
                  seconds);
            QVERIFY(rmse <= bound);
        }
    }

private:
    QTemporaryDir m_out;
};

ECHOLUCENT_TEST_CLASS(TestFrameFiles, "theLoopOfARealHeartIsRenderedWithinTheCodecsErrors")
#include "test_frame_files.moc"
