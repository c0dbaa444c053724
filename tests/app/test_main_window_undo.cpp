// Ctrl+Z in the real window takes back whatever was changed, one movement of the hand after the other.
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QMouseEvent>
#include <QSlider>
#include <QWheelEvent>
#include <QWindow>

#include "io/document/document_file.h"
#include "tests/app/picture_measures.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/otf_editor/curve_canvas.h"

using namespace echolucent;

class TestMainWindowUndo : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAlongAssumedBeam();
        QLocale::setDefault(QLocale::c());
        m_file = file("shapes.mha", {smallPhantom(PhantomScene::shapes, 5)});
        m_moving =
            file("moving.mha", {smallPhantom(PhantomScene::fetus, 3), smallPhantom(PhantomScene::fetus, 4, 0.5)});
    }
    void init() { show(); }
    void cleanup() { close(); }

    void everythingIsTakenBackStepByStep() {
        open(m_file);
        const Picture first = *window().volumeView().picture();
        const SampledCurve otf = window().otfs().adaptive()->curve;
        std::vector<std::string> history{document()};
        const auto oneStep = [&](const char* what) {
            QVERIFY2(steps().count() == static_cast<int>(history.size()),
                     qPrintable(QString("%1: %2 steps").arg(what).arg(steps().count())));
            QVERIFY2(document() != history.back(), what);
            history.push_back(document());
            waitUntilIdle();
        };
        orbit({180, 160}, {230, 140});
        oneStep("an orbit");
        for (int i = 0; i < 3; ++i) turnWheel();
        oneStep("a burst of the wheel");
        type("view.nearCut.value", "12.0");
        oneStep("a typed near cut");
        QTest::keyClick(&window(), Qt::Key_A);
        oneStep("compute for this view");
        choose("view.mode", 1);
        oneStep("a mode");
        choose("view.mode", 0);
        oneStep("and back");
        QTest::keyClick(&window(), Qt::Key_3);
        QTest::keyClick(&window(), Qt::Key_2);
        oneStep("curves looked at one after the other");
        dragNode();
        oneStep("a dragged node");
        choose("adaptive.form", 1);
        oneStep("a form of the method");
        choose("adaptive.initial", 3);
        oneStep("another initial function");
        choose("view.beamAxis", 2);
        oneStep("another beam");
        choose("motion.axis", 1);
        oneStep("an axis of the motion");
        const SampledCurve last = window().otfs().adaptive()->curve;
        for (std::size_t i = history.size() - 1; i-- > 0;) {
            QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
            QCOMPARE(document(), history[i]);
        }
        QVERIFY(!steps().canUndo());
        waitUntilIdle();
        QVERIFY(window().otfs().adaptive()->curve == otf);
        QVERIFY(difference(*window().volumeView().picture(), first) < 0.03);
        while (steps().canRedo()) QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(document(), history.back());
        waitUntilIdle();
        QVERIFY(window().otfs().adaptive()->curve == last);
    }

    void panelsShowWhatIsTakenBack() {
        open(m_file);
        type("view.nearCut.value", "12.0");
        choose("view.colourMap", 2);
        choose("adaptive.form", 1);
        waitUntilIdle();
        QCOMPARE(frontDepthMm(window().otfs().adaptive()->view), 12.0);
        for (int i = 0; i < 3; ++i) QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        waitUntilIdle();
        QCOMPARE(child<QAbstractSpinBox>("view.nearCut.value")->text(), "0.0 mm");
        QCOMPARE(child<QComboBox>("view.colourMap")->currentIndex(), 0);
        QCOMPARE(child<QComboBox>("adaptive.form")->currentIndex(), 0);
        QCOMPARE(window().volumeView().look().colourMap, ColourMap::sepia);
        QCOMPARE(frontDepthMm(window().volumeView().view()), 0.0);
        QCOMPARE(frontDepthMm(window().otfs().adaptive()->view), 0.0);
    }

    void phaseAndMotionAreNoStepsAndStay() {
        open(m_moving);
        type("view.nearCut.value", "5.0");
        child<QSlider>("motion.phase")->setValue(1);
        waitUntilIdle();
        child<QSlider>("motion.angle")->setValue(10);
        waitUntilIdle();
        QCOMPARE(steps().count(), 1);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        waitUntilIdle();
        QCOMPARE(window().openStudy().phase(), 1);
        QCOMPARE(window().volumeView().view().azimuthDegrees, 10.0);
        QCOMPARE(frontDepthMm(window().volumeView().view()), 0.0);
    }

    void theHandEndsTheMotionInOneStep() {
        open(m_file);
        child<QSlider>("motion.angle")->setValue(10);
        waitUntilIdle();
        orbit({180, 160}, {200, 160});
        QCOMPARE(child<QSlider>("motion.angle")->value(), 0);
        QCOMPARE(steps().count(), 1);
        QVERIFY(window().volumeView().view().azimuthDegrees > 10.0);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window().volumeView().view().azimuthDegrees, 0.0);
    }

    void anOtfForEachViewThatComesBackIsThatOfTheView() {
        open(m_file);
        orbit({180, 160}, {200, 160});
        click("motion.mode.eachView");
        waitUntilIdle();
        const Viewpoint shown = window().volumeView().view();
        QVERIFY(shown != Viewpoint{});
        QVERIFY(window().otfs().adaptive()->view == shown);
        click("motion.mode.static");
        waitUntilIdle();
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        waitUntilIdle();
        QVERIFY(window().document().document().motion.otf == MotionOtf::eachView);
        QVERIFY(window().otfs().adaptive()->view == shown);
    }

    void anotherBeamEndsTheMotion() {
        open(m_file);
        window().motionPlayer().play();
        QVERIFY(window().motionPlayer().isPlaying());
        choose("view.beamAxis", 2);
        QVERIFY(!window().motionPlayer().isPlaying());
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        waitUntilIdle();
        QVERIFY(window().volumeView().view() == Viewpoint{});
    }

    void aNodeThatIsDraggedWhileAStudyOpensGoesBack() {
        open(m_file);
        CurveCanvas& canvas = window().otfEditor().canvas();
        const ManualCurve before = window().otfEditor().state().manual;
        const QPoint from = canvas.axes().positionOf(before.nodes[1]).toPoint();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(&canvas, from + QPoint(-15, 20));
        QTest::mouseMove(&canvas, from + QPoint(-30, 40));
        QVERIFY(window().otfEditor().state().manual != before);
        open(m_moving);
        QVERIFY(window().document().document().curves.manual == before);
        QTest::mouseMove(&canvas, from + QPoint(-40, 50));
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, from + QPoint(-40, 50));
        QVERIFY(window().otfEditor().state().manual == before);
        QVERIFY(!steps().canUndo());
    }

    void withoutAStudyBeamAndCutAreNoSteps() {
        const int beam = child<QComboBox>("view.beamAxis")->currentIndex();
        choose("view.beamAxis", beam == 2 ? 3 : 2);
        type("view.nearCut.value", "12.0");
        QCOMPARE(steps().count(), 0);
        QVERIFY(window().document().document().beam.axis == BeamAxis::plusZ);
        QCOMPARE(child<QComboBox>("view.beamAxis")->currentIndex(), beam);
        QCOMPARE(child<QAbstractSpinBox>("view.nearCut.value")->text(), "0.0 mm");
    }

    void anotherStudyBeginsWithoutSteps() {
        open(m_file);
        orbit({180, 160}, {200, 160});
        QTest::keyClick(&window(), Qt::Key_2);
        open(m_moving);
        QVERIFY(!steps().canUndo());
        QVERIFY(window().volumeView().view() == Viewpoint{});
        QCOMPARE(window().otfEditor().state().active, CurveKind::manual);
        QVERIFY(std::get<StudyFile>(window().document().document().study).path == m_moving.toStdString());
    }

