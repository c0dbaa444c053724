// The OTF editor's state: undo, drags as one step, throttled announcements, the modified flag.
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <limits>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/otf_editor/edited_document.h"
#include "widgets/otf_editor/histogram_backdrop.h"
#include "widgets/otf_editor/node_reduction.h"
#include "widgets/otf_editor/plot_axes.h"

using namespace echolucent;

namespace {

OtfEditorState stateWith(const ManualCurve& manual, CurveKind active = CurveKind::manual) {
    OtfEditorState state;
    state.manual = manual;
    state.active = active;
    return state;
}

/// A rise as the adaptive method gives: smooth, steep in the middle, with a bump.
SampledCurve steepSamples() {
    SampledCurve curve;
    for (int i = 0; i < 256; ++i) {
        const double x = i / 255.0;
        const double rise = 0.5 + 0.5 * std::tanh((x - 0.3) / 0.04);
        const double bump = 0.1 * std::exp(-std::pow((x - 0.6) / 0.03, 2));
        curve.opacities.push_back(x * x * 0.8 * rise + bump);
    }
    return curve;
}

OpacityCurve lastCurve(const QSignalSpy& spy) { return spy.last().at(0).value<OpacityCurve>(); }

}  // namespace

class TestOtfEditorModel : public QObject {
    Q_OBJECT

private slots:
    void everyEditIsOneStepThatUndoRestoresExactly_data();
    void everyEditIsOneStepThatUndoRestoresExactly();
    void dragIsOneStep();
    void cancelledDragLeavesNothing();
    void undoDuringADragEndsIt();
    void previewsAreCoalescedAndTheFinalValueArrives();
    void previewsArriveWhileADragGoesOn();
    void activeSwitchEmitsThatCurve();
    void heldKeyIsOneStep();
    void editsOfInactiveNodesActivateManualAndUndoGoesBack();
    void adaptiveCurveIsNoStep();
    void copiedAdaptiveStaysWithinTheStatedError();
    void reductionKeepsBoundForHarshCurves();
    void modifiedFollowsTheNodes();
    void clampsBetweenNeighboursAndRefusesNaN();
    void lastNodeStays();
    void stepCurveKeepsOrderOnAdd();
    void parametersAreKeptInRange();
    void histogramHeightsLinearAndLogarithmic();
    void axisRangesStayInUnitIntervalAndKeepTheAnchor();
    void ticksAreRoundAndInside();
};

void TestOtfEditorModel::everyEditIsOneStepThatUndoRestoresExactly_data() {
    using Edit = std::function<void(OtfEditorModel&)>;
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<CurveKind>("active");
    const auto row = [](const char* name, CurveKind active, Edit edit) { QTest::newRow(name) << edit << active; };
    row("add node", CurveKind::manual, [](auto& model) { model.addNode({0.7, 0.3}); });
    row("add node in gap", CurveKind::manual, [](auto& model) { model.addNodeInGap(); });
    row("move node", CurveKind::manual, [](auto& model) { model.moveNode(1, {0.55, 0.45}); });
    row("delete node", CurveKind::manual, [](auto& model) { model.removeNode(1); });
    row("preset", CurveKind::adaptive, [](auto& model) { model.replaceManual(curvePresets()[1].curve, "preset"); });
    row("copy adaptive", CurveKind::adaptive, [](auto& model) { model.copyIntoNodes(); });
    row("linear", CurveKind::linear, [](auto& model) { model.setLinear({0.1, 0.7, 0.6}); });
    row("parabolic", CurveKind::parabolic, [](auto& model) { model.setScale(CurveKind::parabolic, 0.3); });
    row("quartic", CurveKind::quartic, [](auto& model) { model.setScale(CurveKind::quartic, 2.5); });
    row("reset manual", CurveKind::manual, [](auto& model) { model.resetActiveCurve(); });
}

void TestOtfEditorModel::everyEditIsOneStepThatUndoRestoresExactly() {
    QFETCH(std::function<void(OtfEditorModel&)>, edit);
    QFETCH(CurveKind, active);
    OtfEditorState before = stateWith(threeNodes, active);
    before.adaptive = steepSamples();
    before.linear.slope = 1.0 / 3.0;
    EditedModel model;
    model.setState(before);
    edit(model);
    const OtfEditorState after = model.state();
    QVERIFY(static_cast<const CurveSet&>(before) != after);
    QCOMPARE(model.steps().count(), 1);
    model.steps().undo();
    QVERIFY(model.state() == before);
    QVERIFY(model.activeCurve() == curveOf(before, active));
    model.steps().redo();
    QVERIFY(model.state() == after);
}

