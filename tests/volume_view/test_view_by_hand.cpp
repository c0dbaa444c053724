// The 3D view under a person's hand: real mouse, wheel, keyboard and drop events on a real window.
#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QShortcut>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "tests/qt_program/test_classes.h"
#include "tests/volume_view/shown_view.h"

using namespace echolucent;
using namespace echolucent::testing;

class ViewByHandTest : public QObject {
    Q_OBJECT

private slots:
    void viewRoundTrip_data() {
        QTest::addColumn<Viewpoint>("view");
        QTest::newRow("beam") << Viewpoint{};
        QTest::newRow("turned") << withFrontAcross(Viewpoint{BeamAxis::plusY, 33.5, -12.25, 0}, 7.5);
        QTest::newRow("rolled") << Viewpoint{BeamAxis::minusX, -170, 80, 45};
        QTest::newRow("pole") << Viewpoint{BeamAxis::plusZ, 25, 90, 10};
    }
    void viewRoundTrip() {
        QFETCH(Viewpoint, view);
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
        ShownView s(ballInTheCorner(), withFrontAcross({BeamAxis::plusZ, 20, 30, 0}, 5));
        QVERIFY(s.ready);
        const ViewFrame before = frameOf(s.view.view());
        s.view.setBeamAxis(BeamAxis::plusY);
        QCOMPARE(s.view.view().beamAxis, BeamAxis::plusY);
        QCOMPARE(frontDepthMm(s.view.view()), 5.0);
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
        QVERIFY(!changes.empty());
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
        const Viewpoint view = s.view.view();
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
        const Viewpoint before = s.view.view();
        QTest::mousePress(s.window(), Qt::LeftButton, {}, {150, 120});
        s.moveTo({190, 140}, Qt::LeftButton);
        QVERIFY(s.view.view() != before);
        QTest::keyClick(&s.view, Qt::Key_Escape);
        QCOMPARE(s.view.view(), before);
        s.moveTo({200, 140}, Qt::LeftButton);
        QCOMPARE(s.view.view(), before);
        QTest::mouseRelease(s.window(), Qt::LeftButton, {}, {200, 140});
    }

    void controlDragMovesTheLight() {
        ShownView s;
        QVERIFY(s.ready);
        Look lit = s.view.look();
        lit.lighting = Lighting::surface;
        lit.light = {-30, 20};
        s.view.setLook(lit);
        QVERIFY(s.awaitIdle());
        const Viewpoint view = s.view.view();
        QSignalSpy camera(&s.view, &VolumeViewWidget::cameraChanged);
        QSignalSpy light(&s.view, &VolumeViewWidget::lightChanged);
        const auto before = s.view.picture();
        s.drag(Qt::LeftButton, Qt::ControlModifier, {150, 120}, {200, 145});
        QVERIFY(!light.empty());
        QVERIFY(std::abs(s.view.look().light.azimuthDegrees - (-30 + 180.0 * 50 / 250)) < 1e-9);   // to the right
        QVERIFY(std::abs(s.view.look().light.elevationDegrees - (20 - 180.0 * 25 / 250)) < 1e-9);  // down
        QVERIFY(length(s.view.settings().shading->towardsLight - towardsLight(s.view.look().light)) < 1e-12);
        QVERIFY(s.awaitIdle());
        QVERIFY(s.view.picture()->rgba != before->rgba);
        QCOMPARE(s.view.view(), view);
        QCOMPARE(camera.size(), 0);
    }

