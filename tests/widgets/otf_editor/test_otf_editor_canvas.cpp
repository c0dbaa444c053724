// The plot under real mouse and keyboard events.
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>
#include <cmath>
#include <memory>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/otf_editor/edited_document.h"
#include "widgets/otf_editor/curve_canvas.h"

using namespace echolucent;

class TestOtfEditorCanvas : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void dragMovesExactlyThatNode();
    void dragIsClampedBetweenNeighbours();
    void nodeIsHitEightPixelsAway();
    void clickAloneChangesNothing();
    void escapeEndsADragWithoutChange();
    void doubleClickAddsWhereItFell();
    void deleteRemovesTheSelectedNode();
    void arrowsMoveByExactSteps_data();
    void arrowsMoveByExactSteps();
    void autoRepeatIsOneStep();
    void tabGoesFromNodeToNodeAndLeaves();
    void keysAreTakenFromShortcutsOnlyWhereUsed();
    void wheelZoomsTheAxisUnderThePointer();
    void middleDragPansAndEscapeTakesItBack();
    void doubleClickOnAnAxisResetsIt();
    void dragWhileZoomedFollowsThePointer();
    void hoverTellsValueAndNode();

private:
    [[nodiscard]] QPoint pixelOf(const CurveNode& value) const { return m_canvas->axes().positionOf(value).toPoint(); }
    [[nodiscard]] QWindow* window() const { return m_canvas->windowHandle(); }
    [[nodiscard]] const std::vector<CurveNode>& nodes() const { return m_model->state().manual.nodes; }
    void press(QPoint position, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mousePress(window(), button, {}, position);
    }
    void move(QPoint position) { QTest::mouseMove(window(), position); }
    void release(QPoint position, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mouseRelease(window(), button, {}, position);
    }
    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
        press(from, button);
        move((from + to) / 2);
        move(to);
        release(to, button);
    }
    void wheel(QPoint position, int notches, Qt::KeyboardModifiers modifiers = {}) {
        QWheelEvent event(position, m_canvas->mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_canvas.get(), &event);
    }
    /// What a move by whole pixels from the node's own position gives.
    [[nodiscard]] CurveNode movedBy(const CurveNode& node, QPoint pixels) const {
        const PlotAxes& axes = m_canvas->axes();
        return {node.intensity + pixels.x() / axes.rect.width() * axes.intensity.length(),
                node.opacity - pixels.y() / axes.rect.height() * axes.opacity.length()};
    }

    std::unique_ptr<EditedModel> m_model;
    std::unique_ptr<CurveCanvas> m_canvas;
};

void TestOtfEditorCanvas::init() {
    m_model = std::make_unique<EditedModel>();
    OtfEditorState state;
    state.manual = threeNodes;
    state.active = CurveKind::manual;
    for (int i = 0; i < 256; ++i) state.adaptive.opacities.push_back(std::min(1.0, 0.9 * std::sqrt(i / 255.0)));
    m_model->setState(state);
    m_canvas = std::make_unique<CurveCanvas>(*m_model);
    m_canvas->resize(520, 340);
    m_canvas->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_canvas.get()));
    m_canvas->setFocus();
    QCoreApplication::processEvents();
}

void TestOtfEditorCanvas::cleanup() {
    m_canvas.reset();
    m_model.reset();
}

void TestOtfEditorCanvas::dragMovesExactlyThatNode() {
    const QPoint from = pixelOf(threeNodes.nodes[1]);
    drag(from, from + QPoint(40, -60));
    const CurveNode expected = movedBy(threeNodes.nodes[1], {40, -60});
    QVERIFY(std::abs(nodes()[1].intensity - expected.intensity) < 1e-12);
    QVERIFY(std::abs(nodes()[1].opacity - expected.opacity) < 1e-12);
    QVERIFY(nodes()[0] == threeNodes.nodes[0]);
    QVERIFY(nodes()[2] == threeNodes.nodes[2]);
    QCOMPARE(m_model->selectedNode(), 1);
    QCOMPARE(m_model->steps().count(), 1);
    const ManualCurve dragged = m_model->state().manual;
    m_model->steps().undo();
    QVERIFY(m_model->state().manual == threeNodes);
    m_model->steps().redo();
    QVERIFY(m_model->state().manual == dragged);
}

void TestOtfEditorCanvas::dragIsClampedBetweenNeighbours() {
    const QPoint from = pixelOf(threeNodes.nodes[1]);
    drag(from, QPoint(m_canvas->width() - 1, 0));
    QVERIFY((nodes()[1] == CurveNode{0.9, 1.0}));
    QVERIFY(nodes()[2] == threeNodes.nodes[2]);
}

