// The labels of pictures that leave the window: words, places, and a bar as long as it says.
#include <QImage>
#include <QPainter>
#include <QTest>
#include <algorithm>
#include <thread>

#include "tests/qt_program/test_classes.h"
#include "widgets/picture_labels/picture_labels.h"

using namespace echolucent;

class TestPictureLabels : public QObject {
    Q_OBJECT

private slots:
    void aFrameIsNamedByWhatMoves_data() {
        QTest::addColumn<int>("scenario");
        QTest::addColumn<double>("seconds");  // 0: not known
        QTest::addColumn<QString>("words");
        QTest::newRow("object") << static_cast<int>(MotionScenario::object) << 0.0305 << "volume 7 of 20 · 183 ms";
        QTest::newRow("unknown time") << static_cast<int>(MotionScenario::object) << 0.0 << "volume 7 of 20";
        QTest::newRow("probe") << static_cast<int>(MotionScenario::probe) << 0.0305 << "−12°";
        QTest::newRow("both") << static_cast<int>(MotionScenario::both) << 0.0305 << "volume 7 of 20 · 183 ms · −12°";
    }
    void aFrameIsNamedByWhatMoves() {
        QFETCH(int, scenario);
        QFETCH(double, seconds);
        QFETCH(QString, words);
        const MotionPosition position{.angle = -12, .phase = 6};
        QCOMPARE(frameWords(position, static_cast<MotionScenario>(scenario), 20, PhaseTimes::every(seconds)), words);
    }

    void theBarIsAsLongAsItSays_data() {
        QTest::addColumn<double>("scale");
        QTest::newRow("plain") << 1.0;
        QTest::newRow("larger labels") << 1.5;
    }
    void theBarIsAsLongAsItSays() {
        QFETCH(double, scale);
        PictureLabels labels;
        labels.camera.heightMm = 60;  // 5 pixels a millimetre: the bar has 10 mm
        const QImage image = painted({400, 300}, labels, scale);
        int longest = 0;
        for (int y = 240; y < 300; ++y) {
            int run = 0;
            for (int x = 200; x < 400; ++x)
                longest = std::max(longest, run = qRed(image.pixel(x, y)) > 150 ? run + 1 : 0);
        }
        QVERIFY2(std::abs(longest - 51) <= 2, qPrintable(QString::number(longest)));
    }

    void noLengthIsClaimedWhereTheSpacingIsUnknown() {
        PictureLabels labels;
        labels.camera.heightMm = 60;
        const QImage known = painted({400, 300}, labels), unknown = painted({400, 300}, {.spacingKnown = false});
        QVERIFY(lit(unknown, {200, 240, 200, 60}) > 100);
        QVERIFY(lit(unknown, {200, 240, 200, 60}) > lit(known, {200, 240, 200, 60}));
    }

    void wordsStandInTheUpperCorners() {
        const QImage none = painted({400, 300}, {});
        QCOMPARE(lit(none, {0, 0, 400, 100}), 0);
        const QImage caption = painted({400, 300}, {.caption = "beam +z\nlight tells depth"});
        QVERIFY(lit(caption, {0, 0, 200, 100}) > 100);
        QCOMPARE(lit(caption, {200, 0, 200, 100}), 0);
        const QImage frame = painted({400, 300}, {.frame = "volume 7 of 20"});
        QVERIFY(lit(frame, {200, 0, 200, 100}) > 100);
        QCOMPARE(lit(frame, {0, 0, 200, 100}), 0);
    }

    void theMarkerShowsTheGridsAxes() {
        PictureLabels labels;
        labels.camera.frame = frameOf(Viewpoint{});  // x goes right and y down
        const QImage image = painted({200, 200}, labels);
        constexpr int foot = 68;  // margin + arm + letter
        const QRgb alongX = image.pixel(foot + 20, 199 - foot), alongY = image.pixel(foot, 199 - foot + 20);
        QVERIFY(qRed(alongX) > qGreen(alongX) + 40);
        QVERIFY(qGreen(alongY) > qRed(alongY) + 20);
        QCOMPARE(image.pixel(foot - 20, 199 - foot), qRgb(0, 0, 0));
    }

    void labelsArePaintedTheSameInAnotherThread() {
        const PictureLabels labels{.caption = "beam +z", .frame = "+3°"};
        const QImage here = painted({320, 240}, labels);
        QImage there;
        std::thread([&] { there = painted({320, 240}, labels); }).join();
        QCOMPARE(there, here);
    }

private:
    static QImage painted(const QSize& size, const PictureLabels& labels, double scale = 1.0) {
        QImage image(size, QImage::Format_RGB888);
        image.fill(Qt::black);
        QPainter painter(&image);
        paintLabels(painter, size, labels, scale);
        return image;
    }
    static int lit(const QImage& image, const QRect& where) {
        int pixels = 0;
        for (int y = where.top(); y <= where.bottom(); ++y)
            for (int x = where.left(); x <= where.right(); ++x) pixels += qRed(image.pixel(x, y)) > 150;
        return pixels;
    }
};

ECHOLUCENT_TEST_CLASS(TestPictureLabels)
#include "test_picture_labels.moc"
