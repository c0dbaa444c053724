// What makes the adaptive OTF be computed anew, and for which view.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/otf/pane_otfs.h"
#include "io/writers/meta_image_writer.h"
#include "processing/motion/otf_sweep.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

/// Tells what it was asked for and finds nothing.
std::optional<Design> echo(const DesignerConfig&, const DesignerInput& input, const Progress&) {
    auto otf = std::make_shared<AdaptiveOtf>();
    otf->view = input.view;
    otf->config = input.method;
    return Design{.classification = SampledCurve{}, .tubeCores = std::move(otf)};
}

}  // namespace

class TestOtfViews : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
    void init() {
        VolumeGeometry geometry;
        geometry.size = {4, 4, 4};
        const QString path = m_folder.filePath("cube.mha");
        const auto phase = std::make_shared<const Volume>(geometry, Voxels(std::vector<std::uint8_t>(64, 90)));
        // Nothing is written over a study that is open.
        m_otfs.reset();
        m_openStudy.reset();
        QVERIFY(writeMetaImage(path.toStdString(), {phase, phase}));
        m_model = std::make_unique<DocumentModel>();
        m_openStudy = std::make_unique<OpenStudy>(m_works);
        m_otfs = std::make_unique<PaneOtfs>(*m_model, *m_openStudy, m_works);
        m_otfs->setRun(&echo);
        QSignalSpy opened(m_openStudy.get(), &OpenStudy::studyOpened);
        m_openStudy->open(path);
        QVERIFY(opened.wait(patience));
        awaitOtf();
    }

    void whatTheOtfDependsOnAsksForAnother_data() {
        using Change = std::function<void(Document&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<bool>("asks");
        const auto row = [](const char* name, bool asks, Change change) { QTest::newRow(name) << change << asks; };
        row("cut", true, [](Document& d) { d.scene.front.depthMm = 2; });
        row("beam", true, [](Document& d) { d.beam.axis = BeamAxis::plusX; });
        row("direction", true, [](Document& d) { d.scene.side.azimuth = 5; });
        row("parameter", true, [](Document& d) { d.method.config.grid.columns = 3; });
        row("scale of the initial function", true, [](Document& d) { d.method.initialScale = 0.5; });
        row("the editor's curve as initial function", true,
            [](Document& d) { d.method.initial = InitialKind::linear; });
        row("a curve that is not the initial function", false, [](Document& d) { d.curves.linear.slope = 0.1; });
        row("pose", false, [](Document& d) { d.scene.pose.direction.azimuth = 5; });
        row("look", false, [](Document& d) { d.scene.look.colourMap = ColourMap::ice; });
        row("rendered curve", false, [](Document& d) { d.panes.at(firstPane).curve = CurveKind::linear; });
        row("motion", false, [](Document& d) { d.motion.axis = MotionAxis::z; });
    }
    void whatTheOtfDependsOnAsksForAnother() {
        QFETCH(std::function<void(Document&)>, change);
        QFETCH(bool, asks);
        Document next = m_model->document();
        change(next);
        m_model->edit(next, "change");
        QCOMPARE(m_otfs->busy(), asks);
        if (!asks) return;
        awaitOtf();
        QVERIFY(m_otfs->adaptive()->view == otfViewpointOf(next, firstPane));
        QVERIFY(m_otfs->adaptive()->config == configOf(next));
        m_model->steps().undo();
        awaitOtf();
        QVERIFY(m_otfs->adaptive()->view == Viewpoint{});
        QVERIFY(m_otfs->adaptive()->config == AdaptiveOtfConfig{});
    }

    void anEditOfTheInitialFunctionAsks() {
        Document next = m_model->document();
        next.method.initial = InitialKind::manual;
        m_model->edit(next, "initial");
        awaitOtf();
        next.curves.manual.nodes[1].opacity = 0.25;
        m_model->preview(next, "drag");  // already while the hand drags
        awaitOtf();
        QVERIFY(m_otfs->adaptive()->config.initial == OpacityCurve(next.curves.manual));
    }

    void computeForThisViewTakesWhatIsShownAsOneStep() {
        Document next = m_model->document();
        next.scene.pose.direction = {10, 20, 30};
        m_model->edit(next, "turn");
        m_model->showFrame(5, 0);
        m_otfs->computeForThisView();
        awaitOtf();
        QVERIFY(m_otfs->adaptive()->view == turned({BeamAxis::plusZ, 10, 20, 30}, MotionAxis::screenVertical, 5));
        QCOMPARE(m_model->steps().count(), 2);
        m_model->steps().undo();
        awaitOtf();
        QVERIFY(m_otfs->adaptive()->view == Viewpoint{});
    }

    void theOneOtfIsOfThePhaseThatTheDocumentNames() {
        m_model->showPhase(1);
        QVERIFY(m_otfs->isNewest(PaneOtfs::adaptiveOfScene));  // whichever phase is shown
        m_otfs->computeForThisView();
        awaitOtf();
        QCOMPARE(m_model->document().motion.otfPhase, 1);
        QCOMPARE(phaseOfOtf(), 1);
        QCOMPARE(m_model->steps().count(), 1);
        m_model->steps().undo();
        awaitOtf();
        QCOMPARE(phaseOfOtf(), 0);
        Document next = m_model->document();
        next.motion.otf = MotionOtf::eachView;
        m_model->edit(next, "each");
        awaitOtf();
        QCOMPARE(phaseOfOtf(), 1);  // the phase that is shown
        m_model->showPhase(0);
        awaitOtf();
        QCOMPARE(phaseOfOtf(), 0);
    }

    void aCutKeepsTheDirectionOfAFrame() {
        Document next = m_model->document();
        next.motion.otf = MotionOtf::eachView;
        m_model->edit(next, "each");
        m_model->showFrame(12, 0);
        awaitOtf();
        QVERIFY(m_otfs->adaptive()->view == (Viewpoint{BeamAxis::plusZ, 12, 0, 0}));
        next = m_model->document();
        next.scene.front = frontAcross({.azimuth = 12}, 1);
        m_model->edit(next, "cut");
        awaitOtf();
        QVERIFY(m_otfs->adaptive()->view == (withFrontAcross(Viewpoint{BeamAxis::plusZ, 12, 0, 0}, 1)));
    }

    void theHandThatEndsAMotionLeavesTheViewOfItsLastFrame() {
        Document next = m_model->document();
        next.motion.otf = MotionOtf::eachView;
        m_model->edit(next, "each");
        m_model->showFrame(12, 0);
        awaitOtf();
        next = m_model->document();
        next.scene.pose.direction.elevation = 30;
        next.scene.motionAngle = 0;
        m_model->edit(next, "turn view");
        QVERIFY(m_otfs->isNewest(PaneOtfs::adaptiveOfScene));
        QCOMPARE(m_otfs->adaptive()->view.azimuthDegrees, 12.0);
        // Another side has the last word.
        next.scene.side.azimuth = 40;
        m_model->edit(next, "side");
        awaitOtf();
        QCOMPARE(m_otfs->adaptive()->view.azimuthDegrees, 40.0);
    }

private:
    void awaitOtf() {
        QVERIFY(QTest::qWaitFor([this] { return m_otfs->isNewest(PaneOtfs::adaptiveOfScene); }, patience));
    }
    int phaseOfOtf() { return *m_openStudy->phaseOfVoxels(*m_otfs->of(PaneOtfs::adaptiveOfScene)->asked.raw); }

    QTemporaryDir m_folder;
    std::unique_ptr<DocumentModel> m_model;
    std::unique_ptr<OpenStudy> m_openStudy;
    std::unique_ptr<PaneOtfs> m_otfs;
};

ECHOLUCENT_TEST_CLASS(TestOtfViews)
#include "test_otf_views.moc"