void TestOtfEditorCanvas::nodeIsHitEightPixelsAway() {
    const QPoint centre = pixelOf(threeNodes.nodes[1]);
    for (const QPoint away : {QPoint(8, 8), QPoint(-8, 8), QPoint(8, -8), QPoint(-8, -8)})
        QCOMPARE(m_canvas->nodeAt(centre + away), 1);
    QCOMPARE(m_canvas->nodeAt(centre + QPoint(20, 0)), -1);
    drag(centre + QPoint(-8, 7), centre + QPoint(-8, 7) + QPoint(10, 10));  // taken off centre, moves by the same
    QVERIFY(std::abs(nodes()[1].intensity - movedBy(threeNodes.nodes[1], {10, 10}).intensity) < 1e-12);
}

void TestOtfEditorCanvas::clickAloneChangesNothing() {
    m_model->setActive(CurveKind::quartic);
    const int before = m_model->steps().count();
    QTest::mouseClick(window(), Qt::LeftButton, {}, pixelOf(threeNodes.nodes[2]) + QPoint(3, 2));
    QVERIFY(m_model->state().manual == threeNodes);
    QCOMPARE(m_model->state().active, CurveKind::quartic);
    QCOMPARE(m_model->steps().count(), before);
    QCOMPARE(m_model->selectedNode(), 2);
    QTest::mouseClick(window(), Qt::LeftButton, {}, pixelOf({0.5, 0.9}));
    QCOMPARE(m_model->selectedNode(), -1);
}

void TestOtfEditorCanvas::escapeEndsADragWithoutChange() {
    QSignalSpy announced(m_model.get(), &OtfEditorModel::activeCurveChanged);
    const QPoint from = pixelOf(threeNodes.nodes[0]);
    press(from);
    move(from + QPoint(30, -30));
    QTRY_VERIFY(announced.count() > 0);
    QVERIFY(m_model->state().manual != threeNodes);
    QTest::keyClick(window(), Qt::Key_Escape);
    QVERIFY(m_model->state().manual == threeNodes);
    QVERIFY(announced.last().at(0).value<OpacityCurve>() == OpacityCurve(threeNodes));
    move(from + QPoint(60, -60));
    release(from + QPoint(60, -60));
    QVERIFY(m_model->state().manual == threeNodes);
    QCOMPARE(m_model->steps().count(), 0);
}

void TestOtfEditorCanvas::doubleClickAddsWhereItFell() {
    const QPoint position = pixelOf({0.7, 0.25});
    QTest::mouseDClick(window(), Qt::LeftButton, {}, position);
    QCOMPARE(nodes().size(), std::size_t{4});
    const CurveNode expected = m_canvas->axes().valueAt(position);
    QVERIFY(std::abs(nodes()[2].intensity - expected.intensity) < 1e-12);
    QVERIFY(std::abs(nodes()[2].opacity - expected.opacity) < 1e-12);
    QVERIFY(std::abs(expected.opacity - 0.25) < 0.01);
    QCOMPARE(m_model->selectedNode(), 2);
    QTest::mouseDClick(window(), Qt::LeftButton, {}, position);  // on a node: no second one
    QCOMPARE(nodes().size(), std::size_t{4});
    QCOMPARE(m_model->steps().count(), 1);
    m_model->steps().undo();
    QVERIFY(m_model->state().manual == threeNodes);
}

void TestOtfEditorCanvas::deleteRemovesTheSelectedNode() {
    QTest::keyClick(window(), Qt::Key_Delete);
    QCOMPARE(nodes().size(), std::size_t{3});
    QTest::mouseClick(window(), Qt::LeftButton, {}, pixelOf(threeNodes.nodes[1]));
    QTest::keyClick(window(), Qt::Key_Delete);
    QVERIFY(m_model->state().manual == ManualCurve({{threeNodes.nodes[0], threeNodes.nodes[2]}}));
    m_model->steps().undo();
    QVERIFY(m_model->state().manual == threeNodes);
}

