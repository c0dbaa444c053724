// The order of the angles in the transducer motion, and that playing never outruns the picture. The tests use no
// clocks: they call stepNow().
#include <QList>
#include <QObject>
#include <QSignalSpy>
#include <QTest>
#include <QVariant>
#include <chrono>

#include "app/motion/motion_player.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

QList<double> anglesIn(const QSignalSpy& spy) {
    QList<double> angles;
    for (const auto& arguments : spy) angles << arguments.first().toDouble();
    return angles;
}

QList<double> range(int from, int to) {
    QList<double> angles;
    for (int angle = from; from <= to ? angle <= to : angle >= to; angle += from <= to ? 1 : -1) angles << angle;
    return angles;
}

/// Shows the present frame and takes the next step, again and again.
void showAndStep(MotionPlayer& player, int times) {
    for (int i = 0; i < times; ++i) {
        player.frameShown();
        QVERIFY(player.stepNow());
    }
}

constexpr int anHour = 3600 * 1000;  // an interval that never ends within a test

}  // namespace

class TestMotionPlayer : public QObject {
    Q_OBJECT

private slots:
    void loopsFromTheFirstAngleToTheLast() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        player.setChoice({.pingPong = false});
        player.setAngle(44);
        player.frameShown();
        QSignalSpy spy(&player, &MotionPlayer::frameChanged);
        player.play();  // takes the first step: to 45
        showAndStep(player, 92);
        QCOMPARE(anglesIn(spy), range(45, 45) + range(-45, 45) + range(-45, -45));
    }

    void turnsAtTheEndsWithoutRepeatingThem() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        player.setAngle(43);
        player.frameShown();
        QSignalSpy spy(&player, &MotionPlayer::frameChanged);
        player.play();
        showAndStep(player, 93);
        QCOMPARE(anglesIn(spy), range(44, 45) + range(44, -45) + range(-44, -43));
    }

    void playingFromTheLastAngleTurns() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        player.setAngle(45);
        player.frameShown();
        player.play();
        QCOMPARE(player.angle(), 44.0);
    }

    void neverAdvancesBeforeTheFrameIsShown() {
        MotionPlayer player;
        player.setMinimumFrameInterval(0);
        QSignalSpy spy(&player, &MotionPlayer::frameChanged);
        player.play();
        QCOMPARE(spy.count(), 1);
        QVERIFY(!player.stepNow());
        for (int i = 0; i < 20; ++i) QTest::qWait(0);  // the interval is long over
        QCOMPARE(spy.count(), 1);
        player.frameShown();
        QTRY_COMPARE(spy.count(), 2);
        for (int i = 0; i < 20; ++i) QTest::qWait(0);
        QCOMPARE(spy.count(), 2);
    }

    void neverAdvancesBeforeTheIntervalIsOver() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        QSignalSpy spy(&player, &MotionPlayer::frameChanged);
        player.play();
        player.frameShown();
        player.frameShown();
        player.pause();
        player.play();  // no way around the interval
        QCOMPARE(spy.count(), 1);
    }

    void rendererThatAnswersAtOnceDrivesItByTheTimer() {
        MotionPlayer player;
        player.setMinimumFrameInterval(0);
        connect(&player, &MotionPlayer::frameChanged, &player, &MotionPlayer::frameShown);
        QSignalSpy spy(&player, &MotionPlayer::frameChanged);
        player.play();
        QTRY_VERIFY(spy.count() >= 10);
        player.pause();
        const auto count = spy.count();
        QCOMPARE(anglesIn(spy).mid(0, 10), range(1, 10));
        for (int i = 0; i < 20; ++i) QTest::qWait(0);
        QCOMPARE(spy.count(), count);
    }

    void pauseHoldsAndPlayGoesOn() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        QSignalSpy playing(&player, &MotionPlayer::playingChanged);
        player.togglePlaying();
        player.play();
        player.frameShown();
        player.togglePlaying();
        player.pause();
        QCOMPARE(playing.count(), 2);
        QCOMPARE(playing[0].first().toBool(), true);
        QCOMPARE(playing[1].first().toBool(), false);
        QVERIFY(!player.stepNow());
        QCOMPARE(player.angle(), 1.0);
    }

    void scrubbingRoundsClampsAndSaysOnce() {
        MotionPlayer player;
        QSignalSpy spy(&player, &MotionPlayer::frameChanged);
        player.setAngle(12.4);
        player.setAngle(12.0);
        player.setAngle(1e300);
        player.setAngle(std::numeric_limits<double>::quiet_NaN());
        player.stepBy(5);
        player.stepBy(-1);
        player.setAngle(-46);
        player.stepBy(std::numeric_limits<int>::min());
        QCOMPARE(anglesIn(spy), (QList<double>{12, 45, 44, -45}));
        QVERIFY(!player.isPlaying());
    }

    void scrubWhilePlayingWaitsForItsFrame() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        player.play();
        player.frameShown();
        player.setAngle(20);
        QVERIFY(!player.stepNow());
        player.frameShown();
        QVERIFY(player.stepNow());
        QCOMPARE(player.angle(), 21.0);
    }

    void theObjectGoesOnOverAndOverWhileTheProbeRests() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        player.setChoice({.scenario = MotionScenario::object});
        player.setStudy(3, {});
        QSignalSpy frames(&player, &MotionPlayer::frameChanged);
        player.play();
        showAndStep(player, 4);
        QList<int> phases;
        for (const auto& frame : frames) phases << frame.at(1).toInt();
        QCOMPARE(phases, (QList<int>{1, 2, 0, 1, 2}));
        QCOMPARE(anglesIn(frames), (QList<double>{0, 0, 0, 0, 0}));
    }

    void bothMoveInOneFrame() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        player.setChoice({.scenario = MotionScenario::both});
        player.setStudy(2, {});
        player.setAngle(45);
        player.frameShown();
        QSignalSpy frames(&player, &MotionPlayer::frameChanged);
        player.play();
        showAndStep(player, 2);
        QCOMPARE(frames, (QList<QList<QVariant>>{{44.0, 1}, {43.0, 0}, {42.0, 1}}));
    }

    void thePhasesOfARangeGoBackAndForth() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        player.setStudy(9, {});
        player.setChoice({.scenario = MotionScenario::object, .phasesPingPong = true, .phaseRange = PhaseRange{2, 4}});
        QSignalSpy frames(&player, &MotionPlayer::frameChanged);
        player.play();
        showAndStep(player, 6);
        QList<int> phases;
        for (const auto& frame : frames) phases << frame.at(1).toInt();
        QCOMPARE(phases, (QList<int>{2, 3, 4, 3, 2, 3, 4}));
    }

    void aFrameThatIsLateMakesTheNextWaitShorter() {
        using namespace std::chrono_literals;
        constexpr FramePacing::Time interval = 50ms;
        FramePacing pacing;
        FramePacing::Time now = 7s;
        pacing.resume(now, interval);
        QCOMPARE(pacing.wait(now, interval), 0ns);
        pacing.begin(now, interval);
        QCOMPARE(pacing.wait(now, interval), interval);
        // Whatever each frame takes below an interval, the frames stay where they are due.
        for (int frame = 1; frame <= 1000; ++frame) {
            const FramePacing::Time due = 7s + frame * interval;
            now = due + std::chrono::milliseconds(frame * 13 % 50);
            QCOMPARE(pacing.wait(now, interval), 0ns);
            pacing.begin(now, interval);
            QCOMPARE(pacing.wait(now, interval), due + interval - now);
        }
    }

    void whatIsLateByMoreThanAnIntervalIsGivenUp() {
        using namespace std::chrono_literals;
        constexpr FramePacing::Time interval = 50ms;
        FramePacing pacing;
        pacing.resume(1s, interval);
        pacing.begin(1s, interval);
        pacing.begin(3s, interval);
        QCOMPARE(pacing.wait(3s, interval), 0ns);  // due at once, and no more than one
        pacing.begin(3s, interval);
        QCOMPARE(pacing.wait(3s, interval), interval);
        // A pause is nothing to catch up with.
        pacing.resume(9s, interval);
        pacing.begin(9s, interval);
        QCOMPARE(pacing.wait(9s, interval), interval);
        // Another speed counts from the frame that is shown.
        QCOMPARE(pacing.wait(9s, 4 * interval), 4 * interval);
        QCOMPARE(pacing.wait(9s + 30ms, interval / 2), 0ns);
        // A step that is taken before its time begins anew.
        pacing.begin(9s + 10ms, interval);
        QCOMPARE(pacing.wait(9s + 10ms, interval), interval);
    }

    void unevenPhasesAreShownAsLongAsTheyLasted() {
        using namespace std::chrono_literals;
        MotionPlayer player;
        player.setChoice({.scenario = MotionScenario::object, .phasesPingPong = true, .speed = 0.5});
        player.setStudy(3, phaseTimesAt({2.0, 2.1, 2.4}));
        QCOMPARE(player.interval(), FramePacing::Time(200ms));  // from phase 0 to 1, at half speed
        player.play();
        player.frameShown();
        QCOMPARE(player.phase(), 1);
        QCOMPARE(player.interval(), FramePacing::Time(600ms));
        player.setPhase(2);  // back from here: the same gap
        QCOMPARE(player.interval(), FramePacing::Time(600ms));
        player.setChoice({.scenario = MotionScenario::object});
        QCOMPARE(player.interval(), FramePacing::Time(200ms));  // the first follows the last after the mean
    }

    void aPhaseChosenByHandIsAFrameToWaitFor() {
        MotionPlayer player;
        player.setMinimumFrameInterval(anHour);
        player.setStudy(5, {});
        QSignalSpy frames(&player, &MotionPlayer::frameChanged);
        player.setPhase(3);
        QCOMPARE(frames.count(), 0);
        player.play();
        QCOMPARE(frames.count(), 0);
        player.frameShown();
        QCOMPARE(frames, (QList<QList<QVariant>>{{1.0, 3}}));  // the probe moves, not the object
        player.setStudy(1, {});
        QCOMPARE(player.phase(), 0);
    }

    void anotherAxisStartsFromTheViewAgain() {
        MotionPlayer player;
        player.setAngle(20);
        QSignalSpy spy(&player, &MotionPlayer::frameChanged);
        player.setChoice({.axis = MotionAxis::x});
        QCOMPARE(anglesIn(spy), (QList<double>{0}));
        player.setChoice({.axis = MotionAxis::x, .speed = 2});
        QCOMPARE(spy.count(), 1);
    }
};

ECHOLUCENT_TEST_CLASS(TestMotionPlayer)
#include "test_motion_player.moc"
