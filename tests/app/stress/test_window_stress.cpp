// Actions by chance in the real window: whatever a person does, undo leads back, work ends, and memory comes back.
#include "tests/app/stress/compare_actions.h"
#include "tests/app/stress/lesson_actions.h"
#include "tests/app/stress/stress_fixture.h"

using namespace echolucent;

/// Everything, 10,000 actions twice.
class TestWindowStress : public QObject, private StressFixture {
    Q_OBJECT

private slots:
    void initTestCase() { makeFiles(60, 10'000); }
    void cleanup() { close(); }

    void whateverIsDoneIsTakenBack_data() {
        QTest::addColumn<qulonglong>("mostBytes");
        QTest::addRow("the newest steps are kept") << 200'000ULL;
        QTest::addRow("all steps are kept") << 1'000'000'000ULL;
    }
    void whateverIsDoneIsTakenBack() {
        QFETCH(qulonglong, mostBytes);
        show();
        window().document().steps().setMostBytes(mostBytes);
        WindowStress stress(window(), files(), seed(), logFile());
        if (mostBytes > 1'000'000) stress.expectAllSteps();
        runAll(stress);
    }
};

/// Designers, phases, figures and studies are switched while pictures and OTFs are made. After every 25 actions the
/// window rests, and all is checked.
class TestTaughtStress : public QObject, private StressFixture {
    Q_OBJECT

private slots:
    void initTestCase() { makeFiles(44, 2'000); }
    void cleanup() { close(); }

    void theComparisonShowsWhatTheDocumentSays() {
        show();
        window().document().steps().setMostBytes(stepBytes);
        WindowStress stress(window(), files(), seed(), logFile());
        CompareActions actions(window(), stress.hand(), files());
        stress.add(actions, actionsBetweenRests);
        runAll(stress);
    }
    void aLessonIsLeftAsItWasEntered() {
        show();
        window().document().steps().setMostBytes(stepBytes);
        WindowStress stress(window(), files(), seed(), logFile());
        LessonActions actions(window(), stress.hand(), files());
        stress.add(actions, actionsBetweenRests);
        runAll(stress);
    }

private:
    static constexpr std::size_t stepBytes = 150'000;  ///< for some dozens of steps; each check takes all of them back
    static constexpr int actionsBetweenRests = 25;
};

ECHOLUCENT_TEST_CLASS(TestWindowStress)
ECHOLUCENT_TEST_CLASS(TestTaughtStress)

#include "test_window_stress.moc"