private:
    std::string document() { return jsonOf(window().document().document()); }
    DocumentSteps& steps() { return window().document().steps(); }
    QWindow* picture() { return pictureWindow(); }
    void orbit(const QPoint& from, const QPoint& to) {
        QTest::mousePress(picture(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 5; ++step) {
            const QPoint at = from + (to - from) * step / 5;
            QMouseEvent move(QEvent::MouseMove, QPointF(at), QPointF(picture()->mapToGlobal(at)), Qt::NoButton,
                             Qt::LeftButton, {});
            QCoreApplication::sendEvent(picture(), &move);
        }
        QTest::mouseRelease(picture(), Qt::LeftButton, {}, to);
        QCoreApplication::processEvents();
    }
    void turnWheel() {
        QWheelEvent turn(QPointF(100, 100), picture()->mapToGlobal(QPointF(100, 100)), {}, {0, 120}, Qt::NoButton, {},
                         Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(picture(), &turn);
    }
    void type(const QString& name, const QString& number) {
        auto* box = child<QAbstractSpinBox>(name);
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, number);
        QTest::keyClick(box, Qt::Key_Return);
        QCoreApplication::processEvents();
    }
    void choose(const QString& name, int index) { child<QComboBox>(name)->setCurrentIndex(index); }
    void dragNode() {
        CurveCanvas& canvas = window().otfEditor().canvas();
        const CurveNode node = window().otfEditor().state().manual.nodes[1];
        const QPoint from = canvas.axes().positionOf(node).toPoint();
        const QPoint to = canvas.axes().positionOf({node.intensity - 0.1, node.opacity - 0.3}).toPoint();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(&canvas, (from + to) / 2);
        QTest::mouseMove(&canvas, to);
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, to);
        QCoreApplication::processEvents();
    }

    QString m_file;
    QString m_moving;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowUndo)

#include "test_main_window_undo.moc"