void TestOtfEditorModel::dragIsOneStep() {
    EditedModel model;
    model.setState(stateWith(threeNodes));
    model.beginDrag();
    for (int i = 1; i <= 10; ++i) model.dragNode(1, {0.5 + 0.01 * i, 0.4 + 0.02 * i});
    QCOMPARE(model.steps().count(), 0);
    QVERIFY(model.dragging());
    model.endDrag();
    QCOMPARE(model.steps().count(), 1);
    QVERIFY((model.state().manual.nodes[1] == CurveNode{0.5 + 0.01 * 10, 0.4 + 0.02 * 10}));
    model.steps().undo();
    QVERIFY(model.state().manual == threeNodes);
}

void TestOtfEditorModel::cancelledDragLeavesNothing() {
    EditedModel model;
    const OtfEditorState before = stateWith(threeNodes, CurveKind::parabolic);
    model.setState(before);
    model.beginDrag();
    model.dragNode(0, {0.0, 1.0});
    QCOMPARE(model.state().active, CurveKind::manual);
    model.cancelDrag();
    QVERIFY(model.state() == before);
    QCOMPARE(model.steps().count(), 0);
    model.endDrag();
    QCOMPARE(model.steps().count(), 0);
}

void TestOtfEditorModel::undoDuringADragEndsIt() {
    EditedModel model;
    model.setState(stateWith(threeNodes));
    model.moveNode(0, {0.25, 0.2});
    model.beginDrag();
    model.dragNode(1, {0.6, 0.6});
    model.steps().undo();
    QVERIFY(!model.dragging());
    QVERIFY(model.state().manual == threeNodes);
    model.endDrag();
    QCOMPARE(model.steps().count(), 1);
    QVERIFY(model.steps().canRedo());
}

void TestOtfEditorModel::previewsAreCoalescedAndTheFinalValueArrives() {
    EditedModel model;
    model.setState(stateWith(threeNodes));
    QSignalSpy announced(&model, &OtfEditorModel::activeCurveChanged);
    model.beginDrag();
    for (int i = 1; i <= 50; ++i) model.dragNode(1, {0.5, 0.4 + 0.001 * i});
    QCOMPARE(announced.count(), 0);  // no turn of the event loop yet
    model.endDrag();
    QCOMPARE(announced.count(), 1);
    QVERIFY(lastCurve(announced) == OpacityCurve(model.state().manual));
    QCoreApplication::processEvents();
    QCOMPARE(announced.count(), 1);  // nothing comes late
}

void TestOtfEditorModel::previewsArriveWhileADragGoesOn() {
    EditedModel model;
    model.setState(stateWith(threeNodes));
    QSignalSpy announced(&model, &OtfEditorModel::activeCurveChanged);
    model.beginDrag();
    for (int i = 1; i <= 50; ++i) model.dragNode(1, {0.5, 0.4 + 0.001 * i});
    QTRY_COMPARE(announced.count(), 1);
    QVERIFY(lastCurve(announced) == OpacityCurve(model.state().manual));
    QVERIFY(model.dragging());
}

void TestOtfEditorModel::activeSwitchEmitsThatCurve() {
    OtfEditorState state = stateWith(threeNodes);
    state.adaptive = steepSamples();
    EditedModel model;
    model.setState(state);
    QSignalSpy announced(&model, &OtfEditorModel::activeCurveChanged);
    int expected = 0;
    for (const CurveKind kind :
         {CurveKind::adaptive, CurveKind::linear, CurveKind::parabolic, CurveKind::quartic, CurveKind::manual}) {
        model.setActive(kind);
        QCOMPARE(announced.count(), ++expected);
        QVERIFY(lastCurve(announced) == curveOf(state, kind));
    }
    model.setActive(CurveKind::manual);
    QCOMPARE(announced.count(), expected);
    QCOMPARE(model.steps().count(), 0);
}

void TestOtfEditorModel::heldKeyIsOneStep() {
    EditedModel model;
    model.setState(stateWith(threeNodes));
    const auto held = model.newGesture();
    for (int i = 1; i <= 5; ++i) model.moveNode(1, {0.5 + 0.01 * i, 0.4}, held);
    QCOMPARE(model.steps().count(), 1);
    model.moveNode(1, {0.6, 0.4}, model.newGesture());
    QCOMPARE(model.steps().count(), 2);
    model.steps().undo();
    QCOMPARE(model.state().manual.nodes[1].intensity, 0.5 + 0.01 * 5);
    model.steps().undo();
    QVERIFY(model.state().manual == threeNodes);
}