    void escapeEndsALightDragWithoutChange() {
        ShownView s;
        QVERIFY(s.ready);
        Look lit = s.view.look();
        lit.lighting = Lighting::surface;
        s.view.setLook(lit);
        QVERIFY(s.awaitIdle());
        const Look before = s.view.look();
        QTest::mousePress(s.window(), Qt::LeftButton, Qt::ControlModifier, {150, 120});
        s.moveTo({190, 140}, Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(s.view.look() != before);
        QSignalSpy light(&s.view, &VolumeViewWidget::lightChanged);
        QTest::keyClick(&s.view, Qt::Key_Escape);
        QCOMPARE(s.view.look(), before);
        QCOMPARE(light.size(), 0);  // the person has not moved it back
        s.moveTo({200, 140}, Qt::LeftButton, Qt::ControlModifier);
        QCOMPARE(s.view.look(), before);
        QTest::mouseRelease(s.window(), Qt::LeftButton, Qt::ControlModifier, {200, 140});
        QVERIFY(s.awaitIdle());
    }

    void whereThereIsNoLightNoneIsMoved() {
        ShownView s;
        QVERIFY(s.ready);
        const Look before = s.view.look();
        QCOMPARE(before.lighting, Lighting::flat);
        QSignalSpy light(&s.view, &VolumeViewWidget::lightChanged);
        s.drag(Qt::LeftButton, Qt::ControlModifier, {150, 120}, {200, 145});
        QCOMPARE(s.view.look(), before);
        QCOMPARE(light.size(), 0);
        QVERIFY(s.works.idle());
    }

    void inAModeWithoutCurveNoOpacityIsPointedAt() {
        ShownView s;
        QVERIFY(s.ready);
        Look look = s.view.look();
        look.mode = RenderMode::maximum;
        s.view.setLook(look);
        QVERIFY(s.awaitIdle());
        QSignalSpy told(&s.view, &VolumeViewWidget::pointed);
        s.moveTo({165, 125});
        QCOMPARE(told.size(), 1);
        QVERIFY(told[0][0].value<std::optional<double>>());
        QVERIFY(!told[0][1].value<std::optional<double>>());
    }

    void setViewKeepsZoomAndResetDoesNot() {
        ShownView s;
        QVERIFY(s.ready);
        const double fitted = s.view.settings().camera.heightMm;
        s.drag(Qt::RightButton, {}, {150, 120}, {150, 80});
        const double zoomedHeight = s.view.settings().camera.heightMm;
        s.view.setView({BeamAxis::plusZ, 10, 0, 0});
        QCOMPARE(s.view.settings().camera.heightMm, zoomedHeight);
        s.view.resetView({});
        QCOMPARE(s.view.settings().camera.heightMm, fitted);
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

    void pointedTellsWhatIsUnderTheCursor() {
        // 51/255 everywhere, and 204/255 in the left half from z = 10 on.
        const auto volume =
            volumeOf(geometryOf(40, 40, 40), [](double x, double, double z) { return x < 20 && z >= 10 ? 204 : 51; });
        ShownView s(volume);
        Look look = s.view.look();
        look.interpolation =
            Interpolation::nearest;  // the picture's fine steps would meet the slope between two voxels
        s.view.setLook(look);
        s.view.setClassification(ManualCurve{{{0.5, 0.0}, {0.5, 0.8}}});
        QVERIFY(s.awaitIdle());
        QList<std::pair<std::optional<double>, std::optional<double>>> told;
        connect(&s.view, &VolumeViewWidget::pointed, this, [&](auto intensity, auto opacity) {
            told.append({intensity, opacity});
        });
        s.moveTo({120, 125});
        QCOMPARE(told.size(), 1);
        QVERIFY(told.last().first && std::abs(*told.last().first - 0.8) < 1e-9);
        QVERIFY(told.last().second && std::abs(*told.last().second - 0.8) < 1e-9);
        s.moveTo({230, 125});
        QVERIFY(!told.last().first && !told.last().second);
        // Under a cursor at rest a new curve is told as well.
        s.view.setClassification(ManualCurve{{{0.1, 0.0}, {0.1, 0.9}}});
        QVERIFY(s.awaitIdle());
        QVERIFY(told.last().first && std::abs(*told.last().first - 0.2) < 1e-9);
        QCOMPARE(told.last().second, std::optional<double>(0.9));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(s.window(), &leave);
        QVERIFY(!told.last().first);
        disconnect(&s.view, &VolumeViewWidget::pointed, this, nullptr);
    }

    void filesAreTaken() {
        ShownView s;
        QVERIFY(s.ready);
        QList<QList<QUrl>> dropped;
        connect(&s.view, &VolumeViewWidget::filesDropped, this,
                [&](const QList<QUrl>& dragged) { dropped.append(dragged); });
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
            QCOMPARE(dropped, QList<QList<QUrl>>{files.urls()});
        }
        disconnect(&s.view, &VolumeViewWidget::filesDropped, this, nullptr);
    }

    void shortcutsOfTheWindowWorkOverThePicture() {
        Works works;
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* view = new VolumeViewWidget(works);
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
};

ECHOLUCENT_TEST_CLASS(ViewByHandTest)
#include "test_view_by_hand.moc"
