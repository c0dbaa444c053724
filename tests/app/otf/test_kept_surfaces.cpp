// Surfaces are found once for each view and volume, whoever asks for them.
#include <QTest>
#include <array>
#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

#include "app/otf/kept_surfaces.h"
#include "tests/processing/tube_core/plane_volume.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> planeAt(double distanceMm) {
    PlaneVolume plane;
    plane.size = {40, 40, 50};
    plane.distanceMm = distanceMm;
    return std::make_shared<const Volume>(plane.make());
}

SurfaceSource turned(double degrees) { return {.view = {.azimuthDegrees = degrees}, .known = {}}; }

}  // namespace

class TestKeptSurfaces : public QObject {
    Q_OBJECT

private slots:
    void oneViewOfOneVolumeIsFoundOnce() {
        KeptSurfaces kept;
        const auto raw = planeAt(30);
        const SurfaceSource source = turned(5);
        const auto first = kept.of(source, raw);
        QVERIFY(first->rays.size() > 20);
        QVERIFY(first->rays == measuredSurfacesOf(source, *raw)->rays);
        QVERIFY(kept.of(source, raw) == first);
        QCOMPARE(kept.timesFound(), 1);
    }

    void anotherViewAnotherPhaseAndTheTruthAreFoundAnew() {
        KeptSurfaces kept;
        const auto raw = planeAt(30), other = planeAt(30);
        const auto first = kept.of({}, raw);
        QVERIFY(kept.of(turned(1), raw) != first);
        QVERIFY(kept.of({}, other) != first);
        QVERIFY(kept.of({.view = {}, .known = SimulatedScan{.size = {40, 40, 50}}}, raw)->from == SurfacesFrom::truth);
        QCOMPARE(kept.timesFound(), 4);
        QVERIFY2(kept.of({}, raw) == first, "as many are kept as there are panes");
        (void)kept.of(turned(2), raw);
        QVERIFY2(kept.of({}, raw) != first, "the oldest has made room");
        QCOMPARE(kept.timesFound(), 6);
    }

    void twoThreadsFindThemOnce() {
        KeptSurfaces kept;
        const auto raw = planeAt(30);
        std::array<std::shared_ptr<const MeasuredSurfaces>, 2> found;
        std::thread other([&] { found[1] = kept.of({}, raw); });
        found[0] = kept.of({}, raw);
        other.join();
        QVERIFY(found[0] && found[0] == found[1]);
        QCOMPARE(kept.timesFound(), 1);
    }

    void aCancelledSearchKeepsNothing() {
        KeptSurfaces kept;
        const auto raw = planeAt(30);
        std::atomic<bool> cancel = true;
        QVERIFY(!kept.of({}, raw, {{}, &cancel}));
        QCOMPARE(kept.timesFound(), 0);
        cancel = false;
        QVERIFY(kept.of({}, raw, {{}, &cancel}));
    }

    void whoWaitsCanBeCancelled() {
        KeptSurfaces kept;
        const auto raw = planeAt(30);
        std::promise<void> finding, mayGoOn;
        std::once_flag first;
        // The search says how far it is, and stays there until the other thread has left.
        const Progress held{[&](double) {
            std::call_once(first, [&] {
                finding.set_value();
                mayGoOn.get_future().wait();
            });
        }};
        std::shared_ptr<const MeasuredSurfaces> found;
        std::thread finder([&] { found = kept.of({}, raw, held); });
        finding.get_future().wait();
        std::atomic<bool> cancel = false;
        std::thread canceller([&] { cancel = true; });
        QVERIFY(!kept.of({}, raw, {{}, &cancel}));
        canceller.join();
        mayGoOn.set_value();
        finder.join();
        QVERIFY(found && kept.of({}, raw) == found);
    }

    void noVoxelsAreKeptAlive() {
        KeptSurfaces kept;
        auto raw = planeAt(30);
        const std::weak_ptr<const Volume> voxels = raw;
        (void)kept.of({}, raw);
        raw.reset();
        QVERIFY(voxels.expired());
    }
};

ECHOLUCENT_TEST_CLASS(TestKeptSurfaces)

#include "test_kept_surfaces.moc"
