// OTFs in memory: found by all they were computed from, and no voxels are kept alive for them.
#include <QTest>

#include "app/study/kept_otfs.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> someVolume() {
    VolumeGeometry geometry;
    geometry.size = {2, 2, 2};
    return std::make_shared<const Volume>(geometry, Voxels(std::vector<std::uint8_t>(8, 1)));
}

/// Cells of which two OTFs fit, but not three.
constexpr std::size_t third = KeptOtfs::byteLimit / sizeof(float) / 3;

OtfRequest request(double azimuth = 0) {
    return {.volume = someVolume(), .voxels = someVolume(), .view = {.azimuthDegrees = azimuth}, .config = {}};
}

std::shared_ptr<const AdaptiveOtf> otfOf(std::size_t cells) {
    AdaptiveOtf otf;
    otf.tubes.resize(1);
    otf.tubes[0].cellMeans.resize(cells);
    return std::make_shared<const AdaptiveOtf>(std::move(otf));
}

}  // namespace

class TestKeptOtfs : public QObject {
    Q_OBJECT

private slots:
    void theSameRequestHasTheSameOtf() {
        KeptOtfs kept;
        const OtfRequest asked = request();
        const auto otf = otfOf(10);
        kept.keep(asked, otf);
        QCOMPARE(kept.find(asked), otf);
    }

    void anyOtherRequestHasNone() {
        KeptOtfs kept;
        const OtfRequest asked = request();
        kept.keep(asked, otfOf(10));
        OtfRequest other = asked;
        other.volume = someVolume();
        QCOMPARE(kept.find(other), nullptr);
        other = asked;
        other.voxels = other.volume;
        QCOMPARE(kept.find(other), nullptr);
        other = asked;
        other.view.azimuthDegrees = 1e-9;
        QCOMPARE(kept.find(other), nullptr);
        other = asked;
        other.config.grid.rows += 1;
        QCOMPARE(kept.find(other), nullptr);
    }

    void noVoxelsAreKeptAlive() {
        KeptOtfs kept;
        OtfRequest asked = request();
        const std::weak_ptr<const Volume> volume = asked.volume, voxels = asked.voxels;
        kept.keep(asked, otfOf(10));
        asked = request();
        QVERIFY(volume.expired() && voxels.expired());
        asked.volume.reset();
        asked.voxels.reset();
        QCOMPARE(kept.count(), std::size_t(1));
        QCOMPARE(kept.find(asked), nullptr);
    }

    void whatWasKeptFirstStaysWhereALoopIsTooLong() {
        KeptOtfs kept;
        const OtfRequest first = request(1), second = request(2), last = request(3);
        for (const OtfRequest& asked : {first, second, last}) kept.keep(asked, otfOf(third));
        QVERIFY(kept.find(first) && kept.find(second));
        QCOMPARE(kept.find(last), nullptr);
        kept.keep(second, otfOf(1));  // once is enough
        QCOMPARE(kept.count(), std::size_t(2));
        kept.clear();
        QCOMPARE(kept.find(first), nullptr);
        kept.keep(last, otfOf(third));
        QVERIFY(kept.find(last));
    }

    void whatIsOfNoUseMakesRoom() {
        KeptOtfs kept;
        OtfRequest gone = request(1);
        const OtfRequest stays = request(2), next = request(3);
        kept.keep(gone, otfOf(third));
        kept.keep(stays, otfOf(third));
        gone.volume.reset();
        kept.keep(next, otfOf(third));
        QVERIFY(kept.find(stays) && kept.find(next));
        QCOMPARE(kept.count(), std::size_t(2));
    }
};

ECHOLUCENT_TEST_CLASS(TestKeptOtfs)
#include "test_kept_otfs.moc"
