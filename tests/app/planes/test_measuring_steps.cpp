// The measuring tools in the hand in the real main window: steps, drags of marks, Escape, the list.
#include <QAction>
#include <QClipboard>
#include <QImage>
#include <QToolButton>
#include <cmath>

#include "app/motion/motion_player.h"
#include "tests/app/planes/measuring_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/casting/picture_image.h"
#include "widgets/theme_colours.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

using namespace echolucent;

class TestMeasuringSteps : public QObject, private MeasuringFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QApplication::setStyle(QStringLiteral("Fusion"));
        QLocale::setDefault(QLocale::c());
    }
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
        const Planes planes = document().scene.planes;
        const int before = window().document().steps().count();
        const QPointF mark = pane.mapping().seenAt(at(1)), to = mark + QPointF(-31.5, 22.25);
        // The target is 16 pixels wide; what is held keeps its place under the hand.
        drag(pane, mark + QPointF(5, -5), to + QPointF(5, -5));
        QCOMPARE(measurements().size(), 1u);
        QVERIFY(length(measurements()[0].placesMm[1] - pane.mapping().gridAt(to)) < 1e-9);
        QVERIFY(length(measurements()[0].placesMm[0] - at(0)) < 1e-9);
        QCOMPARE(window().document().steps().count(), before + 1);
        QCOMPARE(window().document().steps().undoText(), "move distance 1");
        QVERIFY(document().scene.planes == planes);
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

    void planesSayWhatTheToolWantsUntilItIsDone() {
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        PlanePane& other = this->pane(pane.plane() == PlaneName::a ? "planes.b" : "planes.a");
        const auto accents = [&] {
            const QImage shown = pane.grab().toImage();
            const QColor accent = coloursOverPictures().accent;
            int count = 0;
            for (int y = shown.height() * 3 / 4; y < shown.height(); ++y)
                for (int x = 0; x < shown.width(); ++x) {
                    const QColor is = shown.pixelColor(x, y);
                    count += std::abs(is.red() - accent.red()) + std::abs(is.green() - accent.green()) < 40;
                }
            return count;
        };
        QCOMPARE(pane.hint(), "");
        const int before = accents();
        key(Qt::Key_M);
        QCOMPARE(pane.hint(), "Click the two ends of the distance");
        QVERIFY(accents() > before + 100);
        press(pane, pane.mapping().seenAt(at(0)));
        QCOMPARE(pane.hint(), "Click the other end");
        QCOMPARE(other.hint(), "Click the two ends of the distance");
        press(pane, pane.mapping().seenAt(at(1)));
        QCOMPARE(pane.hint(), "");
        QTest::keyClick(&window(), Qt::Key_M, Qt::ShiftModifier);
        QCOMPARE(other.hint(), "Click three places; the angle is at the second");
        QTest::keyClick(&pane, Qt::Key_Escape);
        QCOMPARE(other.hint(), "");
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
        const ViewFrame frame = frameOf(PlaneName::b, document().scene.planes, document().beam.axis);
        QVERIFY(std::abs(frame.forward.dot(measurements()[0].placesMm[1] - measurements()[0].placesMm[0])) < 1e-9);
        // A plane that was stepped away is not gone on in.
        press(a, QPointF(a.width() / 2.0 - 30, a.height() / 2.0));
        QTest::keyClick(&a, Qt::Key_PageDown);
        press(a, QPointF(a.width() / 2.0 + 30, a.height() / 2.0));
        QCOMPARE(measurements().size(), 1u);
    }

    void theListGoesToPhaseAndPlane() {
        openPhases();
        window().document().showPhase(1);
        waitUntilIdle();
        PlanePane& c = pane("planes.c");
        key(Qt::Key_M);
        drag(c, QPointF(c.width() / 2.0 - 25, c.height() / 2.0 - 10),
             QPointF(c.width() / 2.0 + 40, c.height() / 2.0 + 12));
        key(Qt::Key_M);
        QCOMPARE(measurements().size(), 1u);
        QCOMPARE(measurements()[0].phase, 1);
        QVERIFY2(list().item(0)->text().endsWith(", in a plane, volume 2"), qPrintable(list().item(0)->text()));
        window().document().showPhase(0);
        QTest::keyClick(&c, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&pane("planes.a"), Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&c, Qt::Key_PageDown);
        waitUntilIdle();
        QVERIFY(c.scene()->measurements.empty());  // another phase's
        QVERIFY(window().volumeView().overlay().texts.empty());
        raise("dock.room");
        const QRect row = list().visualItemRect(list().item(0));
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(phaseOf(document(), firstPane), 1);
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

    void theListPausesAMotion() {
        openPhases();
        PlanePane& c = pane("planes.c");
        key(Qt::Key_M);
        drag(c, QPointF(c.width() / 2.0 - 25, c.height() / 2.0 - 10),
             QPointF(c.width() / 2.0 + 40, c.height() / 2.0 + 12));
        QCOMPARE(measurements().size(), 1u);
        MotionPlayer& player = window().motionPlayer();
        player.setMinimumFrameInterval(1'000'000);
        player.play();
        raise("dock.room");
        QVERIFY(player.isPlaying());
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(list().item(0)).center());
        QVERIFY(!player.isPlaying());
        QCOMPARE(phaseOf(document(), firstPane), measurements()[0].phase);
        waitUntilIdle();
    }

    /// The OTF of a phase that was stepped to is computed first, and meanwhile the picture is the phase before's.
    void aSurfaceIsMarkedInThePictureOfItsOwnPhase() {
        openPhases();
        Document next = document();
        next.motion.scenario = MotionScenario::object;
        next.motion.otf = MotionOtf::eachView;
        next.curves.manual = {{{0.2, 0.0}, {0.2, 1.0}, {1.0, 1.0}}};
        next.panes.at(firstPane).curve = CurveKind::manual;
        window().document().edit(next, "each phase's OTF");
        waitUntilIdle();
        key(Qt::Key_M);
        const QPointF middle(QRect({}, window().volumeView().size()).center());
        QTest::keyClick(&window(), Qt::Key_Period);
        QCOMPARE(phaseOf(document(), firstPane), 1);
        clickIn3d(middle);
        QVERIFY2(message().contains("picture of this volume is not there yet"), qPrintable(message()));
        waitUntilIdle();
        QVERIFY(window().volumeView().overlay().discs.empty());
        clickIn3d(middle);
        QVERIFY2(!message().contains("nothing was marked"), qPrintable(message()));
        QTRY_COMPARE(window().volumeView().overlay().discs.size(), 1u);
        clickIn3d(middle + QPointF(20, 10));
        QCOMPARE(measurements().size(), 1u);
        QCOMPARE(measurements()[0].phase, 1);
        waitUntilIdle();
    }

    void aPictureShowsTheMeasurementsOfTheVolumeThatItIsOf() {
        openPhases();
        Document next = document();
        next.motion.scenario = MotionScenario::object;
        next.motion.otf = MotionOtf::eachView;
        const Vec3 centre = (dataBox().lowMm + dataBox().highMm) * 0.5;
        next.measurements = {{.id = 1, .placesMm = {centre - Vec3(20, 0, 0), centre + Vec3(20, 0, 0)}, .phase = 0},
                             {.id = 2, .placesMm = {centre - Vec3(0, 30, 0), centre + Vec3(0, 30, 0)}, .phase = 1}};
        window().document().edit(next, "each phase's OTF");
        waitUntilIdle();
        const auto saved = [&](const QString& name) {
            const QString path = temporaryFolder().filePath(name);
            if (!window().savePicture(path)) qFatal("not saved");
            return QImage(path);
        };
        const auto texts = [&] {
            QStringList all;
            for (const auto& words : window().volumeView().overlay().texts) all << QString::fromStdString(words.text);
            return all;
        };
        const QImage first = saved("first.png");
        QCOMPARE(texts(), QStringList{"40.0 mm (in plane A)"});
        // The view keeps the picture of a phase until the OTF of the next one is there.
        QTest::keyClick(&window(), Qt::Key_Period);
        QCOMPARE(phaseOf(document(), firstPane), 1);
        QVERIFY(window().volumeView().measured() != window().openStudy().volume());
        QCOMPARE(texts(), QStringList{"40.0 mm (in plane A)"});
        QCOMPARE(saved("stepped.png"), first);
        QTest::keyClick(&window(), Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(rgbBytesOf(QApplication::clipboard()->image()), rgbBytesOf(first));
        waitUntilIdle();
        QCOMPARE(texts(), QStringList{"60.0 mm (in plane B)"});
        QVERIFY(saved("second.png") != first);
    }

    void anotherStudyEndsTheDragOfAMark() {
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        key(Qt::Key_M);
        drag(pane, pane.mapping().seenAt(at(0)), pane.mapping().seenAt(at(1)));
        const Measurement measured = measurements().at(0);
        const QPointF mark = pane.mapping().seenAt(at(1));
        press(pane, mark, false);
        moveTo(pane, (mark + QPointF(-20, 10)).toPoint());
        QVERIFY(!(measurements().at(0) == measured));
        open(file("others.mha", {markedPoints(obliqueGrid())}));
        QVERIFY(measurements().empty());
        // A session may bring a measurement of the same number.
        Document next = document();
        next.measurements = {measured};
        window().document().edit(next, "distance 1");
        moveTo(pane, (mark + QPointF(-40, 20)).toPoint());
        release(pane, mark + QPointF(-40, 20));
        QCOMPARE(measurements().size(), 1u);
        QVERIFY(measurements()[0] == measured);
        waitUntilIdle();
    }

    void theToolsCursorComesBackBesideAMarkOfTheBox_data() {
        QTest::addColumn<Qt::Key>("tool");
        QTest::newRow("measuring") << Qt::Key_M;
        QTest::newRow("scalpel") << Qt::Key_S;
    }
    void theToolsCursorComesBackBesideAMarkOfTheBox() {
        QFETCH(Qt::Key, tool);
        openPoints();
        key(Qt::Key_F2);
        key(Qt::Key_B);
        waitUntilIdle();
        const QPoint mark = seenIn3d(placed().centreMm);
        const auto cursorAt = [&](const QPoint& to) {
            QMouseEvent move(QEvent::MouseMove, to, pictureWindow()->mapToGlobal(to), Qt::NoButton, Qt::NoButton,
                             Qt::NoModifier);
            QCoreApplication::sendEvent(pictureWindow(), &move);
            return pictureWindow()->cursor().shape();
        };
        const QPoint beside = mark + QPoint(37, 23);
        QCOMPARE(cursorAt(beside), Qt::ArrowCursor);
        QCOMPARE(cursorAt(mark), Qt::OpenHandCursor);
        key(tool);  // over the mark
        QCOMPARE(cursorAt(beside), Qt::CrossCursor);
        QCOMPARE(cursorAt(mark), Qt::OpenHandCursor);
        QCOMPARE(cursorAt(beside), Qt::CrossCursor);
        QCOMPARE(cursorAt(mark), Qt::OpenHandCursor);
        key(Qt::Key_B);  // the mark is gone
        QCOMPARE(pictureWindow()->cursor().shape(), Qt::CrossCursor);
        key(tool);
        QCOMPARE(pictureWindow()->cursor().shape(), Qt::ArrowCursor);
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

private:
    void openPhases() {
        open(file("phases.mha",
                  {smallPhantom(PhantomScene::shapes, 5, 0.0), smallPhantom(PhantomScene::shapes, 5, 0.5)}));
        key(Qt::Key_F3);
        QTRY_VERIFY(window().idle());
    }
};

ECHOLUCENT_TEST_CLASS(TestMeasuringSteps)

#include "test_measuring_steps.moc"
