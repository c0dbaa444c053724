// Sessions in the real window: saved beside the volume, opened again, found where they moved, refused where they are
// wrong.
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <atomic>
#include <filesystem>
#include <thread>

#include "app/sessions/session_keeping.h"
#include "io/document/session_file.h"
#include "tests/app/window_fixture.h"
#include "tests/io/document/mutations.h"
#include "widgets/panels/message_bar.h"

using namespace echolucent;

class TestMainWindowSessions : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        QLocale::setDefault(QLocale::c());
        m_small = smallPhantom(PhantomScene::shapes, 5);
    }
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath("heart.mha");
        QVERIFY(writeMetaImage(m_file.toStdString(), {m_small}).has_value());
        show();
        useLook(Look{});
        open(m_file);
    }
    void cleanup() { close(); }

    void aSessionIsSavedBesideTheVolumeAndOpensAsItWas() {
        work();
        QTRY_VERIFY(window().isWindowModified());
        QString proposed;
        answerDialog([&](QFileDialog& dialog) { proposed = dialog.selectedFiles().value(0); }, true);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QCOMPARE(proposed, m_folder->filePath("heart.session.json"));
        QTRY_COMPARE(message()->text(), QString("The session was saved as heart.session.json."));
        QVERIFY(!window().isWindowModified());
        waitUntilIdle();
        const Document saved = document();
        const auto& reference = std::get<StudyFile>(saved.study);
        QVERIFY(QString::fromStdString(reference.checksum).startsWith("xxh3-128:"));
        const auto inFile = readSession(proposed.toStdString());
        QVERIFY(inFile);
        QCOMPARE(QString::fromStdString(std::get<StudyFile>(inFile->document.study).path), QString("heart.mha"));
        QVERIFY(autosaves().isEmpty());

        // Saved again without a question, and the same bytes come back out.
        close();
        show();
        QSignalSpy pictures(&window().openStudy(), &OpenStudy::otfComputed);
        window().open(proposed);
        QTRY_VERIFY_WITH_TIMEOUT(!pictures.isEmpty(), 20000);
        waitUntilIdle();
        QVERIFY(document() == saved);
        QCOMPARE(pictures.count(), 1);
        QCOMPARE(window().document().steps().count(), 0);
        QCOMPARE(window().sessionKeeping().snapshots().list().size(), std::size_t{1});
        QVERIFY(!window().isWindowModified());
        const QByteArray before = bytesOf(proposed);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QTRY_COMPARE(message()->text(), QString("The session was saved as heart.session.json."));
        QCOMPARE(bytesOf(proposed), before);
        auto* recent = child<QMenu>("file.recent");
        emit recent->aboutToShow();
        QVERIFY2(recent->actions().first()->text().contains("heart.session.json"),
                 qPrintable(recent->actions().first()->text()));
        // Its small picture stands beside it.
        waitUntilIdle();
        QVERIFY(
            QFile::exists(Settings(settingsFile()).dataFolder() + "/recent/" + Settings::hashOf(proposed) + ".png"));
    }

    void inTheSameWindowItsStrokesCutAgain() {
        work();
        const QString session = savedSession();
        QVERIFY(window().openStudy().volume()->isCut());
        const std::vector<std::uint8_t> left = window().openStudy().volume()->dataMask();
        Document next = document();
        next.curves.linear.lower = 0.4;
        window().document().edit(next, "curve");
        waitUntilIdle();
        open(session);
        QVERIFY(window().openStudy().strokes() == strokesOf(document(), 1));
        QCOMPARE(document().curves.linear.lower, 0.2);
        QVERIFY(window().openStudy().volume()->isCut());
        QVERIFY(window().openStudy().volume()->dataMask() == left);
    }

    void aSessionOfFourDimensionsOpensInItsPhase() {
        const QString study = fourPhases();
        open(study);
        Document next = document();
        phaseOf(next, 1) = 2;
        next.motion.scenario = MotionScenario::object;
        next.motion.phaseRange = PhaseRange{1, 3};
        next.motion.otf = MotionOtf::oneOtf;
        next.motion.otfPhase = 1;
        window().document().edit(next, "motion");
        waitUntilIdle();
        const QString session = savedSession();
        const Document saved = document();
        for (const bool inSameWindow : {true, false}) {
            if (!inSameWindow) {
                close();
                show();
            }
            open(session);
            QVERIFY(document() == saved);
            QCOMPARE(window().openStudy().phase(), 2);
            QCOMPARE(window().openStudy().phaseOfOtf(), 1);
            QCOMPARE(child<QSlider>("motion.phase")->value(), 2);  // counted from 0
        }
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

    void savingWaitsForTheChecksumAndCanBeCancelled() {
        holdChecksum();
        const QString session = m_folder->filePath("held.session.json");
        QSignalSpy saved(&window().sessionKeeping(), &SessionKeeping::saved);
        window().sessionKeeping().saveAs(session);
        QTRY_COMPARE(child<QLabel>("status.activity")->text().contains("saving the session"), true);
        QTRY_VERIFY(child<QAbstractButton>("status.cancel")->isVisible());
        click("status.cancel");
        QTRY_VERIFY(message()->text().startsWith("Saving held.session.json was cancelled"));
        QVERIFY(!QFile::exists(session));
        window().sessionKeeping().saveAs(session);
        QVERIFY(window().sessionKeeping().saving());
        m_held = false;
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(!std::get<StudyFile>(readSession(session.toStdString()).value().document.study).checksum.empty());
        waitUntilIdle();
    }

    void anotherStudyEndsTheWaitAndTheWindowStays() {
        const QString session = savedSession();
        holdChecksum();
        open(session);
        // The session's reading takes the checksum by itself: another file is what is held.
        window().open(file("third.mha", {smallPhantom(PhantomScene::fetus, 4)}));
        QTRY_VERIFY(window().openStudy().path().endsWith("third.mha") && window().openStudy().takingChecksum());
        Document next = document();
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        window().document().edit(next, "distance");
        const QString third = m_folder->filePath("third.session.json");
        QSignalSpy saved(&window().sessionKeeping(), &SessionKeeping::saved);
        window().sessionKeeping().saveAs(third, SessionKeeping::Then::closeWindow);
        QVERIFY(window().sessionKeeping().saving());
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        window().open(session);
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 20000);
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(window().isVisible());
        QCOMPARE(window().sessionKeeping().file(), session);
        QVERIFY(readSession(third.toStdString()).value().document.measurements == next.measurements);
        m_held = false;
        waitUntilIdle();
    }

    void aVolumeThatMovedIsFoundByItsBytes() {
        const QString session = savedSession();
        const Document saved = document();
        QVERIFY(QDir().mkpath(m_folder->filePath("a/b")));
        const QString moved = m_folder->filePath("a/b/other name.mha");
        QVERIFY(QFile::rename(m_file, moved));
        again(session);
        QCOMPARE(window().openStudy().path(), moved);
        QVERIFY(nameless(document()) == nameless(saved));
    }

    void aVolumeThatIsNowhereIsAskedForAndTheOpenOneStays() {
        const QString session = savedSession();
        const Document saved = document();
        const QTemporaryDir elsewhere;
        const QString moved = elsewhere.filePath("heart.mha");
        QVERIFY(QFile::rename(m_file, moved));
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
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 20000);
        waitUntilIdle();
        QCOMPARE(window().openStudy().path(), moved);
        QVERIFY(nameless(document()) == nameless(saved));
    }

    void aVolumeThatChangedIsSaidAndOpensOnlyWhenToldTo() {
        const QString session = savedSession();
        const Document saved = document();
        QFile volume(m_file);
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
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 20000);
        waitUntilIdle();
        QVERIFY(nameless(document()) == nameless(saved));
        QVERIFY(std::get<StudyFile>(document().study).bytes == std::get<StudyFile>(saved.study).bytes + 4);
    }

    void whereNothingCanBeWrittenAnotherPlaceIsOffered() {
        work();
        const Document before = document();
        window().sessionKeeping().saveAs("/proc/heart.session.json");
        QTRY_VERIFY(message()->text().contains("could not be written"));
        QCOMPARE(message()->kind(), MessageKind::error);
        QVERIFY(document() == before);
        QTRY_VERIFY(window().isWindowModified());
        const QString elsewhere = m_folder->filePath("elsewhere.session.json");
        QString proposed;
        answerDialog(
            [&](QFileDialog& dialog) {
                proposed = dialog.selectedFiles().value(0);
                dialog.selectFile(elsewhere);
            },
            true);
        click("message.action.0");
        QTRY_COMPARE(message()->text(), QString("The session was saved as elsewhere.session.json."));
        QCOMPARE(QFileInfo(proposed).fileName(), QString("heart.session.json"));
        QVERIFY(QFileInfo(QFileInfo(proposed).absolutePath()).isWritable());
        QVERIFY(readSession(elsewhere.toStdString()).value().document.poses == before.poses);
    }

    void itNeverTakesTheVolumesPlace() {
        const QByteArray before = bytesOf(m_file);
        window().sessionKeeping().saveAs(m_file);
        QTRY_VERIFY(message()->text().contains("would overwrite"));
        QCOMPARE(bytesOf(m_file), before);
    }

    void asManyPhasesAreNeededAsTheSessionShows() {
        const QString session = savedSession();
        SavedSession changed = readSession(session.toStdString()).value();
        phaseOf(changed.document, 1) = 3;
        QVERIFY(writeSession(session.toStdString(), changed).has_value());
        const Document before = document();
        window().open(session);
        QTRY_VERIFY(message()->text().contains("phases asks for phase 4, but the study has 1"));
        QVERIFY(document() == before);
    }

    void theSimulatedScanHasSessionsToo() {
        window().openSimulatedScan();
        QTRY_VERIFY_WITH_TIMEOUT(window().openStudy().isSimulatedScan() && window().idle(), 60000);
        Document next = document();
        poseOf(next, 1).magnification = 1.25;
        window().document().edit(next, "zoom");
        const QString session = m_folder->filePath("scan.session.json");
        window().sessionKeeping().saveAs(session);
        QTRY_VERIFY(message()->text().startsWith("The session was saved"));
        const Document saved = document();
        again(session);
        QVERIFY(window().openStudy().isSimulatedScan());
        QVERIFY(document() == saved);
    }

    void closingAsksOnlyWhereASessionWithAFileWasChanged() {
        const auto asked = [this](const char* answer) {
            int boxes = 0;
            QTimer::singleShot(0, this, [&] {
                auto* box = window().findChild<QMessageBox*>("unsavedSession");
                if (box == nullptr) return;
                ++boxes;
                for (QAbstractButton* button : box->buttons())
                    if (button->text().remove('&').startsWith(answer)) return button->click();
            });
            window().close();
            return boxes;
        };
        lookFrom(window(), Viewpoint{.azimuthDegrees = 30});
        QCOMPARE(asked("Cancel"), 0);  // a person only looked around
        QVERIFY(!window().isVisible());
        window().show();
        const QString session = savedSession();
        QCOMPARE(asked("Cancel"), 0);
        window().show();
        lookFrom(window(), Viewpoint{.azimuthDegrees = 60});
        QCOMPARE(asked("Cancel"), 1);
        QVERIFY(window().isVisible());
        QCOMPARE(asked("Save"), 1);
        QTRY_VERIFY(!window().isVisible());
        QVERIFY(readSession(session.toStdString()).value().document.poses == document().poses);
    }

    /// The loop goes through the window as a person would; the open study is compared after each.
    void aThousandMutatedSessionsLeaveTheOpenStudyOrOpen() {
        const QString session = savedSession();
        const QString mutated = m_folder->filePath("mutated.session.json");
        Mutations mutations(bytesOf(session).toStdString(), 41);
        int opened = 0, refused = 0, asked = 0;
        Document before = document();
        QSignalSpy loading(&window().openStudy(), &OpenStudy::loadingChanged);
        QSignalSpy studies(&window().openStudy(), &OpenStudy::studyOpened);
        for (int i = 0; i < 1000; ++i) {
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
            "1,000 mutated session files in the window: %d opened, %d ended in a sentence, %d asked for the volume\n",
            opened, refused, asked);
        QVERIFY(opened > 20 && refused > 300);
        waitUntilIdle();
    }

