// What the 3D view shows: the ray caster's pixels on the screen, made when needed and not otherwise.
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QApplication>
#include <QProcess>
#include <QScreen>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "processing/ray_caster/ray_caster.h"
#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/shown_view.h"
#include "widgets/volume_view/scene/annotation/overlay.h"
#include "widgets/volume_view/scene/volume_scene.h"

using namespace echolucent;
using namespace echolucent::testing;

class ViewPictureTest : public QObject {
    Q_OBJECT

private slots:
    void screenShowsWhatTheRayCasterMade() {
        ShownView s;
        QVERIFY(s.ready);
        const auto expected = castRays(*s.volume, wall, s.view.settings());
        QVERIFY(expected);
        const QImage screen = s.view.screenImage();
        QCOMPARE(screen.size(), QSize(330, 250));
        QVERIFY2(largestDifference(screen, *expected) <= 2,
                 qPrintable(QString::number(largestDifference(screen, *expected))));
        // The ball lies in the corner of small x and y: upper left when looking along +z.
        const QPointF centre = brightCentre(*expected);
        QVERIFY(centre.x() < -0.1 && centre.y() < -0.1);
        QVERIFY(s.view.picture()->rgba == expected->rgba);
    }

    void whatThePersonSeesIsThere() {
        // Not from the render window but from the display itself.
        ShownView s;
        QVERIFY(s.ready);
        const auto shown = [&] {
            const QImage grabbed = s.view.screen()->grabWindow(s.view.winId()).toImage();
            return grabbed.size() == QSize(330, 250) && largestDifference(grabbed, *s.view.picture()) <= 2;
        };
        QTRY_VERIFY_WITH_TIMEOUT(shown(), patience);
    }

    void everyFrameReachesTheDisplay() {
        // With no swap interval and nothing drawn twice the newest frame must not hang one behind.
        ShownView s;
        QVERIFY(s.ready);
        for (const double opacity : {0.02, 1.0, 0.1}) {
            s.view.setClassification(ManualCurve{{{0.5, 0}, {0.5, opacity}}});
            QVERIFY(s.awaitIdle());
            QTRY_VERIFY_WITH_TIMEOUT(
                largestDifference(s.view.screen()->grabWindow(s.view.winId()).toImage(), *s.view.picture()) <= 2,
                patience);
        }
    }

    void unchangedViewCastsNothing() {
        ShownView s;
        QVERIFY(s.ready);
        QSignalSpy deliveries(&s.view, &VolumeViewWidget::pictureDelivered);
        QSignalSpy works(&s.works, &Works::changed);
        const QImage before = s.view.screenImage();
        s.view.setClassification(wall);
        s.view.setLook(s.view.look());
        s.view.setLimits(withFrontAcross(s.view.view(), 0));
        QCOMPARE(works.size(), 0);
        s.view.setView(s.view.view());
        s.view.setVolume(s.volume);
        s.view.update();
        QTRY_VERIFY_WITH_TIMEOUT(s.works.idle(), patience);
        QCOMPARE(s.view.screenImage(), before);
        QCoreApplication::processEvents();
        QCOMPARE(deliveries.size(), 0);
        QVERIFY(s.view.pictureIsFine());
    }

    void linesOverThePictureThatChangeInARowAreDrawnOnce() {
        ShownView s;
        QVERIFY(s.ready);
        int drawings = 0;
        vtkNew<vtkCallbackCommand> count;
        count->SetClientData(&drawings);
        count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
        QCoreApplication::processEvents();
        vtkRenderer* renderer = s.view.scene().renderer();
        const unsigned long observer = renderer->AddObserver(vtkCommand::StartEvent, count);
        for (const double width : {1.0, 2.0, 3.0}) {
            Overlay overlay;
            overlay.pictureLines.push_back({{{-0.2, -0.2}, {0.2, 0.2}}, {255, 255, 255}, width});
            s.view.setOverlay(overlay);
        }
        s.view.setCaption(QStringLiteral("words"));
        QVERIFY2(drawings == 0, "a hand that moves on is not held up");
        QTRY_COMPARE(drawings, 1);
        QCoreApplication::processEvents();
        QCOMPARE(drawings, 1);
        const auto shown = s.view.scene().overlay();
        QCOMPARE(shown.pictureLines.front().width, 3.0);
        QVERIFY2(s.view.screenImage() != s.view.convergedImage(), "it is seen, and in saved pictures it is not");
        // Where the picture changes with the lines, they are drawn together: once for each picture that comes.
        QVERIFY(s.awaitIdle());
        QCoreApplication::processEvents();
        drawings = 0;
        QSignalSpy deliveries(&s.view, &VolumeViewWidget::pictureDelivered);
        s.view.setLimits(withFrontAcross(s.view.view(), 2));
        s.view.setOverlay({});
        QVERIFY(s.awaitIdle());
        QCoreApplication::processEvents();
        QVERIFY(!deliveries.isEmpty());
        QCOMPARE(drawings, static_cast<int>(deliveries.size()));
        // And where all is again as it was, the lines are drawn alone.
        drawings = 0;
        s.view.setLimits(withFrontAcross(s.view.view(), 3));
        s.view.setLimits(withFrontAcross(s.view.view(), 2));
        s.view.setOverlay({.pictureLines = {{{{0.0, 0.0}, {0.2, 0.2}}, {255, 255, 255}, 1.0}}});
        QTRY_COMPARE(drawings, 1);
        QVERIFY(s.works.idle());
        renderer->RemoveObserver(observer);
    }

