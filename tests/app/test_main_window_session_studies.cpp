// The studies of sessions in the real window: found where they moved, asked for where they changed, refused where they
// do not fit.
#include <cstdio>

#include "tests/app/session_fixture.h"
#include "tests/io/document/mutations.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestMainWindowSessionStudies : public QObject, private SessionFixture {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { begin(); }
    void cleanup() { close(); }

    void aVolumeThatMovedIsFoundByItsBytes() {
        const QString session = savedSession();
        const Document saved = document();
        QVERIFY(QDir().mkpath(inFolder("a/b")));
        const QString moved = inFolder("a/b/other name.mha");
        QVERIFY(QFile::rename(studyFile(), moved));
        again(session);
        QCOMPARE(window().openStudy().path(), moved);
        QVERIFY(nameless(document()) == nameless(saved));
    }

    void aVolumeThatIsNowhereIsAskedForAndTheOpenOneStays() {
        const QString session = savedSession();
        const Document saved = document();
        const QTemporaryDir elsewhere;
        const QString moved = elsewhere.filePath("heart.mha");
        QVERIFY(QFile::rename(studyFile(), moved));
        close();
        show();
        useLook(Look{});
        const QString other = file("other.mha", {smallPhantom(PhantomScene::fetus, 2)});
        open(other);
        const Document before = document();
        window().open(session);
        QTRY_COMPARE(message()->text(), QString("heart.mha, the volume of this session, was not found."));
        QVERIFY(document() == before);
        QCOMPARE(window().openStudy().path(), other);
        answerDialog([&](QFileDialog& dialog) { dialog.selectFile(moved); }, true);
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        waitUntilIdle();
        QCOMPARE(window().openStudy().path(), moved);
        QVERIFY(nameless(document()) == nameless(saved));
    }

    void aVolumeThatChangedIsSaidAndOpensOnlyWhenToldTo() {
        const QString session = savedSession();
        const Document saved = document();
        QFile volume(studyFile());
        QVERIFY(volume.open(QIODevice::Append) && volume.write("more") == 4);
        volume.close();
        close();
        show();
        window().open(session);
        QTRY_VERIFY(message()->text().contains("bytes, and had"));
        QVERIFY(message()->text().contains("heart.mha"));
        QVERIFY(window().openStudy().study() == nullptr);
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        waitUntilIdle();
        QVERIFY(nameless(document()) == nameless(saved));
        QVERIFY(std::get<StudyFile>(document().study).bytes == std::get<StudyFile>(saved.study).bytes + 4);
    }

    void asManyPhasesAreNeededAsTheSessionShows() {
        const QString session = savedSession();
        SavedSession changed = readSession(session.toStdString()).value();
        changed.document.scene.phase = 3;
        QVERIFY(writeSession(session.toStdString(), changed).has_value());
        const Document before = document();
        window().open(session);
        QTRY_VERIFY(message()->text().contains("phases asks for phase 4, but the study has 1"));
        QVERIFY(document() == before);
    }

    void aFrontThatIsFixedInTheVolumeStaysThere() {
        const QString session = savedSession();
        SavedSession changed = readSession(session.toStdString()).value();
        changed.document.scene.front = {.depthMm = 9, .direction = ViewDirection{.azimuth = 120}};
        changed.snapshots.push_back({"fixed", changed.document});
        QVERIFY(writeSession(session.toStdString(), changed).has_value());
        again(session);
        waitUntilIdle();
        QVERIFY(document().scene == changed.document.scene);
        QVERIFY(window().sessionKeeping().snapshots().list().back().document.scene == changed.document.scene);
    }

    void aSessionThatMovesTheObjectOpensWithoutPhases() {
        const QString session = savedSession();
        SavedSession changed = readSession(session.toStdString()).value();
        changed.document.motion.scenario = MotionScenario::object;
        changed.snapshots.push_back({"moves", changed.document});
        QVERIFY(writeSession(session.toStdString(), changed).has_value());
        again(session);
        QCOMPARE(document().motion.scenario, MotionScenario::probe);
        QCOMPARE(window().sessionKeeping().snapshots().list().front().document.motion.scenario, MotionScenario::probe);
    }

    /// The loop goes through the window as a person would; the open study is compared after each.
    void mutatedSessionsLeaveTheOpenStudyOrOpen() {
        const int count = isLongRun() ? 1000 : 60;
        const QString session = savedSession();
        const QString mutated = inFolder("mutated.session.json");
        Mutations mutations(bytesOf(session).toStdString(), 41);
        int opened = 0, refused = 0, asked = 0;
        Document before = document();
        QSignalSpy loading(&window().openStudy(), &OpenStudy::loadingChanged);
        QSignalSpy studies(&window().openStudy(), &OpenStudy::studyOpened);
        for (int i = 0; i < count; ++i) {
            QFile out(mutated);
            QVERIFY(out.open(QIODevice::WriteOnly | QIODevice::Truncate));
            out.write(QByteArray::fromStdString(mutations.next()));
            out.close();
            studies.clear();
            message()->dismiss();
            window().open(mutated);
            while (window().openStudy().loading()) QVERIFY(loading.wait(60000));
            if (!studies.isEmpty()) {
                ++opened;
                before = document();
                continue;
            }
            QVERIFY2(!message()->text().isEmpty(), qPrintable(QString("mutation %1 says nothing").arg(i)));
            QVERIFY(!message()->text().contains('\n'));
            message()->text().contains("was not found") || message()->text().contains("when the session was saved")
                ? ++asked
                : ++refused;
            QVERIFY2(document() == before, qPrintable(QString("mutation %1 changed the document").arg(i)));
        }
        std::printf(
            "%d mutated session files in the window: %d opened, %d ended in a sentence, %d asked for the volume\n",
            count, opened, refused, asked);
        QVERIFY(opened > count / 50 && refused > count * 3 / 10);
        waitUntilIdle();
    }
};

ECHOLUCENT_TEST_CLASS(TestMainWindowSessionStudies, "mutatedSessionsLeaveTheOpenStudyOrOpen")

#include "test_main_window_session_studies.moc"
