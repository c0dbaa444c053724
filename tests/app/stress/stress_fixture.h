// Three small studies, files that cannot be opened, and what the environment says, for tests by chance.
//
// ECHOLUCENT_STRESS_SEED (1) chooses the seed, ECHOLUCENT_STRESS_ACTIONS how many actions are done and, to repeat the
// end of a run, ECHOLUCENT_STRESS_FIRST (0) the number of its first action. Each action follows from seed and number;
// how far work in threads has come when it begins does not, so that a failure may need several runs to come again.
#pragma once

#include <malloc.h>
#include <QDir>

#include "tests/app/stress/memory_in_use.h"
#include "tests/app/stress/window_stress.h"
#include "tests/app/window_fixture.h"

namespace echolucent {

class StressFixture : protected WindowFixture {
protected:
    /// Studies of these sizes, in voxels along an axis; the first is the largest, and has four phases.
    void makeFiles(std::int64_t size, int actions) {
        // Else what many threads' arenas keep for themselves hides what is lost.
        mallopt(M_MMAP_THRESHOLD, 1 << 18);
        mallopt(M_ARENA_MAX, 2);
        lookAtNoPicture();
        QLocale::setDefault(QLocale::c());
        const auto phase = [size](int number) {
            return phantom(PhantomScene::fetus, size, static_cast<std::uint64_t>(7 + number), 0.25 * number);
        };
        m_files.studies = {file("moving.mha", {phase(0), phase(1), phase(2), phase(3)}),
                           file("still.mha", {phantom(PhantomScene::fetus, size - 4, 7)}),
                           file("shapes.mha", {phantom(PhantomScene::shapes, size - 8, 5)})};
        const QString broken = temporaryFolder().filePath("broken.mha"), text = temporaryFolder().filePath("text.mha");
        QVERIFY(QFile::copy(m_files.studies.first(), broken));
        QVERIFY(QFile::resize(broken, QFileInfo(broken).size() / 2));
        QFile written(text);
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write("no volume") > 0);
        m_files.failures = {broken, text, temporaryFolder().filePath("missing.mha")};
        m_files.folder = temporaryFolder().path();
        m_seed = static_cast<std::uint64_t>(number("ECHOLUCENT_STRESS_SEED", 1));
        m_first = number("ECHOLUCENT_STRESS_FIRST", 0);
        m_end = number("ECHOLUCENT_STRESS_ACTIONS", actions);
    }
    [[nodiscard]] const StressFiles& files() const { return m_files; }
    [[nodiscard]] std::uint64_t seed() const { return m_seed; }

    /// Does all actions and removes the log if all held. Memory is measured twice: once all that is made once is made,
    /// after a tenth of the actions and at least 1,000, and at the end. Each time the window shows the simulated scan
    /// from the same view and nothing else is open. What was made for other studies, pictures and steps is gone then.
    /// It may be a tenth more then, which is some 25 MB: so in 10,000 actions a loss of 3 kB an action fails, and so
    /// does one volume, picture or window that stays with every tenth opening.
    void runAll(WindowStress& stress) {
        const auto holds = [&](const QString& problem) {
            if (problem.isEmpty()) return true;
            qWarning("ECHOLUCENT_STRESS_SEED=%llu, %s: %s", static_cast<unsigned long long>(m_seed),
                     qPrintable(logFile()), qPrintable(problem));
            return false;
        };
        QVERIFY(holds(stress.beginAnew()));
        const int count = m_end - m_first;
        const int warm = m_first + std::max(count / 10, std::min(1000, count / 2));
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
        QFile::remove(logFile());
    }
    /// Beside the pictures of failures.
    QString logFile() const {
        const QDir folder(QCoreApplication::applicationDirPath() + "/../failed");
        if (!folder.mkpath(".")) qFatal("cannot make %s", qPrintable(folder.path()));
        QString name = QString::fromStdString(runningClass()) + '.' + QTest::currentTestFunction();
        if (const char* row = QTest::currentDataTag()) name += '.' + QString(row).replace(' ', '_');
        return QDir::cleanPath(folder.filePath(QStringLiteral("%1.seed_%2.log").arg(name).arg(m_seed)));
    }

private:
    static std::shared_ptr<const Volume> phantom(PhantomScene scene, std::int64_t size, std::uint64_t seed,
                                                 double phase = 0) {
        PhantomConfig config = defaultPhantom(scene);
        config.size = {size, size - 4, size - 2};
        config.spacing = Vec3::all(84.0 / static_cast<double>(size));
        config.seed = seed;
        config.phase = phase;
        return std::make_shared<const Volume>(*makePhantom(config));
    }
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

    StressFiles m_files;
    std::uint64_t m_seed = 1;
    int m_first = 0, m_end = 0;
};

}  // namespace echolucent
