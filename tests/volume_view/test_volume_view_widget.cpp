// The 3D view as a person meets it: a real window, real mouse events, real pictures.
#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QProcess>
#include <QShortcut>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <QWindow>
#include <chrono>
#include <cmath>

#include "tests/volume_view/test_volumes.h"
#include "widgets/volume_view/volume_view_widget.h"

using namespace echolucent;
using echolucent::testing::ballInTheCorner;
using echolucent::testing::geometryOf;
using echolucent::testing::volumeOf;

namespace {

constexpr int patience = 30000;  // ms, a bound for broken programs
const OpacityCurve wall = ManualCurve{{{0.4, 0.0}, {0.6, 1.0}}};

/// A shown view with the corner ball, its fine picture there.
struct ShownView {
    explicit ShownView(std::shared_ptr<const Volume> shown = ballInTheCorner(), const View& from = {})
        : volume(std::move(shown)) {
        view.resize(330, 250);
        view.setVolume(volume);
        view.setCurve(wall);
        view.resetView(from);
        view.show();
        ready = QTest::qWaitForWindowExposed(&view) && awaitIdle();
    }
    bool awaitIdle() {
        return QTest::qWaitFor([this] { return !view.busy() && view.pictureIsFine(); }, patience);
    }
    QWindow* window() {
        // The only native child window of the view's top level.
        return view.windowHandle()->findChild<QWindow*>();
    }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPoint& from, const QPoint& to) {
        QTest::mousePress(window(), button, modifiers, from);
        for (int step = 1; step <= 10; ++step) moveTo(from + (to - from) * step / 10, button, modifiers);
        QTest::mouseRelease(window(), button, modifiers, to);
    }
    void moveTo(const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton, Qt::KeyboardModifiers modifiers = {}) {
        QMouseEvent move(QEvent::MouseMove, QPointF(to), QPointF(window()->mapToGlobal(to)), Qt::NoButton, buttons, modifiers);
        QCoreApplication::sendEvent(window(), &move);
    }
    std::shared_ptr<const Volume> volume;
    VolumeViewWidget view;
    bool ready = false;
};

/// Largest difference in levels between the screen and a picture over black, corners with marker and bar left out.
int largestDifference(const QImage& screen, const Picture& picture) {
    const std::vector<std::uint8_t> rgb = overBackground(picture, {0, 0, 0});
    int largest = 0;
    for (int y = 0; y < picture.height - 110; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const QRgb seen = screen.pixel(x, y);
            const std::uint8_t* expected = &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                                     static_cast<std::size_t>(x))];
            largest = std::max({largest, std::abs(qRed(seen) - expected[0]), std::abs(qGreen(seen) - expected[1]),
                                std::abs(qBlue(seen) - expected[2])});
        }
    }
    return largest;
}

/// Centre of what is brighter than a level, in shares of the picture's height from the centre.
QPointF brightCentre(const Picture& picture) {
    double x = 0, y = 0, weight = 0;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            const float value = picture.rgba[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                                                  static_cast<std::size_t>(column))];
            x += value * (column + 0.5 - picture.width / 2.0);
            y += value * (row + 0.5 - picture.height / 2.0);
            weight += value;
        }
    }
    return QPointF(x, y) / weight / picture.height;
}

}  // namespace