    void severalChangesMakeOnePicture() {
        ShownView s;
        QVERIFY(s.ready);
        QSignalSpy deliveries(&s.view, &VolumeViewWidget::pictureDelivered);
        s.view.setLimits(withFrontAcross(s.view.view(), 3));
        s.view.setClassification(PowerCurve{2, 1.0});
        s.view.setView(withFrontAcross({BeamAxis::plusZ, 20, 10, 0}, 2));
        Look look;
        look.colourMap = ColourMap::ice;
        s.view.setLook(look);
        QVERIFY(!s.works.idle());
        QVERIFY(s.awaitIdle());
        QVERIFY(deliveries.size() <= 3);  // a preview, where one is needed, high quality and converged
        QVERIFY(s.view.picture()->rgba == castRays(*s.volume, PowerCurve{2, 1.0}, s.view.settings())->rgba);
    }

    void hundredCurveChangesEndWithTheLast() {
        ShownView s;
        QVERIFY(s.ready);
        for (int i = 1; i <= 100; ++i) {
            s.view.setClassification(ManualCurve{{{0.3, 0}, {0.9, i / 100.0}}});
            QCoreApplication::processEvents();
        }
        QVERIFY(s.awaitIdle());
        const auto expected = castRays(*s.volume, ManualCurve{{{0.3, 0}, {0.9, 1.0}}}, s.view.settings());
        // Edits under one camera are made of kept samples, which are rounded to 16 bits.
        QCOMPARE(s.view.picture()->rgba.size(), expected->rgba.size());
        for (std::size_t i = 0; i < expected->rgba.size(); ++i)
            QVERIFY(std::abs(s.view.picture()->rgba[i] - expected->rgba[i]) <= 0.25f / 255);
        QVERIFY(largestDifference(s.view.screenImage(), *expected) <= 2);
    }

    void nearCutRemovesWhatLiesBefore() {
        ShownView s;
        QVERIFY(s.ready);
        s.view.setLimits(withFrontAcross(s.view.view(), 16));  // the ball ends at 15.5 mm behind the foremost face
        QCOMPARE(frontDepthMm(s.view.view()), 16.0);
        QVERIFY(s.awaitIdle());
        const auto alphaSum = [&] {
            double sum = 0;
            for (std::size_t i = 3; i < s.view.picture()->rgba.size(); i += 4) sum += s.view.picture()->rgba[i];
            return sum;
        };
        QCOMPARE(alphaSum(), 0.0);
        s.view.setLimits(withFrontAcross(s.view.view(), 8));
        QVERIFY(s.awaitIdle());
        QVERIFY(alphaSum() > 100);
        // The cut is measured along wherever one looks from: from behind, the ball is the last thing.
        s.view.setView(withFrontAcross({BeamAxis::minusZ, 0, 0, 0}, 16));
        QVERIFY(s.awaitIdle());
        QVERIFY(alphaSum() > 100);
    }

