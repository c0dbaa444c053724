// The panel of section 4: it shows the numbers of processing/theory, and nothing else.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <memory>

#include "processing/adaptive/adaptive_otf_result.h"
#include "processing/document/curve_set.h"
#include "processing/theory/theory_plots.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/controls/value_slider.h"
#include "widgets/plots/plot_canvas.h"
#include "widgets/theory/theory_panel.h"

using namespace echolucent;

class TestTheoryPanel : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_panel = std::make_unique<TheoryPanel>();
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }
    void cleanup() { m_panel.reset(); }

    void itBeginsWithThePapersCurvesAndThePhantomsIntensities() {
        QVERIFY(m_panel->setting() == TheorySetting{});
        showsItsSetting();
        QVERIFY2(words().startsWith("By difference, the tissue is shown best by adaptive: 0.333 of white."),
                 qPrintable(words()));
    }

    void eachControlSetsItsValueAlone() {
        TheorySetting expected;
        type("theory.tissue", "128");
        expected.model.tissue = 128.0 / 255.0;
        type("theory.fluid", "51");
        expected.model.fluid = 51.0 / 255.0;
        type("theory.fluidUnits", "120");
        expected.model.fluidUnits = 120;
        type("theory.tissueUnits", "7");
        expected.model.tissueUnits = 7;
        type("theory.scale", "0.5");
        expected.scale = 0.5;
        choose("theory.scaling", 1);
        expected.scaling = OpacityScaling::sameAtTissue;
        choose("theory.contrast", 1);
        expected.contrast = ContrastKind::michelson;
        choose("theory.axis", 1);
        QVERIFY(m_panel->setting() == expected);
        QCOMPARE(m_panel->axis(), CourseAxis::ratio);
        showsItsSetting();
        child<QPushButton>(*m_panel, "theory.reset")->click();
        QVERIFY(m_panel->setting() == TheorySetting{});
        showsItsSetting();
    }

    void aStudyGivesIntensitiesAndCurves() {
        auto* fromStudy = child<QPushButton>(*m_panel, "theory.fromStudy");
        QVERIFY(!fromStudy->isEnabled());
        std::optional<StudyIntensities> study;
        m_panel->setStudy([&study] { return study; });
        QVERIFY2(!fromStudy->isEnabled(), "a study without a surface gives nothing");
        study = StudyIntensities{0.4321, 0.1234, {}};
        study->given.adaptive = SampledCurve{{0.0, 0.0, 0.9, 0.9}};
        study->given.parabolic.scale = 0.7;
        m_panel->followStudy();
        QVERIFY(fromStudy->isEnabled());
        fromStudy->click();
        QCOMPARE(m_panel->setting().model.tissue, 0.4321);
        QCOMPARE(m_panel->setting().model.fluid, 0.1234);
        QVERIFY(m_panel->setting().given == study->given);
        showsItsSetting();
        type("theory.fluidUnits", "50");
        QCOMPARE(m_panel->setting().model.tissue, 0.4321);  // not rounded to what its field shows
    }

    void intensitiesAreTheMeansOfTheSurfacesFound() {
        const CurveSet curves;
        QVERIFY(!studyIntensities(nullptr, curves));
        AdaptiveOtf otf;
        otf.curve.opacities = {0.0, 0.5, 1.0};
        TubeCore tube;
        tube.lowIntensity = 0.1;
        tube.highIntensity = 0.5;
        tube.d = 3.0;
        otf.tubes.push_back(tube);
        tube.lowIntensity = 0.2;
        tube.highIntensity = 0.3;
        tube.d = 1.0;
        otf.tubes.push_back(tube);
        QVERIFY2(!studyIntensities(&otf, curves), "no tube core is said to have a weight");
        otf.tubesWithWeight = 2;
        const auto found = studyIntensities(&otf, curves);
        QVERIFY(found);
        QCOMPARE(found->fluid, 0.125);  // (3 * 0.1 + 1 * 0.2) / 4
        QCOMPARE(found->tissue, 0.45);
        QVERIFY(found->given.adaptive == otf.curve);
        QVERIFY(found->given.equation1 == curves.linear);
        otf.surfacesWhereDataBegin = true;
        QVERIFY2(!studyIntensities(&otf, curves), "where data begin there is no fluid");
    }

    void nothingIsComputedWhileNobodySeesIt() {
        m_panel->hide();
        const QString before = words();
        TheorySetting dark;
        dark.model.tissue = 0.0;
        m_panel->setSetting(dark);
        QCOMPARE(words(), before);
        m_panel->show();
        QVERIFY2(words().startsWith("No curve shows the tissue."), qPrintable(words()));
        showsItsSetting();
    }

private:
    [[nodiscard]] QString words() const { return child<QLabel>(*m_panel, "theory.words")->text(); }

    void type(const char* name, const char* number) {
        auto* box = child<QAbstractSpinBox>(*m_panel, (std::string(name) + ".value").c_str());
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, number);
        QTest::keyClick(box, Qt::Key_Return);
    }
    void choose(const char* name, int index) { child<QComboBox>(*m_panel, name)->setCurrentIndex(index); }

    void showsItsSetting() {
        const TheorySetting& setting = m_panel->setting();
        const auto* table = child<QTableWidget>(*m_panel, "theory.table");
        const auto contrasts = contrastsOf(setting);
        QCOMPARE(table->rowCount(), static_cast<int>(contrasts.size()));
        for (int row = 0; row < table->rowCount(); ++row) {
            const CurveContrast& one = contrasts[static_cast<std::size_t>(row)];
            QCOMPARE(table->verticalHeaderItem(row)->text(), QString::fromStdString(one.name));
            QCOMPARE(table->item(row, 0)->text(), QString::fromStdString(shareText(one.pixels.fluid)));
            QCOMPARE(table->item(row, 1)->text(), QString::fromStdString(shareText(one.pixels.tissue)));
            QCOMPARE(table->item(row, 2)->text(), QString::fromStdString(shareText(one.contrast)));
        }
        QCOMPARE(words(), QString::fromStdString(winnerSentence(setting)));
        const ContrastCourse course = courseOf(setting, m_panel->axis());
        QVERIFY(child<PlotCanvas>(*m_panel, "theory.contrastPlot")->plot() ==
                contrastPlot(setting, course, m_panel->axis()));
        QVERIFY(child<PlotCanvas>(*m_panel, "theory.pixelPlot")->plot() == pixelPlot(setting, course, m_panel->axis()));
        QVERIFY(child<PlotCanvas>(*m_panel, "theory.curvePlot")->plot() == opacityPlot(setting));
    }

    std::unique_ptr<TheoryPanel> m_panel;
};

ECHOLUCENT_TEST_CLASS(TestTheoryPanel)
#include "test_theory_panel.moc"
