// Measurements that are named and commented in the real main window, and places that are none of the scan.
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPlainTextEdit>

#include "tests/app/planes/measuring_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/volume_view/scene/annotation/overlay.h"

using namespace echolucent;

class TestNamedMeasurements : public QObject, private MeasuringFixture {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { showWindow(); }
    void cleanup() { close(); }

    void onlyAPlaceInTheScanIsMarked() {
        const auto whole = markedPoints(obliqueGrid());
        auto voxels = std::get<VoxelArray<std::uint8_t>>(whole->voxels()).toVector();
        // A corner without data. It is no whole side, so that the box around the data holds it.
        for (std::int64_t z = 0; z < 40; ++z)
            for (std::int64_t y = 0; y < 30; ++y)
                for (std::int64_t x = 0; x < 45; ++x)
                    voxels[static_cast<std::size_t>(whole->geometry().offset(x, y, z))] = 0;
        open(file("corner.mha", {std::make_shared<const Volume>(whole->geometry(), Voxels(voxels), 255.0)}));
        key(Qt::Key_F3);
        QTRY_VERIFY(window().idle());
        const Vec3 outside = geometry().gridMmFromVoxel({20, 15, 20}), inside = at(2), other = at(5);
        PlanePane& pane = turnedToHold({outside, inside, other});
        const auto seen = [&pane](const Vec3& place) { return pane.mapping().seenAt(place); };
        const QString refusal = "That place lies outside the scan. Mark a place in it.";
        key(Qt::Key_M);
        press(pane, seen(outside));
        QCOMPARE(message(), refusal);
        press(pane, seen(inside));
        QVERIFY(message() != refusal);
        press(pane, seen(outside));
        QVERIFY(measurements().empty());
        QCOMPARE(message(), refusal);
        press(pane, QPointF(-4000, 20));  // beside the grid
        QVERIFY(measurements().empty());
        press(pane, seen(other));
        QCOMPARE(measurements().size(), 1u);
        QVERIFY(length(measurements()[0].placesMm[0] - inside) < 1e-9);
        // A mark is not dragged out of the scan either.
        drag(pane, seen(other), seen(outside));
        QVERIFY(length(measurements()[0].placesMm[1] - other) < 1e-9);
    }

