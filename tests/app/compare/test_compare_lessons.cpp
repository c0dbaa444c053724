// What a lesson shows in the comparison: the OTFs of a motion side by side, figures of the paper, the page that is
// kept.
#include <QAction>
#include <QLabel>
#include <QSlider>
#include <thread>

#include "app/otf/pane_otfs.h"
#include "processing/designers/choice/designer.h"
#include "processing/motion/otf_smoothing.h"
#include "tests/app/compare/compare_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestCompareLessons : public QObject, private CompareFixture {
    Q_OBJECT

private slots:
    void initTestCase() { makeFiles(); }
    void init() { begin(); }
    void cleanup() { close(); }

    void panesShowTheOtfsOfAMotion() {
        waitUntilRest();
        child<QAction>("compare.motions")->trigger();
        QCOMPARE(document().panes.size(), std::size_t{3});
        QCOMPARE(document().panes.at(1).motionOtf, std::optional(MotionOtf::eachView));
        waitUntilRest();
        QVERIFY(child<QComboBox>("compare.motion2")->isVisible());
        const auto curves = [this] {
            std::vector<Classification> made;
            for (const PaneRequest& pane : window().compareRoom().views().frame()->request.panes)
                made.push_back(pane.classification);
            return made;
        };
        QVERIFY(curves()[0] == curves()[1] && curves()[1] == curves()[2]);  // all begin in one view
        const Classification begun = curves()[0];
        std::vector<SampledCurve> own;
        OtfHistory history(OtfSmoothing::leastFlicker);
        (void)history.add(0, std::get<SampledCurve>(begun.curve()));
        for (int angle = 1; angle <= 3; ++angle) {
            child<QSlider>("motion.angle")->setValue(angle);
            waitUntilRest();
            const auto made = curves();
            QVERIFY(made[0] == begun);
            const Design design = *echolucent::design(AdaptiveConfig{}, {*window().openStudy().volume(),
                                                                         *window().openStudy().newestVoxels(),
                                                                         {},
                                                                         viewpointOf(document()),
                                                                         configOf(document())});
            QVERIFY(made[1] == design.classification);
            QVERIFY(made[2] == Classification(history.add(angle, std::get<SampledCurve>(made[1].curve()))));
        }
        click("compare.measureFlicker");
        QTRY_VERIFY_WITH_TIMEOUT(panel().rows()[2].flicker.has_value(), 60000);
        QCOMPARE(*panel().rows()[0].flicker, 0.0);
        QVERIFY(*panel().rows()[2].flicker < *panel().rows()[1].flicker);
    }

    void figuresOfThePaperAreOneClick() {
        child<QAction>("compare.figure9")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(document().scene.motionAngle, 30.0, 60000);
        QVERIFY(window().openStudy().isSimulatedScan());
        QTRY_VERIFY_WITH_TIMEOUT(window().idle() && window().compareRoom().views().settled(), 60000);
        const auto nine = window().compareRoom().views().frame();
        QCOMPARE(nine->panes.size(), std::size_t{2});
        QVERIFY(nine->request.panes[0].classification != nine->request.panes[1].classification);
        // The truth of the simulated scan is known, also in the turned view.
        QVERIFY(panel().rows()[1].surfaces == SurfacesFrom::truth);
        QVERIFY(panel().rows()[1].depth->rays() > 1000);
        QVERIFY(panel().rows()[0].depth->rays() == panel().rows()[1].depth->rays());
        QVERIFY(child<QLabel>("compare.note")->text().contains("true ones of the simulated scan"));
        child<QAction>("compare.figure1")->trigger();
        waitUntilRest();
        const auto one = window().compareRoom().views().frame();
        QCOMPARE(one->panes.size(), std::size_t{3});
        QVERIFY(opacityAt(one->request.panes[0].classification, 0.5, 0.0) == 0.5);
        const auto names = [this] {
            QStringList all;
            for (std::size_t place = 0; place < 3; ++place) all << grid().pane(place).face().name;
            return all;
        };
        QCOMPARE(names(), QStringList({"1  (a) Linear OTF", "2  (b) Manually designed piecewise linear OTF",
                                       "3  (c) Adaptively designed OTF"}));
        QCOMPARE(panel().rows()[1].name, QString("(b) Manually designed piecewise linear OTF"));
        QCOMPARE(child<QComboBox>("compare.first")->itemText(2), QString("3: (c) Adaptively designed OTF"));
        // Another slope is another curve than the paper's.
        Document steeper = document();
        steeper.curves.linear.slope = 0.6;
        window().document().edit(steeper, "slope");
        QCOMPARE(names(), QStringList({"1  Manual curve", "2  Piecewise linear curve (eq. 1)", "3  Adaptive curve"}));
        QCOMPARE(child<QComboBox>("compare.first")->itemText(1), QString("2: Piecewise linear curve (eq. 1)"));
    }

    void thePageOpensWithoutANetwork() {
        waitUntilRest();
        const QString path = temporaryFolder().filePath("comparison.html");
        window().compareRoom().savePage(path);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path), patience);
        waitUntilRest();
        QFile page(path);
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray text = page.readAll();
        QCOMPARE(text.count("data:image/png"), 4);
        QVERIFY(text.contains("not for diagnosis") && text.contains("<svg"));
        QVERIFY(!text.contains("href=\"http") && !text.contains("src=\"http"));
    }

    void aPageIsGivenUpWhereAPaneWillNotCome() {
        waitUntilRest();
        window().otfs().setRun([](const DesignerConfig&, const DesignerInput&, const Progress& progress) {
            while (!progress.cancelled()) std::this_thread::yield();
            return std::optional<Design>();
        });
        window().document().edit(withPane(document(), 1, {.designer = OtsuConfig{}}), "designer");
        QTRY_VERIFY(window().otfs().busy());
        const QString path = temporaryFolder().filePath("given-up.html");
        window().compareRoom().savePage(path);
        QVERIFY(!window().idle());
        window().otfs().cancel();
        waitUntilRest();
        QVERIFY(!QFile::exists(path));
        QVERIFY(!child<QAbstractButton>("designer.compute")->isHidden());
        QVERIFY(!panel().rows()[1].contrast);
    }
};

ECHOLUCENT_TEST_CLASS(TestCompareLessons)

#include "test_compare_lessons.moc"
