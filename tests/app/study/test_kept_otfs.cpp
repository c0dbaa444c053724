// OTFs in memory: found by all they were computed from, and no voxels are kept alive for them.
#include <QTest>

#include "app/study/kept_otfs.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> someVolume() {
    VolumeGeometry geometry;
    geometry.size = {2, 2, 2};
    return std::make_shared<const Volume>(geometry, Voxels(std::vector<std::uint8_t>(8, 1)));
}

/// Cells of which two answers fit, but not three.
constexpr std::size_t third = KeptOtfs::byteLimit / sizeof(float) / 3;

OtfQuestion question(double azimuth = 0) {
    return {.volume = someVolume(), .voxels = someVolume(), .view = {.azimuthDegrees = azimuth}, .config = {}};
}

std::shared_ptr<const AdaptiveOtf> answerOf(std::size_t cells) {
    AdaptiveOtf otf;
    otf.tubes.resize(1);
    otf.tubes[0].cellMeans.resize(cells);
    return std::make_shared<const AdaptiveOtf>(std::move(otf));
}

}  // namespace

class TestKeptOtfs : public QObject {
    Q_OBJECT

private slots:
    void theSameQuestionHasTheSameAnswer() {
        KeptOtfs kept;
        const OtfQuestion asked = question();
        const auto answer = answerOf(10);
        kept.keep(asked, answer);
        QCOMPARE(kept.find(asked), answer);
    }

    void anyOtherQuestionHasNone() {
        KeptOtfs kept;
        const OtfQuestion asked = question();
        kept.keep(asked, answerOf(10));
        OtfQuestion other = asked;
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
        OtfQuestion asked = question();
        const std::weak_ptr<const Volume> volume = asked.volume, voxels = asked.voxels;
        kept.keep(asked, answerOf(10));
        asked = question();
        QVERIFY(volume.expired() && voxels.expired());
        asked.volume.reset();
        asked.voxels.reset();
        QCOMPARE(kept.count(), std::size_t(1));
        QCOMPARE(kept.find(asked), nullptr);
    }

    void whatWasKeptFirstStaysWhereALoopIsTooLong() {
        KeptOtfs kept;
        const OtfQuestion first = question(1), second = question(2), last = question(3);
        for (const OtfQuestion& asked : {first, second, last}) kept.keep(asked, answerOf(third));
        QVERIFY(kept.find(first) && kept.find(second));
        QCOMPARE(kept.find(last), nullptr);
        kept.keep(second, answerOf(1));  // once is enough
        QCOMPARE(kept.count(), std::size_t(2));
        kept.clear();
        QCOMPARE(kept.find(first), nullptr);
        kept.keep(last, answerOf(third));
        QVERIFY(kept.find(last));
    }

    void whatIsOfNoUseMakesRoom() {
        KeptOtfs kept;
        OtfQuestion otherMethod = question(1), gone = question(2);
        otherMethod.config.grid.rows += 1;
        kept.keep(otherMethod, answerOf(third));
        kept.keep(gone, answerOf(third));
        gone.volume.reset();
        const OtfQuestion next = question(3), last = question(4);
        kept.keep(next, answerOf(third));
        kept.keep(last, answerOf(third));
        QVERIFY(kept.find(next) && kept.find(last));
        QCOMPARE(kept.count(), std::size_t(2));
    }
};

QTEST_APPLESS_MAIN(TestKeptOtfs)
#include "test_kept_otfs.moc"
