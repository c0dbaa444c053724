// Whose OTF the real window shows while phases play and are stepped through, and when one is computed.
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <array>
#include <atomic>
#include <utility>
#include <vector>

#include "app/window/theme.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/designers/choice/designer.h"
#include "processing/motion/otf_smoothing.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "tests/app/cine_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestMainWindowCineOtfs : public QObject, private CineFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        wearTheme(Theme::dark);
        teach();
        writeStudies();
    }
    void init() { showWindow(); }
    void cleanup() { close(); }

    void theCaptionSaysOfWhichPhaseTheOneOtfIs() {
        open(moving());
        const auto said = [this] { return window().volumeView().caption().contains("curve of volume 1"); };
        QVERIFY(said());  // as in every frame of the motion
        click("face.review");
        QVERIFY(!said());  // a matter of Teach
        click("face.teach");
        QVERIFY(said());
        QTest::keyClick(&window(), Qt::Key_Period);
        waitUntilIdle();
        QVERIFY2(said(), qPrintable(window().volumeView().caption()));
        QTest::keyClick(&window(), Qt::Key_2);  // another curve
        QVERIFY(!said());
        QTest::keyClick(&window(), Qt::Key_1);
        QVERIFY(said());
        Document next = document();
        next.motion.scenario = MotionScenario::probe;
        window().document().edit(next, "what moves");
        QVERIFY(said());
        window().document().showPhase(0);
        QVERIFY(!said());  // it is that of the phase shown
        window().document().showPhase(1);
        next = document();
        next.motion.otf = MotionOtf::eachView;
        window().document().edit(next, "each phase's OTF");
        QVERIFY(!said());
        waitUntilIdle();
    }

    void thePhasesOfARangePlayBackAndForthWithSmoothedOtfs() {
        open(moving());
        QTest::keyClick(child<QSpinBox>("motion.firstPhase"), Qt::Key_Up);
        click("motion.phasesPingPong");
        click("motion.mode.leastFlicker");
        waitUntilIdle();
        const auto& phases = window().openStudy().study()->phases;
        const auto ofPhase = [&](int phase) {
            return adaptOpacity(*phases[static_cast<std::size_t>(phase)], Viewpoint{}, {})->curve;
        };
        OtfHistory history;
        (void)history.add(0, ofPhase(0));
        const std::vector<std::pair<int, SampledCurve>> frames = play(9);
        const std::vector<int> order{1, 2, 3, 4, 3, 2, 1, 2, 3};
        for (std::size_t i = 0; i < order.size(); ++i) {
            QCOMPARE(frames[i].first, order[i]);
            QVERIFY2(frames[i].second == history.add(i + 1.0, ofPhase(order[i])), qPrintable(QString::number(i)));
        }
    }

    void theOneOtfIsThatOfItsPhaseWhicheverIsShown_data() {
        QTest::addColumn<bool>("quiet");
        QTest::newRow("raw voxels") << false;
        QTest::newRow("quiet voxels") << true;
    }
    void theOneOtfIsThatOfItsPhaseWhicheverIsShown() {
        QFETCH(bool, quiet);
        Look look;
        if (quiet) look.reduction = SpeckleReduction::light;
        useLook(look);
        open(moving());
        const auto shows = [&](int phaseOfOtf) {
            const auto& openStudy = window().openStudy();
            const auto expected =
                adaptOpacity(*openStudy.study()->phases[static_cast<std::size_t>(phaseOfOtf)],
                             otfViewpointOf(document(), firstPane), configOf(document()), {},
                             quiet ? QuietVoxels{openStudy.quietPhases().of(phaseOfOtf).get(), SpeckleReduction::light}
                                   : QuietVoxels{});
            return window().otfEditor().state().adaptive == expected->curve &&
                   window().volumeView().volume() == window().openStudy().newestVoxels();
        };
        QVERIFY(shows(0));
        for (const int phase : {1, 2}) {
            QTest::keyClick(&window(), Qt::Key_Period);
            waitUntilIdle();
            QCOMPARE(window().openStudy().phase(), phase);
            QVERIFY(shows(0));
        }
        QTest::keyClick(&window(), Qt::Key_A);
        waitUntilIdle();
        QCOMPARE(document().motion.otfPhase, 2);
        QVERIFY(shows(2));
        // A parameter that changes while another phase is shown.
        QTest::keyClick(child<QSlider>("motion.phase"), Qt::Key_End);
        QTest::keyClick(child<QComboBox>("adaptive.form"), Qt::Key_End);
        waitUntilIdle();
        QVERIFY(shows(2));
        QTest::keyClick(child<QSpinBox>("motion.otfPhase"), Qt::Key_Down);
        waitUntilIdle();
        QVERIFY(shows(1));
        click("motion.mode.eachView");
        waitUntilIdle();
        QVERIFY(shows(phaseCount - 1));
        QTest::keyClick(&window().volumeView(), Qt::Key_Z, Qt::ControlModifier);
        waitUntilIdle();
        QVERIFY(shows(1));
        // Chosen again, it is the phase that is shown.
        click("motion.mode.mean");
        child<QSlider>("motion.phase")->setFocus();  // else the key turns the probe
        QTest::keyClick(child<QSlider>("motion.phase"), Qt::Key_Left);
        waitUntilIdle();
        click("motion.mode.static");
        waitUntilIdle();
        QCOMPARE(document().motion.otfPhase, phaseCount - 2);
        QVERIFY(shows(phaseCount - 2));
        for (const auto& [phase, curve] : play(phaseCount)) QVERIFY(curve == window().otfEditor().state().adaptive);
        QVERIFY(shows(phaseCount - 2));
    }

    void aStrokeReachesTheOneOtfOfAPhaseThatIsNotShown() {
        open(moving());
        const SampledCurve before = window().otfEditor().state().adaptive;
        for (int i = 0; i < 2; ++i) QTest::keyClick(&window(), Qt::Key_Period);
        waitUntilIdle();
        ScalpelStroke stroke{.tool = ScalpelTool::polygon, .camera = window().volumeView().settings().camera};
        stroke.places = {{-0.1, -0.1}, {0.2, -0.1}, {0.2, 0.2}, {-0.1, 0.2}};
        Document next = document();
        next.scene.strokes.push_back(stroke);
        window().document().edit(next, "cut");
        waitUntilIdle();
        const Volume& scan = *window().openStudy().study()->phases.front();
        ScalpelCuts cuts(scan.geometry());
        const Volume cut = *cuts.cut(scan, std::array{stroke});
        const auto expected = adaptOpacity(cut, otfViewpointOf(document(), firstPane), configOf(document()));
        QVERIFY(expected->curve != before);
        QVERIFY(window().otfEditor().state().adaptive == expected->curve);
        QVERIFY(window().volumeView().volume() == window().openStudy().newestVoxels());
        QVERIFY(window().openStudy().volume() != window().openStudy().study()->phases[2]);  // cut too
        QTest::keyClick(&window().volumeView(), Qt::Key_Z, Qt::ControlModifier);
        waitUntilIdle();
        QVERIFY(window().otfEditor().state().adaptive == before);
        QCOMPARE(window().volumeView().volume(), window().openStudy().study()->phases[2]);
    }

    void anotherPhaseNeedsNoOtfWhereOneServesAll() {
        open(moving());
        std::atomic<int> runs = 0;
        countRuns(runs);
        for (int i = 0; i < phaseCount; ++i) {
            QTest::keyClick(&window(), Qt::Key_Period);
            waitUntilIdle();
        }
        (void)play(2 * phaseCount);
        QCOMPARE(runs.load(), 0);
        QCOMPARE(window().explanation().contains("the OTF of volume 1 serves every frame"), true);
    }

    void aKeptTurnComputesAndCastsNothingAnew() {
        open(moving());
        click("motion.mode.eachView");
        waitUntilIdle();
        std::atomic<int> runs = 0;
        countRuns(runs);
        MotionPlayer& player = window().motionPlayer();
        player.setMinimumFrameInterval(0);
        int kept = 0;  // frames in a row that came from memory, which keep no picture of floats
        QObject context;
        connect(&window().volumeView(), &VolumeViewWidget::pictureDelivered, &context,
                [&] { kept = window().volumeView().picture() ? 0 : kept + 1; });
        click("motion.play");
        QTRY_VERIFY_WITH_TIMEOUT(kept >= 2 * phaseCount, 30000);
        QCOMPARE(window().volumeView().keptFrames(), phaseCount);
        QVERIFY(window().volumeView().keptFrameBytes() > 0);
        QCOMPARE(window().otfs().kept().count(), static_cast<std::size_t>(phaseCount));
        QVERIFY(runs <= phaseCount);
        const int before = runs, keptBefore = kept;
        QTRY_VERIFY_WITH_TIMEOUT(kept >= keptBefore + 2 * phaseCount, 30000);
        QCOMPARE(runs.load(), before);
        QVERIFY(kept >= 4 * phaseCount);  // none was cast in between
        auto* readOut = child<QLabel>("motion.frameRate");
        QTRY_VERIFY2(readOut->toolTip().contains(QString("%1 pictures").arg(phaseCount)), qPrintable(readOut->text()));
        click("motion.play");
        waitUntilIdle();
    }

