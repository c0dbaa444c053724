// When a designer is run for a view, with what, and what the view has meanwhile.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <new>
#include <thread>

#include "app/otf/view_designs.h"
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

class TestViewDesigns : public QObject {
    Q_OBJECT

private slots:
    void init() {
        VolumeGeometry geometry;
        geometry.size = {6, 6, 6};
        std::vector<std::uint8_t> voxels(216, 40);
        for (std::size_t i = 108; i < voxels.size(); ++i) voxels[i] = 160;
        const auto phase = std::make_shared<const Volume>(geometry, Voxels(voxels));
        const QString path = m_folder.filePath("cube.mha");
        m_designs.reset();
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
        m_openStudy = std::make_unique<OpenStudy>();
        m_designs = std::make_unique<ViewDesigns>(*m_model, *m_openStudy);
        m_designs->setRun([this](const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
            return run(config, input, progress);
        });
        QSignalSpy opened(m_openStudy.get(), &OpenStudy::studyOpened);
        m_openStudy->open(path);
        QVERIFY(opened.wait(patience));
    }

    void nothingIsComputedWithoutADesign() {
        Document next = m_model->document();
        next.scene.front.depthMm = 1;
        m_model->edit(next, "cut");
        QVERIFY(!m_designs->busy());
        QVERIFY(!m_designs->of(firstPane));
        QVERIFY(!m_designs->isNewest(firstPane));
    }

    void aDesignIsComputedOnceAndTold() {
        QSignalSpy computed(m_designs.get(), &ViewDesigns::computed);
        QSignalSpy busy(m_designs.get(), &ViewDesigns::busyChanged);
        design(otsuOf(0.7));
        QVERIFY(m_designs->busy());
        QVERIFY(!m_designs->isNewest(firstPane));
        wait();
        QCOMPARE(computed.count(), 1);
        QCOMPARE(computed.first().first().toInt(), firstPane);
        QCOMPARE(busy.count(), 2);
        QVERIFY(m_designs->isNewest(firstPane));
        const auto made = m_designs->of(firstPane);
        QVERIFY(made->milliseconds >= 0.0);
        QVERIFY(made->raw == m_openStudy->volume());
        QVERIFY(made->shown == m_openStudy->volume());
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
            QVERIFY(m_designs->isNewest(firstPane));
            QCOMPARE(m_asked.size() > before, tubeCores ? withTubeCores : without);
            m_model->begin(Document(unchanged));
            m_openStudy->setReduction(SpeckleReduction::off);
            wait();
        }
    }

    void theNewestWinsAndTheOneBeforeStaysMeanwhile() {
        design(otsuOf(0.2));
        wait();
        const auto first = m_designs->of(firstPane);
        m_held = true;
        design(otsuOf(0.3));
        QTRY_COMPARE(m_running, 1);
        QVERIFY(m_designs->of(firstPane) == first);
        QVERIFY(!m_designs->isNewest(firstPane));
        design(otsuOf(0.4));
        QTRY_COMPARE(m_cancelled, 1);
        QVERIFY(m_designs->of(firstPane) == first);
        m_held = false;
        wait();
        QCOMPARE(opacityAt(m_designs->of(firstPane)->design.classification, 0.9, 0.0), 0.4);
        QVERIFY(m_designs->isNewest(firstPane));
    }

    void whatWasMadeBeforeIsKept() {
        design(otsuOf(0.2));
        wait();
        design(otsuOf(0.3));
        wait();
        QCOMPARE(m_asked.size(), std::size_t{2});
        QSignalSpy computed(m_designs.get(), &ViewDesigns::computed);
        m_model->steps().undo();
        QVERIFY(m_designs->isNewest(firstPane));  // at once
        QCOMPARE(computed.count(), 1);
        QCOMPARE(opacityAt(m_designs->of(firstPane)->design.classification, 0.9, 0.0), 0.2);
        QCOMPARE(m_asked.size(), std::size_t{2});
    }

    void viewsThatAskTheSameShareOneComputation() {
        Document next = withDesigner(m_model->document(), firstPane, otsuOf(0.5));
        next.panes.resize(3, next.panes.front());
        next = withDesigner(withCurve(std::move(next), 2, CurveKind::manual), 2, otsuOf(0.5));
        QSignalSpy computed(m_designs.get(), &ViewDesigns::computed);
        m_designs->setExtraPanes({1, 2});
        m_model->edit(next, "three views");
        wait();
        QCOMPARE(computed.count(), 3);
        QCOMPARE(m_asked.size(), std::size_t{1});
        QVERIFY(m_designs->of(0) == m_designs->of(1));
        QVERIFY(m_designs->of(0) == m_designs->of(2));
        m_designs->setExtraPanes({});  // nobody looks at the others
        QVERIFY(m_designs->of(0) && !m_designs->of(1) && !m_designs->of(2));
    }

    void extraViewsHaveTheirAdaptiveOtf() {
        Document next = m_model->document();
        next.panes.push_back({.withoutTubes = {3}});
        m_model->edit(next, "another view");
        QVERIFY(!m_designs->busy());
        m_designs->setExtraPanes({0, 1});
        wait();
        QCOMPARE(m_asked.size(), std::size_t{2});
        QVERIFY(std::holds_alternative<AdaptiveConfig>(m_asked.front().config));
        QVERIFY(m_asked.front().method.grid.withoutTubes.empty());
        QCOMPARE(m_asked.back().method.grid.withoutTubes, std::vector<int>{3});
        QVERIFY(m_designs->isNewest(0) && m_designs->isNewest(1));
        m_designs->setExtraPanes({});
        QVERIFY(!m_designs->of(1));
    }

    void whatWasCancelledIsNotBegunAgainByItself() {
        design(otsuOf(0.2));
        wait();
        m_held = true;
        design(otsuOf(0.3));
        QTRY_COMPARE(m_running, 1);
        m_designs->cancel();
        QTRY_VERIFY(!m_designs->busy());
        Document next = m_model->document();
        next.scene.front.depthMm = 1;
        m_model->edit(next, "cut");
        QVERIFY(!m_designs->busy());
        QVERIFY(!m_designs->isNewest(firstPane));
        QCOMPARE(opacityAt(m_designs->of(firstPane)->design.classification, 0.9, 0.0), 0.2);
        m_held = false;
        m_designs->computeAgain();
        wait();
        QVERIFY(m_designs->isNewest(firstPane));
        QCOMPARE(opacityAt(m_designs->of(firstPane)->design.classification, 0.9, 0.0), 0.3);
    }

    void cancelBeginsNothingOfWhatWaits() {
        Document next = withDesigner(m_model->document(), firstPane, otsuOf(0.5));
        next.panes.push_back({.curve = CurveKind::manual, .designer = otsuOf(0.7)});
        m_designs->setExtraPanes({1});
        m_held = true;
        m_model->edit(next, "two designs");
        QTRY_COMPARE(m_running, 1);
        QSignalSpy cancelled(m_designs.get(), &ViewDesigns::cancelled);
        m_designs->cancel();
        QTRY_VERIFY(!m_designs->busy());
        QCOMPARE(cancelled.count(), 1);
        QCOMPARE(static_cast<int>(m_cancelled), 1);
        QVERIFY(m_asked.empty());
        QVERIFY(m_designs->isRefused(0) && m_designs->isRefused(1));
        m_held = false;
        m_designs->computeAgain();
        wait();
        QVERIFY(m_designs->isNewest(0) && m_designs->isNewest(1));
        QVERIFY(!m_designs->isRefused(0));
    }

    void whatPlaysNoPartIsNotComputed() {
        Document next = withDesigner(m_model->document(), firstPane, otsuOf(0.5));
        next.scene.look.mode = RenderMode::maximum;
        m_model->edit(next, "maximum");
        QVERIFY(!m_designs->busy());
        next.scene.look.mode = RenderMode::direct;
        m_model->edit(next, "direct");
        wait();
        QVERIFY(m_designs->isNewest(firstPane));
    }

    void aDesignerWithoutMemoryEndsInASentence() {
        m_outOfMemory = true;
        QSignalSpy failed(m_designs.get(), &ViewDesigns::failed);
        design(otsuOf(0.2));
        wait();
        QCOMPARE(failed.count(), 1);
        QCOMPARE(failed.first().at(0).value<std::size_t>(), firstPane);
        QVERIFY(failed.first().at(1).toString().endsWith('.'));
        QVERIFY(!m_designs->of(firstPane));
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
        QVERIFY(m_designs->isNewest(firstPane));
    }

    void anotherStudyHasNothingOfTheOneBefore() {
        design(otsuOf(0.2));
        wait();
        const auto before = m_openStudy->volume();
        QSignalSpy opened(m_openStudy.get(), &OpenStudy::studyOpened);
        m_openStudy->open(m_folder.filePath("cube.mha"));
        QVERIFY(opened.wait(patience));
        wait();
        QVERIFY(m_designs->of(firstPane)->raw != before);
        QVERIFY(m_designs->isNewest(firstPane));
    }

