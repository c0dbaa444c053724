// Movies and series of pictures from the window, with real events: what is written, and what is left.
#include <fcntl.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QAction>
#include <QCloseEvent>
#include <QDir>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QProgressBar>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "app/window/theme.h"
#include "processing/pane_picture/pane_picture.h"
#include "tests/app/movie_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/casting/picture_image.h"
#include "widgets/controls/run_status.h"
#include "widgets/picture_labels/measurement_drawing.h"

using namespace echolucent;

class TestMainWindowMovie : public QObject, private MovieFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        wearTheme(Theme::dark);
        writeStudies();
    }
    void init() { showWindow(); }
    void cleanup() { close(); }

    void aMovieOfThePhasesIsWrittenByTheDialog_data() {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<double>("rmse");  // levels
        QTest::newRow("avi") << ".avi" << 8.0;
        QTest::newRow("mp4") << ".mp4" << 10.0;
        QTest::newRow("mkv") << ".mkv" << 0.0;
    }
    void aMovieOfThePhasesIsWrittenByTheDialog() {
        QFETCH(QString, ending);
        QFETCH(double, rmse);
        open(moving());
        playThePhases();
        const QString path = out().filePath("heart" + ending);
        QTest::keyClick(&window(), Qt::Key_P, Qt::ShiftModifier);
        QDialog* dialog = theDialog();
        QCOMPARE(in<QLabel>(dialog, "plays")->text(), QString("Volumes in time, 1 to 4"));
        // As it plays where the time between phases is not known.
        QCOMPARE(in<QDoubleSpinBox>(dialog, "rate")->value(), assumedPhasesPerSecond);
        type(in<QSpinBox>(dialog, "width"), "129");
        type(in<QSpinBox>(dialog, "height"), "96");
        QCOMPARE(in<QSpinBox>(dialog, "width")->value(), 128);
        type(in<QDoubleSpinBox>(dialog, "rate"), "12.5");
        tick(in<QCheckBox>(dialog, "labels"));
        QVERIFY(!in<QCheckBox>(dialog, "labels")->isChecked());
        write(in<QLineEdit>(dialog, "path"), path);
        QCOMPARE(in<QLabel>(dialog, "sentence")->text(), QString("4 frames, 0.3 s"));
        QVERIFY(save(dialog));
        QCOMPARE(message()->text(), QString("heart%1 was saved.").arg(ending));
        QCOMPARE(message()->kind(), MessageKind::info);
        QCOMPARE(QDir(out().path()).entryList(QDir::Files), QStringList{"heart" + ending});

        cv::VideoCapture movie(path.toStdString(), cv::CAP_FFMPEG);
        QVERIFY(movie.isOpened());
        QVERIFY(std::abs(movie.get(cv::CAP_PROP_FPS) - 12.5) < 1e-3);
        std::vector<cv::Mat> expected;
        for (int phase = 0; phase < phaseCount; ++phase) {
            std::vector<std::uint8_t> rgb = alone(phase, QSize(128, 96));
            cv::cvtColor(cv::Mat(96, 128, CV_8UC3, rgb.data()), expected.emplace_back(), cv::COLOR_RGB2BGR);
        }
        cv::Mat frame;
        int count = 0;
        for (; movie.read(frame) && count < phaseCount; ++count) {
            QCOMPARE(frame.cols, 128);
            QCOMPARE(frame.rows, 96);
            std::vector<double> apart;
            for (const cv::Mat& phase : expected)
                apart.push_back(std::sqrt(cv::norm(frame, phase, cv::NORM_L2SQR) / (128 * 96 * 3.0)));
            const double own = apart[static_cast<std::size_t>(count)];
            QVERIFY2(own <= rmse, qPrintable(QString("frame %1: RMSE %2").arg(count).arg(own)));
            // What a codec loses may be more than what moves from phase to phase, but no other phase is as near.
            QCOMPARE(std::ranges::min_element(apart) - apart.begin(), count);
        }
        QCOMPARE(count, phaseCount);
    }

    void aMovieOfThreeBeatsShowsItsFramesThreeTimes() {
        open(moving());
        playThePhases();
        const QString path = out().filePath("beats.mkv");
        QTest::keyClick(&window(), Qt::Key_P, Qt::ShiftModifier);
        QDialog* dialog = theDialog();
        type(in<QSpinBox>(dialog, "width"), "64");
        type(in<QSpinBox>(dialog, "height"), "48");
        QCOMPARE(in<QDoubleSpinBox>(dialog, "length")->value(), 1.0);
        type(in<QDoubleSpinBox>(dialog, "length"), "3");
        write(in<QLineEdit>(dialog, "path"), path);
        QCOMPARE(in<QLabel>(dialog, "sentence")->text(), QString("12 frames, 0.6 s"));
        QVERIFY(save(dialog));
        cv::VideoCapture movie(path.toStdString(), cv::CAP_FFMPEG);
        std::vector<cv::Mat> frames;
        for (cv::Mat frame; movie.read(frame);) frames.push_back(frame.clone());
        QCOMPARE(frames.size(), std::size_t{3 * phaseCount});
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const std::size_t first = i % phaseCount;
            QCOMPARE(cv::norm(frames[i], frames[first], cv::NORM_INF), 0.0);
            if (first > 0) QVERIFY(cv::norm(frames[i], frames[0], cv::NORM_INF) > 0.0);
        }
    }

    void aSeriesIsThePicturesToTheBit() {
        open(moving());
        playThePhases();
        child<QAction>("file.savePictureSeries")->trigger();
        QDialog* dialog = theDialog();
        QVERIFY(!in<QDoubleSpinBox>(dialog, "rate")->isVisible());
        type(in<QSpinBox>(dialog, "width"), "51");  // pictures may have odd sizes
        type(in<QSpinBox>(dialog, "height"), "37");
        tick(in<QCheckBox>(dialog, "labels"));
        write(in<QLineEdit>(dialog, "path"), out().filePath("heart.png"));
        QVERIFY(save(dialog));
        QCOMPARE(message()->text(), QString("heart-0001.png to heart-0004.png were saved."));
        const QStringList files = QDir(out().path()).entryList(QDir::Files);
        QCOMPARE(files, (QStringList{"heart-0001.png", "heart-0002.png", "heart-0003.png", "heart-0004.png"}));
        for (int frame = 0; frame < phaseCount; ++frame) {
            const QImage written(out().filePath(files[frame]));
            QCOMPARE(written.size(), QSize(51, 37));
            QCOMPARE(rgbBytesOf(written), alone(frame, QSize(51, 37)));
        }
    }

    void labelsStandInTheCornersAndNowhereElse() {
        open(moving());
        playThePhases();
        window().document().change("beam axis", [](Document& next) { next.beam.source = BeamSource::person; });
        QTRY_VERIFY(window().idle());  // the sides along that beam are found
        const QSize size(320, 240);
        window().movieFiles().begin(FrameOutput::series, {.path = out().filePath("with.png"), .size = size});
        QVERIFY(ended());
        window().movieFiles().begin(FrameOutput::series,
                                    {.path = out().filePath("without.png"), .size = size, .labels = false});
        QVERIFY(ended());
        const QImage first(out().filePath("with-0001.png")), plain(out().filePath("without-0001.png")),
            second(out().filePath("with-0002.png")), secondPlain(out().filePath("without-0002.png"));
        const auto differing = [](const QImage& a, const QImage& b, const QRect& where) {
            int pixels = 0;
            for (int y = where.top(); y <= where.bottom(); ++y)
                for (int x = where.left(); x <= where.right(); ++x) pixels += a.pixel(x, y) != b.pixel(x, y);
            return pixels;
        };
        const QRect caption(0, 0, 150, 60), frame(170, 0, 150, 40), marker(0, 130, 130, 110), bar(230, 190, 90, 50);
        for (const QRect& corner : {caption, frame, marker, bar}) QVERIFY(differing(first, plain, corner) > 20);
        QCOMPARE(differing(first, plain, QRect(140, 70, 60, 100)), 0);
        // The words of the frame follow it: what is written there differs from picture to picture.
        int words = 0;
        for (int y = frame.top(); y <= frame.bottom(); ++y)
            for (int x = frame.left(); x <= frame.right(); ++x)
                words += (first.pixel(x, y) != plain.pixel(x, y)) != (second.pixel(x, y) != secondPlain.pixel(x, y));
        QVERIFY(words > 5);
    }

    void measurementsAreDrawnInTheFramesOfTheirPhase() {
        open(moving());
        playThePhases();
        Document next = window().document().document();
        const DataBox& box = phases().front()->dataBox();
        const Vec3 centre = (box.lowMm + box.highMm) * 0.5;
        next.measurements.push_back({.placesMm = {centre - Vec3(15, 0, 0), centre + Vec3(15, 0, 0)}, .phase = 1});
        window().document().edit(next, "measure");
        const auto coloured = [&](const QString& name) {
            const QImage image(out().filePath(name));
            int pixels = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) pixels += image.pixelColor(x, y) == measurementColour;
            return pixels;
        };
        window().movieFiles().begin(FrameOutput::series, {.path = out().filePath("with.png"), .size = {160, 120}});
        QVERIFY(ended());
        window().movieFiles().begin(FrameOutput::series,
                                    {.path = out().filePath("without.png"), .size = {160, 120}, .labels = false});
        QVERIFY(ended());
        QVERIFY(coloured("with-0002.png") > 20);
        QCOMPARE(coloured("with-0001.png"), 0);
        QCOMPARE(coloured("without-0002.png"), 0);
    }

    void cancelLeavesNoFile_data() {
        QTest::addColumn<bool>("series");
        QTest::newRow("movie") << false;
        QTest::newRow("series") << true;
    }
    void cancelLeavesNoFile() {
        QFETCH(bool, series);
        open(still());  // 180 frames
        child<RunStatus>("status")->setProgressDelay(0);
        QFile old(out().filePath("heart-0001.png"));
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        const QString name = series ? "heart.png" : "heart.mp4";
        QSignalSpy progressed(&window().works(), &Works::progressed);
        window().movieFiles().begin(series ? FrameOutput::series : FrameOutput::movie,
                                    {.path = out().filePath(name), .size = {256, 256}, .replace = true});
        QVERIFY(!window().idle());
        QTRY_VERIFY_WITH_TIMEOUT(progressed.count() > 2, 30000);
        QVERIFY(
            child<QLabel>("status.activity")->text().contains(series ? "writing the pictures" : "writing the movie"));
        QTRY_VERIFY(child<QToolButton>("status.cancel")->isVisible());
        QVERIFY(child<QProgressBar>("status.progress")->value() < child<QProgressBar>("status.progress")->maximum());
        // The window is in use meanwhile: the edit is no part of the movie, and nothing waits for it.
        QTest::keyClick(&window(), Qt::Key_3);
        QVERIFY(window().document().steps().canUndo());
        QSignalSpy told(&window().movieFiles(), &MovieFiles::ended);
        click("status.cancel");
        QVERIFY(told.count() == 1 || told.wait(30000));
        QCOMPARE(told.first().first().toBool(), false);
        QVERIFY2(message()->text().contains("was cancelled; no file is left"), qPrintable(message()->text()));
        QCOMPARE(QDir(out().path()).entryList(QDir::Files), QStringList{"heart-0001.png"});
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("old"));
        QTRY_VERIFY_WITH_TIMEOUT(window().idle(), 30000);
    }

    void closingTheWindowLeavesNoFile_data() {
        QTest::addColumn<bool>("byThePerson");
        QTest::newRow("closed by a person, and there until the program ends") << true;
        QTest::newRow("destroyed with what it writes") << false;
    }
    void closingTheWindowLeavesNoFile() {
        QFETCH(bool, byThePerson);
        open(still());
        QSignalSpy progressed(&window().works(), &Works::progressed);
        window().movieFiles().begin(FrameOutput::movie, {.path = out().filePath("heart.mp4"), .size = {256, 256}});
        QTRY_VERIFY_WITH_TIMEOUT(progressed.count() > 0, 30000);
        if (byThePerson) {
            QSignalSpy told(&window().movieFiles(), &MovieFiles::ended);
            QCloseEvent closing;
            QCoreApplication::sendEvent(&window(), &closing);
            QVERIFY(closing.isAccepted());
            QVERIFY(told.count() == 1 || told.wait(30000));
            QCOMPARE(told.first().first().toBool(), false);
            QVERIFY2(message()->text().contains("was cancelled"), qPrintable(message()->text()));
        } else {
            close();
        }
        QCOMPARE(QDir(out().path()).entryList(QDir::Files), QStringList());
    }

    void whatIsWrittenIsWhatWasShownWhenItWasBegun() {
        open(moving());
        playThePhases();
        const Document asked = window().document().document();
        window().movieFiles().begin(FrameOutput::series,
                                    {.path = out().filePath("heart.png"), .size = {48, 48}, .labels = false});
        QTest::keyClick(&window(), Qt::Key_5);  // another curve
        window().open(still());                 // and another study
        QVERIFY(ended());
        const auto picture = panePicture(frameOf(asked, 3), firstPane, phases(), 48, 48);
        QCOMPARE(rgbBytesOf(QImage(out().filePath("heart-0004.png"))), overBackground(picture->picture, {0, 0, 0}));
        waitUntilIdle();
    }

    /// The GUI thread begins the movie, and then does nothing but wait until the movie is in its place: whatever makes
    /// it runs elsewhere.
    void whatMakesAMovieRunsOutsideTheGuiThread() {
        open(moving());
        playThePhases();
        const QString movie = out().filePath("heart.mp4");
        const int notices = inotify_init1(IN_CLOEXEC);
        QVERIFY(inotify_add_watch(notices, QFile::encodeName(out().path()).constData(), IN_MOVED_TO) >= 0);
        QSignalSpy told(&window().movieFiles(), &MovieFiles::ended);
        window().movieFiles().begin(FrameOutput::movie, {.path = movie, .size = {256, 256}, .replace = true});
        QVERIFY(window().movieFiles().busy());
        pollfd waiting{.fd = notices, .events = POLLIN, .revents = 0};
        const int came = poll(&waiting, 1, 60000);
        ::close(notices);
        QCOMPARE(came, 1);
        QVERIFY(QFileInfo(movie).size() > 1000);
        QCOMPARE(told.count(), 0);  // that comes with the event loop
        QVERIFY(told.wait(60000));
        QVERIFY2(told.first().first().toBool(), qPrintable(told.first().at(1).toString()));
    }

    void aPipeIsRefusedAtOnce() {
        open(moving());
        const QString pipe = out().filePath("pipe.mp4");
        QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        QSignalSpy told(&window().movieFiles(), &MovieFiles::ended);
        window().movieFiles().begin(FrameOutput::movie, {.path = pipe, .size = {64, 64}, .replace = true});
        QVERIFY(!window().movieFiles().busy());
        QCOMPARE(told.count(), 1);
        QVERIFY2(told.first().at(1).toString().contains("it is a named pipe"),
                 qPrintable(told.first().at(1).toString()));
    }

private:
    /// The document that shows a phase, its OTF computed along the view.
    static Document frameOf(Document document, int phase) {
        document.scene.phase = phase;
        document.scene.side = document.scene.pose.direction;
        return document;
    }
    /// The picture of a phase by itself.
    std::vector<std::uint8_t> alone(int phase, const QSize& size) {
        const auto picture = panePicture(frameOf(window().document().document(), phase), firstPane,
                                         window().openStudy().study()->phases, size.width(), size.height());
        return overBackground(picture->picture, {0, 0, 0});
    }
};

ECHOLUCENT_TEST_CLASS(TestMainWindowMovie)

#include "test_main_window_movie.moc"
