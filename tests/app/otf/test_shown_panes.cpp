// What a pane is to show, and when it is ready: voxels and classification of one study, and no picture in between.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <mutex>
#include <thread>

#include "app/otf/shown_panes.h"
#include "io/writers/meta_image_writer.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> cube(std::uint8_t bright) {
    VolumeGeometry geometry;
    geometry.size = {6, 6, 6};
    std::vector<std::uint8_t> voxels(216, 40);
    for (std::size_t i = 108; i < voxels.size(); ++i) voxels[i] = bright;
    return std::make_shared<const Volume>(geometry, Voxels(voxels));
}

ScalpelStroke someStroke() { return {.places = {{-0.4, -0.4}, {0.4, -0.4}, {0.0, 0.4}}}; }

}  // namespace

class TestShownPanes : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
    void initTestCase() {
        m_first = m_folder.filePath("first.mha");
        m_second = m_folder.filePath("second.mha");
        QVERIFY(writeMetaImage(m_first.toStdString(), {cube(160)}));
        QVERIFY(writeMetaImage(m_second.toStdString(), {cube(200), cube(220)}));
    }
    void init() {
        m_quieteningIsHeld = false;
        m_otfIsHeld = m_adaptiveToo = false;
        m_views.clear();
        m_model = std::make_unique<DocumentModel>();
        Document document;
        document.scene.look.reduction = SpeckleReduction::light;
        m_model->begin(document);
        m_openStudy = std::make_unique<OpenStudy>(m_works);
        m_openStudy->quietPhases().setReduce(
            [this](const Volume& volume, SpeckleReduction reduction, const Progress& progress) {
                while (m_quieteningIsHeld && !progress.cancelled()) std::this_thread::yield();
                return quietVolume(volume, reduction, progress);
            });
        m_otfs = std::make_unique<PaneOtfs>(*m_model, *m_openStudy, m_works);
        m_otfs->setRun([this](const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
            return run(config, input, progress);
        });
        m_panes = std::make_unique<ShownPanes>(*m_model, *m_openStudy, *m_otfs, m_course);
    }
    void cleanup() {
        m_quieteningIsHeld = false;
        m_otfIsHeld = false;
        m_panes.reset();
        m_otfs.reset();
        m_openStudy.reset();
    }

    void aPictureWithoutAComputedOtfWaitsForQuietVoxelsToo_data() {
        QTest::addColumn<Document>("document");
        Document document;
        document.scene.look.reduction = SpeckleReduction::light;
        QTest::newRow("a person's curve") << withCurve(document, firstPane, CurveKind::manual);
        document.scene.look.mode = RenderMode::maximum;
        QTest::newRow("maximum intensity") << document;
        document.scene.look.mode = RenderMode::direct;
        QTest::newRow("adaptive") << document;
    }
    void aPictureWithoutAComputedOtfWaitsForQuietVoxelsToo() {
        QFETCH(Document, document);
        m_model->begin(document);
        m_quieteningIsHeld = true;
        const auto voxels = collectVoxels();
        open(m_first);
        QVERIFY(!m_panes->at(firstPane).ready);
        QVERIFY2(m_views.empty(), "no OTF of raw voxels was begun");
        m_quieteningIsHeld = false;
        QTRY_VERIFY(m_panes->at(firstPane).ready);
        QCOMPARE(voxels->size(), std::size_t{1});
        QVERIFY(voxels->front() == m_openStudy->quietPhases().of(0));
        QVERIFY(m_panes->at(firstPane).measured == m_openStudy->volume());
    }

    void cancelledQuieteningIsWaitedForNoMore() {
        m_quieteningIsHeld = true;
        open(m_first);
        QVERIFY(!m_panes->at(firstPane).ready);
        m_openStudy->quietPhases().cancel();
        QTRY_VERIFY(m_panes->at(firstPane).ready);
        QVERIFY(m_panes->at(firstPane).voxels == m_openStudy->volume());
    }

    void anotherReductionChangesVoxelsAndOtfTogether() {
        open(m_first);
        QTRY_VERIFY(m_panes->at(firstPane).newest);
        const ShownPane before = m_panes->at(firstPane);
        m_quieteningIsHeld = true;
        const auto voxels = collectVoxels();
        Document next = m_model->document();
        next.scene.look.reduction = SpeckleReduction::strong;
        m_model->edit(next, "more");
        QVERIFY(m_panes->at(firstPane).ready);
        QVERIFY(m_panes->at(firstPane).voxels == before.voxels);
        m_quieteningIsHeld = false;
        QTRY_VERIFY(m_panes->at(firstPane).newest);
        QCOMPARE(voxels->size(), std::size_t{2});  // what was, and what is
        QVERIFY(m_otfs->of(firstPane)->asked.reduction == SpeckleReduction::strong);
    }

    void aDesignerThatIsCancelledLeavesWhatWasShown() {
        m_model->begin(withCurve(m_model->document(), firstPane, CurveKind::linear));
        open(m_first);
        QTRY_VERIFY(m_panes->at(firstPane).ready);
        const Classification before = m_panes->at(firstPane).classification;
        QVERIFY(opacityAt(before, 0.9, 0) > 0);
        m_otfIsHeld = true;
        m_model->edit(withDesigner(m_model->document(), firstPane, OtsuConfig{}), "designer");
        QVERIFY(!m_panes->at(firstPane).ready);
        QTRY_VERIFY(m_otfs->designing());
        m_otfs->cancel();
        QVERIFY(m_panes->at(firstPane).ready && m_panes->at(firstPane).refused);
        QVERIFY(m_panes->at(firstPane).classification == before);
    }

    void cancellingADesignerLeavesTheOtfOfTheScene() {
        m_model->begin(withDesigner(m_model->document(), firstPane, OtsuConfig{}));
        m_otfIsHeld = true;
        open(m_first);
        QTRY_VERIFY(m_otfs->designing());
        QVERIFY(m_otfs->isNewest(PaneOtfs::adaptiveOfScene));  // it does not wait for the designer
        m_otfs->cancel();
        Document next = m_model->document();
        next.scene.front.depthMm = 1;
        m_model->edit(withCurve(next, firstPane, CurveKind::adaptive), "curve");
        QTRY_VERIFY(m_panes->at(firstPane).newest);
    }

    void aStudyIsFollowedWithItsOwnDocumentAlone() {
        open(m_first);
        QTRY_VERIFY(m_panes->at(firstPane).newest);
        Document turned = m_model->document();
        turned.motion.otf = MotionOtf::eachView;
        turned.scene.pose.direction.azimuth = 33;
        turned.scene.strokes = {someStroke()};
        m_model->edit(turned, "turn");
        m_panes->setPlaying(true);
        m_model->showFrame(7, 0);
        // The stroke is cut meanwhile, and asks for an OTF of its own.
        QTRY_VERIFY(m_works.idle() && m_panes->at(firstPane).newest);
        m_views.clear();
        connect(m_openStudy.get(), &OpenStudy::studyReplaced, m_panes.get(), [this] {
            m_panes->setPlaying(false);
            m_model->begin(openedDocument(m_model->document(), m_openStudy->reference()));
        });
        const auto voxels = collectVoxels();
        open(m_second);
        QTRY_VERIFY(m_panes->at(firstPane).newest);
        QVERIFY(m_openStudy->strokes().empty());
        QCOMPARE(m_views.size(), std::size_t{1});
        QVERIFY(m_views.front() == viewpointOf(m_model->document()));
        QVERIFY(voxels->back() == m_openStudy->newestVoxels());
    }

    void whatPlaysShowsAFrameWithItsOwnOtf() {
        open(m_second);
        Document next = m_model->document();
        next.motion.otf = MotionOtf::eachView;
        m_model->edit(next, "each view");
        QTRY_VERIFY(m_panes->at(firstPane).newest);
        m_otfIsHeld = m_adaptiveToo = true;
        m_model->showFrame(3, 0);
        QVERIFY2(m_panes->at(firstPane).ready, "under the hand the picture follows at once");
        m_panes->setPlaying(true);
        QVERIFY(!m_panes->at(firstPane).ready);
        m_model->showFrame(3, 1);
        QVERIFY(!m_panes->at(firstPane).ready);
        m_otfIsHeld = false;
        QTRY_VERIFY(m_panes->at(firstPane).ready);
        QVERIFY(m_panes->at(firstPane).measured == m_openStudy->rawVoxelsOf(1));
        QVERIFY(m_otfs->of(firstPane)->asked.raw == m_openStudy->rawVoxelsOf(1));  // never that of the phase left
    }

    void whatNobodyLooksAtKeepsNoVoxels() {
        open(m_first);
        Document two = m_model->document();
        two.panes.push_back({.withoutTubes = {1}});
        m_model->edit(two, "two panes");
        m_otfs->setComparing(true);
        QTRY_VERIFY(m_panes->at(1).newest);
        const std::weak_ptr<const Volume> quiet = m_panes->at(1).voxels;
        m_otfs->setComparing(false);
        Document next = m_model->document();
        next.scene.look.reduction = SpeckleReduction::strong;
        m_model->edit(next, "more");
        QTRY_VERIFY(m_panes->at(firstPane).newest);
        QTRY_VERIFY(quiet.expired());
    }

