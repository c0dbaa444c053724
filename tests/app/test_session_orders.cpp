// Sessions on their way to their files, and what comes in between: other studies, other sessions, files that somebody
// else wrote, and places that cannot be written to.
#include <QDateTime>
#include <QMessageBox>

#include "app/settings/settings.h"
#include "tests/app/session_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestSessionOrders : public QObject, private SessionFixture {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() {
        m_said.clear();
        begin();
    }
    void cleanup() {
        release();
        close();
    }

    void theSameStudyOpenedAgainHasNotTheFileOfTheSessionBefore() {
        openHeld("held.mha");
        measure();
        const QString session = inFolder("held.session.json");
        QSignalSpy saved(&keeping(), &SessionKeeping::saved);
        keeping().saveAs(session, SessionKeeping::Then::closeWindow);
        QVERIFY(keeping().saving());
        const std::vector<Measurement> measurements = document().measurements;
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        window().open(inFolder("held.mha"));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(window().isVisible());
        QVERIFY(document().measurements.empty());
        QCOMPARE(keeping().file(), QString());
        QVERIFY(readSession(session.toStdString()).value().document.measurements == measurements);
    }

    void twoFilesThatAreAskedForAreBothWritten() {
        openHeld("held.mha");
        measure();
        QSignalSpy saved(&keeping(), &SessionKeeping::saved);
        for (const QString name : {"one.session.json", "two.session.json", "one.session.json"})
            keeping().saveAs(inFolder(name));
        release();
        QTRY_COMPARE(saved.count(), 2);
        waitUntilIdle();
        QCOMPARE(saved.count(), 2);
        QCOMPARE(keeping().file(), inFolder("one.session.json"));
        for (const QString name : {"one.session.json", "two.session.json"})
            QVERIFY(nameless(readSession(inFolder(name).toStdString()).value().document) == nameless(document()));
    }

    void whatIsBeingSavedIsNotOfferedAsLeft() {
        openHeld("held.mha");
        measure();
        const QString session = inFolder("held.session.json");
        QSignalSpy saved(&keeping(), &SessionKeeping::saved);
        message()->installEventFilter(this);
        keeping().saveAs(session);
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        window().open(studyFile());
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        QTRY_COMPARE(saved.count(), 1);
        release();
        waitUntilIdle();
        QVERIFY2(m_said.filter("was left unsaved").isEmpty(), qPrintable(m_said.join('|')));
        QVERIFY2(autosaves().isEmpty(), qPrintable(autosaves().join(' ')));
        window().open(inFolder("held.mha"));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 2, patience);
        waitUntilIdle();
        QVERIFY2(m_said.filter("was left unsaved").isEmpty(), qPrintable(m_said.join('|')));
    }

    void whatCouldNotBeSavedIsOfferedElsewhereThoughAnotherStudyIsOpen() {
        openHeld("held.mha");
        measure();
        const Document left = document();
        keeping().saveAs("/proc/held.session.json");
        QVERIFY(keeping().saving());
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        window().open(studyFile());
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        QTRY_VERIFY(message()->text().contains("could not be written"));
        release();
        waitUntilIdle();
        QCOMPARE(autosaves().size(), 1);  // until it is saved
        const QString elsewhere = inFolder("elsewhere.session.json");
        const QString proposed = chooseInMessage(elsewhere);
        QTRY_COMPARE(message()->text(), QString("The session was saved as elsewhere.session.json."));
        QCOMPARE(QFileInfo(proposed).fileName(), QString("held.session.json"));
        QVERIFY(nameless(readSession(elsewhere.toStdString()).value().document) == nameless(left));
        QCOMPARE(keeping().file(), QString());
        QTRY_VERIFY2(autosaves().isEmpty(), qPrintable(autosaves().join(' ')));
    }

    /// The settings bring a look of their own, of which no session was made.
    void aSessionThatIsOpenedFirstLeavesNothingBehind() {
        const QString session = savedSession();
        close();
        Look brighter;
        brighter.brightness = 1.7;
        Settings(settingsFile()).setLook(brighter);
        showAgain();
        QVERIFY(document().scene.look != Look{});  // else the test would show nothing
        open(session);
        QVERIFY2(!message()->text().contains("was left unsaved"), qPrintable(message()->text()));
        QVERIFY2(autosaves().isEmpty(), qPrintable(autosaves().join(' ')));
    }

    void aFileThatSomebodyElseSavedSinceIsReplacedOnlyWhenToldTo() {
        const QString session = savedSession();
        SavedSession theirs = readSession(session.toStdString()).value();
        theirs.document.motion.speed = 0.5;
        QVERIFY(writeSession(session.toStdString(), theirs).has_value());
        setTime(session, QDateTime::currentDateTime().addSecs(5));
        const QByteArray before = bytesOf(session);
        measure();
        answerBox("newerSession", QMessageBox::RejectRole);
        keeping().save();
        waitUntilIdle();
        QVERIFY(bytesOf(session) == before);
        QTRY_VERIFY(window().isWindowModified());
        answerBox("newerSession", QMessageBox::AcceptRole);
        QSignalSpy saved(&keeping(), &SessionKeeping::saved);
        keeping().save();
        QTRY_COMPARE(saved.count(), 1);
        waitUntilIdle();
        QVERIFY(readSession(session.toStdString()).value().document.measurements == document().measurements);
        measure();
        keeping().save();  // nobody is asked: what is there was written here
        QTRY_COMPARE(saved.count(), 2);
        waitUntilIdle();
    }

    void whatAnEarlierRunLeftReplacesNoNewerFile() {
        const QString session = savedSession();
        SavedSession left = readSession(session.toStdString()).value();
        left.file = session.toStdString();
        left.document.measurements.push_back({.id = 7, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        const QString folder = temporaryFolder().filePath("settings-data/autosaves");
        close();
        QVERIFY(QDir().mkpath(folder));
        const QString file = folder + "/100-dead.autosave.json";
        QVERIFY(writeSession(file.toStdString(), left).has_value());
        setTime(file, QDateTime::currentDateTime().addSecs(-3600));
        const QByteArray before = bytesOf(session);
        showAgain();
        open(studyFile());
        QTRY_VERIFY2(message()->text().contains("was left unsaved"), qPrintable(message()->text()));
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        waitUntilIdle();
        QCOMPARE(keeping().file(), session);
        answerBox("newerSession", QMessageBox::RejectRole);
        keeping().save();
        waitUntilIdle();
        QVERIFY(bytesOf(session) == before);
    }

    void theRecentFilesShowThePictureOfASessionOnceItIsSaved() {
        const QString pictures = temporaryFolder().filePath("settings-data/recent");
        // A study whose picture is fine leaves a small one.
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(pictures).entryList({"*.png"}, QDir::Files).isEmpty(), patience);
        savedSession();
        QTRY_COMPARE(QDir(pictures).entryList({"*.png"}, QDir::Files).size(), 2);  // the volume's and the session's
    }

protected:
    /// Keeps every sentence that the bar of messages showed.
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint || event->type() == QEvent::Show) m_said << message()->text();
        return QObject::eventFilter(watched, event);
    }