void TestOtfEditorModel::editsOfInactiveNodesActivateManualAndUndoGoesBack() {
    OtfEditorState before = stateWith(threeNodes, CurveKind::quartic);
    before.visible[indexOf(CurveKind::manual)] = false;
    EditedModel model;
    model.setState(before);
    QSignalSpy announced(&model, &OtfEditorModel::activeCurveChanged);
    model.addNode({0.3, 0.3});
    QCOMPARE(model.state().active, CurveKind::manual);
    QVERIFY(model.state().visible[indexOf(CurveKind::manual)]);
    QVERIFY(lastCurve(announced) == OpacityCurve(model.state().manual));
    model.steps().undo();
    QCOMPARE(model.state().active, CurveKind::quartic);
    QVERIFY(lastCurve(announced) == OpacityCurve(before.quartic));
}

void TestOtfEditorModel::adaptiveCurveIsNoStep() {
    EditedModel model;
    model.setState(stateWith(threeNodes, CurveKind::adaptive));
    QVERIFY(!model.copyIntoNodes());
    QSignalSpy announced(&model, &OtfEditorModel::activeCurveChanged);
    model.setAdaptiveCurve(steepSamples());
    QCOMPARE(announced.count(), 1);
    QVERIFY(lastCurve(announced) == OpacityCurve(steepSamples()));
    QCOMPARE(model.steps().count(), 0);
    // A result that arrives between an edit and its undo stays.
    model.setScale(CurveKind::parabolic, 0.5);
    SampledCurve newer = steepSamples();
    newer.opacities[100] = 0.99;
    model.setAdaptiveCurve(newer);
    model.steps().undo();
    QVERIFY(model.state().adaptive == newer);
}

void TestOtfEditorModel::copiedAdaptiveStaysWithinTheStatedError() {
    EditedModel model;
    model.setState(stateWith(threeNodes, CurveKind::adaptive));
    model.setAdaptiveCurve(steepSamples());
    QVERIFY(model.copyIntoNodes());
    QCOMPARE(model.state().active, CurveKind::manual);
    const ManualCurve& copied = model.state().manual;
    QVERIFY(copied.nodes.size() < 40);
    for (int i = 0; i <= 5000; ++i) {  // between the samples too
        const double x = i / 5000.0;
        QVERIFY(std::abs(opacityAt(copied, x) - opacityAt(steepSamples(), x)) <= copiedCurveMaxError + 1e-12);
    }
}

void TestOtfEditorModel::reductionKeepsBoundForHarshCurves() {
    SampledCurve zigzag;
    for (int i = 0; i < 256; ++i) zigzag.opacities.push_back(i % 2 ? 1.0 : 0.0);
    QCOMPARE(reducedToNodes(zigzag, 0.003).nodes.size(), std::size_t{256});
    SampledCurve straight;
    for (int i = 0; i < 256; ++i) straight.opacities.push_back(i / 255.0);
    QCOMPARE(reducedToNodes(straight, 0.003).nodes.size(), std::size_t{2});
    QVERIFY(reducedToNodes(SampledCurve{}, 0.003) == ManualCurve({{{0.0, 0.0}}}));
    // The preset made this way is x^2 within the bound plus the 256 samples' own error, (1/255)^2 / 4.
    for (int i = 0; i <= 1000; ++i) {
        const double x = i / 1000.0;
        QVERIFY(std::abs(opacityAt(curvePresets()[1].curve, x) - x * x) <= copiedCurveMaxError + 4e-6);
    }
}

void TestOtfEditorModel::modifiedFollowsTheNodes() {
    EditedModel model;
    model.setState(stateWith(threeNodes));
    QVERIFY(!model.isManualModified());
    model.setScale(CurveKind::quartic, 0.1);
    QVERIFY(!model.isManualModified());  // only nodes are files
    model.moveNode(0, {0.1, 0.1});
    QVERIFY(model.isManualModified());
    model.steps().undo();
    QVERIFY(!model.isManualModified());
    model.steps().redo();
    model.setManualSaved();
    QVERIFY(!model.isManualModified());
    model.steps().undo();
    QVERIFY(model.isManualModified());  // what is shown is not what was saved
    model.replaceManual(curvePresets()[0].curve, "preset");
    QVERIFY(!model.isManualModified());  // a preset cannot be lost
}