private:
    std::optional<Design> run(const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
        m_running = 1;
        while (m_held && !progress.cancelled()) std::this_thread::yield();
        m_running = 0;
        if (progress.cancelled()) {
            ++m_cancelled;
            return std::nullopt;
        }
        if (m_outOfMemory) throw std::bad_alloc();
        m_asked.push_back({config, &input.raw, &input.shown, input.reduction, input.view, input.method});
        const auto* otsu = std::get_if<OtsuConfig>(&config);
        const double opacity = otsu != nullptr ? otsu->opacity : 1.0;
        return Design{.classification = ManualCurve{{{0.0, 0.0}, {0.5, opacity}, {1.0, opacity}}}};
    }
    void design(const DesignerConfig& config) {
        m_model->edit(withDesigner(m_model->document(), firstPane, config), "design");
    }
    void wait() { QTRY_VERIFY_WITH_TIMEOUT(!m_designs->busy() && !m_openStudy->quietPhases().busy(), patience); }

    QTemporaryDir m_folder;
    std::unique_ptr<DocumentModel> m_model;
    std::unique_ptr<OpenStudy> m_openStudy;
    // Above the designs, whose thread is the only one that touches them while something is computed.
    std::vector<Asked> m_asked;
    std::atomic<bool> m_held = false, m_outOfMemory = false;
    std::atomic<int> m_running = 0, m_cancelled = 0;
    std::unique_ptr<ViewDesigns> m_designs;
};

ECHOLUCENT_TEST_CLASS(TestViewDesigns)
#include "test_view_designs.moc"