private:
    SessionKeeping& keeping() { return window().sessionKeeping(); }
    /// One distance more.
    void measure() {
        Document next = document();
        next.measurements.push_back(
            {.id = static_cast<int>(next.measurements.size()) + 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        window().document().edit(next, "distance");
    }
    static void setTime(const QString& path, const QDateTime& time) {
        QFile file(path);
        if (!file.open(QIODevice::ReadWrite) || !file.setFileTime(time, QFileDevice::FileModificationTime))
            qFatal("%s keeps its time", qPrintable(path));
    }
    /// The first button of a role in the box that the next event opens.
    void answerBox(const QString& name, QMessageBox::ButtonRole role) {
        QTimer::singleShot(0, &window(), [name, role] {
            for (QWidget* each : QApplication::topLevelWidgets()) {
                auto* box = qobject_cast<QMessageBox*>(each);
                if (box == nullptr || box->objectName() != name) continue;
                for (QAbstractButton* button : box->buttons())
                    if (box->buttonRole(button) == role) return QTest::mouseClick(button, Qt::LeftButton);
            }
            qFatal("there is no box %s", qPrintable(name));
        });
    }

    QStringList m_said;
};

ECHOLUCENT_TEST_CLASS(TestSessionOrders)

#include "test_session_orders.moc"
