// The panel of OTF designers: controls from the tables, what a person does comes out once, what is set makes no noise.
#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QObject>
#include <QPoint>
#include <QProgressBar>
#include <QSignalSpy>
#include <QString>
#include <QTest>
#include <QWidget>
#include <cmath>
#include <limits>

#include "processing/designers/choice/designer.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/panels/design_plot.h"
#include "widgets/panels/designer_panel.h"
#include "widgets/panels/designer_parameters.h"
#include "widgets/panels/emphasis_canvas.h"

using namespace echolucent;

namespace {

DesignPlot plotOf(const std::vector<double>& values) {
    DesignPlot plot{"area", "Area", "square units", {}, values};
    for (std::size_t i = 0; i < values.size(); ++i)
        plot.intensities.push_back(static_cast<double>(i) / static_cast<double>(values.size() - 1));
    return plot;
}

}  // namespace

class TestPanelsDesigner : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void offersACurveAndAllDesigners() {
        DesignerPanel panel;
        auto* choice = child<QComboBox>(panel, "designer.choice");
        QCOMPARE(choice->count(), 1 + static_cast<int>(allDesigners.size()));
        QCOMPARE(choice->itemText(0), QString("Curve"));
        QCOMPARE(choice->currentIndex(), 0);
        QSignalSpy chosen(&panel, &DesignerPanel::chosen);
        QTest::keyClick(choice, Qt::Key_Down);
        QCOMPARE(chosen.count(), 1);
        QVERIFY(chosen.first().first().value<std::optional<Designer>>() == Designer::adaptive);
        QTest::keyClick(choice, Qt::Key_Up);
        QCOMPARE(chosen.count(), 2);
        QVERIFY(chosen.last().first().value<std::optional<Designer>>() == std::nullopt);
    }

    void everyParameterHasAControlWithItsMeaning_data() {
        QTest::addColumn<int>("designer");
        for (const Designer designer : allDesigners)
            QTest::newRow(std::string(nameOf(designer)).c_str()) << static_cast<int>(designer);
    }
    void everyParameterHasAControlWithItsMeaning() {
        QFETCH(int, designer);
        DesignerPanel panel;
        AllSignals noise(panel);
        const DesignerConfig config = defaultConfigOf(static_cast<Designer>(designer));
        panel.setConfig(config);
        panel.show();
        forEachParameter(config, [&](const auto& row, const auto& values) {
            const QString name = "designer." + QString::fromStdString(camelCase(row.name));
            auto* control = child<QWidget>(panel, name.toLatin1().constData());
            QCOMPARE(control->isVisible(), row.get(values).has_value());
            QVERIFY(control->toolTip().startsWith(QString::fromUtf8(row.meaning.data(), row.meaning.size())));
            QVERIFY(!control->accessibleName().isEmpty());
        });
        QVERIFY2(panel.minimumSizeHint().width() <= 329, qPrintable(QString::number(panel.minimumSizeHint().width())));
        QCOMPARE(noise.count(), 0);
    }

    void aTypedNumberComesOutOnce() {
        DesignerPanel panel;
        panel.setConfig(OtsuConfig{});
        QSignalSpy changed(&panel, &DesignerPanel::configChanged);
        auto* opacity = child<QDoubleSpinBox>(panel, "designer.opacity");
        opacity->selectAll();
        QTest::keyClicks(opacity, "0.25");
        QTest::keyClick(opacity, Qt::Key_Return);
        QCOMPARE(changed.count(), 1);
        QVERIFY(changed.first().at(0).value<DesignerConfig>() == DesignerConfig(OtsuConfig{.opacity = 0.25}));
        QCOMPARE(changed.first().at(1).toString(), QString("Otsu ramp: opacity"));
    }

    void aNumberThatNobodyMovedKeepsItsDigits() {
        DesignerPanel panel;
        const OtsuConfig exact{.spreads = 1.23456789, .opacity = 0.5};
        panel.setConfig(exact);
        QSignalSpy changed(&panel, &DesignerPanel::configChanged);
        QTest::keyClick(child<QDoubleSpinBox>(panel, "designer.opacity"), Qt::Key_Up);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(std::get<OtsuConfig>(changed.first().at(0).value<DesignerConfig>()).spreads, 1.23456789);
    }

    void whatPlaysNoPartIsHidden() {
        DesignerPanel panel;
        panel.setConfig(LevoyConfig{});
        panel.show();
        auto* given = child<QWidget>(panel, "designer.fluidLevel");
        QVERIFY(!given->isVisible());
        panel.setConfig(LevoyConfig{.levels = LevoyLevels::given});
        QVERIFY(given->isVisible());
        QVERIFY(child<QWidget>(panel, "designer.transitionWidth")->isVisible());
        panel.setConfig(LevoyConfig{.form = LevoyForm::boundaries});
        QVERIFY(!child<QWidget>(panel, "designer.transitionWidth")->isVisible());
        panel.setConfig(std::nullopt);
        QVERIFY(!given->isVisible());
    }

    void resetGivesTheDefaults() {
        DesignerPanel panel;
        panel.setConfig(OtsuConfig{.opacity = 0.5});
        QSignalSpy changed(&panel, &DesignerPanel::configChanged);
        QTest::mouseClick(child<QAbstractButton>(panel, "designer.reset"), Qt::LeftButton);
        QCOMPARE(changed.count(), 1);
        const DesignerConfig standard = OtsuConfig{};
        QVERIFY(changed.first().at(0).value<DesignerConfig>() == standard);
    }

    void whatWasMadeIsToldAndPlotted() {
        DesignerPanel panel;
        panel.setConfig(OtsuConfig{});
        panel.show();
        const Design design{.classification = PowerCurve{2, 1.0},
                            .explanation = {"The first sentence.", "The second."},
                            .facts = {{"threshold", "Threshold", 0.25}, {"share", "Dark voxels", 0.5, "share"}},
                            .plots = {plotOf({0, 2, 1}), DesignPlot{"other", "Other", "", {0, 1}, {0, 1}}},
                            .message = "All are alike."};
        panel.setDesign(&design, 12.3);
        QVERIFY(child<QLabel>(panel, "designer.explanation")->text().contains("The second."));
        QVERIFY(child<QLabel>(panel, "designer.message")->text().endsWith("All are alike."));
        const QString facts = child<QLabel>(panel, "designer.facts")->text();
        QVERIFY(facts.contains("Threshold") && facts.contains("0.25") && facts.contains("0.5 share") &&
                facts.contains("12 ms"));
        auto* plot = child<QComboBox>(panel, "designer.plot");
        QCOMPARE(plot->count(), 2);
        QCOMPARE(plot->itemText(0), QString("Area (square units)"));
        QTest::keyClick(plot, Qt::Key_Down);
        QCOMPARE(child<QWidget>(panel, "designer.plot.canvas")->accessibleDescription(), QString("Other"));
        panel.setDesign(nullptr, 0);
        QVERIFY(!plot->isVisible());
        QVERIFY(!child<QLabel>(panel, "designer.message")->isVisible());
    }

    void progressAndCancelAreSeenWhileItComputes() {
        DesignerPanel panel;
        panel.setConfig(OtsuConfig{});
        panel.show();
        auto* cancel = child<QAbstractButton>(panel, "designer.cancel");
        auto* compute = child<QAbstractButton>(panel, "designer.compute");
        QVERIFY(!cancel->isVisible());
        panel.setComputing(true, false);
        panel.setProgress(0.5);
        QVERIFY(cancel->isVisible() && !compute->isVisible());
        auto* progress = child<QProgressBar>(panel, "designer.progress");
        QCOMPARE(2 * progress->value(), progress->maximum());
        QSignalSpy cancelled(&panel, &DesignerPanel::cancelRequested);
        QTest::mouseClick(cancel, Qt::LeftButton);
        QCOMPARE(cancelled.count(), 1);
        panel.setComputing(false, true);
        QVERIFY(!cancel->isVisible() && compute->isVisible());
        QSignalSpy asked(&panel, &DesignerPanel::computeRequested);
        QTest::mouseClick(compute, Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
        panel.setComputing(false, false);
        QVERIFY(!compute->isVisible());
    }

    void maximaAreFoundBetweenNeighbours() {
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(maximaOf(plotOf({0, 2, 1, 3, 3, 3, 0, 5})), (std::vector<std::size_t>{1, 4}));
        QCOMPARE(maximaOf(plotOf({3, 2, 1})), std::vector<std::size_t>{});
        QCOMPARE(maximaOf(plotOf({0, 4, unknown, 1, 2, 1})), (std::vector<std::size_t>{4}));
        QCOMPARE(maximaOf(plotOf({})), std::vector<std::size_t>{});
    }

    void aMaximumIsPickedByClickAndByKeys() {
        DesignPlotCanvas canvas;
        canvas.resize(300, 160);
        canvas.setPlot(plotOf({0, 1, 4, 1, 0, 0, 1, 2, 1, 0, 0}));
        canvas.show();
        QSignalSpy picked(&canvas, &DesignPlotCanvas::picked);
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.positionOf(2).toPoint());
        QCOMPARE(picked.count(), 0);  // nothing is picked where nothing stands on it
        canvas.setPickable(true);
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.positionOf(2).toPoint() + QPoint(5, 40));
        QCOMPARE(picked.count(), 1);
        QCOMPARE(picked.last().first().toDouble(), 0.2);
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.positionOf(4).toPoint());
        QCOMPARE(picked.count(), 1);
        for (const int key : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Return})
            QTest::keyClick(&canvas, static_cast<Qt::Key>(key));
        QCOMPARE(picked.count(), 2);
        QCOMPARE(picked.last().first().toDouble(), 0.7);
    }

    void aMaximumOfTheContourSpectrumPutsItsRampThere() {
        DesignerPanel panel;
        panel.setConfig(ContourSpectrumConfig{});
        const Design design{.classification = PowerCurve{2, 1.0}, .plots = {plotOf({0, 1, 4, 1, 0, 0, 1, 2, 1, 0, 0})}};
        panel.setDesign(&design, 1.0);
        panel.show();
        auto* canvas = child<DesignPlotCanvas>(panel, "designer.plot.canvas");
        QSignalSpy changed(&panel, &DesignerPanel::configChanged);
        QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->positionOf(7).toPoint());
        QCOMPARE(changed.count(), 1);
        QVERIFY(changed.first().at(0).value<DesignerConfig>() == withThreshold(ContourSpectrumConfig{}, 0.7).value());
        QVERIFY(thresholdOf(changed.first().at(0).value<DesignerConfig>()) == 0.7);
    }

    void theEmphasisKeepsItsOrderAndItsFewestNodes() {
        EmphasisCanvas canvas;
        canvas.resize(300, 160);
        canvas.show();
        QSignalSpy edited(&canvas, &EmphasisCanvas::edited);
        const auto nodes = [&] { return edited.last().first().value<std::vector<EmphasisNode>>(); };
        QTest::keyClick(&canvas, Qt::Key_PageDown);
        for (int i = 0; i < 30; ++i) QTest::keyClick(&canvas, Qt::Key_Right);
        QCOMPARE(nodes()[0].position, 0.0);  // not beyond its neighbour
        QTest::keyClick(&canvas, Qt::Key_Up);
        QVERIFY(std::abs(nodes()[0].opacity - 0.05) < 1e-9);
        QTest::keyClick(&canvas, Qt::Key_Delete);
        QCOMPARE(nodes().size(), std::size_t{2});
        const auto count = edited.count();
        QTest::keyClick(&canvas, Qt::Key_Delete);
        QCOMPARE(edited.count(), count);
    }
};

ECHOLUCENT_TEST_CLASS(TestPanelsDesigner)
#include "test_panels_designer.moc"
