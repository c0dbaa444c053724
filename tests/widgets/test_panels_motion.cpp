// The panel of the transducer motion: real keys and clicks, each heard once; setters are silent.
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QList>
#include <QLocale>
#include <QObject>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QString>
#include <QStringList>
#include <QTest>
#include <QToolButton>
#include <QWidget>
#include <array>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/panels/motion_panel.h"

using namespace echolucent;

class TestPanelsMotion : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void playAsksAndWaitsForTheAnswer() {
        MotionPanel panel;
        auto* play = child<QPushButton>(panel, "motion.play");
        QSignalSpy spy(&panel, &MotionPanel::playRequested);
        QTest::mouseClick(play, Qt::LeftButton);
        QCOMPARE(spy.takeFirst().first().toBool(), true);
        QCOMPARE(panel.playing(), false);  // only the player knows whether it plays
        panel.setPlaying(true);
        QCOMPARE(play->text(), "Pause");
        QCOMPARE(play->accessibleName(), "Pause");
        QTest::keyClick(play, Qt::Key_Space);
        QCOMPARE(spy.takeFirst().first().toBool(), false);
        QCOMPARE(spy.count(), 0);
    }

    void angleInWholeDegrees() {
        MotionPanel panel;
        auto* slider = child<QSlider>(panel, "motion.angle");
        auto* readOut = child<QLabel>(panel, "motion.angle.value");
        QSignalSpy spy(&panel, &MotionPanel::angleChanged);
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(spy.takeFirst().first().toDouble(), 1.0);
        QCOMPARE(readOut->text(), "+1°");
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(spy.takeFirst().first().toDouble(), -45.0);
        QCOMPARE(readOut->text(), "−45°");
        QTest::keyClick(slider, Qt::Key_End);
        QCOMPARE(spy.takeFirst().first().toDouble(), 45.0);
        QTest::keyClick(slider, Qt::Key_PageDown);  // from mark to mark
        QCOMPARE(spy.takeFirst().first().toDouble(), 30.0);
    }

    void everyChoiceIsSaidOnceAndChangesNothingElse() {
        MotionPanel panel;
        panel.setStudy(20, PhaseTimes::every(0.05));
        panel.show();
        MotionChoice expected{.scenario = MotionScenario::both};
        panel.setChoice(expected);
        AllSignals all(panel);
        QSignalSpy spy(&panel, &MotionPanel::choiceChanged);
        QStringList steps;
        const auto isSaid = [&] {
            if (spy.count() != 1) return false;
            steps << spy.first().at(1).toString();
            return spy.takeFirst().first().value<MotionChoice>() == expected && panel.choice() == expected;
        };
        expected.axis = MotionAxis::screenHorizontal;
        QTest::keyClick(child<QComboBox>(panel, "motion.axis"), Qt::Key_Down);
        QVERIFY(isSaid());
        expected.pingPong = false;
        QTest::keyClick(child<QCheckBox>(panel, "motion.pingPong"), Qt::Key_Space);
        QVERIFY(isSaid());
        expected.phasesPingPong = true;
        QTest::keyClick(child<QCheckBox>(panel, "motion.phasesPingPong"), Qt::Key_Space);
        QVERIFY(isSaid());
        expected.speed = 2;
        QTest::keyClick(child<QComboBox>(panel, "motion.speed"), Qt::Key_Down);
        QVERIFY(isSaid());
        expected.phaseRange = PhaseRange{1, 19};
        QTest::keyClick(child<QSpinBox>(panel, "motion.firstPhase"), Qt::Key_Up);
        QVERIFY(isSaid());
        expected.phaseRange = PhaseRange{1, 18};
        QTest::keyClick(child<QSpinBox>(panel, "motion.lastPhase"), Qt::Key_Down);
        QVERIFY(isSaid());
        expected.phaseRange.reset();
        QTest::mouseClick(child<QToolButton>(panel, "motion.allPhases"), Qt::LeftButton);
        QVERIFY(isSaid());
        expected.otfPhase = 1;
        QTest::keyClick(child<QSpinBox>(panel, "motion.otfPhase"), Qt::Key_Up);
        QVERIFY(isSaid());
        const QList<std::pair<const char*, MotionOtf>> modes{
            {"motion.mode.mean", MotionOtf::mean},
            {"motion.mode.movingLeastSquares", MotionOtf::movingLeastSquares},
            {"motion.mode.leastFlicker", MotionOtf::leastFlicker},
            {"motion.mode.eachView", MotionOtf::eachView},
            {"motion.mode.static", MotionOtf::oneOtf}};
        panel.setPhase(6);
        for (const auto& [name, mode] : modes) {
            expected.otf = mode;
            if (mode == MotionOtf::oneOtf) expected.otfPhase = 6;  // the phase that is shown
            QTest::mouseClick(child<QRadioButton>(panel, name), Qt::LeftButton);
            QVERIFY(isSaid());
            QCOMPARE(child<QSpinBox>(panel, "motion.otfPhase")->isEnabled(), mode == MotionOtf::oneOtf);
        }
        expected.scenario = MotionScenario::object;
        QTest::keyClick(child<QComboBox>(panel, "motion.scenario"), Qt::Key_Up);
        QVERIFY(isSaid());
        QCOMPARE(all.count(), static_cast<int>(steps.size()));
        QVERIFY(!steps.contains(QString()));
    }

    void anAxisOfAnOlderFileIsListedOnlyWhileItIsSet() {
        MotionPanel panel;
        const auto* axis = child<QComboBox>(panel, "motion.axis");
        const auto listed = [&] {
            QStringList texts;
            for (int i = 0; i < axis->count(); ++i) texts << axis->itemText(i);
            return texts;
        };
        const QStringList usual{"Upright", "Across", "In plane"};
        QCOMPARE(listed(), usual);
        QCOMPARE(axis->currentText(), usual.first());
        panel.setChoice({.axis = MotionAxis::y});
        QCOMPARE(listed(), usual + QStringList{"Azimuth (older file)"});
        QCOMPARE(axis->currentText(), "Azimuth (older file)");
        panel.setChoice({.axis = MotionAxis::x});
        QCOMPARE(listed(), usual + QStringList{"Elevation (older file)"});
        panel.setChoice({.axis = MotionAxis::picturePlane});
        QCOMPARE(listed(), usual);
        QCOMPARE(axis->currentText(), usual.last());
    }

    void onlyWhatPlaysAPartIsShown() {
        MotionPanel panel;
        panel.setStudy(20, {});
        panel.resize(1600, 80);  // room for all
        panel.show();
        constexpr std::array ofPhases{"motion.phase", "motion.phase.value", "motion.firstPhase",
                                      "motion.phasesPingPong"};
        constexpr std::array ofProbe{"motion.angle", "motion.angle.value", "motion.axis", "motion.pingPong"};
        const auto showsRightly = [&](MotionScenario scenario) {
            panel.setChoice({.scenario = scenario});
            bool right = child<QWidget>(panel, "motion.otfPhase")->isVisible();
            for (const char* name : ofPhases)
                right = right && child<QWidget>(panel, name)->isVisible() == movesObject(scenario);
            for (const char* name : ofProbe)
                right = right && child<QWidget>(panel, name)->isVisible() == movesProbe(scenario);
            return right;
        };
        QVERIFY(showsRightly(MotionScenario::probe));
        QVERIFY(showsRightly(MotionScenario::object));
        QCOMPARE(child<QRadioButton>(panel, "motion.mode.eachView")->text(), "Each volume's");
        QVERIFY(showsRightly(MotionScenario::both));
        panel.setStudy(1, {});
        QCOMPARE(panel.choice().scenario, MotionScenario::probe);
        QVERIFY(!child<QComboBox>(panel, "motion.scenario")->isEnabled());
        QVERIFY(!child<QWidget>(panel, "motion.otfPhase")->isVisible());
        QVERIFY(!child<QWidget>(panel, "motion.phase")->isVisible());
        QCOMPARE(child<QRadioButton>(panel, "motion.mode.static")->text(), "One OTF");
        QCOMPARE(child<QRadioButton>(panel, "motion.mode.eachView")->text(), "Each view");
    }

    void thePhaseIsSaidInTimeWhereThatIsKnown() {
        MotionPanel panel;
        panel.setStudy(20, PhaseTimes::every(0.0305));
        panel.setChoice({.scenario = MotionScenario::object});
        auto* slider = child<QSlider>(panel, "motion.phase");
        auto* readOut = child<QLabel>(panel, "motion.phase.value");
        QCOMPARE(readOut->text(), "volume 1 of 20 · 0 ms");
        QSignalSpy spy(&panel, &MotionPanel::phaseChanged);
        panel.setPhase(6);
        QCOMPARE(readOut->text(), "volume 7 of 20 · 183 ms");
        QCOMPARE(spy.count(), 0);
        QTest::keyClick(slider, Qt::Key_Right);
        QCOMPARE(spy.takeFirst().first().toInt(), 7);
        QTest::keyClick(slider, Qt::Key_End);
        QCOMPARE(spy.takeFirst().first().toInt(), 19);
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(spy.takeFirst().first().toInt(), 0);
        panel.setStudy(20, {});
        panel.setPhase(6);
        QCOMPARE(readOut->text(), "volume 7 of 20");
    }

    void theSpeedSaysHowManyFramesItAimsAt() {
        MotionPanel panel;
        auto* speed = child<QComboBox>(panel, "motion.speed");
        QVERIFY2(speed->toolTip().contains("30 frames a second"), qPrintable(speed->toolTip()));
        panel.setStudy(20, PhaseTimes::every(0.0625));
        panel.setChoice({.scenario = MotionScenario::object, .speed = 0.5});
        QCOMPARE(speed->currentText(), "½×");
        QVERIFY2(speed->toolTip().contains("8 frames a second"), qPrintable(speed->toolTip()));
        panel.setStudy(20, {});
        QVERIFY2(speed->toolTip().contains("10 frames a second"), qPrintable(speed->toolTip()));
        QVERIFY(speed->toolTip().contains("does not say"));
        // A document's own speed stands among the others while it is set.
        const int usual = speed->count();
        panel.setChoice({.speed = 0.7});
        QCOMPARE(speed->currentText(), "0.7×");
        QCOMPARE(speed->count(), usual + 1);
        panel.setChoice({});
        QCOMPARE(speed->count(), usual);
    }

    void theFirstPhaseThatPlaysIsNeverBehindTheLast() {
        MotionPanel panel;
        panel.setStudy(5, {});
        panel.setChoice({.scenario = MotionScenario::object, .phaseRange = PhaseRange{2, 3}});
        auto* first = child<QSpinBox>(panel, "motion.firstPhase");
        auto* last = child<QSpinBox>(panel, "motion.lastPhase");
        QCOMPARE(first->value(), 3);
        QCOMPARE(last->value(), 4);
        for (int i = 0; i < 4; ++i) QTest::keyClick(first, Qt::Key_Up);
        QCOMPARE(panel.choice().phaseRange, std::optional(PhaseRange{3, 3}));
        QTest::keyClick(last, Qt::Key_Down);
        QCOMPARE(panel.choice().phaseRange, std::optional(PhaseRange{3, 3}));
        auto* all = child<QToolButton>(panel, "motion.allPhases");
        QVERIFY(all->isEnabled());
        QTest::mouseClick(all, Qt::LeftButton);
        QVERIFY(!panel.choice().phaseRange);
        QVERIFY(!all->isEnabled());
        // A range that reaches beyond the study ends with it.
        panel.setChoice({.scenario = MotionScenario::object, .phaseRange = PhaseRange{1, 99}});
        QCOMPARE(last->value(), 5);
    }

    void aNarrowWindowKeepsEveryControlInside() {
        MotionPanel panel;
        panel.setStudy(200, PhaseTimes::every(0.05));
        panel.show();
        for (const MotionScenario scenario : {MotionScenario::probe, MotionScenario::object, MotionScenario::both})
            for (const int width : {1400, 930, 760, panel.minimumSizeHint().width()}) {
                panel.setChoice({.scenario = scenario});
                panel.resize(width, panel.heightForWidth(width));
                QCoreApplication::sendPostedEvents();
                for (const QWidget* control : panel.findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
                    if (control->isHidden()) continue;
                    QVERIFY2(panel.rect().contains(control->geometry()), qPrintable(control->objectName()));
                    QVERIFY2(control->width() >= control->minimumSizeHint().width(), qPrintable(control->objectName()));
                }
            }
    }

    void motionSettersAreSilent() {
        MotionPanel panel;
        AllSignals all(panel);
        panel.setPlaying(true);
        panel.setAngle(-7.4);
        panel.setStudy(3, PhaseTimes::every(0.1));
        panel.setPhase(2);
        const MotionChoice choice{.axis = MotionAxis::z,
                                  .scenario = MotionScenario::both,
                                  .otf = MotionOtf::eachView,
                                  .pingPong = false,
                                  .phasesPingPong = true,
                                  .phaseRange = PhaseRange{1, 2},
                                  .otfPhase = 2,
                                  .speed = 4};
        panel.setChoice(choice);
        panel.setChoice({});
        panel.setChoice(choice);
        panel.setFrameRate(24.4);
        QCOMPARE(all.count(), 0);
        QCOMPARE(panel.angle(), -7.0);
        QCOMPARE(panel.phase(), 2);
        QCOMPARE(panel.choice(), choice);
        panel.setAngle(1000);
        QCOMPARE(panel.angle(), 45.0);
    }

    void theReadOutSaysWhatIsKept() {
        MotionPanel panel;
        auto* readOut = child<QLabel>(panel, "motion.frameRate");
        panel.setFrameRate(24.4);
        QCOMPARE(readOut->text(), "24 frames/s");
        panel.setFrameRate(25, {.frames = 20,
                                .quietPhases = 18,
                                .otfs = 17,
                                .frameBytes = std::size_t{20} << 20,
                                .quietBytes = std::size_t{42} << 20,
                                .otfBytes = std::size_t{9} << 20});
        QCOMPARE(readOut->text(), "25 frames/s");
        QVERIFY2(readOut->toolTip().contains("20 pictures (20 MB)"), qPrintable(readOut->toolTip()));
        QVERIFY2(readOut->toolTip().contains("18 volumes (42 MB), 17 OTFs (9 MB)"), qPrintable(readOut->toolTip()));
        panel.setFrameRate(std::nullopt);
        QCOMPARE(readOut->text(), "");
    }
};

ECHOLUCENT_TEST_CLASS(TestPanelsMotion)
#include "test_panels_motion.moc"
