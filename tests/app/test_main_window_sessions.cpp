// Sessions in the real window: saved beside the volume, opened as they were, asked about where the window closes.
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QSlider>
#include <QTimer>

#include "tests/app/session_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestMainWindowSessions : public QObject, private SessionFixture {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { begin(); }
    void cleanup() { close(); }

    void aSessionIsSavedBesideTheVolumeAndOpensAsItWas() {
        work();
        QTRY_VERIFY(window().isWindowModified());
        QString proposed;
        answerDialog([&](QFileDialog& dialog) { proposed = dialog.selectedFiles().value(0); }, true);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QCOMPARE(proposed, inFolder("heart.session.json"));
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
        QSignalSpy pictures(&window().otfs(), &PaneOtfs::computed);
        window().open(proposed);
        QTRY_VERIFY_WITH_TIMEOUT(!pictures.isEmpty(), patience);
        waitUntilIdle();
        QVERIFY(document() == saved);
        QCOMPARE(pictures.count(), 2);  // the scene's one, and the first pane's, which is the same
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

    void aTypedNameGetsTheEndingOfSessions_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("written");
        QTest::newRow("a word") << "mine"
                                << "mine.session.json";
        QTest::newRow("with points") << "Visit 1.2"
                                     << "Visit 1.2.session.json";
        QTest::newRow("with another ending") << "mine.mha"
                                             << "mine.mha.session.json";
        QTest::newRow("JSON") << "mine.json"
                              << "mine.json";
        QTest::newRow("whole") << "mine.session.json"
                               << "mine.session.json";
    }
    void aTypedNameGetsTheEndingOfSessions() {
        QFETCH(QString, typed);
        QFETCH(QString, written);
        typeIntoDialog(typed);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QTRY_COMPARE(message()->text(), QString("The session was saved as %1.").arg(written));
        QVERIFY(readSession(inFolder(written).toStdString()));
        waitUntilIdle();
        // Saved elsewhere it is proposed under the same name.
        QString proposed;
        answerDialog([&](QFileDialog& dialog) { proposed = dialog.selectedFiles().value(0); }, false);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(proposed, inFolder(QString(written).remove(".session").replace(".json", ".session.json")));
    }

    void aFileThatTheEndingMeetsIsAskedAbout() {
        const QString there = inFolder("Visit 1.2.session.json");
        QFile other(there);
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("other") == 5);
        other.close();
        // The dialog comes back with the whole name.
        QString proposed;
        QTimer::singleShot(0, this, [&] {
            answerDialog([&](QFileDialog& dialog) { proposed = dialog.selectedFiles().value(0); }, false);
            auto* line = fileDialog().findChild<QLineEdit*>("fileNameEdit");
            line->selectAll();
            QTest::keyClicks(line, "Visit 1.2");
            QTest::keyClick(line, Qt::Key_Return);
        });
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QCOMPARE(proposed, there);
        QVERIFY(!window().sessionKeeping().saving());
        QCOMPARE(bytesOf(there), QByteArray("other"));
    }

    void anotherStudyClosesTheDialog() {
        const QString other = file("other.mha", {smallPhantom(PhantomScene::fetus, 2)});
        bool closed = false;
        QTimer::singleShot(0, this, [&] {
            QFileDialog& dialog = fileDialog();
            QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
            window().open(other);
            QVERIFY(opened.wait(patience));
            closed = !dialog.isVisible();
            if (!closed) static_cast<QDialog&>(dialog).accept();
        });
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QVERIFY(closed);
        QVERIFY(!window().sessionKeeping().saving());
        QVERIFY(!QFile::exists(inFolder("heart.session.json")));
        waitUntilIdle();
    }

    void aFolderThatCannotBeWrittenToIsNotProposed_data() {
        QTest::addColumn<bool>("gone");
        QTest::newRow("read only") << false;
        QTest::newRow("gone") << true;
    }
    void aFolderThatCannotBeWrittenToIsNotProposed() {
        QFETCH(bool, gone);
        QVERIFY(QDir().mkpath(inFolder("disc")));
        const QString study = inFolder("disc/disc.mha");
        QVERIFY(QFile::rename(studyFile(), study));
        open(study);
        QFile folder(inFolder("disc"));
        if (gone)
            QVERIFY(QDir(folder.fileName()).removeRecursively());
        else
            QVERIFY(folder.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
        if (QFileInfo(folder.fileName()).isWritable()) QSKIP("the superuser writes into every folder");
        QString proposed;
        answerDialog([&](QFileDialog& dialog) { proposed = dialog.selectedFiles().value(0); }, false);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QCOMPARE(QFileInfo(proposed).fileName(), QString("disc.session.json"));
        QVERIFY2(QFileInfo(QFileInfo(proposed).absolutePath()).isWritable(), qPrintable(proposed));
    }

    void inTheSameWindowItsStrokesCutAgain() {
        work();
        const QString session = savedSession();
        QVERIFY(window().openStudy().volume()->isCut());
        const DataMask left = window().openStudy().volume()->dataMask();
        Document next = document();
        next.curves.linear.lower = 0.4;
        window().document().edit(next, "curve");
        waitUntilIdle();
        open(session);
        QVERIFY(window().openStudy().strokes() == document().scene.strokes);
        QCOMPARE(document().curves.linear.lower, 0.2);
        QVERIFY(window().openStudy().volume()->isCut());
        QVERIFY(window().openStudy().volume()->dataMask() == left);
    }

    void aSessionOfFourDimensionsOpensInItsPhase() {
        const QString study = fourPhases();
        open(study);
        Document next = document();
        next.scene.phase = 2;
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
            QVERIFY(window().otfs().of(PaneOtfs::adaptiveOfScene)->asked.raw == window().openStudy().rawVoxelsOf(1));
            QCOMPARE(child<QSlider>("motion.phase")->value(), 2);  // counted from 0
        }
    }

    void savingWaitsForTheChecksumAndCanBeCancelled() {
        openHeld("held.mha");
        const QString session = inFolder("held.session.json");
        QSignalSpy saved(&window().sessionKeeping(), &SessionKeeping::saved);
        window().sessionKeeping().saveAs(session);
        QTRY_COMPARE(child<QLabel>("status.activity")->text().contains("saving the session"), true);
        QTRY_VERIFY(child<QAbstractButton>("status.cancel")->isVisible());
        click("status.cancel");
        QTRY_VERIFY(message()->text().startsWith("Saving held.session.json was cancelled"));
        QVERIFY(!QFile::exists(session));
        window().sessionKeeping().saveAs(session);
        QVERIFY(window().sessionKeeping().saving());
        release();
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(!std::get<StudyFile>(readSession(session.toStdString()).value().document.study).checksum.empty());
        waitUntilIdle();
    }

    void anotherStudyEndsTheWaitAndTheWindowStays() {
        const QString session = savedSession();
        openHeld("held.mha");
        open(session);
        // The session's reading takes the checksum by itself: another file is what is held.
        window().open(file("third.mha", {smallPhantom(PhantomScene::fetus, 4)}));
        QTRY_VERIFY(window().openStudy().path().endsWith("third.mha") && window().openStudy().takingChecksum());
        Document next = document();
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        window().document().edit(next, "distance");
        const QString third = inFolder("third.session.json");
        QSignalSpy saved(&window().sessionKeeping(), &SessionKeeping::saved);
        window().sessionKeeping().saveAs(third, SessionKeeping::Then::closeWindow);
        QVERIFY(window().sessionKeeping().saving());
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        window().open(session);
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(window().isVisible());
        QCOMPARE(window().sessionKeeping().file(), session);
        QVERIFY(readSession(third.toStdString()).value().document.measurements == next.measurements);
        release();
        waitUntilIdle();
    }

    void whereNothingCanBeWrittenAnotherPlaceIsOffered() {
        work();
        const Document before = document();
        window().sessionKeeping().saveAs("/proc/heart.session.json");
        QTRY_VERIFY(message()->text().contains("could not be written"));
        QCOMPARE(message()->kind(), MessageKind::error);
        QVERIFY(document() == before);
        QTRY_VERIFY(window().isWindowModified());
        const QString elsewhere = inFolder("elsewhere.session.json");
        const QString proposed = chooseInMessage(elsewhere);
        QTRY_COMPARE(message()->text(), QString("The session was saved as elsewhere.session.json."));
        QCOMPARE(QFileInfo(proposed).fileName(), QString("heart.session.json"));
        QVERIFY(QFileInfo(QFileInfo(proposed).absolutePath()).isWritable());
        QVERIFY(readSession(elsewhere.toStdString()).value().document.scene.pose == before.scene.pose);
    }

    void itNeverTakesTheVolumesPlace() {
        const QByteArray before = bytesOf(studyFile());
        window().sessionKeeping().saveAs(studyFile());
        QTRY_VERIFY(message()->text().contains("would overwrite"));
        QCOMPARE(bytesOf(studyFile()), before);
    }

    void theSimulatedScanHasSessionsToo() {
        window().openSimulatedScan();
        QTRY_VERIFY_WITH_TIMEOUT(window().openStudy().isSimulatedScan() && window().idle(), 60000);
        Document next = document();
        next.scene.pose.magnification = 1.25;
        window().document().edit(next, "zoom");
        const QString session = inFolder("scan.session.json");
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
            // Where nothing is asked, it ends with this function.
            QTimer answering;
            answering.setSingleShot(true);
            connect(&answering, &QTimer::timeout, this, [&] {
                auto* box = window().findChild<QMessageBox*>("unsavedSession");
                if (box == nullptr) return;
                ++boxes;
                for (QAbstractButton* button : box->buttons())
                    if (button->text().remove('&').startsWith(answer)) return button->click();
            });
            answering.start(0);
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
        QVERIFY(readSession(session.toStdString()).value().document.scene.pose == document().scene.pose);
    }

    void closingWaitsForASessionThatIsBeingWritten() {
        work();
        typeIntoDialog("mine");
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QVERIFY(window().sessionKeeping().saving());
        QVERIFY(!window().close());
        QTRY_VERIFY(!window().isVisible());
        QVERIFY(nameless(readSession(inFolder("mine.session.json").toStdString()).value().document) ==
                nameless(document()));
        close();
        QVERIFY(autosaves().isEmpty());
    }

    void closingWaitsForTheChecksumToo() {
        openHeld("held.mha");
        const QString session = inFolder("held.session.json");
        window().sessionKeeping().saveAs(session);
        QVERIFY(!window().close());
        QVERIFY(!window().close());  // who is impatient loses nothing
        // What was changed since is asked about once the rest is written.
        lookFrom(window(), Viewpoint{.azimuthDegrees = 50});
        int asked = 0;
        connect(&window().sessionKeeping(), &SessionKeeping::saved, this, [&] {
            QTimer::singleShot(0, this, [&] {
                auto* box = window().findChild<QMessageBox*>("unsavedSession");
                if (box == nullptr) return;
                ++asked;
                box->reject();
            });
        });
        release();
        QTRY_COMPARE(asked, 1);
        QVERIFY(window().isVisible());
        QVERIFY(QFile::exists(session));
        waitUntilIdle();
        window().sessionKeeping().save();
        QVERIFY(!window().close());
        QTRY_VERIFY(!window().isVisible());
        QVERIFY(nameless(readSession(session.toStdString()).value().document) == nameless(document()));
    }

    void theWindowStaysWhereWhatItWaitsForIsCancelledOrFails() {
        openHeld("held.mha");
        window().sessionKeeping().saveAs(inFolder("held.session.json"));
        QVERIFY(!window().close());
        click("status.cancel");
        QVERIFY(message()->text().contains("was cancelled"));
        release();
        waitUntilIdle();
        QVERIFY(window().isVisible());
        window().sessionKeeping().saveAs("/proc/held.session.json");
        QVERIFY(!window().close());
        QTRY_VERIFY(message()->text().contains("could not be written"));
        QVERIFY(window().isVisible());
        // The next session is not what the window closes after.
        (void)savedSession("held.session.json");
        QVERIFY(window().isVisible());
    }

private:
    QString fourPhases() {
        std::vector<std::shared_ptr<const Volume>> phases;
        for (int phase = 0; phase < 4; ++phase)
            phases.push_back(smallPhantom(PhantomScene::shapes, static_cast<std::uint64_t>(phase)));
        return file("four.mha", phases);
    }
};

ECHOLUCENT_TEST_CLASS(TestMainWindowSessions)

#include "test_main_window_sessions.moc"
