// The panel of the method's parameters: what a person does comes out once, what is set comes back and makes no noise.
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QList>
#include <QLocale>
#include <QObject>
#include <QPointF>
#include <QPushButton>
#include <QRectF>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QString>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <QWidget>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/panels/method_panel.h"

using namespace echolucent;

namespace {

AdaptiveOtfConfig onlyConfigOf(QSignalSpy& spy) {
    return spy.count() == 1 ? spy.first().first().value<AdaptiveOtfConfig>()
                            : AdaptiveOtfConfig{.grid = {.columns = -1}};
}

AdaptiveOtfConfig with(const DetectionRule& detection) { return {.detection = detection}; }
AdaptiveOtfConfig with(const CurveRule& curve) { return {.curve = curve}; }
double strengthIn(const MethodPanel& panel) { return std::get<ProductRule>(panel.config().curve).strength; }

TubeCore tubeWith(double d, double low, double high) {
    TubeCore tube;
    tube.status = TubeStatus::surface;
    tube.d = d;
    tube.lowIntensity = low;
    tube.highIntensity = high;
    return tube;
}

}  // namespace

class TestPanelsMethod : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void startsWithTheDefaults() {
        const MethodPanel panel;
        QCOMPARE(panel.config(), AdaptiveOtfConfig{});
        QCOMPARE(panel.initialKind(), InitialKind::parabolic);
        QCOMPARE(panel.opacityScale(), 1.0);
    }

    void sliderKeyGivesOneStepOnce() {
        MethodPanel panel;
        panel.setConfig(with(ProductRule{}));
        QSignalSpy spy(&panel, &MethodPanel::configChanged);
        QTest::keyClick(child<QSlider>(panel, "adaptive.strength"), Qt::Key_Right);
        QCOMPARE(onlyConfigOf(spy), with(ProductRule{7.0}));
        QCOMPARE(child<QDoubleSpinBox>(panel, "adaptive.strength.value")->value(), 7.0);
    }

    void sliderReachesBothEnds() {
        MethodPanel panel;
        panel.setConfig(with(ProductRule{}));
        auto* slider = child<QSlider>(panel, "adaptive.strength");
        QTest::keyClick(slider, Qt::Key_End);
        QCOMPARE(strengthIn(panel), 40.0);
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(strengthIn(panel), 0.0);
    }

    void typedStrengthIsTakenExactlyAndOnce() {
        MethodPanel panel;
        panel.setConfig(with(ProductRule{}));
        QSignalSpy spy(&panel, &MethodPanel::configChanged);
        auto* spinBox = child<QDoubleSpinBox>(panel, "adaptive.strength.value");
        spinBox->selectAll();
        QTest::keyClicks(spinBox, "12.34");
        QTest::keyClick(spinBox, Qt::Key_Return);
        QCOMPARE(onlyConfigOf(spy), with(ProductRule{12.34}));
        QCOMPARE(child<QSlider>(panel, "adaptive.strength")->value(), 49);  // 12.34 / 0.25, rounded
    }

    void spinBoxKeyChangesOneField_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<AdaptiveOtfConfig>("expected");
        QTest::newRow("columns") << "tubeColumns" << AdaptiveOtfConfig{.grid = {.columns = 16}};
        QTest::newRow("rows") << "tubeRows" << AdaptiveOtfConfig{.grid = {.rows = 16}};
        QTest::newRow("spacing") << "tubeSpacing" << AdaptiveOtfConfig{.grid = {.spacing = 1.0}};
        QTest::newRow("cell") << "cellSize" << AdaptiveOtfConfig{.cells = {.size = 6}};
        QTest::newRow("coarsest") << "coarsestScale" << with(VarianceRule{.coarsestScale = 8});
        QTest::newRow("finest") << "finestScale" << with(VarianceRule{.finestScale = 4});
        QTest::newRow("significance") << "significance" << with(VarianceRule{.significance = 0.45});
        QTest::newRow("false alarm") << "falseAlarm" << with(RatioRule{.falseAlarm = RatioRule{}.falseAlarm + 0.25});
        QTest::newRow("slope") << "slopeHalfStep" << AdaptiveOtfConfig{.surface = {.slopeHalfStep = 6}};
        QTest::newRow("scale") << "opacityScale" << AdaptiveOtfConfig{.initial = PowerCurve{2, 1.05}};
    }
    void spinBoxKeyChangesOneField() {
        QFETCH(QString, name);
        QFETCH(AdaptiveOtfConfig, expected);
        MethodPanel panel;
        if (std::holds_alternative<VarianceRule>(expected.detection)) panel.setConfig(with(VarianceRule{}));
        QSignalSpy spy(&panel, &MethodPanel::configChanged);
        QTest::keyClick(child<QAbstractSpinBox>(panel, ("adaptive." + name).toLatin1()), Qt::Key_Up);
        QCOMPARE(onlyConfigOf(spy), expected);
        QCOMPARE(panel.config(), expected);
    }

    void spacingZeroReadsAutomatic() {
        MethodPanel panel;
        QCOMPARE(child<QDoubleSpinBox>(panel, "adaptive.tubeSpacing")->text(), "automatic");
    }

    void theFinestScaleNeverExceedsTheCoarsest() {
        MethodPanel panel;
        panel.setConfig(with(VarianceRule{.coarsestScale = 4, .finestScale = 4}));
        QSignalSpy spy(&panel, &MethodPanel::configChanged);
        QTest::keyClick(child<QSpinBox>(panel, "adaptive.coarsestScale"), Qt::Key_Down);
        QCOMPARE(onlyConfigOf(spy), with(VarianceRule{.coarsestScale = 3, .finestScale = 3}));
        spy.clear();
        QTest::keyClick(child<QSpinBox>(panel, "adaptive.finestScale"), Qt::Key_Up);
        QCOMPARE(onlyConfigOf(spy), with(VarianceRule{.coarsestScale = 4, .finestScale = 4}));
    }

    void initialFunctionByKeyboard() {
        MethodPanel panel;
        const OpacityCurve linear = LinearCurve{0.1, 2.0, 0.9};
        panel.setConfig({.initial = linear});
        QCOMPARE(panel.initialKind(), InitialKind::linear);
        panel.setConfig({.initial = PowerCurve{2, 0.5}});
        auto* comboBox = child<QComboBox>(panel, "adaptive.initial");
        auto* scale = child<QDoubleSpinBox>(panel, "adaptive.opacityScale");
        QSignalSpy spy(&panel, &MethodPanel::configChanged);

        QTest::keyClick(comboBox, Qt::Key_Down);
        QCOMPARE(onlyConfigOf(spy).initial, OpacityCurve(PowerCurve{4, 0.5}));
        QVERIFY(scale->isEnabled());
        spy.clear();
        QTest::keyClick(comboBox, Qt::Key_Down);
        QCOMPARE(onlyConfigOf(spy).initial, linear);  // the last linear curve that the panel was given
        QVERIFY(!scale->isEnabled());
        spy.clear();
        QTest::keyClick(comboBox, Qt::Key_Down);
        QCOMPARE(onlyConfigOf(spy).initial, OpacityCurve(ManualCurve{}));
        QCOMPARE(panel.initialKind(), InitialKind::manual);
    }

    void settingEmitsNothingAndComesBack() {
        MethodPanel panel;
        QSignalSpy spy(&panel, &MethodPanel::configChanged);
        AdaptiveOtfConfig config{.grid = {.columns = 20, .rows = 3, .spacing = 7.25},
                                 .cells = {.size = 9},
                                 .detection = VarianceRule{.coarsestScale = 6,
                                                           .finestScale = 2,
                                                           .sigmaPerKernelSize = 0.31,
                                                           .kernelCut = 2.5,
                                                           .significance = 0.123456},
                                 .surface = {.slopeHalfStep = 2},
                                 .curve = ProductRule{6.754321},
                                 .initial = PowerCurve{4, 0.3333}};
        panel.setConfig(config);
        QCOMPARE(panel.config(), config);
        QCOMPARE(spy.count(), 0);
        QTest::keyClick(child<QSpinBox>(panel, "adaptive.cellSize"), Qt::Key_Up);
        config.cells.size = 10;  // and no other field is rounded to what its control shows
        QCOMPARE(onlyConfigOf(spy), config);
    }

    void aScaleThatNobodyMovedKeepsItsDigits() {
        MethodPanel panel;
        panel.setConfig({.initial = PowerCurve{2, 0.123456}});
        QCOMPARE(panel.opacityScale(), 0.123456);
        QTest::keyClick(child<QComboBox>(panel, "adaptive.initial"), Qt::Key_Down);
        QCOMPARE(panel.config().initial, OpacityCurve(PowerCurve{4, 0.123456}));
    }

    void settingBeyondTheRangeClamps() {
        MethodPanel panel;
        panel.setConfig({.grid = {.columns = 0},
                         .cells = {.size = 1},
                         .detection = VarianceRule{.coarsestScale = 40, .finestScale = -1, .significance = 2},
                         .curve = ProductRule{1e6}});
        QCOMPARE(panel.config(),
                 (AdaptiveOtfConfig{.grid = {.columns = 1},
                                    .cells = {.size = 2},
                                    .detection = VarianceRule{.coarsestScale = 10, .finestScale = 1, .significance = 1},
                                    .curve = ProductRule{40}}));
    }

    void resetGoesBackOnce() {
        MethodPanel panel;
        panel.setConfig({.cells = {.size = 9}, .curve = ProductRule{1}, .initial = ManualCurve{{{0, 0}, {1, 1}}}});
        QSignalSpy spy(&panel, &MethodPanel::configChanged);
        auto* reset = child<QPushButton>(panel, "adaptive.reset");
        QTest::mouseClick(reset, Qt::LeftButton);
        QCOMPARE(onlyConfigOf(spy), AdaptiveOtfConfig{});
        QTest::mouseClick(reset, Qt::LeftButton);
        QCOMPARE(spy.count(), 1);  // nothing was left to change
    }

    void resetGoesBackForRulesThatAreNotChosenToo() {
        MethodPanel panel;
        auto* function = child<QComboBox>(panel, "adaptive.interfaceFunction");
        auto* form = child<QComboBox>(panel, "adaptive.form");
        const auto setOthers = [&] {
            panel.setConfig({.detection = VarianceRule{.significance = 0.5}, .curve = ProductRule{3.0}});
            panel.setConfig({});
        };
        const auto chooseOthers = [&] {
            QTest::keyClick(function, Qt::Key_End);
            QTest::keyClick(form, Qt::Key_End);
        };
        setOthers();
        child<QPushButton>(panel, "adaptive.reset")->click();
        chooseOthers();
        QCOMPARE(panel.config(), (AdaptiveOtfConfig{.detection = VarianceRule{}, .curve = ProductRule{}}));
        panel.setConfig(with(RatioRule{.falseAlarm = 4}));
        panel.setConfig(with(VarianceRule{}));
        QTest::keyClick(child<QComboBox>(panel, "adaptive.reading"), Qt::Key_Home);  // as published
        QTest::keyClick(function, Qt::Key_Home);
        QVERIFY(panel.config().detection == DetectionRule(RatioRule{}));
    }

    void aReadingSetsEveryParameterButTheInitialFunction() {
        MethodPanel panel;
        auto* reading = child<QComboBox>(panel, "adaptive.reading");
        QCOMPARE(reading->currentText(), "Default");
        panel.setConfig({.cells = {.size = 9}, .initial = PowerCurve{4, 0.5}});
        QCOMPARE(reading->currentText(), "Changed");
        QSignalSpy spy(&panel, &MethodPanel::configChanged);
        const QList<std::pair<QString, MethodReading>> readings{{"Default", MethodReading::standard},
                                                                {"Version 0.1", MethodReading::firstVersion},
                                                                {"Settled", MethodReading::settled},
                                                                {"As published", MethodReading::asPublished}};
        for (const auto& [text, value] : readings) {
            QTest::keyClick(reading, Qt::Key_Up);  // "Changed" stands last and cannot be chosen
            QCOMPARE(reading->currentText(), text);
            AdaptiveOtfConfig expected = configOf(value);
            expected.initial = PowerCurve{4, 0.5};
            QCOMPARE(onlyConfigOf(spy), expected);
            spy.clear();
        }
        QTest::keyClick(child<QSpinBox>(panel, "adaptive.cellSize"), Qt::Key_Up);
        QCOMPARE(reading->currentText(), "Changed");
        QTest::keyClick(child<QSpinBox>(panel, "adaptive.cellSize"), Qt::Key_Down);
        QCOMPARE(reading->currentText(), "As published");
        for (int i = 0; i < 5; ++i) QTest::keyClick(reading, Qt::Key_Down);
        QCOMPARE(reading->currentText(), "Default");
    }

    void rangesDefaultsAndWordsAreThoseOfTheTable() {
        MethodPanel panel;
        for (const auto& [parameter, control] : {std::pair{"cell_size", "adaptive.cellSize"},
                                                 {"slope_half_step", "adaptive.slopeHalfStep"},
                                                 {"coarsest_scale", "adaptive.coarsestScale"}}) {
            const auto& row = *parameterNamed(methodParameters(), parameter);
            auto* spinBox = child<QSpinBox>(panel, control);
            QCOMPARE(spinBox->minimum(), static_cast<int>(row.offeredRange().least));
            QCOMPARE(spinBox->maximum(), static_cast<int>(row.offeredRange().largest));
            QCOMPARE(spinBox->value(), static_cast<int>(*numberOf(defaultOf(methodParameters(), row))));
            QCOMPARE(spinBox->accessibleName().toStdString(), std::string(row.label));
            QVERIFY(spinBox->toolTip().toStdString().starts_with(row.meaning));
        }
    }

    void anotherGridIsNoOtherReading() {
        // As the command line names it: the grid belongs to no reading.
        MethodPanel panel;
        QTest::keyClick(child<QSpinBox>(panel, "adaptive.tubeColumns"), Qt::Key_Up);
        QCOMPARE(readingOf(panel.config()), MethodReading::standard);
        QCOMPARE(child<QComboBox>(panel, "adaptive.reading")->currentText(), "Default");
    }

    void computeAsksAndChangesNothing() {
        MethodPanel panel;
        QSignalSpy compute(&panel, &MethodPanel::computeRequested);
        QSignalSpy changes(&panel, &MethodPanel::configChanged);
        QTest::keyClick(child<QPushButton>(panel, "adaptive.compute"), Qt::Key_Space);
        QCOMPARE(compute.count(), 1);
        QCOMPARE(changes.count(), 0);
    }

    void advancedOpensByKeyboard() {
        MethodPanel panel;
        panel.show();
        auto* cellSize = child<QSpinBox>(panel, "adaptive.cellSize");
        QVERIFY(!cellSize->isVisible());
        QTest::keyClick(child<QToolButton>(panel, "adaptive.advanced"), Qt::Key_Space);
        QVERIFY(cellSize->isVisible());
    }

    void resultIsSummedUp() {
        MethodPanel panel;
        panel.show();
        auto* summary = child<QLabel>(panel, "adaptive.summary");
        auto* message = child<QLabel>(panel, "adaptive.message");
        AdaptiveOtf result;
        result.tubesMeetingVolume = 225;
        result.tubesWithWeight = 2;
        result.tubes = {tubeWith(1, 0.10, 0.30), tubeWith(3, 0.22, 0.50), tubeWith(0, 0.90, 1.0), TubeCore{}};
        panel.showResult(result);
        // (1 x 0.10 + 3 x 0.22) / 4 = 0.19 and (1 x 0.30 + 3 x 0.50) / 4 = 0.45; d = 0 counts for nothing
        QCOMPARE(summary->text(), "2 of 225 tube cores · I_L 0.19 · I_H 0.45");
        QVERIFY(!message->isVisible());

        result.tubesWithWeight = 0;
        result.message = "No surface found: the initial function is used.";
        panel.showResult(result);
        QCOMPARE(summary->text(), "0 of 225 tube cores");
        QCOMPARE(message->text(), "No surface found: the initial function is used.");
        QVERIFY(message->isVisible());
        panel.clearResult();
        QVERIFY(!message->isVisible());
    }

    void wheelChangesOnlyTheFocusedControl() {
        MethodPanel panel;
        panel.setConfig(with(ProductRule{}));
        panel.show();
        QApplication::setActiveWindow(&panel);  // no window manager gives the focus on a virtual display
        auto* slider = child<QSlider>(panel, "adaptive.strength");
        child<QComboBox>(panel, "adaptive.initial")->setFocus();
        turnWheel(slider);
        QCOMPARE(strengthIn(panel), 6.75);
        slider->setFocus();
        turnWheel(slider);
        QVERIFY(strengthIn(panel) > 6.75);
    }

private:
    static void turnWheel(QWidget* widget) {
        const QPointF middle = QRectF(widget->rect()).center();
        QWheelEvent event(middle, widget->mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &event);
    }
};

ECHOLUCENT_TEST_CLASS(TestPanelsMethod)
#include "test_panels_method.moc"