    void aNameIsTypedRightAfterTheLastClick() {
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        child("dock.view")->raise();
        QTRY_VERIFY(child("room")->visibleRegion().isEmpty());
        const QPointF from = pane.mapping().seenAt(at(0)), to = pane.mapping().seenAt(at(1));
        key(Qt::Key_M);
        press(pane, from);
        QVERIFY(pane.hasFocus());
        press(pane, to);
        QTRY_VERIFY(!child("room")->visibleRegion().isEmpty());  // the panel came forward
        auto* name = child<QLineEdit>("measurements.name.field");
        QVERIFY(name->hasFocus());
        // Nothing was typed yet: undo is the window's.
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(measurements().empty());
        // The next measurement begins with a click, wherever the focus was.
        for (const QPointF& click : {from, to}) press(pane, click);
        QCOMPARE(measurements().size(), 1u);
        // These are keys of the window elsewhere: the front and the measuring tool.
        const Front front = document().scene.front;
        QTest::keyClicks(QApplication::focusWidget(), "NM");
        QCOMPARE(measurements()[0].name, std::string("NM"));
        QVERIFY(document().scene.front == front);
        for (const QPointF& click : {from, to}) press(pane, click + QPointF(0, 30));
        QCOMPARE(measurements().size(), 2u);
        QCOMPARE(name->text(), "");
        QVERIFY(name->hasFocus());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(pane.hasFocus());
        list().setFocus();
        QTest::keyClicks(QApplication::focusWidget(), "M");
        QTest::keyClicks(QApplication::focusWidget(), "V");
        QCOMPARE(measurements()[1].name, std::string("MV"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QVERIFY(pane.hasFocus());
        key(Qt::Key_M);
        // Letters are the new measurement's name, also the keys of the tools. Without a name Escape is the window's.
        for (const QPointF& click : {from, to}) press(pane, click + QPointF(0, -30));
        const auto* distance = child<QAction>("room.measureDistance");
        QVERIFY(name->hasFocus() && distance->isChecked());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!distance->isChecked() && pane.hasFocus());
        QCOMPARE(measurements().back().name, std::string());
        key(Qt::Key_M);
        for (const QPointF& click : {from, to}) press(pane, click + QPointF(0, 15));
        QTest::keyClicks(QApplication::focusWidget(), "MCA");
        QVERIFY(distance->isChecked());
        QCOMPARE(measurements().back().name, std::string("MCA"));
        pane.setFocus();
        key(Qt::Key_M);
        // A panel that was closed stays so, and the pane keeps the keys.
        key(Qt::Key_M);
        child<QDockWidget>("dock.room")->close();
        for (const QPointF& click : {from, to}) press(pane, click + QPointF(0, -15));
        QCOMPARE(measurements().size(), 5u);
        QVERIFY(child("dock.room")->isHidden() && pane.hasFocus());
    }

    void aNameAndACommentAreTypedInOneStepEach() {
        openPoints();
        PlanePane& pane = turnedToHold({at(0), at(1)});
        key(Qt::Key_M);
        drag(pane, pane.mapping().seenAt(at(0)), pane.mapping().seenAt(at(1)));
        key(Qt::Key_M);
        raise("dock.room");
        const int before = window().document().steps().count();
        const std::string value = measurementText(measurements()[0], geometry()).value();
        auto* name = child<QLineEdit>("measurements.name.field");
        QTest::keyClicks(name, "left ventricle ");
        QCOMPARE(measurements()[0].name, std::string("left ventricle"));
        QCOMPARE(name->text(), "left ventricle ");  // the blank before the next word
        QTest::keyClicks(name, "2");
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(measurements()[0].name, std::string("left ventricle 2"));
        QCOMPARE(window().document().steps().count(), before + 1);
        QCOMPARE(window().document().steps().undoText(), "name distance 1");
        const std::string label = "left ventricle 2 " + value;
        QCOMPARE(list().item(0)->text(), QString::fromStdString("1. " + label + ", in a plane"));
        QCOMPARE(pane.scene()->measurements.at(0).text, label);
        waitUntilIdle();
        QCOMPARE(window().volumeView().overlay().texts.at(0).text,
                 label + " (in plane " + std::string(nameOf(pane.plane())) + ")");
        auto* comment = child<QPlainTextEdit>("measurements.comment");
        QTest::keyClicks(comment, "at rest");
        QTest::keyClick(comment, Qt::Key_Return);
        QTest::keyClicks(comment, "again");
        QCOMPARE(measurements()[0].comment, std::string("at rest\nagain"));
        QCOMPARE(window().document().steps().count(), before + 2);
        QCOMPARE(window().document().steps().undoText(), "comment on distance 1");
        // A name of the list, chosen later, is a step of its own.
        child<QComboBox>("measurements.name")->setFocus();
        emit child<QComboBox>("measurements.name")->textActivated("BPD");
        QCOMPARE(measurements()[0].name, std::string("BPD"));
        QCOMPARE(window().document().steps().count(), before + 3);
        window().document().steps().setIndex(before);
        QCOMPARE(measurements()[0].name, std::string());
        QCOMPARE(name->text(), "");
        QCOMPARE(comment->toPlainText(), "");
        window().document().steps().redo();
        QCOMPARE(name->text(), "left ventricle 2");
        QTest::keyClick(&list(), Qt::Key_Delete);
        QVERIFY(measurements().empty());
        QCOMPARE(window().document().steps().undoText(), "remove distance 1");
        window().document().steps().undo();
        QCOMPARE(measurements().at(0).name, std::string("left ventricle 2"));
        // F2 is the list's, though it is a key of the window; a usual name that was typed takes the focus nowhere.
        list().setFocus();
        QTest::keyClick(&list(), Qt::Key_F2);
        QVERIFY(window().findChild<PaneGrid*>()->paneLayout() == PaneLayout::quad);
        QVERIFY(name->hasFocus());
        name->selectAll();
        QTest::keyClicks(name, "BPD");
        QTest::keyClick(name, Qt::Key_Tab);
        QVERIFY(comment->hasFocus());
        QCOMPARE(measurements().at(0).name, std::string("BPD"));
    }
};

ECHOLUCENT_TEST_CLASS(TestNamedMeasurements)
#include "test_named_measurements.moc"
