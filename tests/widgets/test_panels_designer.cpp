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

/// The panel on a document whose first pane is rendered with a designer, or with a curve.
struct Shown {
    explicit Shown(const std::optional<DesignerConfig>& config = std::nullopt) { show(config); }
    void show(const std::optional<DesignerConfig>& config) {
        const Document& now = document.document();
        document.begin(config ? withDesigner(now, firstPane, *config) : withCurve(now, firstPane, CurveKind::adaptive));
    }
    [[nodiscard]] const DesignerConfig& config() const {
        const DesignerConfig* config = designerConfigOf(document.document(), firstPane);
        if (config == nullptr) qFatal("no designer");
        return *config;
    }
    DocumentModel document;
    DesignerPanel panel{document};
};

}  // namespace

class TestPanelsDesigner : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void offersACurveAndAllDesigners() {
        Shown s;
        auto* choice = child<QComboBox>(s.panel, "designer.choice");
        QCOMPARE(choice->count(), 1 + static_cast<int>(allDesigners.size()));
        QCOMPARE(choice->itemText(0), QString("Curve"));
        QCOMPARE(choice->currentIndex(), 0);
        QTest::keyClick(choice, Qt::Key_Down);
        QCOMPARE(s.document.steps().undoText(), "choose designer Adaptive");
        QVERIFY(s.config() == DesignerConfig(AdaptiveConfig{}));
        QTest::keyClick(choice, Qt::Key_Up);
        QCOMPARE(s.document.steps().undoText(), "choose curve");
        QCOMPARE(s.document.steps().count(), 2);
        QVERIFY(designerConfigOf(s.document.document(), firstPane) == nullptr);
    }

    void everyParameterHasAControlWithItsMeaning_data() {
        QTest::addColumn<int>("designer");
        for (const Designer designer : allDesigners)
            QTest::newRow(std::string(nameOf(designer)).c_str()) << static_cast<int>(designer);
    }
    void everyParameterHasAControlWithItsMeaning() {
        QFETCH(int, designer);
        const DesignerConfig config = defaultConfigOf(static_cast<Designer>(designer));
        Shown s(config);
        AllSignals noise(s.panel);
        s.panel.show();
        forEachParameter(config, [&](const auto& row, const auto& values) {
            const QString name = "designer." + QString::fromStdString(camelCase(row.name));
            auto* control = child<QWidget>(s.panel, name.toLatin1().constData());
            QCOMPARE(control->isVisible(), row.get(values).has_value());
            QVERIFY(control->toolTip().startsWith(QString::fromUtf8(row.meaning.data(), row.meaning.size())));
            QVERIFY(!control->accessibleName().isEmpty());
        });
        QVERIFY2(s.panel.minimumSizeHint().width() <= 329,
                 qPrintable(QString::number(s.panel.minimumSizeHint().width())));
        QCOMPARE(noise.count(), 0);
        QCOMPARE(s.document.steps().count(), 0);
    }

    void aTypedNumberComesOutOnce() {
        Shown s(OtsuConfig{});
        auto* opacity = child<QDoubleSpinBox>(s.panel, "designer.opacity");
        opacity->selectAll();
        QTest::keyClicks(opacity, "0.25");
        QTest::keyClick(opacity, Qt::Key_Return);
        QCOMPARE(s.document.steps().count(), 1);
        QVERIFY(s.config() == DesignerConfig(OtsuConfig{.opacity = 0.25}));
        QCOMPARE(s.document.steps().undoText(), "Otsu ramp: opacity");
    }

    void aNumberThatNobodyMovedKeepsItsDigits() {
        const OtsuConfig exact{.spreads = 1.23456789, .opacity = 0.5};
        Shown s(exact);
        QTest::keyClick(child<QDoubleSpinBox>(s.panel, "designer.opacity"), Qt::Key_Up);
        QCOMPARE(s.document.steps().count(), 1);
        QCOMPARE(std::get<OtsuConfig>(s.config()).spreads, 1.23456789);
    }

    void whatPlaysNoPartIsHidden() {
        Shown s(LevoyConfig{});
        s.panel.show();
        auto* given = child<QWidget>(s.panel, "designer.fluidLevel");
        QVERIFY(!given->isVisible());
        s.show(LevoyConfig{.levels = LevoyLevels::given});
        QVERIFY(given->isVisible());
        QVERIFY(child<QWidget>(s.panel, "designer.transitionWidth")->isVisible());
        s.show(LevoyConfig{.form = LevoyForm::boundaries});
        QVERIFY(!child<QWidget>(s.panel, "designer.transitionWidth")->isVisible());
        s.show(std::nullopt);
        QVERIFY(!given->isVisible());
    }

    void resetGivesTheDefaults() {
        Shown s(OtsuConfig{.opacity = 0.5});
        QTest::mouseClick(child<QAbstractButton>(s.panel, "designer.reset"), Qt::LeftButton);
        QCOMPARE(s.document.steps().count(), 1);
        const DesignerConfig standard = OtsuConfig{};
        QVERIFY(s.config() == standard);
    }

    void whatWasMadeIsToldAndPlotted() {
        Shown s(OtsuConfig{});
        s.panel.show();
        const Design design{.classification = PowerCurve{2, 1.0},
                            .explanation = {"The first sentence.", "The second."},
                            .facts = {{"threshold", "Threshold", 0.25}, {"share", "Dark voxels", 0.5, "share"}},
                            .plots = {plotOf({0, 2, 1}), DesignPlot{"other", "Other", "", {0, 1}, {0, 1}}},
                            .message = "All are alike."};
        s.panel.setDesign(&design, 12.3);
        QVERIFY(child<QLabel>(s.panel, "designer.explanation")->text().contains("The second."));
        QVERIFY(child<QLabel>(s.panel, "designer.message")->text().endsWith("All are alike."));
        const QString facts = child<QLabel>(s.panel, "designer.facts")->text();
        QVERIFY(facts.contains("Threshold") && facts.contains("0.25") && facts.contains("0.5 share") &&
                facts.contains("12 ms"));
        auto* plot = child<QComboBox>(s.panel, "designer.plot");
        QCOMPARE(plot->count(), 2);
        QCOMPARE(plot->itemText(0), QString("Area (square units)"));
        QTest::keyClick(plot, Qt::Key_Down);
        QCOMPARE(child<QWidget>(s.panel, "designer.plot.canvas")->accessibleDescription(), QString("Other"));
        s.panel.setDesign(nullptr, 0);
        QVERIFY(!plot->isVisible());
        QVERIFY(!child<QLabel>(s.panel, "designer.message")->isVisible());
    }

    void progressAndCancelAreSeenWhileItComputes() {
        Shown s(OtsuConfig{});
        s.panel.show();
        auto* cancel = child<QAbstractButton>(s.panel, "designer.cancel");
        auto* compute = child<QAbstractButton>(s.panel, "designer.compute");
        QVERIFY(!cancel->isVisible());
        s.panel.setComputing(true, false);
        s.panel.setProgress(0.5);
        QVERIFY(cancel->isVisible() && !compute->isVisible());
        auto* progress = child<QProgressBar>(s.panel, "designer.progress");
        QCOMPARE(2 * progress->value(), progress->maximum());
        QSignalSpy cancelled(&s.panel, &DesignerPanel::cancelRequested);
        QTest::mouseClick(cancel, Qt::LeftButton);
        QCOMPARE(cancelled.count(), 1);
        s.panel.setComputing(false, true);
        QVERIFY(!cancel->isVisible() && compute->isVisible());
        QSignalSpy asked(&s.panel, &DesignerPanel::computeRequested);
        QTest::mouseClick(compute, Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
        s.panel.setComputing(false, false);
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
        Shown s(ContourSpectrumConfig{});
        const Design design{.classification = PowerCurve{2, 1.0}, .plots = {plotOf({0, 1, 4, 1, 0, 0, 1, 2, 1, 0, 0})}};
        s.panel.setDesign(&design, 1.0);
        s.panel.show();
        auto* canvas = child<DesignPlotCanvas>(s.panel, "designer.plot.canvas");
        QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->positionOf(7).toPoint());
        QCOMPARE(s.document.steps().count(), 1);
        QVERIFY(s.config() == withThreshold(ContourSpectrumConfig{}, 0.7).value());
        QVERIFY(thresholdOf(s.config()) == 0.7);
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
