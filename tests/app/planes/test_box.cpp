// The render box in the real main window: mouse and keys on planes, picture and panel.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QMouseEvent>
#include <QToolButton>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "app/window/review_room.h"
#include "io/document/document_file.h"
#include "processing/document/box_editing.h"
#include "tests/app/planes/room_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"
#include "widgets/panels/room_panel.h"
#include "widgets/planes/plane_pane.h"

using namespace echolucent;

class TestBox : public QObject, private RoomFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        QLocale::setDefault(QLocale::c());
        m_file = file("shapes.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        window().resize(1280, 720);
        useLook(Look{});  // light plays no part here, and takes its time
        open(m_file);
        key(Qt::Key_F3);
        QTRY_VERIFY(window().idle());
    }
    void cleanup() { close(); }

    void theKeySwitchesABoxAroundAllData() {
        key(Qt::Key_B);
        QVERIFY(box().on);
        QVERIFY(length(box().centreMm - dataBox().centreMm()) < 1e-9);
        QVERIFY(child<QCheckBox>("room.box")->isChecked());
        QVERIFY(window().volumeView().settings().clippingPlanes.empty());  // it cuts nothing off
        key(Qt::Key_B);
        QVERIFY(!box().on);
    }

    void facesCornersAndTheCentreAreDraggedInAPlane() {
        key(Qt::Key_B);
        PlanePane& a = pane("planes.a");
        const OrientedBox before = placed();
        // The right face, 30 pixels to the left.
        const BoxGrip right = grip(a, BoxGrip::Kind::face, {0, 1});
        drag(a, right.at, right.at + QPointF(-30, 0));
        const double mm = 30 * a.mapping().mmPerPixel();
        QVERIFY(std::abs(before.sizeMm[0] - placed().sizeMm[0] - mm) < 1e-6);
        QVERIFY(length(middleOf(placed(), {0, -1}) - middleOf(before, {0, -1})) < 1e-6);
        QCOMPARE(window().document().steps().undoText(), "size of the box");
        // The corner of top and left, 20 to the right and 10 down.
        const OrientedBox narrower = placed();
        const BoxGrip corner = grip(a, BoxGrip::Kind::corner, {0, -1}, {2, -1});
        drag(a, corner.at, corner.at + QPointF(20, 10));
        QVERIFY(std::abs(narrower.sizeMm[0] - placed().sizeMm[0] - 20 * a.mapping().mmPerPixel()) < 1e-6);
        QVERIFY(std::abs(narrower.sizeMm[2] - placed().sizeMm[2] - 10 * a.mapping().mmPerPixel()) < 1e-6);
        const OrientedBox smaller = placed();
        const BoxGrip centre = grip(a, BoxGrip::Kind::centre);
        drag(a, centre.at, centre.at + QPointF(15, -5));
        QVERIFY(length(placed().sizeMm - smaller.sizeMm) < 1e-9);
        QVERIFY(std::abs(length(placed().centreMm - smaller.centreMm) - std::hypot(15, 5) * a.mapping().mmPerPixel()) <
                1e-6);
        for (int i = 0; i < 3; ++i) window().document().steps().undo();
        QVERIFY(placed() == before);
        QVERIFY(!window().volumeView().dragging());
    }

    void aPlaneTurnsTheBoxAndNoTubeCore() {
        key(Qt::Key_B);
        PlanePane& a = pane("planes.a");
        const OrientedBox before = placed();
        const ViewDirection side = document().scene.side;
        const BoxGrip turn = grip(a, BoxGrip::Kind::turn);
        const QPointF centre = a.mapping().seenAt(before.centreMm), arm = turn.at - centre;
        const double radians = 20 * M_PI / 180;
        drag(a, turn.at,
             centre + QPointF(arm.x() * std::cos(radians) - arm.y() * std::sin(radians),
                              arm.x() * std::sin(radians) + arm.y() * std::cos(radians)));
        QVERIFY(std::abs(placed().axes.forward.dot(before.axes.forward) - std::cos(radians)) < 0.01);
        QVERIFY(length(placed().axes.down - before.axes.down) < 1e-6);  // A is seen along it
        QVERIFY(document().scene.side == side);
        QVERIFY(window().volumeView().settings().clippingPlanes.size() > 1);
    }

    void theFrontIsBowedAndEscapeTakesADragBack() {
        key(Qt::Key_B);
        Document next = document();
        next.scene.front = frontAcross({}, 15);
        window().document().edit(next, "front");
        PlanePane& b = pane("planes.b");
        const int steps = window().document().steps().count();
        const BoxGrip bow = grip(b, BoxGrip::Kind::bow);
        QTest::mousePress(&b, Qt::LeftButton, {}, bow.at.toPoint());
        moveTo(b, bow.at.toPoint() + QPoint(0, 40));
        QVERIFY(document().scene.front.surface.has_value());
        QTest::keyClick(&b, Qt::Key_Escape);
        QVERIFY(!document().scene.front.surface);
        QTest::mouseRelease(&b, Qt::LeftButton, {}, bow.at.toPoint());
        QCOMPARE(window().document().steps().count(), steps);
        drag(b, bow.at, bow.at + QPointF(0, 40));
        QVERIFY(document().scene.front.surface.has_value());
        QCOMPARE(window().document().steps().undoText(), "bow the front");
        // What is held follows the hand.
        QVERIFY((grip(b, BoxGrip::Kind::bow).at - bow.at - QPointF(0, 40)).manhattanLength() < 6);
    }

    void theFrontIsMovedInAPlane() {
        Document next = document();
        next.scene.front = frontAcross({}, 20);
        window().document().edit(next, "set up");
        PlanePane& a = pane("planes.a");
        const QPolygonF line = a.drawing().frontLine;
        QVERIFY(!line.isEmpty());
        // Beside the diamond in the middle and inside the pane's rim.
        const auto place = std::ranges::find_if(line, [&](const QPointF& at) { return at.x() > a.width() * 0.25; });
        const QPointF from = *place;
        drag(a, from, from + QPointF(0, 25));
        QVERIFY(std::abs(document().scene.front.depthMm - 20 - 25 * a.mapping().mmPerPixel()) < 1e-6);
        QCOMPARE(window().document().steps().undoText(), "front");
    }

    void theFrontStaysInItsPlacesInThePlanesWhileTheViewTurns() {
        Document next = document();
        next.scene.front = frontAcross({}, 20);
        window().document().edit(next, "set up");
        const QPolygonF line = pane("planes.a").drawing().frontLine;
        QVERIFY(!line.isEmpty());
        next = document();
        next.scene.pose.direction = {70, -30, 15};
        window().document().edit(next, "turn");
        QCOMPARE(pane("planes.a").drawing().frontLine, line);
        window().motionPlayer().setAngle(20);
        QCOMPARE(pane("planes.a").drawing().frontLine, line);
    }

    void theWheelOverItsLineMovesTheFrontAndElsewhereThePlanes() {
        Document next = document();
        next.scene.front = frontAcross({}, 20);
        window().document().edit(next, "set up");
        PlanePane& a = pane("planes.a");
        const QPolygonF line = a.drawing().frontLine;
        const QPointF on = *std::ranges::find_if(line, [&](const QPointF& at) { return at.x() > a.width() * 0.25; });
        const auto wheel = [&](const QPointF& at, int notches) {
            QWheelEvent event(at, a.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&a, &event);
        };
        const Planes before = document().scene.planes;
        const double unit = window().openStudy().volume()->geometry().unit();
        wheel(on, -1);
        QVERIFY(std::abs(document().scene.front.depthMm - 20 - unit) < 1e-9);
        QVERIFY(document().scene.planes == before);
        wheel(on + QPointF(0, 60), -1);
        QVERIFY(std::abs(document().scene.front.depthMm - 20 - unit) < 1e-9);
        QVERIFY(document().scene.planes != before);
    }

    void boxAndFrontAreToldApartByPointerAndPlace() {
        key(Qt::Key_B);
        Document next = document();
        next.scene.front = frontAcross({}, 0.1);  // on the box's own face
        window().document().edit(next, "set up");
        PlanePane& a = pane("planes.a");
        const auto pointerAt = [&](const QPointF& at) {
            QMouseEvent move(QEvent::MouseMove, at, a.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
            QCoreApplication::sendEvent(&a, &move);
            return a.cursor().shape();
        };
        const BoxGrip bow = grip(a, BoxGrip::Kind::bow), face = grip(a, BoxGrip::Kind::face, {2, -1});
        QVERIFY(QLineF(bow.at, face.at).length() >= 16.0);
        QCOMPARE(pointerAt(bow.at), Qt::PointingHandCursor);
        QCOMPARE(pointerAt(face.at), Qt::SizeVerCursor);
        QCOMPARE(pointerAt(grip(a, BoxGrip::Kind::centre).at), Qt::SizeAllCursor);
    }

    void theFrontIsHeldIn3d() {
        Document next = document();
        next.scene.front = frontAcross({}, 20);
        next.scene.pose.direction = {60, 0, 0};
        window().document().edit(next, "set up");
        child<QCheckBox>("view.front.show")->setChecked(true);
        QTRY_VERIFY(window().volumeView().pictureIsCurrent());
        const OrientedBox data = orientedBoxOf(window().openStudy().volume()->dataBox());
        const double depth = window().openStudy().volume()->geometry().depthsAlong({0, 0, 1}).nearest + 20;
        const Vec3 handle(data.centreMm[0], data.centreMm[1], depth - 0.08 * data.sizeMm[2]);
        const QPoint from = seenIn3d(handle);
        QTest::mousePress(pictureWindow(), Qt::LeftButton, {}, from);
        moveIn3d(from + QPoint(-30, 0));
        QTest::mouseRelease(pictureWindow(), Qt::LeftButton, {}, from + QPoint(-30, 0));
        QCOMPARE(window().document().steps().undoText(), "front");
        // The handle's picture has followed the hand.
        const double moved = document().scene.front.depthMm - 20;
        QVERIFY(std::abs(moved) > 1);
        const QPoint now = seenIn3d(handle + Vec3(0, 0, moved));
        QVERIFY((now - from - QPoint(-30, 0)).manhattanLength() <= 2);
        QVERIFY(document().scene.pose == next.scene.pose);
    }

    void aDragEndsWhereItsGripsVanishAndKeepsWhatElseChanges() {
        key(Qt::Key_B);
        QTest::keyClick(&window(), Qt::Key_1, Qt::ControlModifier);
        QTRY_VERIFY(window().volumeView().pictureIsCurrent());
        const QPoint from = seenIn3d(middleOf(placed(), {0, 1}));
        QTest::mousePress(pictureWindow(), Qt::LeftButton, {}, from);
        moveIn3d(from + QPoint(-20, 0));
        const double dragged = placed().sizeMm[0];
        // What changes while the hand drags stays when it goes on.
        Document next = document();
        next.scene.front = {.depthMm = 7};
        window().document().edit(next, "near cut");
        moveIn3d(from + QPoint(-30, 0));
        QVERIFY(placed().sizeMm[0] < dragged);
        QCOMPARE(document().scene.front.depthMm, 7.0);
        key(Qt::Key_B);
        QVERIFY(!box().on);
        moveIn3d(from + QPoint(-60, 0));
        QVERIFY(!box().on);
        QTest::mouseRelease(pictureWindow(), Qt::LeftButton, {}, from);
        key(Qt::Key_B);
        const OrientedBox again = placed();
        moveIn3d(from + QPoint(-10, 0));
        QVERIFY(placed() == again);
    }

    void anotherBeamLeavesTheBoxWhereItIs() {
        key(Qt::Key_B);
        Document next = document();
        next.scene.box.sizeMm = {20, 30, 40};
        window().document().edit(next, "size of the box");
        const auto corners = placed().corners();
        window().document().edit(withBeam(document(), {BeamAxis::plusX, BeamSource::person}), "beam axis");
        const OrientedBox after = placed();
        for (const Vec3& corner : corners) {
            const Vec3 place = after.inBox(corner);
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY(std::abs(std::abs(place[axis]) - after.sizeMm[axis] / 2) < 1e-6);
        }
    }

    void theBrightnessOfTheLookIsThatOfThePlanes() {
        PlanePane& a = pane("planes.a");
        const int before = qGray(a.image().pixel(a.image().rect().center()));
        Document next = document();
        next.scene.look.brightness = 0.5;
        window().document().edit(next, "brightness");
        QVERIFY(std::abs(qGray(a.image().pixel(a.image().rect().center())) - before / 2) <= 1);
    }

    void thePanelSetsSizesSlabsAndTheWholeBox() {
        key(Qt::Key_B);
        raise("dock.room");
        const Box whole = box();
        auto* width = child<QDoubleSpinBox>("room.width");
        width->setFocus();
        width->selectAll();
        QTest::keyClicks(width, "30");
        QTest::keyClick(width, Qt::Key_Return);
        QCOMPARE(box().sizeMm[0], 30.0);
        click("room.wholeBox");
        QVERIFY(length(box().sizeMm - whole.sizeMm) < 1e-9);
        click("room.slab.b");
        QVERIFY(std::abs(box().sizeMm[2] - child<QDoubleSpinBox>("room.slab.thickness")->value()) < 1e-9);
        QVERIFY(length(frameOf(viewpointOf(document())).forward -
                       frameOf(PlaneName::b, document().scene.planes, document().beam.axis).forward) < 1e-9);
    }

    void aFaceIsDraggedInThePicture() {
        key(Qt::Key_B);
        QTest::keyClick(&window(), Qt::Key_1, Qt::ControlModifier);
        QTRY_VERIFY(window().volumeView().pictureIsCurrent());
        const OrientedBox before = placed();
        const QPoint from = seenIn3d(middleOf(before, {0, 1}));
        const Pose pose = document().scene.pose;
        dragIn3d(from, from + QPoint(-25, 0));
        const double mm = before.sizeMm[0] - placed().sizeMm[0];
        const Camera camera = window().volumeView().shownCamera();
        QVERIFY(std::abs(mm - 25 * camera.heightMm / window().volumeView().height()) < 0.2);
        QVERIFY(document().scene.pose == pose);  // the picture did not turn
        window().document().steps().undo();
        QVERIFY(placed() == before);
        // Beside the marks the left button orbits as ever.
        dragIn3d(from + QPoint(-60, 31), from + QPoint(-40, 31));
        QVERIFY(document().scene.pose != pose);
    }

    void aBoxBesideTheDataSaysSo() {
        key(Qt::Key_3);  // any curve, not the adaptive one alone
        key(Qt::Key_B);
        auto* message = child<MessageBar>("message");
        QVERIFY2(!message->text().contains("beside the data"), qPrintable(message->text()));
        Document next = document();
        next.scene.box.centreMm += Vec3(500, 0, 0);
        window().document().edit(next, "move box");
        QTRY_VERIFY2(message->text().contains("beside the data"), qPrintable(message->text()));
        key(Qt::Key_B);
        QTRY_VERIFY2(!message->text().contains("beside the data"), qPrintable(message->text()));
    }

    void twoHundredActionsAreUndoneAndRedoneByteForByte() {
        key(Qt::Key_B);
        std::mt19937 random(12);
        const auto near = [&random](const QWidget& widget) {
            return QPointF(widget.width() * (0.2 + 0.6 * static_cast<double>(random() % 1000) / 1000.0),
                           widget.height() * (0.2 + 0.6 * static_cast<double>(random() % 1000) / 1000.0));
        };
        const std::vector<std::function<void()>> actions{
            [&] {
                PlanePane& any = anyPane(random());
                drag(any, near(any), near(any));
            },
            [&] {
                PlanePane& any = anyPane(random());
                const QPointF at = near(any);
                QWheelEvent wheel(at, any.mapToGlobal(at), {}, {0, random() % 2 ? 120 : -120}, Qt::NoButton,
                                  random() % 2 ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase, false);
                QCoreApplication::sendEvent(&any, &wheel);
            },
            [&] { QTest::keyClick(&anyPane(random()), random() % 2 ? Qt::Key_Left : Qt::Key_PageDown); },
            [&] {
                PlanePane& any = anyPane(random());
                const BoxDrawing drawing = any.drawing();
                if (drawing.grips.empty()) return;
                const BoxGrip held = drawing.grips[random() % drawing.grips.size()];
                if (any.rect().contains(held.at.toPoint())) drag(any, held.at, held.at + QPointF(9, 7));
            },
            [&] { QTest::keyClick(&window(), static_cast<Qt::Key>(Qt::Key_1 + random() % 6), Qt::ControlModifier); },
            [&] { QTest::keyClick(&window(), Qt::Key_B); },
            [&] { QTest::keyClick(&window(), static_cast<Qt::Key>(Qt::Key_1 + random() % 5)); },
            [&] { QTest::keyClick(&window(), Qt::Key_L); },
            [&] {
                QTest::keyClick(&window(), Qt::Key_S);
                const QPoint from(120, 90);
                dragIn3d(from, from + QPoint(30 + static_cast<int>(random() % 30), 25));
                QTest::keyClick(&window(), Qt::Key_S);
            },
            [&] { QTest::keyClick(&window().volumeView(), Qt::Key_Right, Qt::ControlModifier); },
        };
        window().document().steps().clear();
        const std::string first = jsonOf(document());
        for (int i = 0; i < 200; ++i) actions[random() % actions.size()]();
        const std::string last = jsonOf(document());
        DocumentSteps& steps = window().document().steps();
        QVERIFY2(steps.count() > 120, qPrintable(QString::number(steps.count())));
        while (steps.canUndo()) steps.undo();
        QCOMPARE(QByteArray::fromStdString(jsonOf(document())), QByteArray::fromStdString(first));
        while (steps.canRedo()) steps.redo();
        QCOMPARE(QByteArray::fromStdString(jsonOf(document())), QByteArray::fromStdString(last));
    }

    void everyControlSaysItsName() {
        for (const QWidget* control : child("room")->findChildren<QWidget*>())
            if (control->objectName().startsWith("room."))
                QVERIFY2(!control->accessibleName().isEmpty(), qPrintable(control->objectName()));
    }

private:
    static BoxGrip grip(PlanePane& pane, BoxGrip::Kind kind, BoxFace first = {}, BoxFace second = {}) {
        const bool corner = kind == BoxGrip::Kind::corner;
        for (const BoxGrip& grip : pane.drawing().grips) {
            if (grip.kind != kind) continue;
            const bool same = grip.first == first && grip.second == second;
            const bool other = corner && grip.first == second && grip.second == first;
            if (kind == BoxGrip::Kind::face ? grip.first == first : !corner || same || other) return grip;
        }
        qFatal("no such grip");
        return {};
    }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestBox)
#include "test_box.moc"
