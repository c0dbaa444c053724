// The OTF editor as a whole: table, legend, parameters, actions and their shortcuts.
#include <QAbstractButton>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <cmath>
#include <memory>

#include "tests/widgets/otf_editor/edited_document.h"
#include "widgets/control_keys.h"
#include "widgets/otf_editor/canvas/curve_canvas.h"
#include "widgets/otf_editor/node_reduction.h"

using namespace echolucent;

namespace {

const ManualCurve threeNodes{{{0.2, 0.1}, {0.5, 0.4}, {0.9, 0.8}}};

SampledCurve someAdaptiveCurve() { return {sampledOpacities(PowerCurve{3, 0.7}, 256)}; }

}  // namespace

class TestOtfEditor : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_editor.reset(); }
    void typedNumbersAreTakenExactly();
    void numbersOutOfRangeAreRefused_data();
    void numbersOutOfRangeAreRefused();
    void tableAndPlotShareTheSelection();
    void tableAddsAndDeletes();
    void typedDigitsNeitherEditNorChooseACurve();
    void legendSwitchesVisibility();
    void radioButtonsAndKeysSwitchTheActiveCurve();
    void parametersOfTheActiveCurveAreShown();
    void parametersTakeTypedNumbers();
    void parameterButtonsHeldAreOneStep();
    void aBurstOfTheWheelOverAParameterIsOneStep();
    void halfTypedNumberSurvivesANewAdaptiveCurve();
    void undoRedoResetByKeysAndButtons();
    void presetsReplaceTheNodes();
    void copyAdaptiveNeedsOne();
    void openAndSaveAreAskedFor();
    void dragInTheComposedEditorReachesTheTable();
    void readoutNamesValues();

private:
    template <typename Widget>
    Widget* find(const QString& name) const {
        auto* widget = m_editor->findChild<Widget*>(name);
        if (!widget) qFatal("no widget %s", qPrintable(name));
        return widget;
    }
    QTableView* table() const { return find<QTableView>("otfEditor.nodeTable"); }
    const ManualCurve& manual() const { return m_editor->state().manual; }
    void click(const QString& name) { QTest::mouseClick(find<QAbstractButton>(name), Qt::LeftButton); }
    void typeInto(int row, int column, const QString& text);

    std::unique_ptr<EditedEditor> m_editor;
};

void TestOtfEditor::init() {
    m_editor = std::make_unique<EditedEditor>();
    OtfEditorState state;
    state.manual = threeNodes;
    state.active = CurveKind::manual;
    m_editor->setState(state);
    m_editor->setWhiteLevel(255);
    m_editor->resize(460, 640);
    m_editor->show();
    m_editor->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_editor.get()));
}