private:
    QString fourPhases() {
        std::vector<std::shared_ptr<const Volume>> phases;
        for (int phase = 0; phase < 4; ++phase)
            phases.push_back(smallPhantom(PhantomScene::shapes, static_cast<std::uint64_t>(phase)));
        return file("four.mha", phases);
    }
    /// Another study is opened whose checksum is there once m_held is false.
    void holdChecksum() {
        m_held = true;
        window().openStudy().setChecksum([this](const auto& files, const Progress& progress) {
            while (m_held && !progress.cancelled()) std::this_thread::yield();
            return checksumOf(files, progress);
        });
        QSignalSpy computed(&window().openStudy(), &OpenStudy::otfComputed);
        window().open(file("held.mha", {smallPhantom(PhantomScene::fetus, 3)}));
        QVERIFY(computed.wait(20000));
        QTRY_VERIFY(window().openStudy().takingChecksum());
    }
    [[nodiscard]] const Document& document() { return window().document().document(); }
    MessageBar* message() { return child<MessageBar>("message"); }
    static QByteArray bytesOf(const QString& path) {
        QFile in(path);
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    static Document nameless(Document document) {
        document.study = {};
        return document;
    }
    QStringList autosaves() {
        return QDir(temporaryFolder().filePath("settings-data/autosaves")).entryList({"*.autosave.json"}, QDir::Files);
    }
    /// Something of most kinds that a person sets.
    void work() {
        Document next = document();
        poseOf(next, 1).direction = {.azimuth = 20, .elevation = -8, .roll = 3};
        cutOf(next, 1).nearCutMm = 4;
        ScalpelStroke stroke{.tool = ScalpelTool::eraser, .places = {{-0.2, 0.1}, {0.2, -0.1}}, .radius = 0.06};
        stroke.camera = {{27, 25, 30}, frameOf(Viewpoint{.azimuthDegrees = 10}), Projection::parallel, 60, 30, 100};
        strokesOf(next, 1).push_back(stroke);
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        lookOf(next, 1).brightness = 1.3;
        next.curves.linear.lower = 0.2;
        window().document().edit(next, "work");
        QVERIFY(window().sessionKeeping().snapshots().keep("as it was", document()).isEmpty());
        window().motionPlayer().setAngle(7);
        waitUntilIdle();
    }
    QString savedSession() {
        const QString session = m_folder->filePath("heart.session.json");
        waitUntilIdle();
        QSignalSpy saved(&window().sessionKeeping(), &SessionKeeping::saved);
        window().sessionKeeping().saveAs(session);
        if (!saved.wait(10000)) qFatal("nothing was saved");
        waitUntilIdle();
        return session;
    }
    void again(const QString& session) {
        close();
        show();
        open(session);
    }
    void answerDialog(const std::function<void(QFileDialog&)>& act, bool accept) {
        QTimer::singleShot(0, this, [this, act, accept] {
            QFileDialog* dialog = nullptr;
            for (QWidget* each : QApplication::topLevelWidgets())
                if (auto* found = qobject_cast<QFileDialog*>(each); found && found->isVisible()) dialog = found;
            if (dialog == nullptr) qFatal("there is no dialog");
            act(*dialog);
            static_cast<QDialog*>(dialog)->done(accept ? QDialog::Accepted : QDialog::Rejected);
        });
    }

    std::shared_ptr<const Volume> m_small;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;
    std::atomic<bool> m_held = false;
};

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    TestMainWindowSessions test;
    return QTest::qExec(&test, count, arguments);
}

#include "test_main_window_sessions.moc"
