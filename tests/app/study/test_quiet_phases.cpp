// The quiet voxels of a study: the phase shown first, every other one after it, none of a study or a reduction before.
#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <new>

#include "app/study/quiet_phases.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> phaseOf(std::uint8_t value) {
    VolumeGeometry geometry;
    geometry.size = {3, 4, 5};
    return std::make_shared<const Volume>(geometry, Voxels(std::vector<std::uint8_t>(60, value)));
}

QuietPhases::Phases phases(int count) {
    QuietPhases::Phases all;
    for (int i = 0; i < count; ++i) all.push_back(phaseOf(static_cast<std::uint8_t>(10 * (i + 1))));
    return all;
}

/// Adds the number of the reduction to every voxel, one volume each time a test lets it.
class HeldReduction {
public:
    QuietPhases::Reduce function() {
        return [this](const Volume& volume, SpeckleReduction reduction,
                      const Progress& progress) -> std::optional<Volume> {
            std::unique_lock lock(m_mutex);
            ++m_started;
            m_changed.notify_all();
            m_changed.wait(lock, [this] { return m_released > 0; });
            --m_released;
            if (progress.cancelled()) return std::nullopt;
            auto voxels = std::get<VoxelArray<std::uint8_t>>(volume.voxels()).toVector();
            for (std::uint8_t& voxel : voxels) voxel = static_cast<std::uint8_t>(voxel + static_cast<int>(reduction));
            return Volume(volume.geometry(), Voxels(std::move(voxels)));
        };
    }
    void release(int count) {
        const std::lock_guard lock(m_mutex);
        m_released += count;
        m_changed.notify_all();
    }
    void waitUntilStarted(int count) {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_started >= count; });
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    int m_started = 0, m_released = 0;
};

}  // namespace

class TestQuietPhases : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
    void thePhaseThatIsWantedComesFirstAndTheOthersFollowIt() {
        HeldReduction held;
        QuietPhases quiet(m_works);
        quiet.setReduce(held.function());
        QSignalSpy made(&quiet, &QuietPhases::made);
        quiet.begin(phases(4));
        QVERIFY(!quiet.busy());
        quiet.want(2, SpeckleReduction::light);
        QVERIFY(quiet.busy());
        QCOMPARE(quiet.of(2), nullptr);
        held.release(4);
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 4, patience);
        QCOMPARE(made[0][0].toInt(), 2);
        QCOMPARE(made[1][0].toInt(), 3);
        QCOMPARE(made[2][0].toInt(), 0);
        QCOMPARE(made[3][0].toInt(), 1);
        QCOMPARE(quiet.of(2)->storedValue(0), 31.0);
        QTRY_VERIFY_WITH_TIMEOUT(!quiet.busy(), patience);
    }

    void thePhaseThatIsWantedBesideItComesSecond() {
        HeldReduction held;
        held.release(5);
        QuietPhases quiet(m_works);
        quiet.setReduce(held.function());
        QSignalSpy made(&quiet, &QuietPhases::made);
        quiet.begin(phases(5));
        quiet.want(1, SpeckleReduction::light, 4);
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 5, patience);
        for (const auto& [place, phase] : {std::pair(0, 1), std::pair(1, 4), std::pair(2, 2)})
            QCOMPARE(made[place][0].toInt(), phase);
        QCOMPARE(quiet.bytes(), std::size_t{5 * 60});
    }

    void withoutReductionTheRawVoxelsAreThereAtOnce() {
        QuietPhases quiet(m_works);
        const auto raw = phases(2);
        quiet.begin(raw);
        quiet.want(1, SpeckleReduction::off);
        QVERIFY(!quiet.busy());
        QCOMPARE(quiet.of(1), raw[1]);
        QCOMPARE(quiet.of(2), nullptr);  // no such phase
    }

    void anotherReductionForgetsWhatWasMade() {
        HeldReduction held;
        QuietPhases quiet(m_works);
        quiet.setReduce(held.function());
        quiet.begin(phases(1));
        quiet.want(0, SpeckleReduction::light);
        held.waitUntilStarted(1);
        quiet.want(0, SpeckleReduction::strong);
        held.release(2);
        QTRY_VERIFY_WITH_TIMEOUT(quiet.of(0) != nullptr, patience);
        QCOMPARE(quiet.of(0)->storedValue(0), 13.0);  // strong, never light
        quiet.want(0, SpeckleReduction::light);
        QCOMPARE(quiet.of(0), nullptr);
        held.release(1);
        QTRY_VERIFY_WITH_TIMEOUT(quiet.of(0) != nullptr, patience);
        QCOMPARE(quiet.of(0)->storedValue(0), 11.0);
    }

    void aStudyBeforeLeavesNothingBehind() {
        HeldReduction held;
        QuietPhases quiet(m_works);
        quiet.setReduce(held.function());
        QSignalSpy made(&quiet, &QuietPhases::made);
        quiet.begin(phases(3));
        quiet.want(0, SpeckleReduction::light);
        held.waitUntilStarted(1);
        quiet.begin({phaseOf(200)});
        quiet.want(0, SpeckleReduction::light);
        held.release(4);
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, patience);
        QCOMPARE(quiet.of(0)->storedValue(0), 201.0);
    }

    void aPhaseThatIsBegunRunsToItsEndWhateverIsWantedMeanwhile() {
        HeldReduction held;
        QuietPhases quiet(m_works);
        quiet.setReduce(held.function());
        QSignalSpy made(&quiet, &QuietPhases::made);
        quiet.begin(phases(6));
        quiet.want(0, SpeckleReduction::light);
        held.waitUntilStarted(1);
        for (int phase = 1; phase < 6; ++phase) quiet.want(phase, SpeckleReduction::light);
        held.release(6);
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 6, patience);
        QCOMPARE(made[0][0].toInt(), 0);
        QCOMPARE(made[1][0].toInt(), 5);  // the newest that was wanted
    }

    void whereMemoryEndsItIsSaid() {
        QuietPhases quiet(m_works);
        quiet.setReduce(
            [](const Volume&, SpeckleReduction, const Progress&) -> std::optional<Volume> { throw std::bad_alloc(); });
        QSignalSpy failed(&quiet, &QuietPhases::failed);
        quiet.begin(phases(1));
        quiet.want(0, SpeckleReduction::medium);
        QVERIFY(failed.wait(patience));
        QVERIFY(failed[0][1].toString().contains("memory"));
        QCOMPARE(quiet.of(0), nullptr);
    }

    void whatFailedIsTriedAgainWithAnotherReductionOnly() {
        QuietPhases quiet(m_works);
        std::atomic<int> tries = 0;
        quiet.setReduce([&](const Volume&, SpeckleReduction, const Progress&) -> std::optional<Volume> {
            ++tries;
            throw std::bad_alloc();
        });
        QSignalSpy failed(&quiet, &QuietPhases::failed);
        quiet.begin(phases(3));
        quiet.want(0, SpeckleReduction::medium);
        QVERIFY(failed.wait(patience));
        for (int phase = 0; phase < 3; ++phase) quiet.want(phase, SpeckleReduction::medium);
        QTRY_VERIFY_WITH_TIMEOUT(!quiet.busy(), patience);
        QCOMPARE(tries, 1);
        quiet.want(0, SpeckleReduction::light);
        QVERIFY(failed.wait(patience));
        QCOMPARE(tries, 2);
    }
};

ECHOLUCENT_TEST_CLASS(TestQuietPhases)
#include "test_quiet_phases.moc"