void TestOtfEditorCanvas::arrowsMoveByExactSteps_data() {
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::addColumn<double>("intensity");
    QTest::addColumn<double>("opacity");
    const auto row = [](const char* name, Qt::Key key, Qt::KeyboardModifiers modifiers, double intensity,
                        double opacity) { QTest::newRow(name) << key << modifiers << intensity << opacity; };
    row("left", Qt::Key_Left, {}, 127.0 / 256, 0.25);
    row("right", Qt::Key_Right, {}, 129.0 / 256, 0.25);
    row("up", Qt::Key_Up, {}, 0.5, 65.0 / 256);
    row("down", Qt::Key_Down, {}, 0.5, 63.0 / 256);
    row("shift left", Qt::Key_Left, Qt::ShiftModifier, 118.0 / 256, 0.25);
    row("shift right", Qt::Key_Right, Qt::ShiftModifier, 138.0 / 256, 0.25);
    row("shift up", Qt::Key_Up, Qt::ShiftModifier, 0.5, 74.0 / 256);
    row("shift down", Qt::Key_Down, Qt::ShiftModifier, 0.5, 54.0 / 256);
}

void TestOtfEditorCanvas::arrowsMoveByExactSteps() {
    QFETCH(Qt::Key, key);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    QFETCH(double, intensity);
    QFETCH(double, opacity);
    m_model->moveNode(1, {0.5, 0.25});
    m_model->selectNode(1);
    QTest::keyClick(window(), key, modifiers);
    QVERIFY((nodes()[1] == CurveNode{intensity, opacity}));  // 1/256 is exact in binary
    QCOMPARE(m_model->steps().count(), 2);
}

void TestOtfEditorCanvas::autoRepeatIsOneStep() {
    m_model->moveNode(1, {0.5, 0.25});
    m_model->selectNode(1);
    QSignalSpy announced(m_model.get(), &OtfEditorModel::activeCurveChanged);
    for (int i = 0; i < 6; ++i) {
        QKeyEvent event(QEvent::KeyPress, Qt::Key_Up, Qt::NoModifier, QString(), i > 0);
        QApplication::sendEvent(m_canvas.get(), &event);
    }
    QCOMPARE(nodes()[1].opacity, 70.0 / 256);
    QCOMPARE(m_model->steps().count(), 2);
    QTRY_VERIFY(!announced.isEmpty());
    QTRY_VERIFY(announced.last().first().value<OpacityCurve>() == OpacityCurve(m_model->state().manual));
}

void TestOtfEditorCanvas::tabGoesFromNodeToNodeAndLeaves() {
    m_model->selectNode(-1);
    for (int i = 0; i < 3; ++i) {
        QTest::keyClick(window(), Qt::Key_Tab);
        QCOMPARE(m_model->selectedNode(), i);
    }
    QTest::keyClick(window(), Qt::Key_Backtab, Qt::ShiftModifier);
    QCOMPARE(m_model->selectedNode(), 1);
    QTest::keyClick(window(), Qt::Key_PageDown);
    QCOMPARE(m_model->selectedNode(), 2);
    QTest::keyClick(window(), Qt::Key_PageUp);
    QTest::keyClick(window(), Qt::Key_PageUp);
    QCOMPARE(m_model->selectedNode(), 0);
    QVERIFY(m_model->state().manual == threeNodes);
}

void TestOtfEditorCanvas::keysAreTakenFromShortcutsOnlyWhereUsed() {
    const auto takes = [&](int key, Qt::KeyboardModifiers modifiers = {}) {
        QKeyEvent event(QEvent::ShortcutOverride, key, modifiers);
        event.ignore();
        QApplication::sendEvent(m_canvas.get(), &event);
        return event.isAccepted();
    };
    m_model->selectNode(-1);
    QVERIFY(!takes(Qt::Key_Left));  // nothing selected: the arrows turn the view
    m_model->selectNode(0);
    QVERIFY(takes(Qt::Key_Left));
    QVERIFY(takes(Qt::Key_Right, Qt::ShiftModifier));
    QVERIFY(!takes(Qt::Key_Z, Qt::ControlModifier));
    QVERIFY(!takes(Qt::Key_Escape));  // no drag to end
    QVERIFY(!takes(Qt::Key_C));
}

