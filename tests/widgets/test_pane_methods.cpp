// Panes of a comparison that run the adaptive method in a way of their own, set by sliders in the panel *Compare*.
#include <QComboBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "processing/adaptive/method_reading.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/tube_cores/reading_parameters.h"

using namespace echolucent;

class TestPaneMethods : public QObject {
    Q_OBJECT

private slots:
    void slidersOfAPaneChangeItsMethodAlone() {
        ComparePanel panel;
        AdaptiveOtfConfig method = configOf(MethodReading::standard);
        method.grid.columns = 9;
        method.grid.withoutTubes = {4};
        method.initial = PowerCurve{4, 0.5};
        panel.setLimits(1, method);
        panel.setPanes({{}, {}, {.curve = CurveKind::parabolic}}, {"one", "two", "three"});
        panel.show();
        QVERIFY(panel.findChild<QSlider*>("compare.method1.cellSize") == nullptr);  // the panel Method is its
        QVERIFY(!child<QToolButton>(panel, "compare.parameters3")->isVisible());    // a curve has none
        auto* slider = child<QSlider>(panel, "compare.method2.cellSize");
        QVERIFY(!slider->isVisible());
        child<QToolButton>(panel, "compare.parameters2")->click();
        QVERIFY(slider->isVisible());
        QVERIFY(!child<QSlider>(panel, "compare.method2.coarsestScale")->isVisible());  // of the other rule

        Pane pane;
        QSignalSpy steps(&panel, &ComparePanel::paneChosen);
        connect(&panel, &ComparePanel::paneChosen, &panel, [&](int place, const Pane& choice) {
            QCOMPARE(place, 1);
            pane = choice;
        });
        auto* reading = child<QComboBox>(panel, "compare.method2");
        const int own = reading->count() - 1;
        reading->setCurrentIndex(own);
        emit reading->activated(own);
        QCOMPARE(steps.count(), 1);  // its own are at first those that it has
        QVERIFY(pane.method && pane.method->cells == method.cells);
        steps.clear();
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(steps.count(), 1);
        QVERIFY(pane.method);
        QCOMPARE(pane.method->cells.size, method.cells.size + 1);
        QCOMPARE(pane.method->grid.columns, 9);
        QVERIFY2(pane.method->initial == AdaptiveOtfConfig{}.initial, "a file of the document would not keep it");
        QVERIFY2(pane.method->grid.withoutTubes.empty(), "those of the document play no part in a pane's method");

        panel.setPanes({{}, pane, {.curve = CurveKind::parabolic}}, {"one", "two", "three"});
        QCOMPARE(nameOfPane(pane), "Adaptive curve, own parameters");
        QCOMPARE(reading->currentText(), "Parameters of its own");
        reading->setCurrentIndex(1);
        emit reading->activated(1);
        QCOMPARE(nameOfPane(pane), "Adaptive curve, as published");
        panel.setPanes({{}, pane, {.curve = CurveKind::parabolic}}, {"one", "two", "three"});
        QVERIFY(child<QSlider>(panel, "compare.method2.coarsestScale")->isVisible());
        ReadingParameters published("published");
        published.setConfig(*pane.method);
        QCOMPARE(slider->value(), child<QSlider>(published, "published.cellSize")->value());
    }
};

ECHOLUCENT_TEST_CLASS(TestPaneMethods)
#include "test_pane_methods.moc"
