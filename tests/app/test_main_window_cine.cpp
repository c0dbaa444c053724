// The cine bar in the real window: every control by mouse or keys, what plays in which order, and whose OTF is shown.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QRadioButton>
#include <QSlider>
#include <QSpinBox>
#include <array>
#include <atomic>
#include <cstdlib>
#include <functional>

#include "app/window/dark_theme.h"
#include "io/output/nifti_writer.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/motion/otf_smoothing.h"
#include "processing/scalpel/scalpel_cuts.h"
#include "tests/app/window_fixture.h"
#include "widgets/panels/motion_panel.h"

using namespace echolucent;

using Change = std::function<void()>;
Q_DECLARE_METATYPE(Change)

class TestMainWindowCine : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        wearDarkTheme();
        std::vector<std::shared_ptr<const Volume>> phases;
        for (int i = 0; i < phaseCount; ++i)
            phases.push_back(
                smallPhantom(PhantomScene::fetus, static_cast<std::uint64_t>(7 + i), 1.0 * i / phaseCount));
        m_moving = file("moving.mha", phases);
        m_still = file("still.mha", {phases.front()});
        m_timed = temporaryFolder().filePath("timed.nii");
        QVERIFY(writeNifti(m_timed.toStdString(), phases, 0.0305).has_value());
    }
    void init() {
        show();
        window().resize(1280, 720);
        useLook(Look{});
    }
    void cleanup() { close(); }

    void spacePlaysThePhasesOfA4dStudy() {
        open(m_moving);
        QCOMPARE(document().motion.scenario, MotionScenario::object);
        const int steps = window().document().steps().count();
        window().motionPlayer().setMinimumFrameInterval(0);
        QSignalSpy frames(&window().motionPlayer(), &MotionPlayer::frameChanged);
        QTest::keyClick(&window(), Qt::Key_Space);
        QTRY_VERIFY(frames.count() >= phaseCount + 1);
        QTest::keyClick(&window(), Qt::Key_Space);
        for (int i = 0; i < phaseCount + 1; ++i) {
            QCOMPARE(frames[i][0].toDouble(), 0.0);
            QCOMPARE(frames[i][1].toInt(), (i + 1) % phaseCount);
        }
        waitUntilIdle();
        QCOMPARE(window().document().steps().count(), steps);  // playing is no step
        // From one 4D study to the next what moves stays; a still study swivels.
        QTest::keyClick(child<QComboBox>("motion.scenario"), Qt::Key_Up);
        open(m_timed);
        QCOMPARE(document().motion.scenario, MotionScenario::probe);
        open(m_still);
        open(m_moving);
        QCOMPARE(document().motion.scenario, MotionScenario::object);
    }

    void everyControlIsOneStepThatIsUndoneAndRedone_data() {
        QTest::addColumn<Change>("change");
        QTest::addColumn<std::function<void(MotionChoice&)>>("expected");
        const auto row = [](const char* name, Change change, std::function<void(MotionChoice&)> expected) {
            QTest::newRow(name) << std::move(change) << std::move(expected);
        };
        const auto key = [this](const char* name, Qt::Key pressed) {
            return Change([this, name, pressed] { QTest::keyClick(child<QWidget>(name), pressed); });
        };
        const auto press = [this](const char* name) { return Change([this, name] { click(name); }); };
        row("speed", key("motion.speed", Qt::Key_Down), [](MotionChoice& choice) { choice.speed = 2; });
        row("phases back and forth", press("motion.phasesPingPong"),
            [](MotionChoice& choice) { choice.phasesPingPong = true; });
        row("first phase", key("motion.firstPhase", Qt::Key_Up), [](MotionChoice& choice) {
            choice.phaseRange = PhaseRange{1, phaseCount - 1};
        });
        row("last phase", key("motion.lastPhase", Qt::Key_Down), [](MotionChoice& choice) {
            choice.phaseRange = PhaseRange{0, phaseCount - 2};
        });
        row("what moves", key("motion.scenario", Qt::Key_Down),
            [](MotionChoice& choice) { choice.scenario = MotionScenario::both; });
        row("phase of the OTF", key("motion.otfPhase", Qt::Key_Up), [](MotionChoice& choice) { choice.otfPhase = 1; });
        row("each phase's OTF", press("motion.mode.eachView"),
            [](MotionChoice& choice) { choice.otf = MotionOtf::eachView; });
        row("mean", press("motion.mode.mean"), [](MotionChoice& choice) { choice.otf = MotionOtf::mean; });
        row("least squares", press("motion.mode.movingLeastSquares"),
            [](MotionChoice& choice) { choice.otf = MotionOtf::movingLeastSquares; });
        row("least flicker", press("motion.mode.leastFlicker"),
            [](MotionChoice& choice) { choice.otf = MotionOtf::leastFlicker; });
    }
    void everyControlIsOneStepThatIsUndoneAndRedone() {
        QFETCH(Change, change);
        QFETCH(std::function<void(MotionChoice&)>, expected);
        open(m_moving);
        const MotionChoice before = document().motion;
        MotionChoice after = before;
        expected(after);
        const int steps = window().document().steps().count();
        change();
        waitUntilIdle();
        QVERIFY(document().motion == after);
        QCOMPARE(window().document().steps().count(), steps + 1);
        QTest::keyClick(&window().volumeView(), Qt::Key_Z, Qt::ControlModifier);
        waitUntilIdle();
        QVERIFY(document().motion == before);
        QVERIFY(child<MotionPanel>("motion")->choice() == before);
        QVERIFY(window().motionPlayer().choice() == before);
        QTest::keyClick(&window().volumeView(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        waitUntilIdle();
        QVERIFY(child<MotionPanel>("motion")->choice() == after);
        QVERIFY(window().motionPlayer().choice() == after);
    }

    void allPhasesPlayAgainByOneClick() {
        open(m_moving);
        QTest::keyClick(child<QSpinBox>("motion.firstPhase"), Qt::Key_Up);
        QTest::keyClick(child<QSpinBox>("motion.lastPhase"), Qt::Key_Down);
        QCOMPARE(document().motion.phaseRange, std::optional(PhaseRange{1, phaseCount - 2}));
        click("motion.allPhases");
        QVERIFY(!document().motion.phaseRange);
        QTest::keyClick(&window().volumeView(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().motion.phaseRange, std::optional(PhaseRange{1, phaseCount - 2}));
        waitUntilIdle();
    }

    void theCaptionSaysOfWhichPhaseTheOneOtfIs() {
        open(m_moving);
        const auto said = [this] { return window().volumeView().caption().contains("OTF of phase 1"); };
        QVERIFY(said());  // as in every frame of the motion
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
        window().document().showPhase(1, 0);
        QVERIFY(!said());  // it is that of the phase shown
        window().document().showPhase(1, 1);
        next = document();
        next.motion.otf = MotionOtf::eachView;
        window().document().edit(next, "each phase's OTF");
        QVERIFY(!said());
        waitUntilIdle();
    }

    void keysAndSliderStepThroughThePhases() {
        open(m_moving);
        const int steps = window().document().steps().count();
        QTest::keyClick(&window(), Qt::Key_Period);
        QCOMPARE(phaseOf(document(), 1), 1);
        for (int i = 0; i < 2; ++i) QTest::keyClick(&window(), Qt::Key_Comma);
        QCOMPARE(phaseOf(document(), 1), phaseCount - 1);
        auto* slider = child<QSlider>("motion.phase");
        QCOMPARE(slider->value(), phaseCount - 1);
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(phaseOf(document(), 1), 0);
        QTest::keyClick(slider, Qt::Key_End);
        QCOMPARE(window().openStudy().phase(), phaseCount - 1);
        QTest::mouseClick(slider, Qt::LeftButton, {}, {2, slider->height() / 2});  // a page back
        QCOMPARE(window().openStudy().phase(), phaseCount - 2);
        QCOMPARE(window().motionPlayer().phase(), phaseCount - 2);
        waitUntilIdle();
        QCOMPARE(window().document().steps().count(), steps);  // showing a phase is no step

        QTest::keyClick(child<QSpinBox>("motion.firstPhase"), Qt::Key_Up);
        QTest::keyClick(child<QSpinBox>("motion.lastPhase"), Qt::Key_Down);
        const PhaseRange played{1, phaseCount - 2};
        window().volumeView().setFocus();
        QTest::keyClick(&window().volumeView(), Qt::Key_Period);
        QCOMPARE(phaseOf(document(), 1), played.first);
        QTest::keyClick(slider, Qt::Key_Home);  // the slider reaches all
        QTest::keyClick(&window().volumeView(), Qt::Key_Comma);
        QCOMPARE(phaseOf(document(), 1), played.last);
        // A step pauses what plays.
        window().motionPlayer().setMinimumFrameInterval(aLongTime);
        QTest::keyClick(&window().volumeView(), Qt::Key_Space);
        QVERIFY(window().motionPlayer().isPlaying());
        QTest::keyClick(&window().volumeView(), Qt::Key_Period);
        QVERIFY(!window().motionPlayer().isPlaying());
        waitUntilIdle();
    }

    void thePhasesOfARangePlayBackAndForthWithSmoothedOtfs() {
        open(m_moving);
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
        open(m_moving);
        const auto shows = [&](int phaseOfOtf) {
            const auto& openStudy = window().openStudy();
            const auto expected =
                adaptOpacity(*openStudy.study()->phases[static_cast<std::size_t>(phaseOfOtf)],
                             otfViewpointOf(document(), 1), configOf(document()), {},
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
        open(m_moving);
        const SampledCurve before = window().otfEditor().state().adaptive;
        for (int i = 0; i < 2; ++i) QTest::keyClick(&window(), Qt::Key_Period);
        waitUntilIdle();
        ScalpelStroke stroke{.tool = ScalpelTool::polygon, .camera = window().volumeView().settings().camera};
        stroke.places = {{-0.1, -0.1}, {0.2, -0.1}, {0.2, 0.2}, {-0.1, 0.2}};
        Document next = document();
        strokesOf(next, 1).push_back(stroke);
        window().document().edit(next, "cut");
        waitUntilIdle();
        const Volume& scan = *window().openStudy().study()->phases.front();
        ScalpelCuts cuts(scan.geometry());
        const Volume cut = *cuts.cut(scan, std::array{stroke});
        const auto expected = adaptOpacity(cut, otfViewpointOf(document(), 1), configOf(document()));
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
        open(m_moving);
        std::atomic<int> runs = 0;
        countRuns(runs);
        for (int i = 0; i < phaseCount; ++i) {
            QTest::keyClick(&window(), Qt::Key_Period);
            waitUntilIdle();
        }
        (void)play(2 * phaseCount);
        QCOMPARE(runs.load(), 0);
        QCOMPARE(window().explanation().contains("the OTF of phase 1 serves every frame"), true);
    }

    void aKeptTurnComputesAndCastsNothingAnew() {
        open(m_moving);
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
        QCOMPARE(window().openStudy().keptOtfs().count(), static_cast<std::size_t>(phaseCount));
        QVERIFY(runs <= phaseCount);
        const int before = runs, keptBefore = kept;
        QTRY_VERIFY_WITH_TIMEOUT(kept >= keptBefore + 2 * phaseCount, 30000);
        QCOMPARE(runs.load(), before);
        QVERIFY(kept >= 4 * phaseCount);  // none was cast in between
        auto* readOut = child<QLabel>("motion.frameRate");
        QTRY_VERIFY2(readOut->text().contains(QString("%1 frames kept").arg(phaseCount)), qPrintable(readOut->text()));
        click("motion.play");
        waitUntilIdle();
    }

    void theTimeIsSaidWhereTheFileKnowsIt() {
        open(m_moving);
        auto* readOut = child<QLabel>("motion.phase.value");
        QTest::keyClick(&window(), Qt::Key_Comma);
        QCOMPARE(readOut->text(), QString("phase %1 of %1").arg(phaseCount));
        QVERIFY(child<QComboBox>("motion.speed")->toolTip().contains("20 frames a second"));
        open(m_timed);
        QTest::keyClick(&window(), Qt::Key_Comma);
        QCOMPARE(readOut->text(), QString("phase %1 of %1 · 122 ms").arg(phaseCount));
        QVERIFY(child<QComboBox>("motion.speed")->toolTip().contains("32.8 frames a second"));
        waitUntilIdle();
    }

    void speedAndOrderAreRememberedAndTheRangeIsNot() {
        open(m_moving);
        QTest::keyClick(child<QComboBox>("motion.speed"), Qt::Key_Up);
        click("motion.phasesPingPong");
        QTest::keyClick(child<QSpinBox>("motion.firstPhase"), Qt::Key_Up);
        QTest::keyClick(child<QSpinBox>("motion.otfPhase"), Qt::Key_Up);
        waitUntilIdle();
        window().close();
        MainWindow again(settingsFile());
        const MotionChoice motion = again.document().document().motion;
        QCOMPARE(motion.speed, 0.5);
        QVERIFY(motion.phasesPingPong);
        QVERIFY(!motion.phaseRange);
        QCOMPARE(motion.otfPhase, 0);
    }

    void nothingOfTheBarIsClippedAndNothingMovesWhenItPlays() {
        open(m_timed);
        auto* panel = child<MotionPanel>("motion");
        auto* scenario = child<QComboBox>("motion.scenario");
        const auto isWhole = [&] {
            for (const QWidget* control : panel->findChildren<QWidget*>()) {
                if (!control->isVisible() || control->objectName().startsWith("qt_")) continue;
                const QRect place(control->mapTo(panel, QPoint(0, 0)), control->size());
                const bool fits =
                    panel->rect().contains(place) && control->width() >= control->minimumSizeHint().width();
                if (!fits) qWarning("%s", qPrintable(control->objectName()));
                if (!fits) return false;
            }
            return true;
        };
        QVERIFY(isWhole());
        const int ofTwoLines = panel->height();
        QTest::keyClick(scenario, Qt::Key_Up);
        QTRY_VERIFY(child<QSlider>("motion.angle")->isVisible());
        QVERIFY(isWhole());
        QVERIFY(std::abs(panel->height() - ofTwoLines) <= 2);  // as many lines: the picture stays where it is
        QTest::keyClick(scenario, Qt::Key_End);
        QTRY_VERIFY(child<QSlider>("motion.angle")->isVisible() && child<QSlider>("motion.phase")->isVisible());
        QTRY_VERIFY(isWhole());
        waitUntilIdle();
        const QRect picture = window().volumeView().geometry();
        click("motion.play");
        auto* readOut = child<QLabel>("motion.frameRate");
        QTRY_VERIFY(readOut->text().contains("kept"));
        QCOMPARE(window().volumeView().geometry(), picture);
        QVERIFY(isWhole());
        click("motion.play");
        waitUntilIdle();
    }

private:
    static constexpr int phaseCount = 5;
    static constexpr int aLongTime = 3600 * 1000;  // ms

    const Document& document() { return window().document().document(); }
    void countRuns(std::atomic<int>& runs) {
        window().openStudy().setPipeline([&runs](const Volume& volume, const Viewpoint& view,
                                                 const AdaptiveOtfConfig& config, const Progress& progress,
                                                 const QuietVoxels& shown) {
            ++runs;
            return adaptOpacity(volume, view, config, progress, shown);
        });
    }
    /// Plays so many frames, and returns the phase and the curve that each was shown with.
    std::vector<std::pair<int, SampledCurve>> play(int count) {
        std::vector<std::pair<int, SampledCurve>> frames;
        MotionPlayer& player = window().motionPlayer();
        player.setMinimumFrameInterval(0);
        QObject context;
        int phase = -1;
        // A frame begins: the one before is on the screen.
        connect(&player, &MotionPlayer::frameChanged, &context, [&](double, int next) {
            if (phase >= 0) frames.emplace_back(phase, window().otfEditor().state().adaptive);
            phase = next;
        });
        click("motion.play");
        (void)QTest::qWaitFor([&] { return static_cast<int>(frames.size()) >= count; }, 60000);
        click("motion.play");
        waitUntilIdle();
        return frames;
    }

    QString m_moving, m_timed, m_still;
};

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    TestMainWindowCine test;
    return QTest::qExec(&test, count, arguments);
}

#include "test_main_window_cine.moc"