void TestOtfEditorCanvas::wheelZoomsTheAxisUnderThePointer() {
    const QPoint position = pixelOf({0.3, 0.6});
    const CurveNode before = m_canvas->axes().valueAt(position);
    wheel(position, 2);
    QVERIFY(std::abs(m_canvas->axes().intensity.length() - 0.85 * 0.85) < 1e-12);
    QVERIFY((m_canvas->axes().opacity == AxisRange{}));
    QVERIFY(std::abs(m_canvas->axes().valueAt(position).intensity - before.intensity) < 1e-12);
    wheel(position, 3, Qt::ControlModifier);
    QVERIFY(std::abs(m_canvas->axes().opacity.length() - std::pow(0.85, 3)) < 1e-12);
    QVERIFY(std::abs(m_canvas->axes().valueAt(position).opacity - before.opacity) < 1e-12);
    wheel(position, -50, Qt::ControlModifier);
    QVERIFY((m_canvas->axes().opacity == AxisRange{}));
    const double intensityLength = m_canvas->axes().intensity.length();
    wheel(QPoint(10, position.y()), 1);  // over the opacity axis
    QVERIFY(std::abs(m_canvas->axes().opacity.length() - 0.85) < 1e-12);
    QCOMPARE(m_canvas->axes().intensity.length(), intensityLength);
}

void TestOtfEditorCanvas::middleDragPansAndEscapeTakesItBack() {
    m_canvas->setIntensityRange({0.4, 0.6});
    m_canvas->setOpacityRange({0.4, 0.6});
    const QRectF rect = m_canvas->axes().rect;
    const QPoint from = rect.center().toPoint();
    drag(from, from + QPoint(50, 30), Qt::MiddleButton);
    QVERIFY(std::abs(m_canvas->axes().intensity.lower - (0.4 - 0.2 * 50 / rect.width())) < 1e-12);
    QVERIFY(std::abs(m_canvas->axes().opacity.lower - (0.4 + 0.2 * 30 / rect.height())) < 1e-12);
    const AxisRange panned = m_canvas->axes().intensity;
    press(from, Qt::MiddleButton);
    move(from + QPoint(-70, 0));
    QVERIFY(m_canvas->axes().intensity != panned);
    QTest::keyClick(window(), Qt::Key_Escape);
    release(from + QPoint(-70, 0), Qt::MiddleButton);
    QVERIFY(m_canvas->axes().intensity == panned);
    QVERIFY(m_model->state().manual == threeNodes);
}

void TestOtfEditorCanvas::doubleClickOnAnAxisResetsIt() {
    m_canvas->setIntensityRange({0.4, 0.6});
    m_canvas->setOpacityRange({0.4, 0.6});
    const QRectF rect = m_canvas->axes().rect;
    QTest::mouseDClick(window(), Qt::LeftButton, {},
                       QPoint(static_cast<int>(rect.center().x()), m_canvas->height() - 8));
    QVERIFY((m_canvas->axes().intensity == AxisRange{}));
    QVERIFY((m_canvas->axes().opacity == AxisRange{0.4, 0.6}));
    QTest::mouseDClick(window(), Qt::LeftButton, {}, QPoint(8, static_cast<int>(rect.center().y())));
    QVERIFY((m_canvas->axes().opacity == AxisRange{}));
    QVERIFY(m_model->state().manual == threeNodes);
}

void TestOtfEditorCanvas::dragWhileZoomedFollowsThePointer() {
    m_canvas->setIntensityRange({0.45, 0.55});
    m_canvas->setOpacityRange({0.35, 0.45});
    const QPoint from = pixelOf(threeNodes.nodes[1]);
    drag(from, from + QPoint(20, 20));
    const CurveNode expected = movedBy(threeNodes.nodes[1], {20, 20});
    QVERIFY(std::abs(nodes()[1].intensity - expected.intensity) < 1e-12);
    QVERIFY(std::abs(nodes()[1].opacity - expected.opacity) < 1e-12);
    QVERIFY(std::abs(nodes()[1].intensity - 0.5) < 0.01);
}

void TestOtfEditorCanvas::hoverTellsValueAndNode() {
    QSignalSpy hovered(m_canvas.get(), &CurveCanvas::hovered);
    const QPoint open = pixelOf({0.4, 0.7});
    move(open);
    QVERIFY(hovered.count() > 0);
    auto value = hovered.last().at(0).value<std::optional<CurveNode>>();
    QVERIFY(value && *value == m_canvas->axes().valueAt(open));
    QCOMPARE(hovered.last().at(1).toInt(), -1);
    move(pixelOf(threeNodes.nodes[2]) + QPoint(-4, 4));
    value = hovered.last().at(0).value<std::optional<CurveNode>>();
    QVERIFY(value && *value == threeNodes.nodes[2]);
    QCOMPARE(hovered.last().at(1).toInt(), 2);
}

ECHOLUCENT_TEST_CLASS(TestOtfEditorCanvas)
#include "test_otf_editor_canvas.moc"
