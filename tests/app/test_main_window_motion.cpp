// The motion in the real window: every mode and every scenario, what is shown against the pure functions.
#include <QComboBox>
#include <QDockWidget>
#include <QImage>
#include <QSlider>

#include "processing/adaptive/adaptive_otf.h"
#include "processing/designers/choice/designer.h"
#include "processing/motion/otf_sweep.h"
#include "processing/ray_caster/ray_caster.h"
#include "tests/app/picture_measures.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"
#include "widgets/motion/otf_curves_canvas.h"
#include "widgets/motion/otf_map_canvas.h"

using namespace echolucent;

namespace {

struct Mode {
    const char* name;
    std::optional<OtfSmoothing> smoothing;  // without one there is one OTF
};
constexpr std::array modes{
    Mode{"static", std::nullopt}, Mode{"eachView", OtfSmoothing::none}, Mode{"mean", OtfSmoothing::mean},
    Mode{"movingLeastSquares", OtfSmoothing::movingLeastSquares}, Mode{"leastFlicker", OtfSmoothing::leastFlicker}};

/// What the window was at when a frame's picture was on the screen.
struct Shown {
    double angle;
    int phase;
    Viewpoint view;  // of the camera
    SampledCurve curve;
};

}  // namespace

class TestMainWindowMotion : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_still = m_fixture.file("still.mha", {smallPhantom(PhantomScene::fetus, 5)});
        std::vector<std::shared_ptr<const Volume>> phases;
        for (int i = 0; i < 4; ++i)
            phases.push_back(smallPhantom(PhantomScene::fetus, static_cast<std::uint64_t>(7 + i), 0.25 * i));
        m_moving = m_fixture.file("moving.mha", phases);
    }
    void init() {
        m_fixture.show();
        m_fixture.useLook(Look{});
    }
    void cleanup() { m_fixture.close(); }

    void playsTenFrames_data() {
        QTest::addColumn<int>("mode");
        for (std::size_t i = 0; i < modes.size(); i += isLongRun() ? 1 : 3)
            QTest::newRow(modes[i].name) << static_cast<int>(i);
    }
    void playsTenFrames() {
        QFETCH(int, mode);
        const Mode& wanted = modes[static_cast<std::size_t>(mode)];
        m_fixture.open(m_still);
        const SampledCurve first = window().otfs().adaptive()->curve;
        m_fixture.click(QString("motion.mode.") + wanted.name);
        m_fixture.waitUntilIdle();
        const std::vector<Shown> frames = play(10);

        const auto volume = window().openStudy().volume();
        OtfHistory history(wanted.smoothing.value_or(OtfSmoothing::none));
        (void)history.add(0, first);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            QCOMPARE(frames[i].angle, i + 1.0);
            if (wanted.smoothing) QCOMPARE(frames[i].view.azimuthDegrees, frames[i].angle);
            const SampledCurve own =
                adaptOpacity(*volume, turned(Viewpoint{}, MotionAxis::y, frames[i].angle), {})->curve;
            const SampledCurve smoothed = history.add(frames[i].angle, own);
            QVERIFY2(frames[i].curve == (wanted.smoothing ? smoothed : first), qPrintable(QString::number(i)));
        }
        QCOMPARE(m_fixture.child<QSlider>("motion.angle")->value(), static_cast<int>(window().motionPlayer().angle()));
        const Picture picture = *window().volumeView().picture();
        const auto expected =
            castRays(*volume, window().otfEditor().state().adaptive, window().volumeView().settings());
        QVERIFY(difference(picture, *expected) < 0.01);
    }

    void theObjectMoves_data() {
        QTest::addColumn<int>("entry");
        QTest::addColumn<int>("degreesPerFrame");
        QTest::newRow("object") << 0 << 0;
        QTest::newRow("both") << 1 << 1;
    }
    void theObjectMoves() {
        QFETCH(int, entry);
        QFETCH(int, degreesPerFrame);
        m_fixture.open(m_moving);
        m_fixture.click("motion.mode.leastFlicker");
        auto* scenario = m_fixture.child<QComboBox>("motion.scenario");
        QVERIFY(scenario->isEnabled());
        for (int i = 0; i < entry; ++i) QTest::keyClick(scenario, Qt::Key_Down);
        m_fixture.waitUntilIdle();
        const std::vector<Shown> frames = play(10);
        const auto& phases = window().openStudy().study()->phases;
        OtfHistory history;
        (void)history.add(0, adaptOpacity(*phases[0], Viewpoint{}, {})->curve);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const double time = i + 1.0;
            QCOMPARE(frames[i].phase, static_cast<int>((i + 1) % 4));
            QCOMPARE(frames[i].angle, degreesPerFrame * time);
            const Viewpoint view = turned(Viewpoint{}, MotionAxis::y, frames[i].angle);
            const auto own = adaptOpacity(*phases[static_cast<std::size_t>(frames[i].phase)], view, {})->curve;
            QVERIFY2(frames[i].curve == history.add(time, own), qPrintable(QString::number(i)));
        }
        QCOMPARE(m_fixture.child<QSlider>("motion.phase")->value(), window().motionPlayer().phase());
        QCOMPARE(window().openStudy().phase(), window().motionPlayer().phase());
        QCOMPARE(window().otfCourse().rowCount(), degreesPerFrame == 0 ? 4 : 91);
    }

    void oneOtfServesEveryPhase() {
        m_fixture.open(m_moving);
        const SampledCurve first = window().otfs().adaptive()->curve;
        for (const Shown& frame : play(5)) QVERIFY(frame.curve == first);
        QVERIFY(window().openStudy().phase() > 0);
        QVERIFY(difference(*window().volumeView().picture(),
                           *castRays(*window().openStudy().volume(), first, window().volumeView().settings())) < 0.01);
    }

    void anEditWhileTheObjectMovesReachesTheOtf() {
        m_fixture.open(m_moving);
        playOneFrame();
        Document next = window().document().document();
        next.method.initialScale = 0.5;
        window().document().edit(next, "initial function");
        QVERIFY(window().otfs().busy());
        QVERIFY(window().motionPlayer().stepNow());
        window().motionPlayer().pause();
        m_fixture.waitUntilIdle();
        QVERIFY(window().otfs().adaptive() != nullptr);
        QVERIFY(window().otfs().adaptive()->config == configOf(next));
        QVERIFY(window().otfEditor().state().adaptive == window().otfs().adaptive()->curve);
    }

    void aRemarkWaitsForThePause() {
        m_fixture.open(m_still);
        m_fixture.click("motion.mode.eachView");
        m_fixture.waitUntilIdle();
        window().otfs().setRun([](const DesignerConfig& config, const DesignerInput& input, const Progress& progress) {
            std::optional<Design> made = design(config, input, progress);
            if (made) made->message = "The frame is dark.";
            return made;
        });
        playOneFrame();
        auto* bar = m_fixture.child<MessageBar>("message");
        QVERIFY(!bar->text().contains("The frame is dark."));
        window().motionPlayer().pause();
        QVERIFY(bar->text().contains("The frame is dark."));
    }

    void oneMomentCannotMove() {
        m_fixture.open(m_still);
        auto* scenario = m_fixture.child<QComboBox>("motion.scenario");
        QVERIFY(!scenario->isEnabled());
        QVERIFY(scenario->toolTip().contains("one volume only"));
        // A 4D study is opened, with its object moving, and a 3D study again.
        m_fixture.open(m_moving);
        QCOMPARE(window().motionPlayer().choice().scenario, MotionScenario::object);
        m_fixture.open(m_still);
        QCOMPARE(scenario->currentIndex(), 0);
        QCOMPARE(window().motionPlayer().choice().scenario, MotionScenario::probe);
    }

    void aJumpForgetsThePast() {
        m_fixture.open(m_still);
        m_fixture.click("motion.mode.mean");
        m_fixture.waitUntilIdle();
        auto* angle = m_fixture.child<QSlider>("motion.angle");
        for (int i = 0; i < 3; ++i) {
            QTest::keyClick(angle, Qt::Key_Right);
            m_fixture.waitUntilIdle();
        }
        QVERIFY(window().otfEditor().state().adaptive != window().otfs().adaptive()->curve);
        QTest::keyClick(angle, Qt::Key_Home);
        m_fixture.waitUntilIdle();
        QCOMPARE(window().otfs().adaptive()->view.azimuthDegrees, -45.0);
        QVERIFY(window().otfEditor().state().adaptive == window().otfs().adaptive()->curve);
    }

    void anotherConfigForgetsThePastAndTheMap() {
        m_fixture.open(m_still);
        m_fixture.click("motion.mode.leastFlicker");
        m_fixture.waitUntilIdle();
        (void)play(4);
        QTest::keyClick(m_fixture.child<QComboBox>("adaptive.form"), Qt::Key_End);  // the product, which has a strength
        m_fixture.waitUntilIdle();
        auto* strength = m_fixture.child<QSlider>("adaptive.strength");
        m_fixture.click("face.teach");
        m_fixture.child<QDockWidget>("dock.method")->raise();
        QTRY_VERIFY(strength->isVisible());
        strength->setFocus();
        QTest::keyClick(strength, Qt::Key_Right);  // and not one degree on
        m_fixture.waitUntilIdle();
        QCOMPARE(window().otfs().adaptive()->config.curve, CurveRule(ProductRule{ProductRule{}.strength + 0.25}));
        QVERIFY(window().otfEditor().state().adaptive == window().otfs().adaptive()->curve);
        QCOMPARE(filledRows(MotionOtf::leastFlicker), 1);
    }

    void theMapFillsAsTheMotionPlays() {
        m_fixture.open(m_still);
        const QRect view = window().volumeView().geometry();
        auto* map = m_fixture.child<OtfMapCanvas>("motion.map");
        QVERIFY(!map->isVisible());
        window().findChild<QAction*>("motion.showMap")->trigger();
        QTRY_VERIFY(map->isVisible());
        QCOMPARE(window().volumeView().geometry(), view);

        m_fixture.click("motion.mode.mean");
        m_fixture.waitUntilIdle();
        const std::vector<Shown> frames = play(10);
        const int last = static_cast<int>(window().motionPlayer().angle());
        const OtfCourse& course = window().otfCourse();
        QCOMPARE(filledRows(MotionOtf::mean), last + 1);
        for (const Shown& frame : frames) {
            const int row = course.rowOf({.angle = static_cast<int>(frame.angle)});
            QVERIFY(*course.curve(row, MotionOtf::mean) == frame.curve);
        }
        const QImage image = map->image();
        QCOMPARE(image.size(), QSize(256, 91));
        for (int angle = -45; angle <= 45; ++angle)
            QCOMPARE(qAlpha(image.pixel(200, 45 - angle)), angle >= 0 && angle <= last ? 255 : 0);
        QCOMPARE(qRed(image.pixel(200, 45 - 10)), qRound(255 * course.curve(55, MotionOtf::mean)->opacities[200]));
        QCOMPARE(m_fixture.child<OtfCurvesCanvas>("motion.map.curves")->shownRows(),
                 (std::vector<int>{45, 45 + last}));  // 0° and now
        QVERIFY(*course.flicker(MotionOtf::mean) < *course.flicker(MotionOtf::eachView));
    }

    void theMapRemembersItsPlace() {
        window().findChild<QAction*>("motion.showMap")->trigger();
        QVERIFY(m_fixture.child("dock.motionMap")->isVisible());
        window().close();
        MainWindow again(m_fixture.settingsFile());
        again.show();
        QVERIFY(!again.findChild<QWidget*>("dock.motionMap")->isHidden());
    }

    void theExplanationSaysWhatTheMotionDoes() {
        m_fixture.open(m_still);
        QVERIFY(window().explanation().contains("this one OTF serves every frame"));
        m_fixture.click("motion.mode.mean");
        m_fixture.waitUntilIdle();
        QVERIFY(window().explanation().contains("mean of the newest five"));
    }

    void anotherStudyEndsTheMotionAndShowsNothingStale() {
        m_fixture.open(m_moving);
        m_fixture.click("motion.mode.leastFlicker");
        m_fixture.click("motion.play");
        m_fixture.open(m_still);
        QVERIFY(!window().motionPlayer().isPlaying());
        QCOMPARE(window().motionPlayer().angle(), 0.0);
        const SampledCurve own = adaptOpacity(*window().openStudy().volume(), Viewpoint{}, {})->curve;
        QVERIFY(window().otfEditor().state().adaptive == own);
        QCOMPARE(filledRows(MotionOtf::eachView), 1);
    }

