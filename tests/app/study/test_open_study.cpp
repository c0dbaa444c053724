// The open study: loading and computing off the GUI thread, the newest request wins, nothing stale is ever shown.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/study/open_study.h"
#include "io/writers/meta_image_writer.h"
#include "processing/adaptive/adaptive_otf.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> constantVolume(std::uint8_t value) {
    VolumeGeometry geometry;
    geometry.size = {8, 9, 10};
    return std::make_shared<const Volume>(geometry, Voxels(std::vector<std::uint8_t>(8 * 9 * 10, value)));
}

/// A pipeline that ends when it is told to, and not before, whatever is cancelled meanwhile.
class HeldPipeline {
public:
    OpenStudy::Pipeline function() {
        return [this](const Volume&, const Viewpoint& view, const AdaptiveOtfConfig&, const Progress& progress,
                      const QuietVoxels&) -> std::optional<AdaptiveOtf> {
            std::unique_lock lock(m_mutex);
            ++m_started;
            m_changed.notify_all();
            m_changed.wait(lock, [this] { return m_released > 0; });
            --m_released;
            m_thread = QThread::currentThread();
            m_sawCancel = m_sawCancel || progress.cancelled();
            AdaptiveOtf otf;
            otf.view = view;
            return otf;
        };
    }
    void release(int count = 1) {
        const std::lock_guard lock(m_mutex);
        m_released += count;
        m_changed.notify_all();
    }
    void waitUntilStarted(int count) {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_started >= count; });
    }
    QThread* thread() const { return m_thread; }
    bool sawCancel() const { return m_sawCancel; }
    int started() const {
        const std::lock_guard lock(m_mutex);
        return m_started;
    }

private:
    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    int m_started = 0;
    int m_released = 0;
    bool m_sawCancel = false;
    QThread* m_thread = nullptr;
};

Viewpoint turned(double azimuth) {
    Viewpoint view;
    view.azimuthDegrees = azimuth;
    return view;
}

}  // namespace

