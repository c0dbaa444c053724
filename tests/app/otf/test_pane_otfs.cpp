// When a designer is run for a pane, with what, and what the pane has meanwhile.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <atomic>
#include <new>
#include <thread>

#include "app/otf/pane_otfs.h"
#include "io/writers/meta_image_writer.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

struct Asked {
    DesignerConfig config;
    const Volume* raw;
    const Volume* shown;
    SpeckleReduction reduction;
    Viewpoint view;
    AdaptiveOtfConfig method;
};

OtsuConfig otsuOf(double opacity) { return {.opacity = opacity}; }

}  // namespace

class TestPaneOtfs : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
    void init() {
        VolumeGeometry geometry;
        geometry.size = {6, 6, 6};
        std::vector<std::uint8_t> voxels(216, 40);
        for (std::size_t i = 108; i < voxels.size(); ++i) voxels[i] = 160;
        const auto phase = std::make_shared<const Volume>(geometry, Voxels(voxels));
        const QString path = m_folder.filePath("cube.mha");
        m_otfs.reset();
        m_openStudy.reset();
        QVERIFY(writeMetaImage(path.toStdString(), {phase, phase}));
        m_held = false;
        m_outOfMemory = false;
        m_cancelled = 0;
        m_asked.clear();
        m_model = std::make_unique<DocumentModel>();
        Document look = m_model->document();
        look.scene.look.reduction = SpeckleReduction::off;
        m_model->begin(look);
        m_openStudy = std::make_unique<OpenStudy>(m_works);
        m_otfs = std::make_unique<PaneOtfs>(*m_model, *m_openStudy, m_works);
        m_otfs->setRun([this](const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
            return run(config, input, progress);
        });
        QSignalSpy opened(m_openStudy.get(), &OpenStudy::studyOpened);
        m_openStudy->open(path);
        QVERIFY(opened.wait(patience));
        wait();
        m_adaptive.clear();
    }

    void withoutADesignerAPaneHasTheOtfOfTheScene() {
        QVERIFY(m_otfs->isNewest(firstPane) && m_otfs->isNewest(PaneOtfs::adaptiveOfScene));
        QVERIFY(m_otfs->of(firstPane) == m_otfs->of(PaneOtfs::adaptiveOfScene));
        QVERIFY(!m_otfs->designOf(firstPane));
        Document next = withCurve(m_model->document(), firstPane, CurveKind::manual);
        next.scene.front.depthMm = 1;
        m_model->edit(next, "cut, seen through a curve of a person");
        wait();
        QVERIFY(!m_otfs->of(firstPane));  // nothing that is computed plays a part there
        QVERIFY(m_otfs->isNewest(PaneOtfs::adaptiveOfScene));
        QCOMPARE(m_adaptive.size(), std::size_t{1});
        QCOMPARE(frontDepthMm(m_adaptive.front().view), 1.0);
        QVERIFY(m_asked.empty());
    }

    void aPaneKeepsItsOtfUntilItsDesignerHasMadeAnother() {
        const auto adaptive = m_otfs->of(firstPane);
        m_held = true;
        design(otsuOf(0.7));
        QTRY_COMPARE(m_running, 1);
        QVERIFY(m_otfs->of(firstPane) == adaptive);
        QVERIFY(!m_otfs->designOf(firstPane));
        m_held = false;
        wait();
        QVERIFY(m_otfs->designOf(firstPane) == m_otfs->of(firstPane));
        QVERIFY(m_otfs->of(PaneOtfs::adaptiveOfScene) == adaptive);
        m_model->edit(withCurve(m_model->document(), firstPane, CurveKind::adaptive), "curve");
        QVERIFY(m_otfs->of(firstPane) == adaptive);  // at once
    }

    void whatIsBeingComputedIsNotBegunAgain() {
        m_held = true;
        design(otsuOf(0.7));
        QTRY_COMPARE(m_running, 1);
        Document next = m_model->document();
        next.scene.pose.direction.azimuth = 3;
        m_model->edit(next, "pose");  // no designer depends on it
        m_held = false;
        wait();
        QCOMPARE(m_asked.size(), std::size_t{1});
        QCOMPARE(static_cast<int>(m_cancelled), 0);
    }

    void closingWhileComputingIsSafe() {
        int delivered = 0;
        QObject context;
        connect(m_otfs.get(), &PaneOtfs::computed, &context, [&delivered] { ++delivered; });
        m_held = true;
        design(otsuOf(0.7));
        QTRY_COMPARE(m_running, 1);
        m_otfs.reset();
        QCoreApplication::processEvents();
        QCOMPARE(delivered, 0);
        QCOMPARE(static_cast<int>(m_cancelled), 1);
    }

    void everythingRunsOutsideTheGuiThread() {
        design(otsuOf(0.7));
        wait();
        QVERIFY(m_thread != nullptr && m_thread != QThread::currentThread());
    }

    void aDesignIsComputedOnceAndTold() {
        QTRY_VERIFY(m_works.idle());        // the study's checksum is a work too
        QCoreApplication::processEvents();  // a work that was destroyed ends here
        QSignalSpy computed(m_otfs.get(), &PaneOtfs::computed);
        QSignalSpy works(&m_works, &Works::changed);
        design(otsuOf(0.7));
        QVERIFY(m_otfs->busy());
        QVERIFY(!m_otfs->isNewest(firstPane));
        wait();
        QCOMPARE(computed.count(), 1);
        QCOMPARE(computed.first().first().toInt(), firstPane);
        QCOMPARE(works.count(), 2);
        QVERIFY(m_otfs->isNewest(firstPane));
        const auto made = m_otfs->of(firstPane);
        QVERIFY(made->milliseconds >= 0.0);
        QVERIFY(made->asked.raw == m_openStudy->volume());
        QVERIFY(made->asked.shown == m_openStudy->volume());
        QCOMPARE(opacityAt(made->design.classification, 0.9, 0.0), 0.7);
        QCOMPARE(m_asked.size(), std::size_t{1});
    }

    void whatADesignerDependsOnAsksAgain_data() {
        using Change = std::function<void(Document&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<bool>("withTubeCores");
        QTest::addColumn<bool>("without");
        const auto row = [](const char* name, bool withTubeCores, bool without, Change change) {
            QTest::newRow(name) << change << withTubeCores << without;
        };
        row("cut", true, false, [](Document& d) { d.scene.front.depthMm = 2; });
        row("beam", true, false, [](Document& d) { d.beam.axis = BeamAxis::plusX; });
        row("direction", true, false, [](Document& d) { d.scene.side.azimuth = 5; });
        row("parameter of the method", true, false, [](Document& d) { d.method.config.grid.columns = 3; });
        row("pose", false, false, [](Document& d) { d.scene.pose.direction.azimuth = 5; });
        row("light", false, false, [](Document& d) { d.scene.look.brightness = 1.5; });
        row("threshold", false, false, [](Document& d) { d.curves.adjustment.threshold = 0.1; });
        row("speckle reduction", true, true, [](Document& d) { d.scene.look.reduction = SpeckleReduction::medium; });
        row("another phase", true, true, [](Document& d) { d.scene.phase = 1; });
    }
    void whatADesignerDependsOnAsksAgain() {
        QFETCH(std::function<void(Document&)>, change);
        QFETCH(bool, withTubeCores);
        QFETCH(bool, without);
        for (const bool tubeCores : {true, false}) {
            Document eachFrame = m_model->document();
            eachFrame.motion.otf = MotionOtf::eachView;
            m_model->begin(eachFrame);
            design(LevoyConfig{.levels = tubeCores ? LevoyLevels::tubeCores : LevoyLevels::otsu});
            wait();
            const std::size_t before = m_asked.size();
            const Document unchanged = m_model->document();
            Document next = unchanged;
            change(next);
            m_model->edit(next, "change");
            m_openStudy->setReduction(m_model->document().scene.look.reduction);
            wait();
            QVERIFY(m_otfs->isNewest(firstPane));
            QCOMPARE(m_asked.size() > before, tubeCores ? withTubeCores : without);
            m_model->begin(Document(unchanged));
            m_openStudy->setReduction(SpeckleReduction::off);
            wait();
        }
    }

    void theNewestWinsAndTheOneBeforeStaysMeanwhile() {
        design(otsuOf(0.2));
        wait();
        const auto first = m_otfs->of(firstPane);
        m_held = true;
        design(otsuOf(0.3));
        QTRY_COMPARE(m_running, 1);
        QVERIFY(m_otfs->of(firstPane) == first);
        QVERIFY(!m_otfs->isNewest(firstPane));
        design(otsuOf(0.4));
        QTRY_COMPARE(m_cancelled, 1);
        QVERIFY(m_otfs->of(firstPane) == first);
        m_held = false;
        wait();
        QCOMPARE(opacityAt(m_otfs->of(firstPane)->design.classification, 0.9, 0.0), 0.4);
        QVERIFY(m_otfs->isNewest(firstPane));
    }

    void ofManyRequestsThoseBetweenNeverRun() {
        m_held = true;
        design(otsuOf(0.01));
        QTRY_COMPARE(m_running, 1);
        QSignalSpy computed(m_otfs.get(), &PaneOtfs::computed);
        for (int i = 2; i <= 50; ++i) design(otsuOf(i / 100.0));
        QTRY_COMPARE(m_cancelled, 1);
        m_held = false;
        wait();
        QCOMPARE(computed.count(), 1);
        QCOMPARE(m_asked.size(), std::size_t{1});
        QCOMPARE(opacityAt(m_otfs->of(firstPane)->design.classification, 0.9, 0.0), 0.5);
    }

    void whatWasMadeBeforeIsKept() {
        design(otsuOf(0.2));
        wait();
        design(otsuOf(0.3));
        wait();
        QCOMPARE(m_asked.size(), std::size_t{2});
        QSignalSpy computed(m_otfs.get(), &PaneOtfs::computed);
        m_model->steps().undo();
        QVERIFY(m_otfs->isNewest(firstPane));  // at once
        QCOMPARE(computed.count(), 1);
        QCOMPARE(opacityAt(m_otfs->of(firstPane)->design.classification, 0.9, 0.0), 0.2);
        QCOMPARE(m_asked.size(), std::size_t{2});
    }

    void viewsThatAskTheSameShareOneComputation() {
        Document next = withDesigner(m_model->document(), firstPane, otsuOf(0.5));
        next.panes.resize(3, next.panes.front());
        next = withDesigner(withCurve(std::move(next), 2, CurveKind::manual), 2, otsuOf(0.5));
        QSignalSpy computed(m_otfs.get(), &PaneOtfs::computed);
        m_otfs->setComparing(true);
        m_model->edit(next, "three views");
        wait();
        QCOMPARE(computed.count(), 3);
        QCOMPARE(m_asked.size(), std::size_t{1});
        QVERIFY(m_otfs->of(0) == m_otfs->of(1));
        QVERIFY(m_otfs->of(0) == m_otfs->of(2));
        m_otfs->setComparing(false);  // nobody looks at the others
        QVERIFY(m_otfs->of(0) && !m_otfs->of(1) && !m_otfs->of(2));
    }

    void comparedPanesHaveTheirAdaptiveOtf() {
        Document next = m_model->document();
        next.panes.push_back({.withoutTubes = {3}});
        m_model->edit(next, "another view");
        QVERIFY(!m_otfs->busy());
        m_otfs->setComparing(true);
        wait();
        QCOMPARE(m_adaptive.size(), std::size_t{1});  // that of the first is the scene's
        QCOMPARE(m_adaptive.front().method.grid.withoutTubes, std::vector<int>{3});
        QVERIFY(m_otfs->isNewest(0) && m_otfs->isNewest(1));
        m_otfs->setComparing(false);
        QVERIFY(!m_otfs->of(1));
    }

    void whatWasCancelledIsNotBegunAgainByItself() {
        design(otsuOf(0.2));
        wait();
        m_held = true;
        design(otsuOf(0.3));
        QTRY_COMPARE(m_running, 1);
        m_otfs->cancel();
        QTRY_VERIFY(!m_otfs->busy());
        Document next = m_model->document();
        next.scene.front.depthMm = 1;
        m_model->edit(next, "cut");
        wait();
        QVERIFY(!m_otfs->isNewest(firstPane));
        QCOMPARE(opacityAt(m_otfs->of(firstPane)->design.classification, 0.9, 0.0), 0.2);
        m_held = false;
        m_otfs->computeAgain();
        wait();
        QVERIFY(m_otfs->isNewest(firstPane));
        QCOMPARE(opacityAt(m_otfs->of(firstPane)->design.classification, 0.9, 0.0), 0.3);
    }

    void cancelBeginsNothingOfWhatWaits() {
        Document next = withDesigner(m_model->document(), firstPane, otsuOf(0.5));
        next.panes.push_back({.curve = CurveKind::manual, .designer = otsuOf(0.7)});
        m_otfs->setComparing(true);
        m_held = true;
        m_model->edit(next, "two designs");
        QTRY_COMPARE(m_running, 1);
        QSignalSpy cancelled(m_otfs.get(), &PaneOtfs::cancelled);
        m_otfs->cancel();
        QTRY_VERIFY(!m_otfs->busy());
        QCOMPARE(cancelled.count(), 1);
        QCOMPARE(static_cast<int>(m_cancelled), 1);
        QVERIFY(m_asked.empty());
        QVERIFY(m_otfs->isRefused(0) && m_otfs->isRefused(1));
        m_held = false;
        m_otfs->computeAgain();
        wait();
        QVERIFY(m_otfs->isNewest(0) && m_otfs->isNewest(1));
        QVERIFY(!m_otfs->isRefused(0));
    }

    void whatPlaysNoPartIsNotComputed() {
        Document next = withDesigner(m_model->document(), firstPane, otsuOf(0.5));
        next.scene.look.mode = RenderMode::maximum;
        m_model->edit(next, "maximum");
        QVERIFY(!m_otfs->busy());
        next.scene.look.mode = RenderMode::direct;
        m_model->edit(next, "direct");
        wait();
        QVERIFY(m_otfs->isNewest(firstPane));
    }

    void aDesignerWithoutMemoryEndsInASentence() {
        m_outOfMemory = true;
        QSignalSpy failed(m_otfs.get(), &PaneOtfs::failed);
        design(otsuOf(0.2));
        wait();
        QCOMPARE(failed.count(), 1);
        QCOMPARE(failed.first().at(0).value<std::size_t>(), firstPane);
        QVERIFY(failed.first().at(1).toString().endsWith('.'));
        QVERIFY(!m_otfs->designOf(firstPane));
        QVERIFY(m_otfs->isRefused(firstPane));
    }

    void quietVoxelsAreShownToDesigners() {
        Document next = withDesigner(m_model->document(), firstPane, otsuOf(0.5));
        next.scene.look.reduction = SpeckleReduction::medium;
        m_model->edit(next, "quiet");
        m_openStudy->setReduction(SpeckleReduction::medium);
        QTRY_VERIFY(!m_openStudy->quietPhases().busy());
        wait();
        QVERIFY(m_asked.back().reduction == SpeckleReduction::medium);
        QVERIFY(m_asked.back().raw == m_openStudy->volume().get());
        QVERIFY(m_asked.back().shown == m_openStudy->newestVoxels().get());
        QVERIFY(m_asked.back().raw != m_asked.back().shown);
        QVERIFY(m_otfs->isNewest(firstPane));
    }

    void anotherStudyHasNothingOfTheOneBefore() {
        design(otsuOf(0.2));
        wait();
        const auto before = m_openStudy->volume();
        QSignalSpy opened(m_openStudy.get(), &OpenStudy::studyOpened);
        m_openStudy->open(m_folder.filePath("cube.mha"));
        QVERIFY(opened.wait(patience));
        wait();
        QVERIFY(m_otfs->of(firstPane)->asked.raw != before);
        QVERIFY(m_otfs->isNewest(firstPane));
    }

private:
    std::optional<Design> run(const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
        m_thread = QThread::currentThread();
        const Asked asked{config, &input.raw, &input.shown, input.reduction, input.view, input.method};
        if (std::holds_alternative<AdaptiveConfig>(config)) {
            m_adaptive.push_back(asked);
            return Design{.classification = SampledCurve{{0.0, 1.0}}};
        }
        m_running = 1;
        while (m_held && !progress.cancelled()) std::this_thread::yield();
        m_running = 0;
        if (progress.cancelled()) {
            ++m_cancelled;
            return std::nullopt;
        }
        if (m_outOfMemory) throw std::bad_alloc();
        m_asked.push_back(asked);
        const auto* otsu = std::get_if<OtsuConfig>(&config);
        const double opacity = otsu != nullptr ? otsu->opacity : 1.0;
        return Design{.classification = ManualCurve{{{0.0, 0.0}, {0.5, opacity}, {1.0, opacity}}}};
    }
    void design(const DesignerConfig& config) {
        m_model->edit(withDesigner(m_model->document(), firstPane, config), "design");
    }
    void wait() { QTRY_VERIFY_WITH_TIMEOUT(!m_otfs->busy() && !m_openStudy->quietPhases().busy(), patience); }

    QTemporaryDir m_folder;
    std::unique_ptr<DocumentModel> m_model;
    std::unique_ptr<OpenStudy> m_openStudy;
    // Above the designs, whose thread is the only one that touches them while something is computed.
    std::vector<Asked> m_asked, m_adaptive;
    std::atomic<QThread*> m_thread = nullptr;
    std::atomic<bool> m_held = false, m_outOfMemory = false;
    std::atomic<int> m_running = 0, m_cancelled = 0;
    std::unique_ptr<PaneOtfs> m_otfs;
};

ECHOLUCENT_TEST_CLASS(TestPaneOtfs)
#include "test_pane_otfs.moc"
