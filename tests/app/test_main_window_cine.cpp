// The cine bar in the real window: every control by mouse or keys, what plays in which order, and what is remembered.
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cstdlib>
#include <functional>

#include "app/window/theme.h"
#include "tests/app/cine_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/panels/motion_panel.h"

using namespace echolucent;

class TestMainWindowCine : public QObject, private CineFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        wearTheme(Theme::dark);
        writeStudies();
    }
    void init() { showWindow(); }
    void cleanup() { close(); }

    void spacePlaysThePhasesOfA4dStudy() {
        open(moving());
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
        open(timed());
        QCOMPARE(document().motion.scenario, MotionScenario::probe);
        open(still());
        open(moving());
        QCOMPARE(document().motion.scenario, MotionScenario::object);
    }

    void everyControlIsOneStepThatIsUndoneAndRedone() {
        struct Row {
            const char* name;
            std::function<void()> change;
            std::function<void(MotionChoice&)> expected;
        };
        const auto key = [this](const char* name, Qt::Key pressed) {
            return [this, name, pressed] { QTest::keyClick(child<QWidget>(name), pressed); };
        };
        const auto press = [this](const char* name) { return [this, name] { click(name); }; };
        const std::vector<Row> rows{
            {"speed", key("motion.speed", Qt::Key_Down), [](MotionChoice& choice) { choice.speed = 2; }},
            {"phases back and forth", press("motion.phasesPingPong"),
             [](MotionChoice& choice) { choice.phasesPingPong = true; }},
            {"first phase", key("motion.firstPhase", Qt::Key_Up),
             [](MotionChoice& choice) {
                 choice.phaseRange = PhaseRange{1, phaseCount - 1};
             }},
            {"last phase", key("motion.lastPhase", Qt::Key_Down),
             [](MotionChoice& choice) {
                 choice.phaseRange = PhaseRange{0, phaseCount - 2};
             }},
            {"what moves", key("motion.scenario", Qt::Key_Down),
             [](MotionChoice& choice) { choice.scenario = MotionScenario::both; }},
            {"phase of the OTF", key("motion.otfPhase", Qt::Key_Up), [](MotionChoice& choice) { choice.otfPhase = 1; }},
            {"each phase's OTF", press("motion.mode.eachView"),
             [](MotionChoice& choice) { choice.otf = MotionOtf::eachView; }},
            {"mean", press("motion.mode.mean"), [](MotionChoice& choice) { choice.otf = MotionOtf::mean; }},
            {"least squares", press("motion.mode.movingLeastSquares"),
             [](MotionChoice& choice) { choice.otf = MotionOtf::movingLeastSquares; }},
            {"least flicker", press("motion.mode.leastFlicker"),
             [](MotionChoice& choice) { choice.otf = MotionOtf::leastFlicker; }}};
        open(moving());
        const MotionChoice before = document().motion;
        const int steps = window().document().steps().count();
        const auto undo = [this](Qt::KeyboardModifiers more = {}) {
            QTest::keyClick(&window().volumeView(), Qt::Key_Z, Qt::ControlModifier | more);
            waitUntilIdle();
        };
        for (const auto& [name, change, expected] : rows) {
            MotionChoice after = before;
            expected(after);
            change();
            waitUntilIdle();
            QVERIFY2(document().motion == after, name);
            QVERIFY2(window().document().steps().count() == steps + 1, name);
            undo();
            QVERIFY2(document().motion == before, name);
            QVERIFY2(child<MotionPanel>("motion")->choice() == before, name);
            QVERIFY2(window().motionPlayer().choice() == before, name);
            undo(Qt::ShiftModifier);
            QVERIFY2(child<MotionPanel>("motion")->choice() == after, name);
            QVERIFY2(window().motionPlayer().choice() == after, name);
            undo();
        }
    }

    void allPhasesPlayAgainByOneClick() {
        open(moving());
        QTest::keyClick(child<QSpinBox>("motion.firstPhase"), Qt::Key_Up);
        QTest::keyClick(child<QSpinBox>("motion.lastPhase"), Qt::Key_Down);
        QCOMPARE(document().motion.phaseRange, std::optional(PhaseRange{1, phaseCount - 2}));
        click("motion.allPhases");
        QVERIFY(!document().motion.phaseRange);
        QTest::keyClick(&window().volumeView(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(document().motion.phaseRange, std::optional(PhaseRange{1, phaseCount - 2}));
        waitUntilIdle();
    }

    void keysAndSliderStepThroughThePhases() {
        open(moving());
        const int steps = window().document().steps().count();
        QTest::keyClick(&window(), Qt::Key_Period);
        QCOMPARE(phaseOf(document(), firstPane), 1);
        for (int i = 0; i < 2; ++i) QTest::keyClick(&window(), Qt::Key_Comma);
        QCOMPARE(phaseOf(document(), firstPane), phaseCount - 1);
        auto* slider = child<QSlider>("motion.phase");
        QCOMPARE(slider->value(), phaseCount - 1);
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(phaseOf(document(), firstPane), 0);
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
        QCOMPARE(phaseOf(document(), firstPane), played.first);
        QTest::keyClick(slider, Qt::Key_Home);  // the slider reaches all
        QTest::keyClick(&window().volumeView(), Qt::Key_Comma);
        QCOMPARE(phaseOf(document(), firstPane), played.last);
        // A step pauses what plays.
        window().motionPlayer().setMinimumFrameInterval(aLongTime);
        QTest::keyClick(&window().volumeView(), Qt::Key_Space);
        QVERIFY(window().motionPlayer().isPlaying());
        QTest::keyClick(&window().volumeView(), Qt::Key_Period);
        QVERIFY(!window().motionPlayer().isPlaying());
        waitUntilIdle();
    }

    void theTimeIsSaidWhereTheFileKnowsIt() {
        open(moving());
        auto* readOut = child<QLabel>("motion.phase.value");
        QTest::keyClick(&window(), Qt::Key_Comma);
        QCOMPARE(readOut->text(), QString("volume %1 of %1").arg(phaseCount));
        QVERIFY(child<QComboBox>("motion.speed")->toolTip().contains("20 frames a second"));
        open(timed());
        QTest::keyClick(&window(), Qt::Key_Comma);
        QCOMPARE(readOut->text(), QString("volume %1 of %1 · 122 ms").arg(phaseCount));
        QVERIFY(child<QComboBox>("motion.speed")->toolTip().contains("32.8 frames a second"));
        waitUntilIdle();
    }

    void speedAndOrderAreRememberedAndTheRangeIsNot() {
        open(moving());
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
        window().resize(1280, 720);
        open(timed());
        auto* panel = child<MotionPanel>("motion");
        auto* scenario = child<QComboBox>("motion.scenario");
        const auto fits = [&](const QWidget* control) {
            if (!control->isVisible() || control->objectName().startsWith("qt_")) return true;
            const QRect place(control->mapTo(panel, QPoint(0, 0)), control->size());
            const bool whole = panel->rect().contains(place) && control->width() >= control->minimumSizeHint().width();
            if (!whole) qWarning("%s", qPrintable(control->objectName()));
            return whole;
        };
        const auto isWhole = [&] { return std::ranges::all_of(panel->findChildren<QWidget*>(), fits); };
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
        QTRY_VERIFY(readOut->toolTip().startsWith("Kept in memory: ") && !readOut->text().isEmpty());
        QCOMPARE(window().volumeView().geometry(), picture);
        QVERIFY(isWhole());
        click("motion.play");
        waitUntilIdle();
    }

private:
    static constexpr int aLongTime = 3600 * 1000;  // ms
};

ECHOLUCENT_TEST_CLASS(TestMainWindowCine)

#include "test_main_window_cine.moc"
