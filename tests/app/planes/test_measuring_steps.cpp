// The measuring tools in the hand in the real main window: steps, drags of marks, Escape, the list.
#include <QAction>
#include <QToolButton>
#include <cmath>

#include "tests/app/planes/measuring_fixture.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

using namespace echolucent;

class TestMeasuringSteps : public QObject, private MeasuringFixture {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { showWindow(); }
    void cleanup() { close(); }

    void stepsAreUndoneAndMeasurementsRemoved() {
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        key(Qt::Key_M);
        const int before = window().document().steps().count();
        for (int i = 0; i < 2; ++i)
            drag(pane, pane.mapping().seenAt(at(0)) + QPointF(0, 30 * i),
                 pane.mapping().seenAt(at(1)) + QPointF(0, 30 * i));
        QCOMPARE(measurements().size(), 2u);
        QCOMPARE(measurements()[1].id, 2);
        QCOMPARE(window().document().steps().count(), before + 2);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(measurements().size(), 1u);
        QCOMPARE(list().count(), 1);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(measurements().size(), 2u);
        raise("dock.room");
        list().setCurrentRow(0);
        click("measurements.remove");
        QCOMPARE(measurements().size(), 1u);
        QCOMPARE(measurements()[0].id, 2);
        QCOMPARE(window().document().steps().undoText(), "remove distance 1");
        click("measurements.removeAll");
        QVERIFY(measurements().empty());
        QVERIFY(!list().isVisible());
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(measurements().size(), 1u);
    }

    void aMarkIsDraggedInOneStep_data() {
        QTest::addColumn<bool>("tool");
        QTest::newRow("without a tool") << false;
        QTest::newRow("with the tool") << true;
    }
    void aMarkIsDraggedInOneStep() {
        QFETCH(bool, tool);
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        key(Qt::Key_M);
        drag(pane, pane.mapping().seenAt(at(0)), pane.mapping().seenAt(at(1)));
        if (!tool) key(Qt::Key_M);
        const Planes planes = planesOf(document(), 1);
        const int before = window().document().steps().count();
        const QPointF mark = pane.mapping().seenAt(at(1)), to = mark + QPointF(-31.5, 22.25);
        // The target is 16 pixels wide; what is held keeps its place under the hand.
        drag(pane, mark + QPointF(5, -5), to + QPointF(5, -5));
        QCOMPARE(measurements().size(), 1u);
        QVERIFY(length(measurements()[0].placesMm[1] - pane.mapping().gridAt(to)) < 1e-9);
        QVERIFY(length(measurements()[0].placesMm[0] - at(0)) < 1e-9);
        QCOMPARE(window().document().steps().count(), before + 1);
        QCOMPARE(window().document().steps().undoText(), "move distance 1");
        QVERIFY(planesOf(document(), 1) == planes);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(length(measurements()[0].placesMm[1] - at(1)) < 1e-9);
        // Escape ends a drag without change.
        press(pane, mark, false);
        moveTo(pane, to.toPoint());
        QVERIFY(length(measurements()[0].placesMm[1] - at(1)) > 1.0);
        QTest::keyClick(&pane, Qt::Key_Escape);
        QVERIFY(length(measurements()[0].placesMm[1] - at(1)) < 1e-9);
        release(pane, to);
        QVERIFY(length(measurements()[0].placesMm[1] - at(1)) < 1e-9);
        // A press beside the target holds nothing.
        if (!tool) {
            drag(pane, mark + QPointF(0, 12), mark + QPointF(10, 30));
            QVERIFY(length(measurements()[0].placesMm[1] - at(1)) < 1e-9);
        }
    }

    void escapeDropsWhatIsMarkedThenTheTool() {
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        doubleClick(this->pane("planes.a"));
        doubleClick(this->pane("planes.a"));
        key(Qt::Key_M);
        QVERIFY(child<QToolButton>("measurements.distance")->isChecked());
        QVERIFY(child<QAction>("room.measureDistance")->isChecked());
        press(pane, pane.mapping().seenAt(at(0)));
        QTest::keyClick(&pane, Qt::Key_Escape);
        QVERIFY(child<QToolButton>("measurements.distance")->isChecked());
        press(pane, pane.mapping().seenAt(at(1)));
        QVERIFY(measurements().empty());  // what was marked before Escape is gone
        QTest::keyClick(&pane, Qt::Key_Escape);
        QTest::keyClick(&pane, Qt::Key_Escape);
        QVERIFY(!child<QToolButton>("measurements.distance")->isChecked());
        // Without a tool a click moves the reference point again.
        press(pane, pane.mapping().seenAt(at(1)));
        QCOMPARE(window().document().steps().undoText(), "move reference point");
        QVERIFY(measurements().empty());
    }

