// The OTF editor as a whole: legend, choice of the curve, actions and their shortcuts, words beside the plot.
#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>
#include <array>
#include <cmath>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/otf_editor/editor_fixture.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/otf_editor/node_reduction.h"

using namespace echolucent;

class TestOtfEditor : public QObject, private EditorFixture {
    Q_OBJECT

private slots:
    void init() { showEditor(); }
    void cleanup() { close(); }

    void legendSwitchesVisibility() {
        const std::array<QString, 5> keys{"adaptive", "manual", "linear", "parabolic", "quartic"};
        for (const CurveKind kind : allCurveKinds) {
            const QString name = "otfEditor.legend." + keys[indexOf(kind)] + ".visible";
            QVERIFY(find<QCheckBox>(name)->isChecked());
            click(name);
            QVERIFY(!editor().state().visible[indexOf(kind)]);
        }
        QVERIFY((editor().state().visible == std::array<bool, 5>{}));
        editor().setActive(CurveKind::quartic);  // what is rendered is drawn
        QVERIFY(find<QCheckBox>("otfEditor.legend.quartic.visible")->isChecked());
        QVERIFY(!find<QCheckBox>("otfEditor.legend.linear.visible")->isChecked());
        QCOMPARE(editor().steps().count(), 1);  // the choice of the rendered curve, and no step for what is drawn
    }

    void radioButtonsAndKeysSwitchTheActiveCurve() {
        editor().setAdaptiveCurve(someAdaptiveCurve());
        QSignalSpy curves(&editor(), &OtfEditor::activeCurveChanged);
        const std::array<QString, 5> keys{"adaptive", "manual", "linear", "parabolic", "quartic"};
        for (const CurveKind kind : allCurveKinds) {
            click("otfEditor.active." + keys[indexOf(kind)]);
            QCOMPARE(editor().state().active, kind);
            QVERIFY(editor().activateAction(kind)->isChecked());
            QVERIFY(curves.last().at(0).value<OpacityCurve>() == curveOf(editor().state(), kind));
        }
        editor().canvas().setFocus();
        for (const CurveKind kind :
             {CurveKind::linear, CurveKind::adaptive, CurveKind::quartic, CurveKind::manual, CurveKind::parabolic}) {
            QTest::keyClick(editor().windowHandle(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(indexOf(kind))));
            QCOMPARE(editor().state().active, kind);
            QVERIFY(find<QRadioButton>("otfEditor.active." + keys[indexOf(kind)])->isChecked());
            QVERIFY(curves.last().at(0).value<OpacityCurve>() == curveOf(editor().state(), kind));
        }
    }

    void undoRedoResetByKeysAndButtons() {
        editor().canvas().setFocus();
        QVERIFY(!find<QToolButton>("otfEditor.undo")->isEnabled());
        editor().model().moveNode(0, {0.3, 0.3});
        const ManualCurve moved = manual();
        QTest::keyClick(editor().windowHandle(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(manual() == threeNodes);
        QTest::keyClick(editor().windowHandle(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(manual() == moved);
        click("otfEditor.undo");
        QVERIFY(manual() == threeNodes);
        click("otfEditor.redo");
        QVERIFY(manual() == moved);
        QTest::keyClick(editor().windowHandle(), Qt::Key_C);
        QVERIFY(manual() == CurveSet{}.manual);
        click("otfEditor.undo");
        QVERIFY(manual() == moved);
        editor().setActive(CurveKind::adaptive);
        QVERIFY(!find<QToolButton>("otfEditor.reset")->isEnabled());
    }

    void presetsReplaceTheNodes() {
        editor().findChild<QAction*>("otfEditor.presets.fetal")->trigger();
        QVERIFY(manual() == ManualCurve({{{60.0 / 255, 0.0}, {120.0 / 255, 0.6}, {1.0, 0.8}}}));
        editor().findChild<QAction*>("otfEditor.presets.ramp")->trigger();
        QVERIFY(manual() == ManualCurve({{{0.0, 0.0}, {1.0, 1.0}}}));
        editor().findChild<QAction*>("otfEditor.presets.parabolic")->trigger();
        QVERIFY(std::abs(opacityAt(manual(), 0.5) - 0.25) <= copiedCurveMaxError);
        QVERIFY(find<QToolButton>("otfEditor.presets")->menu() == editor().presetsMenu());
        editor().steps().setIndex(0);
        QVERIFY(manual() == threeNodes);
    }

    void copyAdaptiveNeedsOne() {
        QVERIFY(!find<QToolButton>("otfEditor.copyAdaptive")->isEnabled());
        editor().setAdaptiveCurve(someAdaptiveCurve());
        editor().setActive(CurveKind::adaptive);
        QSignalSpy curves(&editor(), &OtfEditor::activeCurveChanged);
        click("otfEditor.copyAdaptive");
        QCOMPARE(editor().state().active, CurveKind::manual);
        QVERIFY(editor().isManualModified());
        QCOMPARE(curves.count(), 1);
        for (int i = 0; i <= 255; ++i)
            QVERIFY(std::abs(opacityAt(manual(), i / 255.0) - opacityAt(someAdaptiveCurve(), i / 255.0)) <=
                    copiedCurveMaxError + 1e-12);
        QCOMPARE(table()->model()->rowCount(), static_cast<int>(manual().nodes.size()));
    }

    void openAndSaveAreAskedFor() {
        QSignalSpy open(&editor(), &OtfEditor::openCurveRequested);
        QSignalSpy save(&editor(), &OtfEditor::saveCurveRequested);
        click("otfEditor.openCurve");
        QCOMPARE(open.count(), 1);
        editor().model().moveNode(0, {0.1, 0.2});
        click("otfEditor.saveCurve");
        QCOMPARE(save.count(), 1);
        QVERIFY(editor().isManualModified());  // only the writer knows whether it was written
        editor().setManualSaved();
        QVERIFY(!editor().isManualModified());
        editor().setActive(CurveKind::linear);
        const ManualCurve read{{{0.3, 0.0}, {0.4, 1.0}}};
        editor().openManualCurve(read);
        QVERIFY(editor().activeCurve() == OpacityCurve(read));
        QVERIFY(!editor().isManualModified());
        editor().steps().undo();
        QCOMPARE(editor().state().active, CurveKind::linear);
        QCOMPARE(manual().nodes.size(), std::size_t{3});
    }

    void readoutNamesValues() {
        const auto readout = [this] { return find<QLabel>("otfEditor.readout")->text(); };
        editor().setCursorIntensity(0.6);
        QVERIFY2(readout().contains("0.600") && readout().contains("153") && readout().contains("0.500"),
                 qPrintable(readout()));  // 0.4 + (0.8 - 0.4) / 4
        CurveCanvas& canvas = editor().canvas();
        const QPoint onNode = canvas.axes().positionOf(threeNodes.nodes[2]).toPoint();
        QTest::mouseMove(editor().windowHandle(), canvas.mapTo(&editor(), onNode));
        QVERIFY2(readout().contains("Node 3") && readout().contains("0.900") && readout().contains("0.800"),
                 qPrintable(readout()));
    }
};

ECHOLUCENT_TEST_CLASS(TestOtfEditor)
#include "test_otf_editor.moc"
