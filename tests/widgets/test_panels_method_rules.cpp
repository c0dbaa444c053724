// The rules of the method's panel: each choice brings its own numbers, and numbers out of use show what counts.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLocale>
#include <QObject>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <tuple>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_parameters.h"
#include "processing/adaptive/method_reading.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/panels/method_panel.h"

using namespace echolucent;

class TestPanelsMethodRules : public QObject {
    Q_OBJECT

private:
    static AdaptiveOtfConfig onlyConfigOf(QSignalSpy& spy) {
        return spy.count() == 1 ? spy.first().first().value<AdaptiveOtfConfig>()
                                : AdaptiveOtfConfig{.grid = {.columns = -1}};
    }
    static AdaptiveOtfConfig with(const DetectionRule& detection) { return {.detection = detection}; }
    static AdaptiveOtfConfig with(const CurveRule& curve) { return {.curve = curve}; }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void formAndInterfaceFunctionAreChoices() {
        MethodPanel panel;
        QSignalSpy spy(&panel, &MethodPanel::configChanged);
        auto* form = child<QComboBox>(panel, "adaptive.form");
        auto* function = child<QComboBox>(panel, "adaptive.interfaceFunction");
        const CurveRule ramp = RampRule{.opacity = 0.5}, product = ProductRule{3.0};
        for (const auto& [key, chosen, other] :
             {std::tuple{Qt::Key_Home, ramp, product}, {Qt::Key_End, product, ramp}}) {
            // What was set of an alternative is there again when it is chosen again.
            panel.setConfig(with(chosen));
            panel.setConfig(with(other));
            QTest::keyClick(form, key);
            QCOMPARE(onlyConfigOf(spy), with(chosen));
            spy.clear();
            const bool isRamp = std::holds_alternative<RampRule>(chosen);
            QCOMPARE(child<QSlider>(panel, "adaptive.strength")->isVisibleTo(&panel), !isRamp);
            QCOMPARE(child<QSlider>(panel, "adaptive.rampOpacity")->isVisibleTo(&panel), isRamp);
        }
        panel.setConfig({});
        const DetectionRule ratio = RatioRule{.falseAlarm = 4}, variance = VarianceRule{.significance = 0.5};
        for (const auto& [key, chosen, other] :
             {std::tuple{Qt::Key_Home, ratio, variance}, {Qt::Key_End, variance, ratio}}) {
            panel.setConfig(with(chosen));
            panel.setConfig(with(other));
            QTest::keyClick(function, key);
            QCOMPARE(onlyConfigOf(spy), with(chosen));
            spy.clear();
            const bool scales = std::holds_alternative<VarianceRule>(chosen);
            for (const char* name : {"adaptive.coarsestScale", "adaptive.finestScale", "adaptive.significance"})
                QCOMPARE(child<QWidget>(panel, name)->isEnabled(), scales);
            QCOMPARE(child<QWidget>(panel, "adaptive.falseAlarm")->isEnabled(), !scales);
            QVERIFY(child<QSpinBox>(panel, "adaptive.cellSize")->isEnabled());
        }
    }

    void aGreyedNumberIsTheOneThatCountsOnceItsRuleIsChosen() {
        MethodPanel panel;
        auto* significance = child<QDoubleSpinBox>(panel, "adaptive.significance");
        auto* reading = child<QComboBox>(panel, "adaptive.reading");
        auto* function = child<QComboBox>(panel, "adaptive.interfaceFunction");
        const double standard = VarianceRule{}.significance;
        QCOMPARE(significance->value(), standard);
        reading->setCurrentIndex(0);  // as published
        QCOMPARE(significance->value(), 0.0);
        QVERIFY(significance->isEnabled());
        reading->setCurrentIndex(2);  // the default, which has no significance
        QVERIFY(!significance->isEnabled());
        QCOMPARE(significance->value(), standard);
        QTest::keyClick(function, Qt::Key_End);
        QVERIFY(significance->isEnabled());
        QCOMPARE(significance->value(), standard);
        QCOMPARE(std::get<VarianceRule>(panel.config().detection).significance, standard);
        // A rule that the person left is remembered, and its number shown.
        significance->setValue(0.25);
        QTest::keyClick(function, Qt::Key_Home);
        QVERIFY(!significance->isEnabled());
        QCOMPARE(significance->value(), 0.25);
    }

    void asManyTubeCoresAsTheCommandLineTakes() {
        MethodPanel panel;
        auto* columns = child<QSpinBox>(panel, "adaptive.tubeColumns");
        auto* rows = child<QSpinBox>(panel, "adaptive.tubeRows");
        QCOMPARE(columns->maximum(), 4096);
        columns->setValue(4096);
        QCOMPARE(panel.config().grid.columns, 4096);
        QCOMPARE(panel.config().grid.rows, 15);
        rows->setValue(4096);  // together too many: the columns follow
        QCOMPARE(panel.config().grid.rows, 4096);
        QCOMPARE(columns->value(), 64);
        QCOMPARE(problemOf(panel.config()), std::string());
    }
};

ECHOLUCENT_TEST_CLASS(TestPanelsMethodRules)
#include "test_panels_method_rules.moc"
