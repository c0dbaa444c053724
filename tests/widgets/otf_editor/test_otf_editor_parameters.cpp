// Parameters of the OTF editor's closed curves: which are shown, what is typed, and what is one step.
#include <QApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QWheelEvent>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/otf_editor/editor_fixture.h"

using namespace echolucent;

class TestOtfEditorParameters : public QObject, private EditorFixture {
    Q_OBJECT

private slots:
    void init() { showEditor(); }
    void cleanup() { close(); }

    void parametersOfTheActiveCurveAreShown() {
        const auto shown = [this](const QString& name) { return find<QWidget>(name)->isVisible(); };
        QVERIFY(shown("otfEditor.nodeTable") && !shown("otfEditor.linear.lower"));
        editor().setActive(CurveKind::linear);
        QVERIFY(shown("otfEditor.linear.lower") && shown("otfEditor.linear.slope") && shown("otfEditor.linear.upper"));
        QVERIFY(!shown("otfEditor.nodeTable") && !shown("otfEditor.quartic.scale"));
        editor().setActive(CurveKind::quartic);
        QVERIFY(shown("otfEditor.quartic.scale") && !shown("otfEditor.parabolic.scale"));
        editor().setActive(CurveKind::parabolic);
        QVERIFY(shown("otfEditor.parabolic.scale"));
    }

    void parametersTakeTypedNumbers() {
        editor().setActive(CurveKind::linear);
        const auto type = [this](const QString& name, const QString& text) {
            auto* box = find<QDoubleSpinBox>(name);
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, text);
            QTest::keyClick(box, Qt::Key_Return);
        };
        const double exactLower = editor().state().linear.lower;
        type("otfEditor.linear.slope", "2.5");
        type("otfEditor.linear.upper", "0.75");
        QVERIFY((editor().state().linear == LinearCurve{exactLower, 2.5, 0.75}));  // 20/255 is not rounded on the way
        type("otfEditor.linear.lower", "0,25");
        QVERIFY((editor().state().linear == LinearCurve{0.25, 2.5, 0.75}));
        QCOMPARE(find<QDoubleSpinBox>("otfEditor.linear.upper")->minimum(), 0.25);
        QCOMPARE(find<QDoubleSpinBox>("otfEditor.linear.lower")->maximum(), 0.75);
        editor().setActive(CurveKind::parabolic);
        type("otfEditor.parabolic.scale", "0.125");
        editor().setActive(CurveKind::quartic);
        type("otfEditor.quartic.scale", "3");
        QCOMPARE(editor().state().parabolic.scale, 0.125);
        QCOMPARE(editor().state().quartic.scale, 3.0);
        QCOMPARE(editor().steps().count(), 8);  // five numbers and three choices of a curve
        editor().steps().setIndex(0);
        QCOMPARE(find<QDoubleSpinBox>("otfEditor.quartic.scale")->value(), 1.0);
        QVERIFY(editor().state().linear == LinearCurve{});
    }

    void parameterButtonsHeldAreOneStep() {
        editor().setActive(CurveKind::parabolic);
        const int before = editor().steps().count();
        auto* box = find<QDoubleSpinBox>("otfEditor.parabolic.scale");
        for (int i = 0; i < 4; ++i) {
            QKeyEvent event(QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier, QString(), i > 0);
            QApplication::sendEvent(box, &event);
        }
        QTRY_VERIFY(editor().state().parabolic.scale < 0.945);  // the box goes on by itself while the key is down
        QTest::keyRelease(box, Qt::Key_Down);
        QCOMPARE(editor().steps().count(), before + 1);
        box->setValue(0.5);
        box->setValue(0.4);
        QCOMPARE(editor().steps().count(), before + 3);
    }

    void aBurstOfTheWheelOverAParameterIsOneStep() {
        editor().setActive(CurveKind::parabolic);
        const int before = editor().steps().count();
        auto* box = find<QDoubleSpinBox>("otfEditor.parabolic.scale");
        box->setFocus();
        const auto turnWheel = [box] {
            const QPointF middle = QRectF(box->rect()).center();
            QWheelEvent event(middle, box->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase,
                              false);
            QApplication::sendEvent(box, &event);
        };
        turnWheel();
        turnWheel();
        QCOMPARE(editor().state().parabolic.scale, 0.98);
        QCOMPARE(editor().steps().count(), before + 1);
        QTest::keyClick(box, Qt::Key_Down);
        turnWheel();
        QCOMPARE(editor().steps().count(), before + 3);
    }

    void halfTypedNumberSurvivesANewAdaptiveCurve() {
        editor().setActive(CurveKind::parabolic);
        auto* box = find<QDoubleSpinBox>("otfEditor.parabolic.scale");
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, "0.3");
        editor().setAdaptiveCurve(someAdaptiveCurve());
        QTest::keyClicks(box, "7");
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(editor().state().parabolic.scale, 0.37);
    }
};

ECHOLUCENT_TEST_CLASS(TestOtfEditorParameters)
#include "test_otf_editor_parameters.moc"
