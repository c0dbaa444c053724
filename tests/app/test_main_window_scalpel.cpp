// Strokes of the scalpel and the render box of the document in the real window, and the same picture without a window.
#include <QElapsedTimer>
#include <QTimer>

#include "processing/document/box_editing.h"
#include "processing/pane_picture/pane_picture.h"
#include "processing/ray_caster/ray_caster.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "tests/app/picture_measures.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestMainWindowScalpel : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        m_file = file("fetus.mha", {smallPhantom(PhantomScene::fetus, 3)});
        m_moving =
            file("moving.mha", {smallPhantom(PhantomScene::fetus, 3), smallPhantom(PhantomScene::fetus, 4, 0.5)});
    }
    void init() { show(); }
    void cleanup() { close(); }

    void aStrokeCutsPictureAndTubeCoresAndIsTakenBack() {
        open(m_file);
        const Picture before = cast();
        const SampledCurve curveBefore = window().otfs().adaptive()->curve;
        const DataBox box = openStudy().volume()->dataBox();
        QVERIFY(!openStudy().volume()->isCut());
        QSignalSpy cut(&openStudy(), &OpenStudy::volumeCut);
        int computed = 0;
        QObject context;
        connect(&window().otfs(), &PaneOtfs::computed, &context,
                [&computed](std::size_t place) { computed += place == PaneOtfs::adaptiveOfScene ? 1 : 0; });
        draw(stroke(0.0, 0.25));
        QVERIFY2(!window().idle(), "the stroke is being cut");
        waitUntilIdle();
        QCOMPARE(cut.count(), 1);
        QVERIFY2(computed == 1, "the OTF follows");
        // Raw and quiet voxels lack the same, and the quiet ones are what they were.
        QVERIFY(openStudy().volume()->isCut());
        QCOMPARE(openStudy().newestVoxels()->dataMask(), openStudy().volume()->dataMask());
        QCOMPARE(openStudy().volume()->dataBox(), box);
        QVERIFY(openStudy().newestVoxels()->voxels() == openStudy().quietPhases().of(0)->voxels());
        QVERIFY(window().volumeView().volume() == openStudy().newestVoxels());
        QVERIFY(window().otfs().adaptive()->curve != curveBefore);
        QVERIFY2(cast().rgba != before.rgba, "it shows");
        QVERIFY2(difference(cast(), *window().volumeView().picture()) < 0.1, "and the view shows it");
        window().document().steps().undo();
        QVERIFY(!window().idle());
        waitUntilIdle();
        QVERIFY(!openStudy().volume()->isCut());
        QVERIFY(window().otfs().adaptive()->curve == curveBefore);
        QVERIFY(cast().rgba == before.rgba);
        window().document().steps().redo();
        waitUntilIdle();
        QVERIFY(openStudy().volume()->isCut());
    }

    void theNewestOfManyStrokesWins() {
        open(m_file);
        for (int i = 0; i < 8; ++i) draw(stroke(0.05 * (i - 4), 0.1));
        waitUntilIdle();
        const auto strokes = window().document().document().scene.strokes;
        QCOMPARE(strokes.size(), std::size_t(8));
        QCOMPARE(openStudy().strokes(), strokes);
        const auto expected = ScalpelCuts(scan(0).geometry()).cut(scan(0), strokes);
        QCOMPARE(openStudy().volume()->dataMask(), expected->dataMask());
    }

    void everyPhaseIsCut() {
        open(m_moving);
        draw(stroke(0.1, 0.2));
        waitUntilIdle();
        const auto strokes = window().document().document().scene.strokes;
        for (const int phase : {1, 0}) {
            window().document().showPhase(phase);
            waitUntilIdle();
            QCOMPARE(openStudy().phase(), phase);
            QCOMPARE(openStudy().volume()->dataMask(),
                     ScalpelCuts(scan(phase).geometry()).cut(scan(phase), strokes)->dataMask());
            QCOMPARE(openStudy().newestVoxels()->dataMask(), openStudy().volume()->dataMask());
        }
        // Another study has no strokes.
        open(m_file);
        QVERIFY(!openStudy().volume()->isCut());
    }

    void thePictureWithoutAWindowIsThatOfTheWindow_data() {
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<bool>("reduced");
        QTest::addColumn<bool>("bow");
        QTest::addRow("parallel, quiet voxels") << false << true << false;
        QTest::addRow("perspective, raw voxels") << true << false << false;
        QTest::addRow("bowed front") << false << false << true;
    }
    void thePictureWithoutAWindowIsThatOfTheWindow() {
        QFETCH(bool, perspective);
        QFETCH(bool, reduced);
        QFETCH(bool, bow);
        open(m_moving);
        Document next = window().document().document();
        next.scene.pose.direction = {.azimuth = 24, .elevation = -11, .roll = 5};
        next.scene.pose.magnification = 1.2;
        Box& box = next.scene.box;
        box = wholeBox({.direction = {.azimuth = 15}}, next.beam.axis, openStudy().volume()->dataBox());
        box.sizeMm = box.sizeMm * 0.7;
        next.scene.front = {.depthMm = 9};
        if (bow) next.scene.front = {.surface = bowed(surfaceOfFront(next, *openStudy().volume()), 8)};
        Look& look = next.scene.look;
        look.projection = perspective ? Projection::perspective : Projection::parallel;
        look.reduction = reduced ? SpeckleReduction::medium : SpeckleReduction::off;
        look.mixing = 0.25;
        look.brightness = 1.3;
        next.scene.strokes.push_back(stroke(0.1, 0.15));
        next.motion.otfPhase = 1;
        window().document().edit(next, "everything");
        window().document().showPhase(1);
        waitUntilIdle();
        const Picture ofWindow = cast();
        const auto alone = panePicture(window().document().document(), firstPane, openStudy().study()->phases,
                                       ofWindow.width, ofWindow.height);
        QVERIFY(alone->cast == window().volumeView().settings());
        QCOMPARE(difference(alone->picture, ofWindow), 0.0);
        QVERIFY(alone->picture.rgba == ofWindow.rgba);
        QVERIFY(difference(alone->picture, *window().volumeView().picture()) < 0.1);
        QVERIFY2(brightest(alone->picture) > 0.2F, "there is something to compare");
    }

    void theEventLoopGoesOnWhileStrokesAreCut() {
        open(m_file);
        qint64 longest = 0;
        QElapsedTimer since;
        QTimer beat;
        connect(&beat, &QTimer::timeout, this, [&] { longest = std::max(longest, since.restart()); });
        since.start();
        beat.start(1);
        for (int i = 0; i < 4; ++i) {
            const auto before = openStudy().volume();
            draw(stroke(0.1 * (i - 2), 0.1));
            QVERIFY2(openStudy().volume() == before, "the stroke was cut before the hand came back");
            waitUntilIdle();
            QVERIFY(openStudy().volume() != before);
        }
        qInfo("longest stall while four strokes were cut: %lld ms", static_cast<long long>(longest));
    }

private:
    OpenStudy& openStudy() { return window().openStudy(); }
    const Volume& scan(int phase) { return *openStudy().study()->phases[static_cast<std::size_t>(phase)]; }
    /// What the ray caster makes of what is shown.
    Picture cast() {
        return *castRays(*openStudy().newestVoxels(),
                         curveOf(window().document().document(), firstPane, window().otfs().adaptive()->curve),
                         window().volumeView().settings());
    }
    /// A square about a place right of the picture's centre, down to the middle.
    ScalpelStroke stroke(double right, double half) {
        const Camera camera = window().volumeView().settings().camera;
        return {.tool = ScalpelTool::polygon,
                .camera = camera,
                .places = {{right - half, -half}, {right + half, -half}, {right + half, half}, {right - half, half}},
                .depthMm = camera.frame.forward.dot(camera.focalPoint)};
    }
    void draw(const ScalpelStroke& stroke) {
        Document next = window().document().document();
        next.scene.strokes.push_back(stroke);
        window().document().edit(next, "cut");
    }
    static float brightest(const Picture& picture) {
        return *std::max_element(picture.rgba.begin(), picture.rgba.end());
    }

    QString m_file, m_moving;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowScalpel)

#include "test_main_window_scalpel.moc"