    void aMeasurementBelongsToOnePaneAndOnePlane() {
        openPoints();
        key(Qt::Key_M);
        PlanePane &a = pane("planes.a"), &b = pane("planes.b");
        press(a, QPointF(a.width() / 2.0 - 30, a.height() / 2.0));
        press(b, QPointF(b.width() / 2.0 - 30, b.height() / 2.0));
        QVERIFY(measurements().empty());
        press(b, QPointF(b.width() / 2.0 + 30, b.height() / 2.0));
        QCOMPARE(measurements().size(), 1u);
        const ViewFrame frame = frameOf(PlaneName::b, planesOf(document(), 1), document().beam.axis);
        QVERIFY(std::abs(frame.forward.dot(measurements()[0].placesMm[1] - measurements()[0].placesMm[0])) < 1e-9);
        // A plane that was stepped away is not gone on in.
        press(a, QPointF(a.width() / 2.0 - 30, a.height() / 2.0));
        QTest::keyClick(&a, Qt::Key_PageDown);
        press(a, QPointF(a.width() / 2.0 + 30, a.height() / 2.0));
        QCOMPARE(measurements().size(), 1u);
        // Nothing is marked where there is no data, and the window says so.
        key(Qt::Key_Escape);
        QTest::keyClick(&a, Qt::Key_Minus);
        press(a, QPointF(30, a.height() - 30.0));
        QVERIFY2(message().contains("no data where you clicked"), qPrintable(message()));
        press(a, QPointF(a.width() / 2.0, a.height() / 2.0));
        QVERIFY(!message().contains("no data where you clicked"));
    }

    void theListGoesToPhaseAndPlane() {
        open(file("phases.mha",
                  {smallPhantom(PhantomScene::shapes, 5, 0.0), smallPhantom(PhantomScene::shapes, 5, 0.5)}));
        key(Qt::Key_F3);
        QTRY_VERIFY(!window().reviewRoom().busy());
        window().document().showPhase(1, 1);
        waitUntilIdle();
        PlanePane& c = pane("planes.c");
        key(Qt::Key_M);
        drag(c, QPointF(c.width() / 2.0 - 25, c.height() / 2.0 - 10),
             QPointF(c.width() / 2.0 + 40, c.height() / 2.0 + 12));
        key(Qt::Key_M);
        QCOMPARE(measurements().size(), 1u);
        QCOMPARE(measurements()[0].phase, 1);
        QVERIFY2(list().item(0)->text().endsWith(", in a plane, phase 2"), qPrintable(list().item(0)->text()));
        window().document().showPhase(1, 0);
        QTest::keyClick(&c, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&pane("planes.a"), Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&c, Qt::Key_PageDown);
        waitUntilIdle();
        QVERIFY(c.scene()->measurements.empty());  // another phase's
        QVERIFY(window().volumeView().overlay().texts.empty());
        raise("dock.room");
        const QRect row = list().visualItemRect(list().item(0));
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(phaseOf(document(), 1), 1);
        waitUntilIdle();
        bool held = false;
        for (const char* name : {"planes.a", "planes.b", "planes.c"})
            held = held || liesInPlane(measurements()[0].placesMm, pane(name).mapping().view, 1e-6);
        QVERIFY(held);
        // There already, nothing is a step.
        const int steps = window().document().steps().count();
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(window().document().steps().count(), steps);
    }

    void oneToolIsInTheHand() {
        openPoints();
        key(Qt::Key_M);
        key(Qt::Key_S);
        QVERIFY(!child<QToolButton>("measurements.distance")->isChecked());
        QVERIFY(child<QToolButton>("room.scalpel.freehand")->isChecked());
        QTest::keyClick(&window(), Qt::Key_M, Qt::ShiftModifier);
        QVERIFY(child<QToolButton>("measurements.angle")->isChecked());
        QVERIFY(!child<QToolButton>("room.scalpel.freehand")->isChecked());
    }
};

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    QApplication::setStyle(QStringLiteral("Fusion"));
    TestMeasuringSteps test;
    return QTest::qExec(&test, count, arguments);
}

#include "test_measuring_steps.moc"
