// The open study: loading off the GUI thread, the newest request wins, nothing stale is ever shown.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "app/study/open_study.h"
#include "io/document/session_file.h"
#include "io/writers/meta_image_writer.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

std::shared_ptr<const Volume> constantVolume(std::uint8_t value) {
    VolumeGeometry geometry;
    geometry.size = {8, 9, 10};
    return std::make_shared<const Volume>(geometry, Voxels(std::vector<std::uint8_t>(8 * 9 * 10, value)));
}

}  // namespace

class TestOpenStudy : public QObject {
    Q_OBJECT

    Works m_works;

private slots:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        m_dark = m_folder.filePath("dark.mha");
        m_bright = m_folder.filePath("bright.mha");
        QVERIFY(writeMetaImage(m_dark.toStdString(), {constantVolume(10), constantVolume(20)}));
        QVERIFY(writeMetaImage(m_bright.toStdString(), {constantVolume(200)}));
    }

    void opensAStudyWithItsFirstPhase() {
        OpenStudy openStudy(m_works);
        QStringList order;
        connect(&openStudy, &OpenStudy::studyReplaced, this, [&] { order << "replaced"; });
        connect(&openStudy, &OpenStudy::volumeChanged, this, [&] { order << "volume"; });
        connect(&openStudy, &OpenStudy::studyOpened, this, [&] { order << "opened"; });
        open(openStudy, m_dark);
        QCOMPARE(order, (QStringList{"replaced", "volume", "opened"}));
        QCOMPARE(openStudy.volume()->storedValue(0), 10.0);
        QCOMPARE(openStudy.histogram().counts[10], std::uint64_t(720));
        openStudy.setPhase(1);
        QCOMPARE(order.last(), "volume");
        QCOMPARE(openStudy.volume()->storedValue(0), 20.0);
        QCOMPARE(openStudy.histogram().counts[20], std::uint64_t(720));
    }

    void aPhaseThatIsWantedBesideTheOneShownIsMadeQuietNext() {
        OpenStudy openStudy(m_works);
        std::vector<int> made;
        connect(&openStudy, &OpenStudy::phaseVoxelsChanged, this, [&](int phase) { made.push_back(phase); });
        QSignalSpy told(&openStudy, &OpenStudy::quietVoxelsMade);
        openStudy.setReduction(SpeckleReduction::light);
        open(openStudy, m_dark);
        openStudy.alsoWant(7);  // there is no such phase: the last one
        QTRY_VERIFY(!openStudy.quietPhases().busy());
        QCOMPARE(made, (std::vector<int>{0, 1}));
        QCOMPARE(told.count(), 2);
        const auto quiet = openStudy.newestVoxels();
        QVERIFY(quiet != openStudy.volume());
        QVERIFY(&openStudy.histogramOf(*quiet) != &openStudy.histogram());
        QVERIFY(&openStudy.histogramOf(*openStudy.volume()) == &openStudy.histogram());
    }

    void whatCannotBeReadLeavesWhatIsOpen() {
        OpenStudy openStudy(m_works);
        open(openStudy, m_bright);
        QSignalSpy failed(&openStudy, &OpenStudy::openFailed);
        openStudy.open(m_folder.filePath("not there.mha"));
        QVERIFY(failed.wait(patience));
        QCOMPARE(openStudy.volume()->storedValue(0), 200.0);
        QCOMPARE(openStudy.path(), m_bright);
        const auto failure = failed.first().at(1).value<Failure>();
        QCOMPARE(failure.kind, FailureKind::unreadable);
        QVERIFY(QString::fromStdString(failure.sentence()).contains("not there.mha"));
    }

    void theNewestOpenWins() {
        OpenStudy openStudy(m_works);
        QSignalSpy opened(&openStudy, &OpenStudy::studyOpened);
        for (int i = 0; i < 20; ++i) openStudy.open(i % 2 == 0 ? m_dark : m_bright);
        QTRY_VERIFY(!openStudy.loading());
        QCOMPARE(openStudy.path(), m_bright);
        QCOMPARE(openStudy.volume()->storedValue(0), 200.0);
        QVERIFY(opened.count() >= 1 && opened.count() <= 2);
    }

    void aSessionOfTheFilesOwnLeftHandedGridStaysOnTheAnatomy() {
        VolumeGeometry left;
        left.size = {8, 9, 10};
        left.direction = Mat3::diag({1, 1, -1});
        std::vector<std::uint8_t> values(8 * 9 * 10, 10);
        values[static_cast<std::size_t>(left.offset(2, 3, 4))] = 90;
        const std::string file = m_folder.filePath("left.mha").toStdString();
        QVERIFY(writeMetaImage(file, {std::make_shared<const Volume>(left, Voxels(values))}));
        SavedSession session;
        session.document.study = StudyFile{.path = file, .options = {}, .checksum = {}};
        session.document.measurements = {{.id = 1, .placesMm = {{2, 3, 4}, {1, 1, 1}}}};
        session.snapshots = {{"first", session.document}};
        const QString saved = m_folder.filePath("left.session.json");
        QVERIFY(writeSession(saved.toStdString(), session));

        OpenStudy openStudy(m_works);
        open(openStudy, QString::fromStdString(file));
        QCOMPARE(turnedAxisOf(openStudy.reference()), std::optional(GridAxis::z));
        open(openStudy, saved);
        QCOMPARE(turnedAxisOf(openStudy.reference()), std::optional(GridAxis::z));
        const SavedSession& opened = openStudy.saved()->session;
        const VolumeGeometry& grid = openStudy.volume()->geometry();
        for (const Document* document : {&opened.document, &opened.snapshots.front().document}) {
            QCOMPARE(document->study, openStudy.reference());
            const Vec3 place = grid.voxelFromGridMm(document->measurements[0].placesMm[0]);
            QCOMPARE(openStudy.volume()->storedValue(
                         grid.offset(std::lround(place[0]), std::lround(place[1]), std::lround(place[2]))),
                     90.0);
        }
        // Saved again, it is of the turned grid, and stays as it is.
        const std::vector<Measurement> measured = opened.document.measurements;
        QVERIFY(writeSession(saved.toStdString(), opened));
        open(openStudy, saved);
        QVERIFY(openStudy.saved()->session.document.measurements.values() == measured);
    }

    void cancelledLoadingOpensNothing() {
        OpenStudy openStudy(m_works);
        QSignalSpy opened(&openStudy, &OpenStudy::studyOpened);
        openStudy.openSimulatedScan();
        openStudy.cancelLoading();
        QTRY_VERIFY(!openStudy.loading());
        QCOMPARE(opened.count(), 0);
        QVERIFY(openStudy.study() == nullptr);
    }

    void anImpossiblePhaseIsABrokenContract() {
        OpenStudy openStudy(m_works);
        open(openStudy, m_dark);
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, openStudy.setPhase(2));
        QVERIFY_THROWS_EXCEPTION(std::out_of_range, openStudy.setPhase(-1));
    }

private:
    static void open(OpenStudy& openStudy, const QString& path) {
        QSignalSpy opened(&openStudy, &OpenStudy::studyOpened);
        openStudy.open(path);
        QVERIFY(opened.wait(patience));
    }

    QTemporaryDir m_folder;
    QString m_dark;
    QString m_bright;
};

ECHOLUCENT_TEST_CLASS(TestOpenStudy)
#include "test_open_study.moc"