class VolumeViewWidgetTest : public QObject {
    Q_OBJECT

private slots:
    void screenShowsWhatTheRayCasterMade() {
        ShownView s;
        QVERIFY(s.ready);
        const auto expected = castRays(*s.volume, wall, s.view.settings());
        QVERIFY(expected);
        const QImage screen = s.view.screenImage();
        QCOMPARE(screen.size(), QSize(330, 250));
        QVERIFY2(largestDifference(screen, *expected) <= 2, qPrintable(QString::number(largestDifference(screen, *expected))));
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
            s.view.setCurve(ManualCurve{{{0.5, 0}, {0.5, opacity}}});
            QVERIFY(s.awaitIdle());
            QTRY_VERIFY_WITH_TIMEOUT(largestDifference(s.view.screen()->grabWindow(s.view.winId()).toImage(),
                                                       *s.view.picture()) <= 2, patience);
        }
    }

    void unchangedViewCastsNothing() {
        ShownView s;
        QVERIFY(s.ready);
        QSignalSpy deliveries(&s.view, &VolumeViewWidget::pictureDelivered);
        QSignalSpy busyChanges(&s.view, &VolumeViewWidget::busyChanged);
        const QImage before = s.view.screenImage();
        s.view.setCurve(wall);
        s.view.setLook(s.view.look());
        s.view.setNearCut(0);
        s.view.setView(s.view.view());
        s.view.setVolume(s.volume);
        s.view.update();
        QTRY_VERIFY_WITH_TIMEOUT(!s.view.busy(), patience);
        QCOMPARE(s.view.screenImage(), before);
        QCoreApplication::processEvents();
        QCOMPARE(deliveries.size(), 0);
        QVERIFY(s.view.pictureIsFine());
    }

    void severalChangesMakeOnePicture() {
        ShownView s;
        QVERIFY(s.ready);
        QSignalSpy deliveries(&s.view, &VolumeViewWidget::pictureDelivered);
        s.view.setNearCut(3);
        s.view.setCurve(PowerCurve{2, 1.0});
        s.view.setView({BeamAxis::plusZ, 20, 10, 0, 2});
        Look look;
        look.colourMap = ColourMap::ice;
        s.view.setLook(look);
        QVERIFY(s.view.busy());
        QVERIFY(s.awaitIdle());
        QVERIFY(deliveries.size() <= 2);  // coarse, where one is needed, and fine
        QVERIFY(s.view.picture()->rgba == castRays(*s.volume, PowerCurve{2, 1.0}, s.view.settings())->rgba);
    }

    void hundredCurveChangesEndWithTheLast() {
        ShownView s;
        QVERIFY(s.ready);
        for (int i = 1; i <= 100; ++i) {
            s.view.setCurve(ManualCurve{{{0.3, 0}, {0.9, i / 100.0}}});
            QCoreApplication::processEvents();
        }
        QVERIFY(s.awaitIdle());
        const auto expected = castRays(*s.volume, ManualCurve{{{0.3, 0}, {0.9, 1.0}}}, s.view.settings());
        QVERIFY(s.view.picture()->rgba == expected->rgba);
        QVERIFY(largestDifference(s.view.screenImage(), *expected) <= 2);
    }

    void viewRoundTrip_data() {
        QTest::addColumn<View>("view");
        QTest::newRow("beam") << View{};
        QTest::newRow("turned") << View{BeamAxis::plusY, 33.5, -12.25, 0, 7.5};
        QTest::newRow("rolled") << View{BeamAxis::minusX, -170, 80, 45, 0};
        QTest::newRow("pole") << View{BeamAxis::plusZ, 25, 90, 10, 0};
    }
    void viewRoundTrip() {
        QFETCH(View, view);
        ShownView s;
        s.view.setView(view);
        QCOMPARE(s.view.view(), view);
        QVERIFY(s.awaitIdle());
        QCOMPARE(s.view.view(), view);
        const ViewFrame frame = s.view.settings().camera.frame;
        QVERIFY(length(frame.forward - frameOf(view).forward) < 1e-12);
        s.view.resetView(view);
        QCOMPARE(s.view.view(), view);
    }

    void anotherBeamAxisLeavesThePictureAlone() {
        ShownView s(ballInTheCorner(), {BeamAxis::plusZ, 20, 30, 0, 5});
        QVERIFY(s.ready);
        const ViewFrame before = frameOf(s.view.view());
        s.view.setBeamAxis(BeamAxis::plusY);
        QCOMPARE(s.view.view().beamAxis, BeamAxis::plusY);
        QCOMPARE(s.view.view().nearCutMm, 5.0);
        QVERIFY(length(frameOf(s.view.view()).forward - before.forward) < 1e-9);
        QVERIFY(length(frameOf(s.view.view()).down - before.down) < 1e-9);
    }

    void dragOrbitsTheRightWay() {
        ShownView s;
        QVERIFY(s.ready);
        QSignalSpy changes(&s.view, &VolumeViewWidget::cameraChanged);
        // The ball is in front (small z): it follows the hand to the right.
        const double before = brightCentre(*s.view.picture()).x();
        s.drag(Qt::LeftButton, {}, {150, 120}, {175, 120});
        QVERIFY(changes.size() > 0);
        QCOMPARE(s.view.view().azimuthDegrees, 180.0 * 25 / 250);
        QVERIFY(std::abs(s.view.view().elevationDegrees) < 1e-9);
        QVERIFY(s.awaitIdle());
        QVERIFY(brightCentre(*s.view.picture()).x() > before + 0.02);

        const double beforeUp = brightCentre(*s.view.picture()).y();
        s.drag(Qt::LeftButton, {}, {150, 120}, {150, 145});
        QVERIFY(std::abs(s.view.view().elevationDegrees + 180.0 * 25 / 250) < 1e-9);
        QVERIFY(s.awaitIdle());
        QVERIFY(brightCentre(*s.view.picture()).y() > beforeUp + 0.02);
    }

    void dragPansWithTheHand_data() {
        QTest::addColumn<Qt::MouseButton>("button");
        QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
        QTest::newRow("middle") << Qt::MiddleButton << Qt::KeyboardModifiers{};
        QTest::newRow("shift and left") << Qt::LeftButton << Qt::KeyboardModifiers{Qt::ShiftModifier};
    }
    void dragPansWithTheHand() {
        QFETCH(Qt::MouseButton, button);
        QFETCH(Qt::KeyboardModifiers, modifiers);
        ShownView s;
        QVERIFY(s.ready);
        const QPointF before = brightCentre(*s.view.picture());
        const View view = s.view.view();
        s.drag(button, modifiers, {150, 120}, {170, 110});
        QVERIFY(s.awaitIdle());
        const QPointF moved = (brightCentre(*s.view.picture()) - before) * 250;
        QVERIFY2(std::abs(moved.x() - 20) < 1 && std::abs(moved.y() + 10) < 1,
                 qPrintable(QString("%1, %2").arg(moved.x()).arg(moved.y())));
        QCOMPARE(s.view.view(), view);
    }

    void wheelAndRightDragZoom() {
        ShownView s;
        QVERIFY(s.ready);
        const double before = s.view.settings().camera.heightMm;
        QWheelEvent in(QPointF(100, 100), s.window()->mapToGlobal(QPointF(100, 100)), {}, {0, 120}, Qt::NoButton, {},
                       Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(s.window(), &in);
        const double nearer = s.view.settings().camera.heightMm;
        QVERIFY(nearer < before);
        QWheelEvent out(QPointF(100, 100), s.window()->mapToGlobal(QPointF(100, 100)), {}, {0, -120}, Qt::NoButton, {},
                        Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(s.window(), &out);
        QVERIFY(std::abs(s.view.settings().camera.heightMm - before) < 1e-9 * before);
        s.drag(Qt::RightButton, {}, {150, 120}, {150, 80});
        QVERIFY(s.view.settings().camera.heightMm < before);
        for (int i = 0; i < 200; ++i) QCoreApplication::sendEvent(s.window(), &in);
        QVERIFY(s.view.settings().camera.heightMm >= 2.0);
        QVERIFY(s.awaitIdle());
    }

    void escapeEndsADragWithoutChange() {
        ShownView s;
        QVERIFY(s.ready);
        const View before = s.view.view();
        QTest::mousePress(s.window(), Qt::LeftButton, {}, {150, 120});
        s.moveTo({190, 140}, Qt::LeftButton);
        QVERIFY(s.view.view() != before);
        QTest::keyClick(&s.view, Qt::Key_Escape);
        QCOMPARE(s.view.view(), before);
        s.moveTo({200, 140}, Qt::LeftButton);
        QCOMPARE(s.view.view(), before);
        QTest::mouseRelease(s.window(), Qt::LeftButton, {}, {200, 140});
    }

    void setViewKeepsZoomAndResetDoesNot() {
        ShownView s;
        QVERIFY(s.ready);
        const double fitted = s.view.settings().camera.heightMm;
        s.drag(Qt::RightButton, {}, {150, 120}, {150, 80});
        const double zoomedHeight = s.view.settings().camera.heightMm;
        s.view.setView({BeamAxis::plusZ, 10, 0, 0, 0});
        QCOMPARE(s.view.settings().camera.heightMm, zoomedHeight);
        s.view.resetView({});
        QCOMPARE(s.view.settings().camera.heightMm, fitted);
    }

    void nearCutRemovesWhatLiesBefore() {
        ShownView s;
        QVERIFY(s.ready);
        s.view.setNearCut(16);  // the ball ends at 15.5 mm behind the foremost face
        QCOMPARE(s.view.view().nearCutMm, 16.0);
        QVERIFY(s.awaitIdle());
        const auto alphaSum = [&] {
            double sum = 0;
            for (std::size_t i = 3; i < s.view.picture()->rgba.size(); i += 4) sum += s.view.picture()->rgba[i];
            return sum;
        };
        QCOMPARE(alphaSum(), 0.0);
        s.view.setNearCut(8);
        QVERIFY(s.awaitIdle());
        QVERIFY(alphaSum() > 100);
        // The cut is measured along wherever one looks from: from behind, the ball is the last thing.
        s.view.setView({BeamAxis::minusZ, 0, 0, 0, 16});
        QVERIFY(s.awaitIdle());
        QVERIFY(alphaSum() > 100);
    }

    void cameraStaysForAnotherPhaseOnly() {
        ShownView s;
        QVERIFY(s.ready);
        s.drag(Qt::RightButton, {}, {150, 120}, {150, 80});
        const double height = s.view.settings().camera.heightMm;
        s.view.setVolume(std::make_shared<const Volume>(*s.volume));
        QCOMPARE(s.view.settings().camera.heightMm, height);
        QVERIFY(s.awaitIdle());
        s.view.setVolume(ballInTheCorner({2, 2, 2}));
        const RayCastSettings settings = s.view.settings();
        QVERIFY(std::abs(settings.camera.heightMm -
                         defaultCamera(geometryOf(40, 36, 32, {2, 2, 2}), {}, 330.0 / 250).heightMm) < 1e-9);
        QVERIFY(s.awaitIdle());
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
        QTRY_VERIFY_WITH_TIMEOUT(s.view.picture() && s.view.pictureIsFine() && s.view.picture()->width == size.width() &&
                                     s.view.picture()->height == size.height() && !s.view.busy(), patience);
        const auto expected = castRays(*s.volume, wall, s.view.settings());
        QTRY_COMPARE_WITH_TIMEOUT(s.view.screenImage().size(), size, patience);
        QVERIFY(largestDifference(s.view.screenImage(), *expected) <= 2);
        // The whole volume is still in the picture.
        QVERIFY(std::abs(s.view.settings().camera.heightMm -
                         defaultCamera(s.volume->geometry(), {}, static_cast<double>(size.width()) / size.height()).heightMm) <
                1e-9);
    }

    void projectionAndColoursReachThePicture() {
        ShownView s;
        QVERIFY(s.ready);
        Look look;
        look.projection = Projection::perspective;
        look.colourMap = ColourMap::ice;
        look.shaded = true;
        look.step = 0.5;
        s.view.setLook(look);
        QCOMPARE(s.view.look(), look);
        QVERIFY(s.awaitIdle());
        const RayCastSettings settings = s.view.settings();
        QCOMPARE(settings.camera.projection, Projection::perspective);
        QVERIFY(settings.shading.has_value());
        QVERIFY(largestDifference(s.view.screenImage(), *castRays(*s.volume, wall, settings)) <= 2);
    }

    void pointedTellsWhatIsUnderTheCursor() {
        // 51/255 everywhere, and 204/255 in the left half from z = 10 on.
        const auto volume = volumeOf(geometryOf(40, 40, 40), [](double x, double, double z) {
            return x < 20 && z >= 10 ? 204 : 51;
        });
        ShownView s(volume);
        s.view.setCurve(ManualCurve{{{0.5, 0.0}, {0.5, 0.8}}});
        QVERIFY(s.awaitIdle());
        QList<std::pair<std::optional<double>, std::optional<double>>> told;
        connect(&s.view, &VolumeViewWidget::pointed, this, [&](auto intensity, auto opacity) { told.append({intensity, opacity}); });
        s.moveTo({120, 125});
        QCOMPARE(told.size(), 1);
        QVERIFY(told.last().first && std::abs(*told.last().first - 0.8) < 1e-9);
        QVERIFY(told.last().second && std::abs(*told.last().second - 0.8) < 1e-9);
        s.moveTo({230, 125});
        QVERIFY(!told.last().first && !told.last().second);
        // Under a cursor at rest a new curve is told as well.
        s.view.setCurve(ManualCurve{{{0.1, 0.0}, {0.1, 0.9}}});
        QVERIFY(s.awaitIdle());
        QVERIFY(told.last().first && std::abs(*told.last().first - 0.2) < 1e-9);
        QCOMPARE(told.last().second, std::optional<double>(0.9));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(s.window(), &leave);
        QVERIFY(!told.last().first);
        disconnect(&s.view, &VolumeViewWidget::pointed, this, nullptr);
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
        QTRY_VERIFY_WITH_TIMEOUT(!s.view.busy(), patience);
        QVERIFY(!s.view.picture());
        QVERIFY(!s.view.pictureIsFine());
        const QImage screen = s.view.screenImage();
        for (int x = 0; x < screen.width(); x += 3)
            for (int y = 0; y < screen.height(); y += 3) QCOMPARE(screen.pixel(x, y) & 0xffffff, 0u);
        s.drag(Qt::LeftButton, {}, {10, 10}, {60, 60});  // nothing to turn
        QCOMPARE(s.view.view(), View{});
        s.view.setVolume(s.volume);
        QVERIFY(s.awaitIdle());
    }

    void busyIsToldOnceEachWay() {
        ShownView s;
        QVERIFY(s.ready);
        QSignalSpy changes(&s.view, &VolumeViewWidget::busyChanged);
        s.view.setNearCut(2);
        QVERIFY(s.view.busy());
        QVERIFY(s.awaitIdle());
        QCOMPARE(changes.size(), 2);
        QCOMPARE(changes[0][0].toBool(), true);
        QCOMPARE(changes[1][0].toBool(), false);
    }

    void closingWhileCasting() {
        for (int round = 0; round < 10; ++round) {
            ShownView s;
            QVERIFY(s.ready);
            s.view.setCurve(PowerCurve{2, 0.01 * (round + 1)});
            for (int i = 0; i < round; ++i) QCoreApplication::processEvents();
        }
    }

    void hiddenViewCastsNothing() {
        VolumeViewWidget view;
        QSignalSpy deliveries(&view, &VolumeViewWidget::pictureDelivered);
        view.setVolume(ballInTheCorner());
        view.setCurve(wall);
        QCoreApplication::processEvents();
        QVERIFY(!view.busy());
        QCOMPARE(deliveries.size(), 0);
        QVERIFY(view.screenImage().isNull());
    }

    void filesAreTaken() {
        ShownView s;
        QVERIFY(s.ready);
        QList<QStringList> dropped;
        connect(&s.view, &VolumeViewWidget::filesDropped, this, [&](const QStringList& files) { dropped.append(files); });
        QMimeData files;
        files.setUrls({QUrl::fromLocalFile("/tmp/a.mha"), QUrl("http://elsewhere.example/b.mha")});
        QMimeData text;
        text.setText("words");
        for (QObject* target : {static_cast<QObject*>(s.window()), static_cast<QObject*>(&s.view)}) {
            dropped.clear();
            QDragEnterEvent enterWords({5, 5}, Qt::CopyAction, &text, Qt::LeftButton, {});
            QCoreApplication::sendEvent(target, &enterWords);
            QVERIFY(!enterWords.isAccepted());
            QDragEnterEvent enter({5, 5}, Qt::CopyAction, &files, Qt::LeftButton, {});
            QCoreApplication::sendEvent(target, &enter);
            QVERIFY(enter.isAccepted());
            QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &files, Qt::LeftButton, {});
            QCoreApplication::sendEvent(target, &drop);
            QCOMPARE(dropped, QList<QStringList>{{"/tmp/a.mha"}});
        }
        disconnect(&s.view, &VolumeViewWidget::filesDropped, this, nullptr);
    }

    void shortcutsOfTheWindowWorkOverThePicture() {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* view = new VolumeViewWidget;
        layout->addWidget(view);
        int fired = 0;
        const QShortcut shortcut(QKeySequence(Qt::Key_R), &window, [&] { ++fired; });
        window.resize(300, 300);
        view->setVolume(ballInTheCorner());
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QWindow* inner = window.windowHandle()->findChild<QWindow*>();
        QVERIFY(inner);
        QTest::mouseClick(inner, Qt::LeftButton, {}, {50, 50});
        QTRY_VERIFY_WITH_TIMEOUT(view->hasFocus(), patience);
        QTest::keyClick(QGuiApplication::focusWindow(), Qt::Key_R);
        QCOMPARE(fired, 1);
        // Should the picture's own window have the keyboard, the keys still reach the program.
        QTest::keyClick(inner, Qt::Key_R);
        QCOMPARE(fired, 2);
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

    void timeOnTheWayToTheScreen_data() {
        QTest::addColumn<int>("edge");
        QTest::newRow("512") << 512;
        QTest::newRow("1000") << 1000;
    }
    /// Prints figures; asserts only that every frame came.
    void timeOnTheWayToTheScreen() {
        QFETCH(int, edge);
        ShownView s;
        s.view.resize(edge, edge);
        QVERIFY(QTest::qWaitFor([&] { return s.view.picture()->width == edge && s.view.pictureIsFine() && !s.view.busy(); }, patience));
        int frames = 0;
        double castMilliseconds = 0;
        const int wanted = 60;
        connect(&s.view, &VolumeViewWidget::pictureDelivered, this, [&](bool, double milliseconds) {
            castMilliseconds += milliseconds;
            if (++frames < wanted) s.view.setView({BeamAxis::plusZ, 0.5 * frames, 0, 0, 0});
        });
        const auto begin = std::chrono::steady_clock::now();
        const auto processorBegin = std::clock();
        s.view.setView({BeamAxis::plusZ, 45, 0, 0, 0});
        QTRY_VERIFY_WITH_TIMEOUT(frames >= wanted && !s.view.busy(), patience);
        const std::chrono::duration<double, std::milli> wall_ = std::chrono::steady_clock::now() - begin;
        const double processor = 1000.0 * static_cast<double>(std::clock() - processorBegin) / CLOCKS_PER_SEC;
        disconnect(&s.view, &VolumeViewWidget::pictureDelivered, this, nullptr);
        qInfo("%d x %d: %.1f ms a frame, %.1f ms of it casting; %.1f ms of processor time", edge, edge,
              wall_.count() / frames, castMilliseconds / frames, processor / frames);
    }
};

int main(int argc, char** argv) {
    VolumeViewWidget::prepareApplication();
    QApplication application(argc, argv);
    VolumeViewWidgetTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_volume_view_widget.moc"
