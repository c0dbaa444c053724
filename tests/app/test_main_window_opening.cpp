// What opening finds of a scan: it is shown, said in the picture, and taken back by one step or one key.
#include <QComboBox>

#include "app/otf/near_cut_finder.h"
#include "io/writers/enhanced_us_writer.h"
#include "processing/document/opening_finds.h"
#include "tests/app/walled_sector.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

class TestMainWindowOpening : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { m_file = file("sector.mha", {walledSector()}); }
    void init() { show(lookAtStart()); }
    void cleanup() { close(); }

    void thePictureSaysThatTheVolumeWasReduced() {
        open(m_file);
        QVERIFY(!window().volumeView().caption().contains("reduced 2"));
        PhantomConfig config = defaultPhantom(PhantomScene::shapes);
        config.size = {110, 100, 120};
        const QString large = file("large.mha", {std::make_shared<const Volume>(*makePhantom(config))});
        ReadOptions options;
        options.studyMebibytes = 1;
        QSignalSpy computed(&window().otfs(), &PaneOtfs::computed);
        window().open(large, options);
        QVERIFY(computed.wait(patience));
        waitUntilIdle();
        QCOMPARE(window().openStudy().volume()->geometry().size[2], 60);
        QVERIFY(window().volumeView().caption().endsWith(
            QString::fromUtf8("\nreduced 2 × 2 × 2: fine detail is averaged")));
        QVERIFY(child<MessageBar>("message")->text().contains("fine detail is averaged away"));
    }

    void aSureBeamIsTakenSaidAndTakenBackByOneStep() {
        open(m_file);
        const auto& finds = window().openStudy().finds();
        QVERIFY(finds && finds->beam.sure);
        QCOMPARE(document().beam, (Beam{BeamAxis::plusY, BeamSource::sectorShape}));
        QVERIFY(window().volumeView().caption().startsWith("from the probe"));
        QCOMPARE(child<QComboBox>("view.beamAxis")->currentText(), QString("+y"));
        QVERIFY(document() == withFinds(document(), *finds));
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        waitUntilIdle();
        QCOMPARE(document().beam, Beam{});
        QCOMPARE(document().scene.front, Front{});
        // Nobody knows where the probe was: nothing names it, though the view runs along the assumed beam.
        QVERIFY(!window().volumeView().caption().contains("probe"));
    }

    void theViewFromTheProbeThatTheFileStatesIsThatOfSide1() {
        const ViewFrame stated = frameOf({BeamAxis::minusY, 15, -20, 40});
        const std::string path = temporaryFolder().filePath("leaning.dcm").toStdString();
        EnhancedUsDetails details;
        details.transducer = {Vec3(35, 90, 35) - stated.forward * 120.0, stated.forward, stated.right};
        QVERIFY(writeEnhancedUs(path, {smallPhantom(PhantomScene::shapes, 3)}, details));
        useLook(Look{});
        open(QString::fromStdString(path));
        QCOMPARE(document().beam.source, BeamSource::file);
        QCOMPARE(document().beam.axis, BeamAxis::minusY);
        QTest::keyClick(&window(), Qt::Key_1, Qt::ControlModifier);
        waitUntilIdle();
        const auto looksAlong = [this] { return frameOf(viewpointOf(document())); };
        QVERIFY(length(looksAlong().forward - stated.forward) < 1e-6);
        QVERIFY(length(looksAlong().right - stated.right) < 1e-6);  // the marker's side is at the right of the picture
        QVERIFY(length(frameOf(otfViewpointOf(document(), firstPane)).forward - stated.forward) < 1e-6);
        QVERIFY(window().volumeView().caption().startsWith("from the probe"));
        lookFrom(window(), Viewpoint{.beamAxis = BeamAxis::minusY, .azimuthDegrees = 80});
        QTRY_VERIFY(!window().volumeView().caption().contains("probe"));
        QTest::keyClick(&window(), Qt::Key_R);
        waitUntilIdle();
        QVERIFY(length(looksAlong().forward - stated.forward) < 1e-6);
        QVERIFY(length(looksAlong().right - stated.right) < 1e-6);
    }

    void aSessionThatReadsAlreadyIsShownWhenItHasRead() {
        MainWindow early(settingsFile(), [this](OpenStudy& openStudy) { openStudy.open(m_file); });
        QVERIFY(!early.idle());
        QVERIFY(early.openStudy().loading());
        early.show();
        QTRY_VERIFY_WITH_TIMEOUT(early.idle() && early.volumeView().pictureIsFine(), 30000);
        open(m_file);
        QVERIFY(early.document().document() == document());
        QCOMPARE(early.volumeView().caption(), window().volumeView().caption());
        QCOMPARE(early.openStudy().path(), m_file);
    }

    void aFoundCutIsTakenBackByOneKeyAndFoundAgainByIt() {
        open(m_file);
        // The search may be sure of this wall or not: what it found is put in place as opening does it.
        Document next = document();
        next.scene.front = frontAcross({}, 9.5, FrontSource::found);
        window().document().edit(next, "cut");
        waitUntilIdle();
        QVERIFY(window().volumeView().caption().contains("front 9.5 mm, found"));
        QTest::keyClick(&window(), Qt::Key_N, Qt::ShiftModifier);
        waitUntilIdle();
        QCOMPARE(document().scene.front, Front{});
        QVERIFY(!window().volumeView().caption().contains("front"));
        window().nearCutFinder().setSearch([](const Volume&, const Viewpoint&, const Progress&) {
            return std::optional(NearCutFinding{.answer = NearCutAnswer::wallBeforeFluid,
                                                .nearCutMm = 7,
                                                .message = "A wall stands before the fluid."});
        });
        QTest::keyClick(&window(), Qt::Key_N);
        QTRY_COMPARE(document().scene.front, frontAcross({}, 7));
        waitUntilIdle();
    }

    void speckleThatIsNotReducedIsNotSaidToBe() {
        window().openStudy().quietPhases().setReduce(
            [](const Volume&, SpeckleReduction, const Progress&) -> std::optional<Volume> { throw std::bad_alloc(); });
        open(m_file);
        QVERIFY(document().scene.look.reduction != SpeckleReduction::off);
        QVERIFY2(window().volumeView().caption().contains("not smoothed"), qPrintable(window().volumeView().caption()));
        QVERIFY(!window().explanation().contains("Speckle was reduced"));
        QVERIFY(child<MessageBar>("message")->text().contains("memory"));
    }

    void speckleIsReducedStepByStepAndLightsFollowEachOther() {
        open(m_file);
        QCOMPARE(document().scene.look.reduction, defaultSpeckleReduction);
        QVERIFY(window().volumeView().caption().contains("smoothed: medium"));
        const auto medium = window().otfs().of(PaneOtfs::adaptiveOfScene)->asked.shown;
        QTest::keyClick(&window(), Qt::Key_Q);
        waitUntilIdle();
        QCOMPARE(document().scene.look.reduction, SpeckleReduction::strong);
        QVERIFY(window().otfs().of(PaneOtfs::adaptiveOfScene)->asked.shown != medium);
        QCOMPARE(window().otfs().adaptive()->reduction, SpeckleReduction::strong);
        for (int i = 0; i < 4; ++i) QTest::keyClick(&window(), Qt::Key_Q, Qt::ShiftModifier);
        waitUntilIdle();
        QCOMPARE(document().scene.look.reduction, SpeckleReduction::off);
        QCOMPARE(window().otfs().of(PaneOtfs::adaptiveOfScene)->asked.shown, window().openStudy().volume());
        QVERIFY(!window().volumeView().caption().contains("smoothed"));
        QTest::keyClick(&window(), Qt::Key_L);
        QCOMPARE(document().scene.look.lighting, Lighting::flat);
        QTest::keyClick(&window(), Qt::Key_L);
        QCOMPARE(document().scene.look.lighting, Lighting::surface);
        waitUntilIdle();
    }

private:
    [[nodiscard]] const Document& document() { return window().document().document(); }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowOpening)

#include "test_main_window_opening.moc"
