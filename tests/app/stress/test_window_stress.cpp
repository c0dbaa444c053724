// Actions by chance in the real window: whatever a person does, undo leads back, work ends, and memory comes back.
//
// The environment chooses what is run: ECHOLUCENT_STRESS_SEED (1), ECHOLUCENT_STRESS_ACTIONS (10000) and, to repeat the
// end of a run, ECHOLUCENT_STRESS_FIRST (0), the number of its first action. Each action follows from seed and number;
// how far work in threads has come when it begins does not, so that a failure may need several runs to come again.
#include <malloc.h>
#include <QDir>

#include "tests/app/stress/memory_in_use.h"
#include "tests/app/stress/window_stress.h"
#include "tests/app/window_fixture.h"

using namespace echolucent;

class TestWindowStress : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        // Else what many threads' arenas keep for themselves hides what is lost.
        mallopt(M_MMAP_THRESHOLD, 1 << 18);
        mallopt(M_ARENA_MAX, 2);
        lookAtNoPicture();
        QLocale::setDefault(QLocale::c());
        const auto phase = [](int number) {
            return smallPhantom(PhantomScene::fetus, static_cast<std::uint64_t>(7 + number), 0.25 * number);
        };
        m_files.studies = {file("moving.mha", {phase(0), phase(1), phase(2), phase(3)}), file("still.mha", {phase(0)}),
                           file("shapes.mha", {smallPhantom(PhantomScene::shapes, 5)})};
        const QString broken = temporaryFolder().filePath("broken.mha"), text = temporaryFolder().filePath("text.mha");
        QVERIFY(QFile::copy(m_files.studies.first(), broken));
        QVERIFY(QFile::resize(broken, QFileInfo(broken).size() / 2));
        QFile written(text);
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write("no volume") > 0);
        m_files.failures = {broken, text, temporaryFolder().filePath("missing.mha")};
        m_files.folder = temporaryFolder().path();
        m_seed = static_cast<std::uint64_t>(number("ECHOLUCENT_STRESS_SEED", 1));
        m_first = number("ECHOLUCENT_STRESS_FIRST", 0);
        m_end = number("ECHOLUCENT_STRESS_ACTIONS", 10'000);
    }
    void cleanup() { close(); }

    void whateverIsDoneIsTakenBack_data() {
        QTest::addColumn<qulonglong>("mostBytes");
        QTest::addRow("the newest steps are kept") << 200'000ULL;
        QTest::addRow("all steps are kept") << 1'000'000'000ULL;
    }
    /// Memory is that of the window in one state, the simulated scan seen from one view, where nothing else is open, so
    /// that all that was made for the studies, pictures and steps between has gone. It is measured after a tenth of the
    /// actions, when all that is made once is made, and at the end. It may be a tenth more then, which is some 25 MB:
    /// so a loss of 3 kB an action fails, and so does one volume, picture or window that stays with every tenth
    /// opening.
    void whateverIsDoneIsTakenBack() {
        QFETCH(qulonglong, mostBytes);
        show();
        window().document().steps().setMostBytes(mostBytes);
        const QString log = logFile();
        WindowStress stress(window(), m_files, m_seed, log);
        if (mostBytes > 1'000'000) stress.expectAllSteps();
        const auto holds = [&](const QString& problem) {
            if (problem.isEmpty()) return true;
            qWarning("seed %llu, %s: %s", static_cast<unsigned long long>(m_seed), qPrintable(log),
                     qPrintable(problem));
            return false;
        };
        QVERIFY(holds(stress.beginAnew()));
        const int warm = m_first + (m_end - m_first) / 10;
        QVERIFY(holds(stress.run(m_first, warm)));
        QVERIFY(holds(stress.checkSteps()));
        QVERIFY(holds(stress.beginAnew()));
        turnOnce();
        QVERIFY(holds(stress.rest()));
        const std::size_t resident = residentBytes(), allocated = allocatedBytes();
        QVERIFY(holds(stress.beginAnew()));
        QVERIFY(holds(stress.run(warm, m_end)));
        QVERIFY(holds(stress.rest()));
        QVERIFY(holds(stress.checkSteps()));
        QVERIFY(holds(stress.beginAnew()));
        turnOnce();
        QVERIFY(holds(stress.rest()));
        const std::size_t residentAtEnd = residentBytes(), allocatedAtEnd = allocatedBytes();
        const auto mb = [](std::size_t bytes) { return static_cast<double>(bytes) * 1e-6; };
        qInfo("resident %.1f MB, then %.1f; allocated %.1f MB, then %.1f", mb(resident), mb(residentAtEnd),
              mb(allocated), mb(allocatedAtEnd));
        QVERIFY(residentAtEnd < resident + resident / 10);
        QFile::remove(log);
    }

private:
    /// From another view the picture is cast anew, once. Of the view before, the ray caster had kept samples or not
    /// (some 20 MB), as often as it had been cast while its study was opened.
    void turnOnce() {
        window().document().change("turn", [](Document& next) { next.scene.pose.direction.azimuth += 1.0; });
    }
    static int number(const char* name, int standard) {
        bool isSet = false;
        const int value = qEnvironmentVariableIntValue(name, &isSet);
        return isSet ? value : standard;
    }
    /// Beside the pictures of failures.
    static QString logFile() {
        const QDir folder(QCoreApplication::applicationDirPath() + "/../failed");
        if (!folder.mkpath(".")) qFatal("cannot make %s", qPrintable(folder.path()));
        const QString row = QString(QTest::currentDataTag()).replace(' ', '_');
        return QDir::cleanPath(folder.filePath(QStringLiteral("TestWindowStress.%1.log").arg(row)));
    }

    StressFiles m_files;
    std::uint64_t m_seed = 1;
    int m_first = 0, m_end = 0;
};

ECHOLUCENT_TEST_CLASS(TestWindowStress)

#include "test_window_stress.moc"
