// OTFs in memory: found by all they were computed from, and no voxels are kept alive for them.
#include <QTest>

#include "app/otf/kept_otfs.h"
#include "processing/adaptive/adaptive_otf_result.h"
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
    return {.raw = someVolume(), .shown = someVolume(), .view = {.azimuthDegrees = azimuth}};
}

ComputedOtf otfOf(const OtfRequest& asked, std::size_t cells) {
    auto otf = std::make_shared<AdaptiveOtf>();
    otf->tubes.resize(1);
    otf->tubes[0].cellMeans.resize(cells);
    return {asked, {.classification = SampledCurve{}, .tubeCores = std::move(otf)}, 2.5};
}

}  // namespace

class TestKeptOtfs : public QObject {
    Q_OBJECT

private slots:
    void theSameRequestHasTheSameOtf() {
        KeptOtfs kept;
        const OtfRequest asked = request();
        const ComputedOtf otf = otfOf(asked, 10);
        kept.keep(otf);
        const auto found = kept.find(asked);
        QVERIFY(found && found->asked == asked && found->design.tubeCores == otf.design.tubeCores);
        QCOMPARE(found->milliseconds, 2.5);
    }

    void anyOtherRequestHasNone() {
        KeptOtfs kept;
        const OtfRequest asked = request();
        kept.keep(otfOf(asked, 10));
        OtfRequest other = asked;
        other.raw = someVolume();
        QCOMPARE(kept.find(other), nullptr);
        other = asked;
        other.shown = other.raw;
        QCOMPARE(kept.find(other), nullptr);
        other = asked;
        other.view.azimuthDegrees = 1e-9;
        QCOMPARE(kept.find(other), nullptr);
        other = asked;
        other.method.grid.rows += 1;
        QCOMPARE(kept.find(other), nullptr);
        other = asked;
        other.config = OtsuConfig{};
        QCOMPARE(kept.find(other), nullptr);
        other = asked;
        other.reduction = SpeckleReduction::light;
        QCOMPARE(kept.find(other), nullptr);
    }

    void noVoxelsAreKeptAlive() {
        KeptOtfs kept;
        OtfRequest asked = request();
        const std::weak_ptr<const Volume> raw = asked.raw, shown = asked.shown;
        kept.keep(otfOf(asked, 10));
        asked = request();
        QVERIFY(raw.expired() && shown.expired());
        asked.raw.reset();
        asked.shown.reset();
        QCOMPARE(kept.count(), std::size_t(1));
        QCOMPARE(kept.find(asked), nullptr);
        const OtfRequest next = request();
        kept.keep(otfOf(next, 10));  // the one that nobody can find any more is forgotten
        QCOMPARE(kept.count(), std::size_t(1));
        QVERIFY(kept.find(next));
    }

    void ofALoopThatIsTooLongTheFirstStayAndTheNewestIsThere() {
        KeptOtfs kept;
        const OtfRequest first = request(1), second = request(2), last = request(3);
        for (const OtfRequest& asked : {first, second, last}) kept.keep(otfOf(asked, third));
        QVERIFY(kept.find(first) && kept.find(last));
        QCOMPARE(kept.find(second), nullptr);
        kept.keep(otfOf(last, 1));  // once is enough
        QCOMPARE(kept.count(), std::size_t(2));
        QVERIFY(kept.bytes() <= KeptOtfs::byteLimit);
        kept.clear();
        QCOMPARE(kept.find(first), nullptr);
        kept.keep(otfOf(last, third));
        QVERIFY(kept.find(last));
    }

    void whatIsTooLargeToKeepTakesNothingFromTheOthers() {
        KeptOtfs kept;
        const OtfRequest first = request(1), large = request(2);
        kept.keep(otfOf(first, third));
        kept.keep(otfOf(large, 4 * third));
        QVERIFY(kept.find(first));
        QCOMPARE(kept.find(large), nullptr);
    }

    void whatIsOfNoUseMakesRoom() {
        KeptOtfs kept;
        OtfRequest gone = request(1);
        const OtfRequest stays = request(2), next = request(3);
        kept.keep(otfOf(gone, third));
        kept.keep(otfOf(stays, third));
        gone.raw.reset();
        kept.keep(otfOf(next, third));
        QVERIFY(kept.find(stays) && kept.find(next));
        QCOMPARE(kept.count(), std::size_t(2));
    }

    void whatFitsNowhereIsNotKept() {
        KeptOtfs kept;
        kept.keep(otfOf(request(), 4 * third));
        QCOMPARE(kept.count(), std::size_t(0));
        QCOMPARE(kept.bytes(), std::size_t(0));
    }
};

ECHOLUCENT_TEST_CLASS(TestKeptOtfs)
#include "test_kept_otfs.moc"