    void resizingKeepsThePictureRight_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("larger") << QSize(500, 400);
        QTest::newRow("narrow") << QSize(200, 400);
        QTest::newRow("wide") << QSize(600, 260);
    }
    void resizingKeepsThePictureRight() {
        QFETCH(QSize, size);
        ShownView s;
        QVERIFY(s.ready);
        s.view.resize(size);
        QTRY_VERIFY_WITH_TIMEOUT(s.view.picture() && s.view.pictureIsFine() &&
                                     s.view.picture()->width == size.width() &&
                                     s.view.picture()->height == size.height() && s.works.idle(),
                                 patience);
        const auto expected = castRays(*s.volume, wall, s.view.settings());
        QTRY_COMPARE_WITH_TIMEOUT(s.view.screenImage().size(), size, patience);
        QVERIFY(largestDifference(s.view.screenImage(), *expected) <= 2);
        // The whole volume is still in the picture.
        QVERIFY(std::abs(s.view.settings().camera.heightMm -
                         defaultCamera(s.volume->geometry(), {}, static_cast<double>(size.width()) / size.height())
                             .heightMm) < 1e-9);
    }

    void projectionAndColoursReachThePicture() {
        ShownView s;
        QVERIFY(s.ready);
        Look look;
        look.projection = Projection::perspective;
        look.colourMap = ColourMap::ice;
        look.lighting = Lighting::surface;
        look.step = 0.5;
        s.view.setLook(look);
        QCOMPARE(s.view.look(), look);
        QVERIFY(s.awaitIdle());
        const RayCastSettings settings = s.view.settings();
        QCOMPARE(settings.camera.projection, Projection::perspective);
        QVERIFY(settings.shading.has_value());
        QVERIFY(largestDifference(s.view.screenImage(), *castRays(*s.volume, wall, settings)) <= 2);
    }

    void modesAndDepthColoursReachThePicture() {
        ShownView s;
        QVERIFY(s.ready);
        Look look;
        look.depthColoured = true;
        s.view.setLook(look);
        QVERIFY(s.view.settings().depthColouring.has_value());
        QVERIFY(s.awaitIdle());
        QVERIFY(largestDifference(s.view.screenImage(), *castRays(*s.volume, wall, s.view.settings())) <= 2);
        for (const RenderMode mode : {RenderMode::maximum, RenderMode::minimum, RenderMode::mean}) {
            look.mode = mode;
            look.lighting = Lighting::surface;
            s.view.setLook(look);
            QCOMPARE(s.view.settings().mode, mode);
            QVERIFY(!s.view.settings().shading && !s.view.settings().depthColouring);  // direct mode only
            QVERIFY(s.awaitIdle());
            QVERIFY(largestDifference(s.view.screenImage(), *castRays(*s.volume, wall, s.view.settings())) <= 2);
        }
    }

    void aCurveThatPlaysNoPartCastsNothing() {
        ShownView s;
        QVERIFY(s.ready);
        Look look;
        look.mode = RenderMode::maximum;
        s.view.setLook(look);
        QVERIFY(s.awaitIdle());
        QSignalSpy deliveries(&s.view, &VolumeViewWidget::pictureDelivered);
        s.view.setClassification(PowerCurve{2, 0.1});
        look.lighting = Lighting::surface;
        look.depthColoured = true;
        s.view.setLook(look);
        QTRY_VERIFY_WITH_TIMEOUT(s.works.idle(), patience);
        QCOMPARE(deliveries.size(), 0);
        // Back in direct mode the newest curve counts.
        s.view.setLook(Look{});
        QVERIFY(s.awaitIdle());
        QVERIFY(s.view.picture()->rgba == castRays(*s.volume, PowerCurve{2, 0.1}, s.view.settings())->rgba);
    }

    void everyPictureSaysHowItWasMade() {
        ShownView s;
        QVERIFY(s.ready);
        QList<PictureReport> reports;
        connect(&s.view, &VolumeViewWidget::pictureDelivered, this, [&](const PictureReport& report) {
            QCOMPARE(report.rays, QSize(s.view.picture()->width, s.view.picture()->height));
            QCOMPARE(report.converged, s.view.pictureIsFine());
            reports << report;
        });
        s.view.setLimits(withFrontAcross(s.view.view(), 3));
        QVERIFY(s.awaitIdle());
        disconnect(&s.view, &VolumeViewWidget::pictureDelivered, this, nullptr);
        QVERIFY(reports.first().followsHand);
        QVERIFY(reports.last().converged);
        QCOMPARE(reports.last().step, s.view.settings().step);
        for (const PictureReport& report : reports) {
            QVERIFY(!report.quality.isEmpty());
            QVERIFY(report.castMilliseconds > 0);
        }
    }

    void drawnMeansOnTheScreen() {
        ShownView s;
        QVERIFY(s.ready);
        QSignalSpy swapped(s.window(), SIGNAL(frameSwapped()));
        const auto awaitSwap = [&] {
            swapped.clear();
            s.window()->requestUpdate();
            return QTest::qWaitFor([&] { return !swapped.empty(); }, patience);
        };
        QVERIFY(awaitSwap());  // what was drawn before is on the screen
        QSignalSpy delivered(&s.view, &VolumeViewWidget::pictureDelivered);
        QSignalSpy drawn(&s.view, &VolumeViewWidget::pictureDrawn);
        s.view.setLimits(withFrontAcross(s.view.view(), 4));
        QVERIFY(s.awaitIdle());
        QVERIFY(awaitSwap());
        const auto pictures = drawn.size();
        QVERIFY(pictures > 0 && pictures <= delivered.size());
        // The window drawing itself again is no new picture.
        QVERIFY(awaitSwap());
        QCOMPARE(drawn.size(), pictures);
    }

    void whatIsSavedIsConverged() {
        ShownView s;
        QVERIFY(s.ready);
        s.view.setLimits(withFrontAcross(s.view.view(), 5));  // not even begun
        const QImage saved = s.view.convergedImage();
        const auto expected = castRays(*s.volume, wall, s.view.settings());
        QVERIFY2(largestDifference(saved, *expected) <= 2,
                 qPrintable(QString::number(largestDifference(saved, *expected))));
        QVERIFY(s.awaitIdle());
        QCOMPARE(s.view.convergedImage(), saved);
        QVERIFY(s.view.settings().step <= 0.5 * s.view.look().step);
    }

    void unknownSpacingIsSaid() {
        VolumeGeometry geometry = geometryOf(40, 36, 32);
        ShownView known(volumeOf(geometry, [](double, double, double) { return 200; }));
        QVERIFY(known.ready);
        QVERIFY(known.view.scaleText().endsWith(" mm"));
        geometry.spacingKnown = false;
        ShownView unknown(volumeOf(geometry, [](double, double, double) { return 200; }));
        QVERIFY(unknown.ready);
        QVERIFY(unknown.view.scaleText().contains("unknown"));
        QVERIFY(unknown.view.screenImage() != known.view.screenImage());
    }

    void emptyViewIsBlackAndIdle() {
        ShownView s;
        QVERIFY(s.ready);
        s.view.setVolume(nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(s.works.idle(), patience);
        QVERIFY(!s.view.picture());
        QVERIFY(!s.view.pictureIsFine());
        const QImage screen = s.view.screenImage();
        for (int x = 0; x < screen.width(); x += 3)
            for (int y = 0; y < screen.height(); y += 3) QCOMPARE(screen.pixel(x, y) & 0xffffff, 0u);
        s.drag(Qt::LeftButton, {}, {10, 10}, {60, 60});  // nothing to turn
        QCOMPARE(s.view.view(), Viewpoint{});
        s.view.setVolume(s.volume);
        QVERIFY(s.awaitIdle());
    }

    void untilThePictureIsConvergedNothingIsAtRest() {
        ShownView s;
        QVERIFY(s.ready);
        QList<bool> told{true};
        connect(&s.works, &Works::changed, this, [&] {
            if (s.works.idle() != told.last()) told << s.works.idle();
        });
        s.view.setLimits(withFrontAcross(s.view.view(), 2));
        QVERIFY(!s.works.idle());
        QVERIFY(s.awaitIdle());
        QCOMPARE(told, (QList<bool>{true, false, true}));
        s.works.disconnect(this);
    }

    void closingWhileCasting() {
        for (int round = 0; round < 10; ++round) {
            ShownView s;
            QVERIFY(s.ready);
            s.view.setClassification(PowerCurve{2, 0.01 * (round + 1)});
            for (int i = 0; i < round; ++i) QCoreApplication::processEvents();
        }
    }

    void hiddenViewCastsNothing() {
        Works works;
        VolumeViewWidget view(works);
        QSignalSpy deliveries(&view, &VolumeViewWidget::pictureDelivered);
        view.setVolume(ballInTheCorner());
        view.setClassification(wall);
        QCoreApplication::processEvents();
        QVERIFY(works.idle());
        QCOMPARE(deliveries.size(), 0);
        QVERIFY(view.screenImage().isNull());
    }

    void onlyOneQtIsLoaded() {
        QProcess ldd;
        ldd.start("ldd", {QCoreApplication::applicationFilePath()});
        QVERIFY(ldd.waitForFinished(patience));
        const QString libraries = ldd.readAllStandardOutput();
        QVERIFY(libraries.contains("libQt6Widgets"));
        QVERIFY(libraries.contains("libvtkRenderingOpenGL2"));
        QVERIFY2(!libraries.contains("libQt5"), "Qt 5 is loaded beside Qt 6");
    }
};

ECHOLUCENT_TEST_CLASS(ViewPictureTest)
#include "test_view_picture.moc"