private:
    std::optional<Design> run(const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
        const bool adaptive = std::holds_alternative<AdaptiveConfig>(config);
        while ((!adaptive || m_adaptiveToo) && m_otfIsHeld && !progress.cancelled()) std::this_thread::yield();
        if (progress.cancelled()) return std::nullopt;
        auto otf = std::make_shared<AdaptiveOtf>();
        otf->view = input.view;
        otf->config = input.method;
        otf->curve = SampledCurve{{0.0, 0.5, 1.0}};
        if (!adaptive) return Design{.classification = ManualCurve{}};
        const std::lock_guard lock(m_mutex);
        m_views.push_back(input.view);
        return Design{.classification = otf->curve, .tubeCores = otf};
    }
    /// The voxels with which the first pane is ready, each once, in their order.
    std::shared_ptr<std::vector<std::shared_ptr<const Volume>>> collectVoxels() {
        auto voxels = std::make_shared<std::vector<std::shared_ptr<const Volume>>>();
        connect(m_panes.get(), &ShownPanes::changed, m_panes.get(), [this, voxels] {
            const ShownPane& pane = m_panes->at(firstPane);
            if (pane.ready && (voxels->empty() || voxels->back() != pane.voxels)) voxels->push_back(pane.voxels);
        });
        return voxels;
    }
    void open(const QString& path) {
        QSignalSpy opened(m_openStudy.get(), &OpenStudy::studyOpened);
        m_openStudy->open(path);
        QVERIFY(opened.wait(patience));
    }

    QTemporaryDir m_folder;
    QString m_first, m_second;
    std::atomic<bool> m_quieteningIsHeld = false, m_otfIsHeld = false, m_adaptiveToo = false;
    std::mutex m_mutex;
    std::vector<Viewpoint> m_views;  ///< of the adaptive OTFs that were computed
    OtfCourse m_course;
    std::unique_ptr<DocumentModel> m_model;
    std::unique_ptr<OpenStudy> m_openStudy;
    std::unique_ptr<PaneOtfs> m_otfs;
    std::unique_ptr<ShownPanes> m_panes;
};

ECHOLUCENT_TEST_CLASS(TestShownPanes)
#include "test_shown_panes.moc"