class TestOpenStudy : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        m_dark = m_folder.filePath("dark.mha");
        m_bright = m_folder.filePath("bright.mha");
        QVERIFY(writeMetaImage(m_dark.toStdString(), {constantVolume(10), constantVolume(20)}));
        QVERIFY(writeMetaImage(m_bright.toStdString(), {constantVolume(200)}));
    }

    void opensAndComputesOffTheGuiThread() {
        HeldPipeline held;
        OpenStudy openStudy;
        openStudy.setPipeline(held.function());
        open(openStudy, m_dark);
        QCOMPARE(openStudy.volume()->storedValue(0), 10.0);
        QCOMPARE(openStudy.histogram().counts[10], std::uint64_t(720));
        QCOMPARE(openStudy.otf(), nullptr);
        QSignalSpy computed(&openStudy, &OpenStudy::otfComputed);
        openStudy.requestOtf(turned(7), {});
        QVERIFY(openStudy.computingOtf());
        held.release();
        QVERIFY(computed.wait());
        QCOMPARE(openStudy.otf()->view.azimuthDegrees, 7.0);
        QVERIFY(held.thread() != nullptr && held.thread() != QThread::currentThread());
    }

    void aStaleResultIsNeverShown() {
        HeldPipeline held;
        OpenStudy openStudy;
        openStudy.setPipeline(held.function());
        open(openStudy, m_dark);
        QSignalSpy computed(&openStudy, &OpenStudy::otfComputed);
        openStudy.requestOtf(turned(1), {});
        held.waitUntilStarted(1);
        for (int azimuth = 2; azimuth <= 50; ++azimuth) openStudy.requestOtf(turned(azimuth), {});
        held.release(2);
        QTRY_VERIFY(!openStudy.computingOtf());
        QCOMPARE(computed.count(), 1);
        QCOMPARE(openStudy.otf()->view.azimuthDegrees, 50.0);
        QVERIFY(held.sawCancel());
        QCOMPARE(held.started(), 2);  // those between were never run
    }

    void whatIsBeingComputedIsNotBegunAgain() {
        HeldPipeline held;
        OpenStudy openStudy;
        openStudy.setPipeline(held.function());
        open(openStudy, m_dark);
        QSignalSpy computed(&openStudy, &OpenStudy::otfComputed);
        openStudy.requestOtf(turned(1), {});
        held.waitUntilStarted(1);
        openStudy.requestOtf(turned(1), {});
        held.release();
        QTRY_VERIFY(!openStudy.computingOtf());
        QCOMPARE(computed.count(), 1);
        QVERIFY(!held.sawCancel());
        QCOMPARE(held.started(), 1);
        // Once it is cancelled, the same request is a new one.
        openStudy.requestOtf(turned(2), {});
        held.waitUntilStarted(2);
        openStudy.cancelComputing();
        openStudy.requestOtf(turned(2), {});
        held.release(2);
        QTRY_VERIFY(!openStudy.computingOtf());
        QCOMPARE(computed.count(), 2);
        QCOMPARE(held.started(), 3);
    }

    void whatWasComputedBeforeComesFromMemory() {
        HeldPipeline held;
        held.release(3);
        OpenStudy openStudy;
        openStudy.setPipeline(held.function());
        open(openStudy, m_dark);
        QSignalSpy computed(&openStudy, &OpenStudy::otfComputed);
        for (const int phase : {0, 1}) {
            openStudy.setPhase(phase);
            openStudy.requestOtf(turned(1), {});
            QTRY_COMPARE(computed.count(), phase + 1);
        }
        QTRY_VERIFY(!openStudy.computingOtf());
        const auto ofSecondPhase = openStudy.otf();
        openStudy.setPhase(0);
        openStudy.requestOtf(turned(1), {});
        QVERIFY(openStudy.computingOtf());
        QCOMPARE(openStudy.otf(), nullptr);  // delivered after the request has returned, as one that is computed
        openStudy.setPhase(1);               // that answer is not this phase's
        openStudy.requestOtf(turned(1), {});
        QTRY_COMPARE(computed.count(), 3);
        QVERIFY(!openStudy.computingOtf());
        QCOMPARE(openStudy.otf(), ofSecondPhase);
        QCOMPARE(openStudy.voxelsOfOtf(), openStudy.volume());
        QCOMPARE(held.started(), 2);
        AdaptiveOtfConfig other;
        other.grid.columns = 3;
        openStudy.requestOtf(turned(1), other);
        QTRY_COMPARE(held.started(), 3);
        QTRY_VERIFY(!openStudy.computingOtf());
    }

    void aNearCutIsFoundAlthoughTheFirstOtfWaitsForItsVoxels() {
        HeldPipeline held;
        held.release(2);
        std::atomic<bool> go = false;
        OpenStudy openStudy;
        openStudy.setPipeline(held.function());
        openStudy.setReduction(SpeckleReduction::light);
        openStudy.quietPhases().setReduce(
            [&](const Volume& volume, SpeckleReduction, const Progress&) -> std::optional<Volume> {
                while (!go) std::this_thread::yield();
                return volume;
            });
        openStudy.setNearCutSearch([](const Volume&, const Viewpoint&, const Progress&) {
            return std::optional(NearCutFinding{.nearCutMm = 3});
        });
        open(openStudy, m_bright);
        openStudy.requestOtf(turned(1), {});
        QVERIFY(openStudy.computingOtf());
        QCOMPARE(held.started(), 0);
        QSignalSpy found(&openStudy, &OpenStudy::nearCutFound);
        openStudy.requestNearCut(turned(1));
        go = true;
        QTRY_COMPARE(found.count(), 1);
        QTRY_VERIFY(!openStudy.quietPhases().busy());
        openStudy.requestOtf(turned(1), {});  // as the finder asks
        QTRY_VERIFY(openStudy.otf() != nullptr);
    }

    void aResultOfAnotherPhaseIsDropped() {
        HeldPipeline held;
        OpenStudy openStudy;
        openStudy.setPipeline(held.function());
        open(openStudy, m_dark);
        QSignalSpy computed(&openStudy, &OpenStudy::otfComputed);
        openStudy.requestOtf(turned(1), {});
        held.waitUntilStarted(1);
        openStudy.setPhase(1);
        QCOMPARE(openStudy.volume()->storedValue(0), 20.0);
        held.release();
        QTRY_VERIFY(!openStudy.computingOtf());
        QCOMPARE(computed.count(), 0);
        QCOMPARE(openStudy.otf(), nullptr);
    }

    void theOtfOfOnePhaseStaysWhicheverIsShown() {
        HeldPipeline held;
        OpenStudy openStudy;
        openStudy.setPipeline([&](const Volume& volume, const Viewpoint& view, const AdaptiveOtfConfig& config,
                                  const Progress& progress, const QuietVoxels& shown) {
            auto otf = held.function()(volume, view, config, progress, shown);
            otf->message = std::to_string(static_cast<int>(volume.storedValue(0)));
            return otf;
        });
        open(openStudy, m_dark);
        QSignalSpy computed(&openStudy, &OpenStudy::otfComputed);
        openStudy.setOtfPhase(0);
        openStudy.requestOtf(turned(1), {});
        held.waitUntilStarted(1);
        openStudy.setPhase(1);  // what is under way goes on
        QVERIFY(openStudy.otfUnderWay());
        held.release();
        QTRY_COMPARE(computed.count(), 1);
        QCOMPARE(openStudy.otf()->message, "10");
        QVERIFY(openStudy.otfIsOfNewestVoxels());
        QCOMPARE(openStudy.voxelsOfOtf()->storedValue(0), 10.0);
        QCOMPARE(openStudy.voxelsForOtf()->storedValue(0), 20.0);  // those of the phase shown
        QCOMPARE(openStudy.histogramOfOtf().counts[20], std::uint64_t(720));
        openStudy.setPhase(0);
        openStudy.setPhase(1);
        QVERIFY(openStudy.otf() != nullptr && !openStudy.otfUnderWay());
        // The other phase's is asked for while this one is shown; there is no third.
        openStudy.setPhase(0);
        openStudy.setOtfPhase(7);
        QVERIFY(!openStudy.otfIsOfNewestVoxels());
        openStudy.requestOtf(turned(1), {});
        held.release();
        QTRY_COMPARE(computed.count(), 2);
        QCOMPARE(openStudy.otf()->message, "20");
        openStudy.setOtfPhase(std::nullopt);
        openStudy.requestOtf(turned(1), {});
        QTRY_COMPARE(computed.count(), 3);
        QCOMPARE(openStudy.otf()->message, "10");
        QCOMPARE(held.started(), 2);  // it was kept
        openStudy.setPhase(1);
        QCOMPARE(openStudy.otf(), nullptr);
    }

    void whatCannotBeReadLeavesWhatIsOpen() {
        OpenStudy openStudy;
        open(openStudy, m_bright);
        QSignalSpy failed(&openStudy, &OpenStudy::openFailed);
        openStudy.open(m_folder.filePath("not there.mha"));
        QVERIFY(failed.wait());
        QCOMPARE(openStudy.volume()->storedValue(0), 200.0);
        QCOMPARE(openStudy.path(), m_bright);
        const auto failure = failed.first().at(1).value<Failure>();
        QCOMPARE(failure.kind, FailureKind::unreadable);
        QVERIFY(QString::fromStdString(failure.sentence()).contains("not there.mha"));
    }

    void theNewestOpenWins() {
        OpenStudy openStudy;
        QSignalSpy opened(&openStudy, &OpenStudy::studyOpened);
        for (int i = 0; i < 20; ++i) openStudy.open(i % 2 == 0 ? m_dark : m_bright);
        QTRY_VERIFY(!openStudy.loading());
        QCOMPARE(openStudy.path(), m_bright);
        QCOMPARE(openStudy.volume()->storedValue(0), 200.0);
        QVERIFY(opened.count() >= 1 && opened.count() <= 2);
    }

    void cancelledLoadingOpensNothing() {
        OpenStudy openStudy;
        QSignalSpy opened(&openStudy, &OpenStudy::studyOpened);
        openStudy.openSimulatedScan();
        openStudy.cancelLoading();
        QTRY_VERIFY(!openStudy.loading());
        QCOMPARE(opened.count(), 0);
        QVERIFY(openStudy.study() == nullptr);
    }

    void closingWhileComputingIsSafe() {
        HeldPipeline held;
        int delivered = 0;
        {
            OpenStudy openStudy;
            openStudy.setPipeline(held.function());
            open(openStudy, m_dark);
            connect(&openStudy, &OpenStudy::otfComputed, this, [&delivered] { ++delivered; });
            openStudy.requestOtf(turned(3), {});
            held.waitUntilStarted(1);
            held.release();
        }
        QCoreApplication::processEvents();
        QCOMPARE(delivered, 0);
        QVERIFY(held.thread() != nullptr);  // the job had run to its end before it was gone
    }

    void anImpossiblePhaseIsABrokenContract() {
        OpenStudy openStudy;
        open(openStudy, m_dark);
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, openStudy.setPhase(2));
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, openStudy.setPhase(-1));
    }

private:
    static void open(OpenStudy& openStudy, const QString& path) {
        QSignalSpy opened(&openStudy, &OpenStudy::studyOpened);
        openStudy.open(path);
        QVERIFY(opened.wait());
    }

    QTemporaryDir m_folder;
    QString m_dark;
    QString m_bright;
};

ECHOLUCENT_TEST_CLASS(TestOpenStudy)
#include "test_open_study.moc"
