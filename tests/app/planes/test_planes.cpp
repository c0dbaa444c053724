// Planes A, B and C in the real main window: what they show, and what mouse and keys do there.
#include <QAction>
#include <QMouseEvent>
#include <QToolButton>
#include <QWheelEvent>
#include <QWindow>
#include <cmath>

#include "app/window/review_room.h"
#include "tests/app/planes/marked_corners.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/planes/plane_pane.h"

using namespace echolucent;

class TestPlanes : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        QLocale::setDefault(QLocale::c());
        m_corners = file("corners.mha", {markedCorners()});
    }
    void init() {
        show();
        window().resize(1280, 720);
        useLook(Look{});  // light plays no part here, and takes its time
        open(m_corners);
        key(Qt::Key_F3);
        waitForPlanes();
    }
    void cleanup() { close(); }

    void layoutsComeByKeyAndADoubleClickGivesAPaneTheRoom() {
        const QSize quad = pane("planes.a").size();
        QVERIFY(std::abs(quad.width() - window().volumeView().width()) <= 1);
        QVERIFY(quad.height() * 2 <= grid().height());
        key(Qt::Key_F4);
        QVERIFY(window().volumeView().width() > 2 * pane("planes.a").width());
        QCOMPARE(window().volumeView().height(), grid().height());
        key(Qt::Key_F2);
        QVERIFY(!pane("planes.b").isVisible());
        QCOMPARE(window().volumeView().size(), grid().size());
        key(Qt::Key_F3);
        doubleClick(pane("planes.b"));
        QCOMPARE(pane("planes.b").size(), grid().size());
        QVERIFY(!window().volumeView().isVisible());
        doubleClick(pane("planes.b"));
        QCOMPARE(pane("planes.a").size(), quad);
        click("planes.c.maximise");
        QCOMPARE(pane("planes.c").size(), grid().size());
        click("planes.c.maximise");
        QWindow* inner = pictureWindow();
        QTest::mouseDClick(inner, Qt::LeftButton);
        QCOMPARE(window().volumeView().size(), grid().size());
        QTest::mouseDClick(inner, Qt::LeftButton);
        QCOMPARE(pane("planes.a").size(), quad);
    }

    void aDoubleClickMovesNothingAndMakesNoStep() {
        const Document before = document();
        const int steps = window().document().steps().count();
        doubleClick(pane("planes.a"), QPoint(60, 60));
        QCOMPARE(planes(), before.scene.planes);
        QCOMPARE(window().document().steps().count(), steps);
    }

    /// Each corner of the volume is as bright as no other: where it is seen says which way round the planes are.
    void cornersAreSeenWhereTheBeamAndTheProbeSay() {
        for (const BeamAxis beam : {BeamAxis::plusZ, BeamAxis::minusY, BeamAxis::plusX}) {
            Document next = document();
            next.beam = {beam, BeamSource::person};
            window().document().edit(next, "beam axis");
            const DataBox data = window().openStudy().volume()->dataBox();
            for (const PlaneName plane : allPlaneNames) {
                PlanePane& shown = paneOf(plane);
                for (int corner = 0; corner < 8; ++corner) {
                    const Vec3 at = cornerMm(window().openStudy().volume()->geometry(), corner);
                    // The plane is stepped to the corner, and the cursor points to it.
                    Document there = document();
                    there.scene.planes = withReferencePoint(there.scene.planes, at, data);
                    window().document().edit(there, "move reference point");
                    waitForPlanes();
                    const QPointF pixel = shown.mapping().seenAt(at);
                    const ViewFrame probe = frameOf(Viewpoint{.beamAxis = beam});
                    const Vec3 fromCentre = at - data.centreMm();
                    const double right =
                        plane == PlaneName::b ? probe.down.dot(fromCentre) : probe.right.dot(fromCentre);
                    const double down =
                        plane == PlaneName::c ? probe.down.dot(fromCentre) : probe.forward.dot(fromCentre);
                    QCOMPARE(pixel.x() > shown.width() / 2.0, right > 0);
                    QCOMPARE(pixel.y() > shown.height() / 2.0, down > 0);
                    QCOMPARE(brightnessAt(shown, pixel), cornerValue(corner));
                }
            }
        }
    }

    void aPlaneShowsTheProbeAndHowItLiesIfTheBeamIsKnown() {
        const auto whiteAtTop = [](PlanePane& pane) {
            const QImage shown = pane.grab().toImage();
            int white = 0;
            for (int x = -7; x <= 7; ++x) {
                const QPointF at(pane.width() / 2.0 + x, 3.5);
                white += qGray(shown.pixel((at * pane.devicePixelRatioF()).toPoint())) > 190;
            }
            return white;
        };
        Document next = document();
        next.beam.source = BeamSource::assumed;
        window().document().edit(next, "beam of nobody");
        waitForPlanes();
        QCOMPARE(pane("planes.a").scene()->lie, QString());
        QCOMPARE(whiteAtTop(pane("planes.a")), 0);
        next.beam.source = BeamSource::person;
        window().document().edit(next, "beam axis");
        waitForPlanes();
        QCOMPARE(pane("planes.a").scene()->lie, "along the beam");
        QCOMPARE(pane("planes.a").scene()->letters[2], "probe");
        QCOMPARE(pane("planes.c").scene()->lie, "from the probe");
        QVERIFY(whiteAtTop(pane("planes.a")) >= 8);  // the probe's foot is 14 pixels wide
        QCOMPARE(whiteAtTop(pane("planes.c")), 0);
        QCOMPARE(pane("planes.c").offsetWords(), "offset 0.0 mm");
        const double unit = window().openStudy().volume()->geometry().unit();
        QTest::keyClick(&pane("planes.c"), Qt::Key_Up);
        QCOMPARE(pane("planes.c").offsetWords(), QString("offset −%1 mm").arg(unit, 0, 'f', 1));
    }

    void aClickAndADragMoveTheReferencePointInOneStepEach() {
        PlanePane& a = pane("planes.a");
        const QPoint to(a.width() / 2 + 40, a.height() / 2 - 25);
        const Vec3 wanted = a.mapping().gridAt(to);
        QTest::mouseClick(&a, Qt::LeftButton, {}, to);
        QVERIFY(length(reference() - wanted) < 1e-6);
        QCOMPARE(window().document().steps().undoText(), "move reference point");
        const int steps = window().document().steps().count();
        const Vec3 second = a.mapping().gridAt(to + QPoint(-60, 30));
        drag(a, Qt::LeftButton, {}, to, to + QPoint(-60, 30));
        QVERIFY(length(reference() - second) < 1e-6);
        QCOMPARE(window().document().steps().count(), steps + 1);
        window().document().steps().undo();
        QVERIFY(length(reference() - wanted) < 1e-6);
        waitForPlanes();
    }

    void beyondTheDataTheReferencePointStaysInThePlane() {
        PlanePane& a = pane("planes.a");
        a.setFocus();
        QTest::keyClick(&pane("planes.c"), Qt::Key_Right, Qt::ShiftModifier);  // A lies obliquely in the grid
        const Vec3 forward = frameOf(PlaneName::a, planes(), document().beam.axis).forward, before = reference();
        const QPoint centre = a.mapping().seenAt(before).toPoint();
        QTest::mousePress(&a, Qt::LeftButton, {}, centre);
        for (int i = 1; i <= 8; ++i) moveTo(a, Qt::LeftButton, {}, centre + QPoint(i * 60, i * 9));
        QTest::mouseRelease(&a, Qt::LeftButton, {}, centre + QPoint(480, 72));
        QVERIFY(std::abs(forward.dot(reference() - before)) < 1e-6);
        QVERIFY(length(reference() - before) > 5.0);
    }

    void homeBringsAllPicturesBackAfterATurn() {
        PlanePane& a = pane("planes.a");
        QTest::mouseClick(&a, Qt::LeftButton, {}, a.rect().center() + QPoint(40, 30));
        QTest::keyClick(&a, Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(planes().crops[1].panRightMm != 0.0 || planes().crops[2].panRightMm != 0.0);
        QTest::keyClick(&a, Qt::Key_Home);
        QVERIFY(planes() == Planes{});
    }

    void escapeEndsADragWithoutChange() {
        PlanePane& b = pane("planes.b");
        const Planes before = planes();
        const int steps = window().document().steps().count();
        const QPoint from(b.width() / 2, b.height() / 2);
        for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton}) {
            QTest::mousePress(&b, button, {}, from);
            moveTo(b, button, {}, from + QPoint(30, 20));
            QVERIFY(planes() != before);
            QTest::keyClick(&b, Qt::Key_Escape);
            QVERIFY(planes() == before);
            QTest::mouseRelease(&b, button, {}, from + QPoint(30, 20));
            QVERIFY(planes() == before);
        }
        QCOMPARE(window().document().steps().count(), steps);
    }

    void theRimTurnsAllThreeAboutTheReferencePoint() {
        PlanePane& a = pane("planes.a");
        const ViewFrame before = frameOf(PlaneName::a, planes(), document().beam.axis);
        const QPointF centre = a.mapping().seenAt(reference());
        // From the right rim to the lower rim: a quarter of a turn, clockwise.
        const QPoint from(a.width() - 8, static_cast<int>(centre.y())),
            to(static_cast<int>(centre.x()), a.height() - 8);
        drag(a, Qt::LeftButton, {}, from, to);
        const ViewFrame after = frameOf(PlaneName::a, planes(), document().beam.axis);
        QVERIFY(length(after.forward - before.forward) < 1e-9);
        QVERIFY(std::abs(after.down.dot(before.right) - 1.0) < 1e-3);
        QVERIFY((a.mapping().seenAt(reference()) - centre).manhattanLength() < 1e-6);
        QCOMPARE(window().document().steps().undoText(), "turn planes");
    }

    void keysTurnStepZoomAndReset() {
        PlanePane& c = pane("planes.c");
        c.setFocus();
        const BeamAxis beam = document().beam.axis;
        const Vec3 start = frameOf(PlaneName::c, planes(), beam).right;
        const auto turnedBy = [&] {
            return std::acos(std::clamp(start.dot(frameOf(PlaneName::c, planes(), beam).right), -1.0, 1.0)) * 180 /
                   M_PI;
        };
        QTest::keyClick(&c, Qt::Key_Right);
        QVERIFY(std::abs(turnedBy() - 1) < 1e-6);
        QTest::keyClick(&c, Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(std::abs(turnedBy() - 11) < 1e-6);
        QTest::keyClick(&c, Qt::Key_Left);
        QVERIFY(std::abs(turnedBy() - 10) < 1e-6);
        QCOMPARE(window().motionPlayer().angle(), 0);  // the focused pane keeps its keys
        const double unit = window().openStudy().volume()->geometry().unit();
        const Vec3 forward = frameOf(PlaneName::c, planes(), beam).forward;
        const Vec3 from = reference();
        QTest::keyClick(&c, Qt::Key_Down);
        QVERIFY(std::abs(forward.dot(reference() - from) - unit) < 1e-9);
        QTest::keyClick(&c, Qt::Key_PageUp);
        QVERIFY(std::abs(forward.dot(reference() - from) + 9 * unit) < 1e-9);
        QTest::keyClick(&c, Qt::Key_Plus);
        QVERIFY(planes().crops[2].magnification > 1.1);
        QTest::keyClick(&c, Qt::Key_Home);
        QVERIFY(planes() == Planes{});
    }

    void theWheelStepsAndZoomsAboutTheCursor() {
        PlanePane& a = pane("planes.a");
        const double unit = window().openStudy().volume()->geometry().unit();
        const Vec3 forward = frameOf(PlaneName::a, planes(), document().beam.axis).forward, from = reference();
        const int steps = window().document().steps().count();
        const QPointF cursor(a.width() / 2.0 + 50, a.height() / 2.0 + 20);
        for (int i = 0; i < 3; ++i) wheel(a, cursor, -1, {});
        QVERIFY(std::abs(forward.dot(reference() - from) - 3 * unit) < 1e-9);
        QCOMPARE(window().document().steps().count(), steps + 1);  // one burst
        const Vec3 under = a.mapping().gridAt(cursor);
        wheel(a, cursor, 2, Qt::ControlModifier);
        QVERIFY(planes().crops[0].magnification > 1.2);
        QVERIFY(length(a.mapping().gridAt(cursor) - under) < 1e-6);
        QCOMPARE(planes().crops[1].magnification, 1.0);
    }

    void middleAndShiftDragsPanAndTheRightButtonSetsGreys() {
        PlanePane& b = pane("planes.b");
        const QPoint from(b.width() / 2, b.height() / 2), to = from + QPoint(30, -20);
        const Vec3 held = b.mapping().gridAt(from);
        drag(b, Qt::MiddleButton, {}, from, to);
        QVERIFY(length(b.mapping().gridAt(to) - held) < 1e-6);
        drag(b, Qt::LeftButton, Qt::ShiftModifier, to, from);
        QVERIFY(length(b.mapping().gridAt(from) - held) < 1e-6);
        QVERIFY(length(reference() - Vec3(window().openStudy().volume()->dataBox().centreMm())) < 1e-9);
        drag(b, Qt::RightButton, {}, from, from + QPoint(-160, -64));
        QCOMPARE(planes().window, 0.5);
        QCOMPARE(planes().level, 0.3);
        click("planes.b.reset");
        QVERIFY(planes() == Planes{});
    }

    void theLayoutIsRememberedAndPlanesThatNobodySeesAreNotMade() {
        QVERIFY(pane("planes.a").wanted(window().openStudy().volume()).has_value());
        key(Qt::Key_F2);
        QVERIFY(!pane("planes.a").wanted(window().openStudy().volume()));
        key(Qt::Key_F4);
        window().close();
        Settings settings(settingsFile());
        QCOMPARE(settings.paneLayout(), PaneLayout::large3d);
    }

    void everyControlSaysItsName() {
        for (const char* name : {"planes.a", "planes.b", "planes.c", "planes.a.reset", "planes.a.maximise"})
            QVERIFY2(!child(name)->accessibleName().isEmpty(), name);
        QCOMPARE(pane("planes.b").accessibleName(), "Plane B");
    }

private:
    static int brightnessAt(const PlanePane& pane, const QPointF& pixel) {
        const QImage& image = pane.image();
        return qGray(image.pixel(static_cast<int>(pixel.x() * image.width() / pane.width()),
                                 static_cast<int>(pixel.y() * image.height() / pane.height())));
    }
    void waitForPlanes() {
        QTRY_VERIFY(window().idle());
        for (const PlaneName plane : allPlaneNames)
            if (paneOf(plane).isVisible()) QVERIFY(!paneOf(plane).image().isNull());
    }
    void key(Qt::Key key) { QTest::keyClick(&window(), key); }
    static void moveTo(PlanePane& pane, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPoint& to) {
        QMouseEvent move(QEvent::MouseMove, to, pane.mapToGlobal(to), Qt::NoButton, button, modifiers);
        QCoreApplication::sendEvent(&pane, &move);
    }
    static void drag(PlanePane& pane, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPoint& from,
                     const QPoint& to) {
        QTest::mousePress(&pane, button, modifiers, from);
        moveTo(pane, button, modifiers, (from + to) / 2);
        moveTo(pane, button, modifiers, to);
        QTest::mouseRelease(&pane, button, modifiers, to);
    }
    static void wheel(PlanePane& pane, const QPointF& at, int notches, Qt::KeyboardModifiers modifiers) {
        QWheelEvent event(at, pane.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                          false);
        QCoreApplication::sendEvent(&pane, &event);
    }
    static void doubleClick(PlanePane& pane, QPoint at = {}) {
        if (at.isNull()) at = pane.rect().center() + QPoint(17, 11);
        QTest::mouseClick(&pane, Qt::LeftButton, {}, at);
        QTest::mouseDClick(&pane, Qt::LeftButton, {}, at);
    }
    [[nodiscard]] const Document& document() { return window().document().document(); }
    [[nodiscard]] const Planes& planes() { return document().scene.planes; }
    [[nodiscard]] Vec3 reference() { return referencePointOf(planes(), window().openStudy().volume()->dataBox()); }
    PlanePane& pane(const char* name) { return *child<PlanePane>(name); }
    PlanePane& paneOf(PlaneName plane) {
        return pane(plane == PlaneName::a ? "planes.a" : plane == PlaneName::b ? "planes.b" : "planes.c");
    }
    PaneGrid& grid() { return *child<PaneGrid>("panes"); }

    QString m_corners;
};

ECHOLUCENT_TEST_CLASS(TestPlanes)
#include "test_planes.moc"
