// The panel of the transducer motion: real keys and clicks, each heard once; setters are silent.
#include <QtTest>
#include <QtWidgets>

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

    void axisModeAndRepeat() {
        MotionPanel panel;
        AllSignals all(panel);
        QSignalSpy axis(&panel, &MotionPanel::axisChanged);
        QSignalSpy otf(&panel, &MotionPanel::otfChanged);
        QSignalSpy pingPong(&panel, &MotionPanel::pingPongChanged);
        QTest::keyClick(child<QComboBox>(panel, "motion.axis"), Qt::Key_Up);
        QCOMPARE(axis.takeFirst().first().value<MotionAxis>(), MotionAxis::x);
        QTest::keyClick(child<QRadioButton>(panel, "motion.mode.eachView"), Qt::Key_Space);
        QCOMPARE(otf.takeFirst().first().value<MotionOtf>(), MotionOtf::eachView);
        QTest::keyClick(child<QRadioButton>(panel, "motion.mode.static"), Qt::Key_Space);
        QCOMPARE(otf.takeFirst().first().value<MotionOtf>(), MotionOtf::oneOtf);
        QTest::keyClick(child<QCheckBox>(panel, "motion.pingPong"), Qt::Key_Space);
        QCOMPARE(pingPong.takeFirst().first().toBool(), false);
        QCOMPARE(all.count(), 4);
    }

    void everyModeAndScenarioIsSaidOnce() {
        MotionPanel panel;
        panel.setPhaseCount(20);
        panel.show();
        AllSignals all(panel);
        QSignalSpy otf(&panel, &MotionPanel::otfChanged);
        const QList<std::pair<const char*, MotionOtf>> modes{
            {"motion.mode.mean", MotionOtf::mean},
            {"motion.mode.movingLeastSquares", MotionOtf::movingLeastSquares},
            {"motion.mode.leastFlicker", MotionOtf::leastFlicker},
            {"motion.mode.eachView", MotionOtf::eachView},
            {"motion.mode.static", MotionOtf::oneOtf}};
        for (const auto& [name, mode] : modes) {
            QTest::mouseClick(child<QRadioButton>(panel, name), Qt::LeftButton);
            QCOMPARE(otf.count(), 1);
            QCOMPARE(otf.takeFirst().first().value<MotionOtf>(), mode);
            QCOMPARE(panel.otf(), mode);
        }
        QSignalSpy scenario(&panel, &MotionPanel::scenarioChanged);
        QTest::keyClick(child<QComboBox>(panel, "motion.scenario"), Qt::Key_Down);
        QCOMPARE(scenario.takeFirst().first().value<MotionScenario>(), MotionScenario::object);
        QTest::keyClick(child<QComboBox>(panel, "motion.scenario"), Qt::Key_Down);
        QCOMPARE(scenario.takeFirst().first().value<MotionScenario>(), MotionScenario::both);
        QCOMPARE(all.count(), 7);
        panel.setPhaseCount(1);
        QCOMPARE(panel.scenario(), MotionScenario::probe);
        QVERIFY(!child<QComboBox>(panel, "motion.scenario")->isEnabled());
        QCOMPARE(all.count(), 7);
    }

    void aNarrowWindowKeepsEveryControlInside() {
        MotionPanel panel;
        panel.show();
        for (const int width : {1400, 760, panel.minimumSizeHint().width()}) {
            panel.resize(width, panel.heightForWidth(width));
            QCoreApplication::sendPostedEvents();
            for (const QWidget* control : panel.findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
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
        panel.setAxis(MotionAxis::z);
        panel.setPhaseCount(3);
        panel.setScenario(MotionScenario::both);
        panel.setOtf(MotionOtf::eachView);
        panel.setOtf(MotionOtf::oneOtf);
        panel.setOtf(MotionOtf::eachView);
        panel.setPingPong(false);
        panel.setFrameRate(24.4);
        QCOMPARE(all.count(), 0);
        QCOMPARE(panel.angle(), -7.0);
        QCOMPARE(panel.axis(), MotionAxis::z);
        QCOMPARE(panel.otf(), MotionOtf::eachView);
        QCOMPARE(panel.pingPong(), false);
        QCOMPARE(child<QLabel>(panel, "motion.frameRate")->text(), "24 frames/s");
        panel.setFrameRate(std::nullopt);
        QCOMPARE(child<QLabel>(panel, "motion.frameRate")->text(), "");
        panel.setAngle(1000);
        QCOMPARE(panel.angle(), 45.0);
    }
};

QTEST_MAIN(TestPanelsMotion)
#include "test_panels_motion.moc"