private:
    void countRuns(std::atomic<int>& runs) {
        window().otfs().setRun(
            [&runs](const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
                ++runs;
                return design(config, input, progress);
            });
    }
    /// Plays so many frames, and returns the phase and the curve that each was shown with.
    std::vector<std::pair<int, SampledCurve>> play(int count) {
        std::vector<std::pair<int, SampledCurve>> frames;
        MotionPlayer& player = window().motionPlayer();
        player.setMinimumFrameInterval(0);
        QObject context;
        int phase = -1;
        // With the picture of a frame its curve is in the editor. An OTF that is kept is there as soon as the next
        // frame begins.
        SampledCurve curve;
        connect(&window().volumeView(), &VolumeViewWidget::pictureDelivered, &context,
                [&] { curve = window().otfEditor().state().adaptive; });
        // A frame begins: the one before is on the screen.
        connect(&player, &MotionPlayer::frameChanged, &context, [&](double, int next) {
            if (phase >= 0) frames.emplace_back(phase, curve);
            phase = next;
        });
        click("motion.play");
        if (!QTest::qWaitFor([&] { return static_cast<int>(frames.size()) >= count; }, 60000))
            qFatal("%d of %d frames were shown", static_cast<int>(frames.size()), count);
        click("motion.play");
        waitUntilIdle();
        return frames;
    }
};

ECHOLUCENT_TEST_CLASS(TestMainWindowCineOtfs)

#include "test_main_window_cine_otfs.moc"