void TestOtfEditor::typeInto(int row, int column, const QString& text) {
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

void TestOtfEditor::typedNumbersAreTakenExactly() {
    typeInto(1, 0, "0.3141592653589793");
    QVERIFY(manual().nodes[1].intensity == 0.3141592653589793);  // QCOMPARE would round
    typeInto(1, 1, "0,0625");
    QCOMPARE(manual().nodes[1].opacity, 0.0625);
    typeInto(2, 2, "120");  // stored value, of a white level of 255
    QVERIFY(manual().nodes[2].intensity == 120.0 / 255.0);
    QCOMPARE(manual().nodes[2].opacity, 0.8);
    QVERIFY(manual().nodes[0] == threeNodes.nodes[0]);
    QCOMPARE(m_editor->undoStack()->count(), 3);
    for (int i = 0; i < 3; ++i) m_editor->undoStack()->undo();
    QVERIFY(manual() == threeNodes);
}

void TestOtfEditor::numbersOutOfRangeAreRefused_data() {
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

void TestOtfEditor::numbersOutOfRangeAreRefused() {
    QFETCH(int, column);
    QFETCH(QString, text);
    const QString before = table()->model()->index(1, column).data().toString();
    const QString readoutBefore = find<QLabel>("otfEditor.readout")->text();
    typeInto(1, column, text);
    QVERIFY(manual() == threeNodes);
    QCOMPARE(m_editor->undoStack()->count(), 0);
    QCOMPARE(table()->model()->index(1, column).data().toString(), before);
    QVERIFY(find<QLabel>("otfEditor.readout")->text() != readoutBefore);
    QVERIFY(find<QLabel>("otfEditor.readout")->text().contains("node 2"));
}

void TestOtfEditor::tableAndPlotShareTheSelection() {
    m_editor->model().selectNode(2);
    QCOMPARE(table()->currentIndex().row(), 2);
    QTest::mouseClick(table()->viewport(), Qt::LeftButton, {},
                      table()->visualRect(table()->model()->index(0, 1)).center());
    QCOMPARE(m_editor->model().selectedNode(), 0);
    m_editor->model().selectNode(-1);
    QVERIFY(!table()->currentIndex().isValid());
}

void TestOtfEditor::tableAddsAndDeletes() {
    m_editor->model().selectNode(0);
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

void TestOtfEditor::typedDigitsNeitherEditNorChooseACurve() {
    const ControlKeys keys;
    table()->setFocus();
    table()->setCurrentIndex(table()->model()->index(1, 1));
    for (const Qt::Key key : {Qt::Key_1, Qt::Key_0, Qt::Key_Period, Qt::Key_5, Qt::Key_3})
        QTest::keyClick(m_editor->windowHandle(), key);
    QCOMPARE(m_editor->state().active, CurveKind::manual);
    QVERIFY(!table()->findChild<QLineEdit*>());
    QCOMPARE(table()->currentIndex(), table()->model()->index(1, 1));
    QVERIFY(manual() == threeNodes);
    QTest::keyClick(m_editor->windowHandle(), Qt::Key_Return);
    auto* field = table()->findChild<QLineEdit*>();
    QVERIFY(field);
    QTest::keyClick(field, Qt::Key_1);
    QCOMPARE(field->text(), QString("1"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(manual().nodes[1].opacity, 1.0);
}

void TestOtfEditor::legendSwitchesVisibility() {
    const std::array<QString, 5> keys{"adaptive", "manual", "linear", "parabolic", "quartic"};
    for (const CurveKind kind : allCurveKinds) {
        const QString name = "otfEditor.legend." + keys[indexOf(kind)] + ".visible";
        QVERIFY(find<QCheckBox>(name)->isChecked());
        click(name);
        QVERIFY(!m_editor->state().visible[indexOf(kind)]);
    }
    QVERIFY((m_editor->state().visible == std::array<bool, 5>{}));
    m_editor->setActive(CurveKind::quartic);  // what is rendered is drawn
    QVERIFY(find<QCheckBox>("otfEditor.legend.quartic.visible")->isChecked());
    QVERIFY(!find<QCheckBox>("otfEditor.legend.linear.visible")->isChecked());
    QCOMPARE(m_editor->undoStack()->count(), 1);  // the choice of the rendered curve, and no step for what is drawn
}

void TestOtfEditor::radioButtonsAndKeysSwitchTheActiveCurve() {
    m_editor->setAdaptiveCurve(someAdaptiveCurve());
    QSignalSpy curves(m_editor.get(), &OtfEditor::activeCurveChanged);
    const std::array<QString, 5> keys{"adaptive", "manual", "linear", "parabolic", "quartic"};
    for (const CurveKind kind : allCurveKinds) {
        click("otfEditor.active." + keys[indexOf(kind)]);
        QCOMPARE(m_editor->state().active, kind);
        QVERIFY(m_editor->activateAction(kind)->isChecked());
        QVERIFY(curves.last().at(0).value<OpacityCurve>() == curveOf(m_editor->state(), kind));
    }
    m_editor->canvas().setFocus();
    for (const CurveKind kind :
         {CurveKind::linear, CurveKind::adaptive, CurveKind::quartic, CurveKind::manual, CurveKind::parabolic}) {
        QTest::keyClick(m_editor->windowHandle(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(indexOf(kind))));
        QCOMPARE(m_editor->state().active, kind);
        QVERIFY(find<QRadioButton>("otfEditor.active." + keys[indexOf(kind)])->isChecked());
        QVERIFY(curves.last().at(0).value<OpacityCurve>() == curveOf(m_editor->state(), kind));
    }
}

void TestOtfEditor::parametersOfTheActiveCurveAreShown() {
    const auto shown = [this](const QString& name) { return find<QWidget>(name)->isVisible(); };
    QVERIFY(shown("otfEditor.nodeTable") && !shown("otfEditor.linear.lower"));
    m_editor->setActive(CurveKind::linear);
    QVERIFY(shown("otfEditor.linear.lower") && shown("otfEditor.linear.slope") && shown("otfEditor.linear.upper"));
    QVERIFY(!shown("otfEditor.nodeTable") && !shown("otfEditor.quartic.scale"));
    m_editor->setActive(CurveKind::quartic);
    QVERIFY(shown("otfEditor.quartic.scale") && !shown("otfEditor.parabolic.scale"));
    m_editor->setActive(CurveKind::parabolic);
    QVERIFY(shown("otfEditor.parabolic.scale"));
}

void TestOtfEditor::parametersTakeTypedNumbers() {
    m_editor->setActive(CurveKind::linear);
    const auto type = [this](const QString& name, const QString& text) {
        auto* box = find<QDoubleSpinBox>(name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
    };
    const double exactLower = m_editor->state().linear.lower;
    type("otfEditor.linear.slope", "2.5");
    type("otfEditor.linear.upper", "0.75");
    QVERIFY((m_editor->state().linear == LinearCurve{exactLower, 2.5, 0.75}));  // 20/255 is not rounded on the way
    type("otfEditor.linear.lower", "0,25");
    QVERIFY((m_editor->state().linear == LinearCurve{0.25, 2.5, 0.75}));
    QCOMPARE(find<QDoubleSpinBox>("otfEditor.linear.upper")->minimum(), 0.25);
    QCOMPARE(find<QDoubleSpinBox>("otfEditor.linear.lower")->maximum(), 0.75);
    m_editor->setActive(CurveKind::parabolic);
    type("otfEditor.parabolic.scale", "0.125");
    m_editor->setActive(CurveKind::quartic);
    type("otfEditor.quartic.scale", "3");
    QCOMPARE(m_editor->state().parabolic.scale, 0.125);
    QCOMPARE(m_editor->state().quartic.scale, 3.0);
    QCOMPARE(m_editor->undoStack()->count(), 8);  // five numbers and three choices of a curve
    m_editor->undoStack()->setIndex(0);
    QCOMPARE(find<QDoubleSpinBox>("otfEditor.quartic.scale")->value(), 1.0);
    QVERIFY(m_editor->state().linear == LinearCurve{});
}

void TestOtfEditor::parameterButtonsHeldAreOneStep() {
    m_editor->setActive(CurveKind::parabolic);
    const int before = m_editor->undoStack()->count();
    auto* box = find<QDoubleSpinBox>("otfEditor.parabolic.scale");
    for (int i = 0; i < 4; ++i) {
        QKeyEvent event(QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier, QString(), i > 0);
        QApplication::sendEvent(box, &event);
    }
    QTRY_VERIFY(m_editor->state().parabolic.scale < 0.945);  // the box goes on by itself while the key is down
    QTest::keyRelease(box, Qt::Key_Down);
    QCOMPARE(m_editor->undoStack()->count(), before + 1);
    box->setValue(0.5);
    box->setValue(0.4);
    QCOMPARE(m_editor->undoStack()->count(), before + 3);
}

void TestOtfEditor::aBurstOfTheWheelOverAParameterIsOneStep() {
    m_editor->setActive(CurveKind::parabolic);
    const int before = m_editor->undoStack()->count();
    auto* box = find<QDoubleSpinBox>("otfEditor.parabolic.scale");
    box->setFocus();
    const auto turnWheel = [box] {
        const QPointF middle = QRectF(box->rect()).center();
        QWheelEvent event(middle, box->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(box, &event);
    };
    turnWheel();
    turnWheel();
    QCOMPARE(m_editor->state().parabolic.scale, 0.98);
    QCOMPARE(m_editor->undoStack()->count(), before + 1);
    QTest::keyClick(box, Qt::Key_Down);
    turnWheel();
    QCOMPARE(m_editor->undoStack()->count(), before + 3);
}

void TestOtfEditor::halfTypedNumberSurvivesANewAdaptiveCurve() {
    m_editor->setActive(CurveKind::parabolic);
    auto* box = find<QDoubleSpinBox>("otfEditor.parabolic.scale");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, "0.3");
    m_editor->setAdaptiveCurve(someAdaptiveCurve());
    QTest::keyClicks(box, "7");
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(m_editor->state().parabolic.scale, 0.37);
}

void TestOtfEditor::undoRedoResetByKeysAndButtons() {
    m_editor->canvas().setFocus();
    QVERIFY(!find<QToolButton>("otfEditor.undo")->isEnabled());
    m_editor->model().moveNode(0, {0.3, 0.3});
    const ManualCurve moved = manual();
    QTest::keyClick(m_editor->windowHandle(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(manual() == threeNodes);
    QTest::keyClick(m_editor->windowHandle(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(manual() == moved);
    click("otfEditor.undo");
    QVERIFY(manual() == threeNodes);
    click("otfEditor.redo");
    QVERIFY(manual() == moved);
    QTest::keyClick(m_editor->windowHandle(), Qt::Key_C);
    QVERIFY(manual() == CurveSet{}.manual);
    click("otfEditor.undo");
    QVERIFY(manual() == moved);
    m_editor->setActive(CurveKind::adaptive);
    QVERIFY(!find<QToolButton>("otfEditor.reset")->isEnabled());
}

void TestOtfEditor::presetsReplaceTheNodes() {
    m_editor->findChild<QAction*>("otfEditor.presets.fetal")->trigger();
    QVERIFY(manual() == ManualCurve({{{60.0 / 255, 0.0}, {120.0 / 255, 0.6}, {1.0, 0.8}}}));
    m_editor->findChild<QAction*>("otfEditor.presets.ramp")->trigger();
    QVERIFY(manual() == ManualCurve({{{0.0, 0.0}, {1.0, 1.0}}}));
    m_editor->findChild<QAction*>("otfEditor.presets.parabolic")->trigger();
    QVERIFY(std::abs(opacityAt(manual(), 0.5) - 0.25) <= copiedCurveMaxError);
    QVERIFY(find<QToolButton>("otfEditor.presets")->menu() == m_editor->presetsMenu());
    m_editor->undoStack()->setIndex(0);
    QVERIFY(manual() == threeNodes);
}

void TestOtfEditor::copyAdaptiveNeedsOne() {
    QVERIFY(!find<QToolButton>("otfEditor.copyAdaptive")->isEnabled());
    m_editor->setAdaptiveCurve(someAdaptiveCurve());
    m_editor->setActive(CurveKind::adaptive);
    QSignalSpy curves(m_editor.get(), &OtfEditor::activeCurveChanged);
    click("otfEditor.copyAdaptive");
    QCOMPARE(m_editor->state().active, CurveKind::manual);
    QVERIFY(m_editor->isManualModified());
    QCOMPARE(curves.count(), 1);
    for (int i = 0; i <= 255; ++i)
        QVERIFY(std::abs(opacityAt(manual(), i / 255.0) - opacityAt(someAdaptiveCurve(), i / 255.0)) <=
                copiedCurveMaxError + 1e-12);
    QCOMPARE(table()->model()->rowCount(), static_cast<int>(manual().nodes.size()));
}

void TestOtfEditor::openAndSaveAreAskedFor() {
    QSignalSpy open(m_editor.get(), &OtfEditor::openCurveRequested);
    QSignalSpy save(m_editor.get(), &OtfEditor::saveCurveRequested);
    click("otfEditor.openCurve");
    QCOMPARE(open.count(), 1);
    m_editor->model().moveNode(0, {0.1, 0.2});
    click("otfEditor.saveCurve");
    QCOMPARE(save.count(), 1);
    QVERIFY(m_editor->isManualModified());  // only the writer knows whether it was written
    m_editor->setManualSaved();
    QVERIFY(!m_editor->isManualModified());
    m_editor->setActive(CurveKind::linear);
    const ManualCurve read{{{0.3, 0.0}, {0.4, 1.0}}};
    m_editor->openManualCurve(read);
    QVERIFY(m_editor->activeCurve() == OpacityCurve(read));
    QVERIFY(!m_editor->isManualModified());
    m_editor->undoStack()->undo();
    QCOMPARE(m_editor->state().active, CurveKind::linear);
    QCOMPARE(manual().nodes.size(), std::size_t{3});
}

void TestOtfEditor::dragInTheComposedEditorReachesTheTable() {
    CurveCanvas& canvas = m_editor->canvas();
    const auto inWindow = [&](QPoint position) { return canvas.mapTo(m_editor.get(), position); };
    const QPoint from = canvas.axes().positionOf(threeNodes.nodes[1]).toPoint();
    QWindow* window = m_editor->windowHandle();
    QTest::mousePress(window, Qt::LeftButton, {}, inWindow(from));
    QTest::mouseMove(window, inWindow(from + QPoint(12, -24)));
    QTest::mouseRelease(window, Qt::LeftButton, {}, inWindow(from + QPoint(12, -24)));
    QVERIFY(manual().nodes[1].intensity > 0.5 && manual().nodes[1].opacity > 0.4);
    QCOMPARE(table()->model()->index(1, 0).data(Qt::EditRole).toString().toDouble(), manual().nodes[1].intensity);
    QCOMPARE(table()->model()->index(1, 1).data(Qt::EditRole).toString().toDouble(), manual().nodes[1].opacity);
    QCOMPARE(table()->currentIndex().row(), 1);
}

void TestOtfEditor::readoutNamesValues() {
    const auto readout = [this] { return find<QLabel>("otfEditor.readout")->text(); };
    m_editor->setCursorIntensity(0.6);
    QVERIFY2(readout().contains("0.600") && readout().contains("153") && readout().contains("0.500"),
             qPrintable(readout()));  // 0.4 + (0.8 - 0.4) / 4
    CurveCanvas& canvas = m_editor->canvas();
    const QPoint onNode = canvas.axes().positionOf(threeNodes.nodes[2]).toPoint();
    QTest::mouseMove(m_editor->windowHandle(), canvas.mapTo(m_editor.get(), onNode));
    QVERIFY2(readout().contains("Node 3") && readout().contains("0.900") && readout().contains("0.800"),
             qPrintable(readout()));
}

QTEST_MAIN(TestOtfEditor)
#include "test_otf_editor.moc"
