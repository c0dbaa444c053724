// The panel *Tube cores* by itself: its map, list, sliders and words.
#include <QAbstractItemModel>
#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <array>
#include <cstdlib>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/explanation/explanation_plots.h"
#include "processing/phantom/phantom.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/plots/plot_canvas.h"
#include "widgets/tube_cores/reading_parameters.h"
#include "widgets/tube_cores/tube_core_list.h"
#include "widgets/tube_cores/tube_core_map.h"
#include "widgets/tube_cores/tube_core_panel.h"
#include "widgets/tube_cores/tube_core_words.h"

using namespace echolucent;

class TestTubeCorePanel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {60, 56, 58};
        config.spacing = Vec3(1.4, 1.4, 1.4);
        m_volume = std::make_shared<const Volume>(*makePhantom(config));
        AdaptiveOtfConfig method = configOf(MethodReading::standard);
        method.grid.withoutTubes = {3};
        m_run = std::make_shared<const AdaptiveOtf>(*adaptOpacity(*m_volume, {}, method));
        QVERIFY(m_run->tubesWithWeight > 10);
    }

    void theMapNumbersItsCellsRowByRowAndArrowsGoOn() {
        TubeCoreMap map;
        map.resize(300, 206);
        QVERIFY(!map.numberAt({20, 20}));
        map.setRun(m_run);
        for (const int number : {0, 14, 15, 112, 224}) QCOMPARE(map.numberAt(map.cellOf(number).center()), number);
        QVERIFY(map.cellOf(14).left() > map.cellOf(0).left() && map.cellOf(15).top() > map.cellOf(0).top());
        QSignalSpy chosen(&map, &TubeCoreMap::chosen);
        QTest::mouseClick(&map, Qt::LeftButton, {}, map.cellOf(17).center().toPoint());
        QCOMPARE(chosen.takeFirst().first().toInt(), 17);
        map.setChosen(17);
        const std::vector<std::pair<Qt::Key, int>> moves{
            {Qt::Key_Left, 16}, {Qt::Key_Right, 18}, {Qt::Key_Up, 2}, {Qt::Key_Down, 32}};
        for (const auto& move : moves) {
            QTest::keyClick(&map, move.first);
            QCOMPARE(chosen.takeFirst().first().toInt(), move.second);
        }
        map.setChosen(14);
        QTest::keyClick(&map, Qt::Key_Right);
        QTest::keyClick(&map, Qt::Key_Up);
        QCOMPARE(chosen.count(), 0);  // there is nothing beyond the grid
    }

    void theMapTellsStatesApartWithoutColour() {
        const auto pictureOf = [](TubeState state) {
            QImage image(15, 15, QImage::Format_Grayscale8);
            image.fill(Qt::black);
            QPainter painter(&image);
            painter.setRenderHint(QPainter::Antialiasing);
            paintTubeCoreSign(painter, QRectF(1, 1, 13, 13), state, state == TubeState::weighs ? 0.5 : 0.0,
                              coloursOf(Theme::dark));
            painter.end();
            return image;
        };
        const std::array states{TubeState::weighs, TubeState::weighsNothing, TubeState::noSurface, TubeState::outside,
                                TubeState::neverPlaced};
        for (std::size_t i = 0; i < states.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const QImage one = pictureOf(states[i]), other = pictureOf(states[j]);
                int unlike = 0;  // pixels that a person tells apart
                for (int y = 0; y < one.height(); ++y)
                    for (int x = 0; x < one.width(); ++x)
                        unlike += std::abs(qGray(one.pixel(x, y)) - qGray(other.pixel(x, y))) > 24 ? 1 : 0;
                QVERIFY2(unlike >= 8, qPrintable(wordsOf(states[i]) + " and " + wordsOf(states[j])));
            }
    }

    void aTubeCoreThatChangesNothingIsNotComparedAndSaysWhy() {
        TubeCorePanel panel;
        panel.setRun(m_run);
        auto* compare = child<QPushButton>(panel, "tubeCores.compare");
        const auto numberOf = [this](TubeState state) {
            for (int t = 0; t < 225; ++t)
                if (stateOf(*m_run, t) == state) return t;
            return -1;
        };
        for (const TubeState state : {TubeState::weighs, TubeState::noSurface}) {
            QVERIFY(numberOf(state) >= 0);
            panel.setChosen(numberOf(state));
            QVERIFY(compare->isEnabled());
            QVERIFY(!compare->toolTip().contains("already"));
        }
        panel.setChosen(3);
        QVERIFY(!compare->isEnabled());
        QVERIFY2(compare->toolTip().contains("never placed: the curve is made without it already."),
                 qPrintable(compare->toolTip()));
        AdaptiveOtf fewer = *m_run;
        fewer.tubes[20] = TubeCore{};
        panel.setRun(std::make_shared<const AdaptiveOtf>(fewer));
        panel.setChosen(20);
        QVERIFY(!compare->isEnabled());
        QVERIFY2(compare->toolTip().contains("meets no data"), qPrintable(compare->toolTip()));
    }

    void theListSortsByNumbersAndFollowsTheChoiceSilently() {
        TubeCoreList list;
        list.setRun(m_run);
        const QAbstractItemModel& rows = *list.model();
        QCOMPARE(rows.rowCount(), 225);
        list.sortByColumn(TubeCoreListModel::weight, Qt::DescendingOrder);
        QSignalSpy chosen(&list, &TubeCoreList::chosen);
        double before = 1e9;
        for (int row = 0; row < rows.rowCount(); ++row) {
            const int number = rows.index(row, TubeCoreListModel::number).data().toInt();
            const double d = m_run->tubes[static_cast<std::size_t>(number)].d;
            QVERIFY(d <= before);
            before = d;
        }
        const int heaviest = rows.index(0, TubeCoreListModel::number).data().toInt();
        QCOMPARE(heaviest, heaviestFirst(*m_run).front());
        list.setChosen(heaviest);
        QCOMPARE(list.currentIndex().row(), 0);
        QCOMPARE(chosen.count(), 0);
        list.setFocus();
        QTest::keyClick(&list, Qt::Key_Down);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.first().first().toInt(), rows.index(1, TubeCoreListModel::number).data().toInt());
        list.setChosen(std::nullopt);
        QVERIFY(!list.currentIndex().isValid());
        QCOMPARE(chosen.count(), 1);
    }

    void onlyParametersOfTheRulesAreShown() {
        ReadingParameters sliders("tubeCores");
        const auto isShown = [&](const char* name) { return child<QWidget>(sliders, name)->isVisibleTo(&sliders); };
        sliders.setConfig(configOf(MethodReading::standard));
        QVERIFY(isShown("tubeCores.falseAlarm") && isShown("tubeCores.rampBegin") && isShown("tubeCores.cellSize"));
        QVERIFY(!isShown("tubeCores.coarsestScale") && !isShown("tubeCores.strength"));
        sliders.setConfig(configOf(MethodReading::asPublished));
        QVERIFY(isShown("tubeCores.coarsestScale") && isShown("tubeCores.strength") && isShown("tubeCores.cellSize"));
        QVERIFY(!isShown("tubeCores.falseAlarm") && !isShown("tubeCores.rampBegin"));
    }

    void parametersThatWouldCrossStayApart() {
        ReadingParameters sliders("tubeCores");
        sliders.setConfig(configOf(MethodReading::asPublished));
        QSignalSpy changed(&sliders, &ReadingParameters::configChanged);
        auto* coarsest = child<QSlider>(sliders, "tubeCores.coarsestScale");
        coarsest->setValue(coarsest->minimum());
        QCOMPARE(changed.count(), 1);
        const auto config = changed.last().first().value<AdaptiveOtfConfig>();
        QCOMPARE(problemOf(config), std::string());
        QCOMPARE(std::get<VarianceRule>(config.detection).coarsestScale, 1);
        QCOMPARE(std::get<VarianceRule>(config.detection).finestScale, 1);
        sliders.setConfig(configOf(MethodReading::standard));
        auto* begin = child<QSlider>(sliders, "tubeCores.rampBegin");
        begin->setValue(begin->maximum());
        const auto ramp = changed.last().first().value<AdaptiveOtfConfig>();
        QCOMPARE(problemOf(ramp), std::string());
        QCOMPARE(std::get<RampRule>(ramp.curve).begin, 3.0);
        QVERIFY(std::get<RampRule>(ramp.curve).end > 3.0);
    }

    void itSaysInWordsWhyItIsEmpty() {
        TubeCorePanel panel;
        const auto words = [&] { return child<QLabel>(panel, "tubeCores.sentence")->text(); };
        const auto* facts = child<QTableWidget>(panel, "tubeCores.facts");
        QVERIFY(words().startsWith("There is no curve yet"));
        QVERIFY(!facts->isVisibleTo(&panel));
        panel.setRun(m_run);
        QVERIFY2(words().startsWith("Click a tube core"), qPrintable(words()));
        AdaptiveOtf nothing = *m_run;
        nothing.tubesWithWeight = 0;
        nothing.message = "No surface found: the initial function is used.";
        panel.setRun(std::make_shared<const AdaptiveOtf>(nothing));
        QCOMPARE(words(), "No tube core has a weight. No surface found: the initial function is used.");
        QVERIFY(!facts->isVisibleTo(&panel));
    }

    void theCurveGrowsFromTheInitialFunctionToTheRuns() {
        TubeCorePanel panel;
        panel.setRun(m_run);
        const int number = heaviestFirst(*m_run).front();
        panel.setChosen(number);
        panel.setExplanation(explained(number));
        QCOMPARE(panel.thirdCurve(), explained(number)->explanation->alone.curve);
        auto* growth = child<QSlider>(panel, "tubeCores.growth");
        auto* words = child<QLabel>(panel, "tubeCores.growthWords");
        const int all = m_run->tubesWithWeight;
        QCOMPARE(growth->maximum(), all);
        const auto* curves = child<PlotCanvas>(panel, "tubeCores.plot.curves");
        const std::size_t lines = curves->plot().series.size();
        QCOMPARE(curves->plot().series.back().y, m_run->curve.opacities);
        QSignalSpy grown(&panel, &TubeCorePanel::grownChanged);
        growth->setValue(all / 2);
        QCOMPARE(curves->plot().series.size(), lines);  // no line comes that would push the slider away
        QCOMPARE(grown.count(), 1);
        QCOMPARE(panel.thirdCurve(), grownCurve(*m_run, static_cast<std::size_t>(all / 2)));
        QCOMPARE(words->text(), QString("%1 of %2 tube cores, heaviest first").arg(all / 2).arg(all));
        QCOMPARE(curves->plot().series.back().y, panel.thirdCurve().opacities);
        growth->setValue(0);
        QCOMPARE(panel.thirdCurve().opacities, explained(number)->explanation->initial);
        growth->setValue(all);
        QCOMPARE(panel.thirdCurve(), m_run->curve);
    }

    void whatItIsToldItDoesNotTell() {
        TubeCorePanel panel;
        AllSignals told(panel);
        panel.setRun(m_run);
        panel.setShown(true);
        panel.setChosen(112);
        panel.setExplanation(explained(112));
        panel.setConfig(configOf(MethodReading::asPublished));
        panel.setChosen(std::nullopt);
        panel.setRun(nullptr);
        QCOMPARE(told.count(), 0);
        child<QCheckBox>(panel, "tubeCores.shown")->click();
        QCOMPARE(told.count(), 1);
    }

private:
    std::shared_ptr<const ShownExplanation> explained(int number) const {
        ShownExplanation shown;
        shown.run = m_run;
        shown.explanation =
            std::make_shared<const TubeExplanation>(*explainTube(*m_volume, QuietVoxels{}, *m_run, number));
        shown.facts = explanationFacts(*shown.explanation);
        shown.sentence = explanationSentence(*shown.explanation);
        shown.curves = curvesPlot(*shown.explanation);
        shown.weighing = static_cast<int>(heaviestFirst(*m_run).size());
        return std::make_shared<const ShownExplanation>(shown);
    }

    std::shared_ptr<const Volume> m_volume;
    std::shared_ptr<const AdaptiveOtf> m_run;
};

ECHOLUCENT_TEST_CLASS(TestTubeCorePanel)
#include "test_tube_core_panel.moc"