void TestOtfEditorModel::clampsBetweenNeighboursAndRefusesNaN() {
    EditedModel model;
    model.setState(stateWith(threeNodes));
    model.moveNode(1, {2.0, 7.0});
    QVERIFY((model.state().manual.nodes[1] == CurveNode{0.9, 1.0}));
    model.moveNode(1, {-1.0, -1.0});
    QVERIFY((model.state().manual.nodes[1] == CurveNode{0.2, 0.0}));
    model.moveNode(0, {-1.0, 0.1});
    QVERIFY((model.state().manual.nodes[0] == CurveNode{0.0, 0.1}));
    model.moveNode(2, {5.0, 0.8});
    QVERIFY((model.state().manual.nodes[2] == CurveNode{1.0, 0.8}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const ManualCurve before = model.state().manual;
    model.moveNode(1, {nan, nan});
    QVERIFY(model.state().manual == before);
}

void TestOtfEditorModel::lastNodeStays() {
    EditedModel model;
    model.setState(stateWith(ManualCurve{{{0.4, 0.5}, {0.6, 0.7}}}));
    model.removeNode(0);
    QVERIFY(!model.canRemoveNode());
    model.removeNode(0);
    QVERIFY(model.state().manual == ManualCurve({{{0.6, 0.7}}}));
}

void TestOtfEditorModel::stepCurveKeepsOrderOnAdd() {
    EditedModel model;
    model.setState(stateWith(ManualCurve{{{0.4, 0.0}, {0.4, 1.0}, {0.8, 1.0}}}));
    QCOMPARE(model.addNode({0.4, 0.5}), 2);  // after the nodes it shares the intensity with
    QCOMPARE(model.addNode({0.0, 0.0}), 0);
    QCOMPARE(model.addNode({1.5, 0.0}), 5);
    QCOMPARE(model.state().manual.nodes.back().intensity, 1.0);
    // In the gap: the curve keeps its shape.
    model.setState(stateWith(threeNodes));
    model.selectNode(1);
    QCOMPARE(model.addNodeInGap(), 2);
    QVERIFY((model.state().manual.nodes[2] == CurveNode{0.7, opacityAt(threeNodes, 0.7)}));
}

void TestOtfEditorModel::parametersAreKeptInRange() {
    EditedModel model;
    model.setLinear({0.6, -2.0, 0.3});
    QVERIFY((model.state().linear == LinearCurve{0.6, 0.0, 0.6}));
    model.setScale(CurveKind::parabolic, -1.0);
    QCOMPARE(model.state().parabolic.scale, 0.0);
    QCOMPARE(model.state().parabolic.exponent, 2);
    model.setScale(CurveKind::quartic, std::numeric_limits<double>::infinity());
    QCOMPARE(model.state().quartic.scale, 1.0);
}

void TestOtfEditorModel::histogramHeightsLinearAndLogarithmic() {
    IntensityHistogram histogram;
    histogram.counts[0] = 1'000'000;  // cut
    histogram.counts[50] = 9999;
    histogram.counts[100] = 99;
    const auto linear = histogramHeights(histogram, HistogramScale::linear);
    const auto logarithmic = histogramHeights(histogram, HistogramScale::logarithmic);
    QCOMPARE(linear[0], 1.0);
    QCOMPARE(linear[50], 1.0);
    QCOMPARE(linear[100], 99.0 / 9999.0);
    QCOMPARE(logarithmic[50], 1.0);
    QVERIFY(std::abs(logarithmic[100] - 0.5) < 1e-12);  // log(100) / log(10000)
    QCOMPARE(linear[200], 0.0);
    QCOMPARE(logarithmic[200], 0.0);
    QVERIFY(histogramHeights({}, HistogramScale::logarithmic) == (std::array<double, 256>{}));
}

void TestOtfEditorModel::axisRangesStayInUnitIntervalAndKeepTheAnchor() {
    const AxisRange half = AxisRange{}.zoomed(0.5, 0.5, 0.01);
    QVERIFY((half == AxisRange{0.25, 0.75}));
    const AxisRange aside = AxisRange{}.zoomed(0.2, 0.5, 0.01);
    QVERIFY(std::abs((0.2 - aside.lower) / aside.length() - 0.2) < 1e-12);
    QVERIFY((half.zoomed(0.25, 10.0, 0.01) == AxisRange{}));
    QVERIFY(std::abs(half.zoomed(0.5, 1e-6, 0.01).length() - 0.01) < 1e-12);
    QVERIFY((half.moved(9.0) == AxisRange{0.5, 1.0}));
    QVERIFY((half.moved(-9.0) == AxisRange{0.0, 0.5}));
}

void TestOtfEditorModel::ticksAreRoundAndInside() {
    QCOMPARE(tickPositions({0.0, 1.0}, 6), (std::vector<double>{0.0, 0.2, 0.4, 3 * 0.2, 0.8, 1.0}));
    for (const AxisRange& range : {AxisRange{0.13, 0.19}, AxisRange{0.0, 0.005}, AxisRange{0.5, 1.0}}) {
        const std::vector<double> ticks = tickPositions(range, 6);
        QVERIFY(ticks.size() >= 2 && ticks.size() <= 6);
        for (const double tick : ticks) QVERIFY(tick >= range.lower - 1e-9 && tick <= range.upper + 1e-9);
    }
}

ECHOLUCENT_TEST_CLASS(TestOtfEditorModel)
#include "test_otf_editor_model.moc"