private:
    MainWindow& window() { return m_fixture.window(); }
    int filledRows(MotionOtf mode) {
        int rows = 0;
        for (int row = 0; row < window().otfCourse().rowCount(); ++row)
            rows += window().otfCourse().curve(row, mode) != nullptr ? 1 : 0;
        return rows;
    }
    /// Plays, and halts while playing with the first frame on the screen: the next step is not taken by itself.
    void playOneFrame() {
        MotionPlayer& player = window().motionPlayer();
        player.setMinimumFrameInterval(1'000'000);
        player.play();
        QTRY_VERIFY_WITH_TIMEOUT(!window().otfs().busy() && window().volumeView().pictureIsFine() &&
                                     window().volumeView().pictureIsCurrent(),
                                 30000);
        QVERIFY(player.isPlaying());
    }
    /// Plays until this many frames were shown, and returns what each was shown with.
    std::vector<Shown> play(std::size_t count) {
        std::vector<Shown> frames;
        MotionPlayer& player = window().motionPlayer();
        QObject context;
        double angle = player.angle();
        int phase = player.phase();
        bool begun = false;
        // With the picture of a frame its curve is in the editor. An OTF that is kept is there as soon as the next
        // frame begins.
        SampledCurve curve;
        Viewpoint view;
        const auto look = [&] {
            curve = window().otfEditor().state().adaptive;
            view = window().volumeView().view();
        };
        connect(&window().volumeView(), &VolumeViewWidget::pictureDelivered, &context, look);
        // A frame begins: the one before is on the screen.
        connect(&player, &MotionPlayer::frameChanged, &context, [&](double nextAngle, int nextPhase) {
            if (std::exchange(begun, true)) frames.push_back({angle, phase, view, curve});
            angle = nextAngle;
            phase = nextPhase;
        });
        m_fixture.click("motion.play");
        if (!QTest::qWaitFor([&] { return frames.size() >= count; }, 60000))
            qFatal("%zu of %zu frames were shown", frames.size(), count);
        m_fixture.click("motion.play");
        m_fixture.waitUntilIdle();
        return frames;
    }

    WindowFixture m_fixture;
    QString m_still;
    QString m_moving;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowMotion, "playsTenFrames")

#include "test_main_window_motion.moc"
