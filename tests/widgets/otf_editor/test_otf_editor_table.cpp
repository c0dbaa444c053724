// The table of the OTF editor's nodes: numbers typed into it, and what it shares with the plot.
#include <QLabel>
#include <QLineEdit>
#include <QTableView>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/otf_editor/editor_fixture.h"
#include "widgets/control_keys.h"
#include "widgets/otf_editor/curve_canvas.h"

using namespace echolucent;

class TestOtfEditorTable : public QObject, private EditorFixture {
    Q_OBJECT

private slots:
    void init() { showEditor(); }
    void cleanup() { close(); }

    void typedNumbersAreTakenExactly() {
        typeInto(1, 0, "0.3141592653589793");
        QVERIFY(manual().nodes[1].intensity == 0.3141592653589793);  // QCOMPARE would round
        typeInto(1, 1, "0,0625");
        QCOMPARE(manual().nodes[1].opacity, 0.0625);
        typeInto(2, 2, "120");  // stored value, of a white level of 255
        QVERIFY(manual().nodes[2].intensity == 120.0 / 255.0);
        QCOMPARE(manual().nodes[2].opacity, 0.8);
        QVERIFY(manual().nodes[0] == threeNodes.nodes[0]);
        QCOMPARE(editor().steps().count(), 3);
        for (int i = 0; i < 3; ++i) editor().steps().undo();
        QVERIFY(manual() == threeNodes);
    }

    void numbersOutOfRangeAreRefused_data() {
        QTest::addColumn<int>("column");
        QTest::addColumn<QString>("text");
        QTest::newRow("beyond the next node") << 0 << "0.95";
        QTest::newRow("before the last node") << 0 << "0.1";
        QTest::newRow("opacity above 1") << 1 << "1.01";
        QTest::newRow("negative opacity") << 1 << "-0.1";
        QTest::newRow("no number") << 1 << "much";
        QTest::newRow("not a number") << 1 << "nan";
        QTest::newRow("empty") << 1 << "";
        QTest::newRow("stored value beyond the next node") << 2 << "250";
    }
    void numbersOutOfRangeAreRefused() {
        QFETCH(int, column);
        QFETCH(QString, text);
        const QString before = table()->model()->index(1, column).data().toString();
        const QString readoutBefore = find<QLabel>("otfEditor.readout")->text();
        typeInto(1, column, text);
        QVERIFY(manual() == threeNodes);
        QCOMPARE(editor().steps().count(), 0);
        QCOMPARE(table()->model()->index(1, column).data().toString(), before);
        QVERIFY(find<QLabel>("otfEditor.readout")->text() != readoutBefore);
        QVERIFY(find<QLabel>("otfEditor.readout")->text().contains("node 2"));
    }

    void tableAndPlotShareTheSelection() {
        editor().model().selectNode(2);
        QCOMPARE(table()->currentIndex().row(), 2);
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {},
                          table()->visualRect(table()->model()->index(0, 1)).center());
        QCOMPARE(editor().model().selectedNode(), 0);
        editor().model().selectNode(-1);
        QVERIFY(!table()->currentIndex().isValid());
    }

    void tableAddsAndDeletes() {
        editor().model().selectNode(0);
        click("otfEditor.addNode");
        QCOMPARE(manual().nodes.size(), std::size_t{4});
        QVERIFY((manual().nodes[1] == CurveNode{0.35, opacityAt(threeNodes, 0.35)}));
        QCOMPARE(table()->model()->rowCount(), 4);
        QCOMPARE(table()->currentIndex().row(), 1);
        click("otfEditor.deleteNode");
        QVERIFY(manual() == threeNodes);
        table()->setFocus();
        table()->setCurrentIndex(table()->model()->index(2, 0));
        QTest::keyClick(table(), Qt::Key_Delete);
        QCOMPARE(manual().nodes.size(), std::size_t{2});
        QVERIFY(manual().nodes[1] == threeNodes.nodes[1]);
    }

    void typedDigitsNeitherEditNorChooseACurve() {
        const ControlKeys keys;
        table()->setFocus();
        table()->setCurrentIndex(table()->model()->index(1, 1));
        for (const Qt::Key key : {Qt::Key_1, Qt::Key_0, Qt::Key_Period, Qt::Key_5, Qt::Key_3})
            QTest::keyClick(editor().windowHandle(), key);
        QCOMPARE(editor().state().active, CurveKind::manual);
        QVERIFY(!table()->findChild<QLineEdit*>());
        QCOMPARE(table()->currentIndex(), table()->model()->index(1, 1));
        QVERIFY(manual() == threeNodes);
        QTest::keyClick(editor().windowHandle(), Qt::Key_Return);
        auto* field = table()->findChild<QLineEdit*>();
        QVERIFY(field);
        QTest::keyClick(field, Qt::Key_1);
        QCOMPARE(field->text(), QString("1"));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(manual().nodes[1].opacity, 1.0);
    }

    void dragInTheComposedEditorReachesTheTable() {
        CurveCanvas& canvas = editor().canvas();
        const auto inWindow = [&](QPoint position) { return canvas.mapTo(&editor(), position); };
        const QPoint from = canvas.axes().positionOf(threeNodes.nodes[1]).toPoint();
        QWindow* window = editor().windowHandle();
        QTest::mousePress(window, Qt::LeftButton, {}, inWindow(from));
        QTest::mouseMove(window, inWindow(from + QPoint(12, -24)));
        QTest::mouseRelease(window, Qt::LeftButton, {}, inWindow(from + QPoint(12, -24)));
        QVERIFY(manual().nodes[1].intensity > 0.5 && manual().nodes[1].opacity > 0.4);
        QCOMPARE(table()->model()->index(1, 0).data(Qt::EditRole).toString().toDouble(), manual().nodes[1].intensity);
        QCOMPARE(table()->model()->index(1, 1).data(Qt::EditRole).toString().toDouble(), manual().nodes[1].opacity);
        QCOMPARE(table()->currentIndex().row(), 1);
    }

private:
    void typeInto(int row, int column, const QString& text) {
        const QModelIndex index = table()->model()->index(row, column);
        const QPoint centre = table()->visualRect(index).center();
        QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, centre);
        QTest::mouseDClick(table()->viewport(), Qt::LeftButton, {}, centre);
        auto* field = table()->findChild<QLineEdit*>();
        QVERIFY(field);
        field->selectAll();
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(!table()->findChild<QLineEdit*>());  // the view takes the number in the next turn
    }
};

ECHOLUCENT_TEST_CLASS(TestOtfEditorTable)
#include "test_otf_editor_table.moc"
