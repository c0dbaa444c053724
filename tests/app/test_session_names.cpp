// Numbers where names would be shown: sessions have that of their study, and what was on the screen keeps no name.
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>

#include "tests/app/session_fixture.h"
#include "tests/app/telling_names.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestSessionNames : public QObject, private SessionFixture {
    Q_OBJECT

    [[nodiscard]] QMenu& recentMenu() {
        auto* menu = child<QMenu>("file.recent");
        emit menu->aboutToShow();
        return *menu;
    }
    [[nodiscard]] QStringList recent() {
        QStringList texts;
        for (const QAction* action : recentMenu().actions())
            if (action->objectName() != "file.recent.clear" && !action->isSeparator()) texts << action->text();
        return texts;
    }
    void showNumbers() {
        auto* numbers = child<QAction>("view.numbersForNames");
        if (!numbers->isChecked()) numbers->trigger();
    }
    /// All that the program shows now and that holds one of the names.
    [[nodiscard]] static QString told() {
        QStringList found;
        const QStringList words = allWords();
        for (const char* name : {"jane", "doe", "roe", "muster"})
            found << words.filter(
                QRegularExpression(QString("\\b%1\\b").arg(name), QRegularExpression::CaseInsensitiveOption));
        return found.join('\n');
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { begin("Jane Doe 1980.mha"); }
    void cleanup() { close(); }

    void aSessionHasTheNumberOfItsStudy_data() {
        QTest::addColumn<bool>("before");
        QTest::newRow("numbers are shown when it is saved") << true;
        QTest::newRow("names are shown when it is saved") << false;
    }
    void aSessionHasTheNumberOfItsStudy() {
        QFETCH(bool, before);
        if (before) showNumbers();
        open(file("other.mha", {smallPhantom(PhantomScene::fetus, 2)}));
        open(studyFile());
        const QString session = savedSession("Jane Doe 1980.session.json");
        showNumbers();
        const QStringList expected{"&1  Study 1 (session)", "&2  Study 1", "&3  Study 2"};
        QCOMPARE(recent(), expected);
        window().close();
        close();
        showAgain();
        open(session);
        QCOMPARE(recent(), expected);
        QVERIFY2(window().windowTitle().contains("Study 1 "), qPrintable(window().windowTitle()));
        QCOMPARE(told(), QString());
        // A session that does not open is called by the same number.
        QFile file(session);
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write("{\"format\": \"echolucent-document\", \"version\": 99}");
        file.close();
        window().open(session);
        QTRY_VERIFY2(message()->text().startsWith("Study 1 (session): "), qPrintable(message()->text()));
        // The settings keep names in the list of recent files, and nowhere else.
        recentMenu().findChild<QAction*>("file.recent.clear")->trigger();
        window().close();
        close();
        const QByteArray settings = bytesOf(settingsFile());
        QVERIFY(settings.contains("numbersForNames=true"));
        QVERIFY2(!settings.contains("Jane") && !settings.contains("Doe"), settings.constData());
    }

    void messagesOfSessionsTellNoName() {
        showNumbers();
        work();
        const QString session = inFolder("Jane Doe 1980.session.json");
        QString proposed;
        answerDialog([&](QFileDialog& dialog) { proposed = dialog.selectedFiles().value(0); }, true);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
        QCOMPARE(proposed, inFolder("study-1.session.json"));
        QTRY_COMPARE(message()->text(), QString("The session was saved as Study 1 (session)."));
        waitUntilIdle();
        (void)savedSession("Jane Doe 1980.session.json");
        QCOMPARE(message()->text(), QString("The session was saved as Study 1 (session)."));
        QCOMPARE(told(), QString());

        // Saved under another name it is called by its number as well.
        answerDialog([&](QFileDialog& dialog) { proposed = dialog.selectedFiles().value(0); }, false);
        QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(proposed, inFolder("study-1.session.json"));

        window().sessionKeeping().saveAs(studyFile());
        QTRY_VERIFY2(message()->text().startsWith("Study 1: would overwrite"), qPrintable(message()->text()));
        QCOMPARE(told(), QString());
        window().sessionKeeping().saveAs("/proc/Jane Doe.session.json");
        QTRY_VERIFY2(message()->text().startsWith("*.json: could not be written"), qPrintable(message()->text()));
        QCOMPARE(told(), QString());

        lookFrom(window(), Viewpoint{.azimuthDegrees = 50});
        QString asked, toldThere;
        QTimer::singleShot(0, this, [&] {
            auto* box = window().findChild<QMessageBox*>("unsavedSession");
            if (box == nullptr) return;
            asked = box->text();
            toldThere = told();
            box->reject();
        });
        QVERIFY(!window().close());
        QCOMPARE(asked, QString("Study 1 (session) was changed and is not saved."));
        QCOMPARE(toldThere, QString());
        QVERIFY(QFile::exists(session));

        openHeld("Muster.mha");
        window().sessionKeeping().saveAs(inFolder("Muster.session.json"));
        window().sessionKeeping().cancelSaving();
        QCOMPARE(message()->text(), QString("Saving *.json was cancelled; it is as it was."));
        release();
        waitUntilIdle();
        QCOMPARE(told(), QString());
    }

    void whatWasLeftIsOfferedByANumber() {
        showNumbers();
        work();
        window().close();
        close();
        showAgain();
        open(file("other.mha", {smallPhantom(PhantomScene::fetus, 2)}));
        QTRY_VERIFY2(message()->text().startsWith("A session of Study 1 was left unsaved ("),
                     qPrintable(message()->text()));
        QCOMPARE(told(), QString());
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        waitUntilIdle();
        QVERIFY2(window().windowTitle().contains("Study 1 "), qPrintable(window().windowTitle()));
        QCOMPARE(recent().value(0), QString("&1  Study 1"));
        QCOMPARE(told(), QString());
    }

    void whatIsOnTheScreenKeepsNoName_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("said");
        QTest::newRow("a curve") << "Richard Roe 7.json"
                                 << "The adaptive curve was saved as *.json (256 nodes).";
        QTest::newRow("without an ending") << "Richard Roe"
                                           << "The adaptive curve was saved as … (256 nodes).";
        QTest::newRow("a word") << "roe"
                                << "The adaptive curve was saved as … (256 nodes).";
        QTest::newRow("a session") << "Richard Roe.session.json"
                                   << "The session was saved as Study 1 (session).";
        QTest::newRow("a folder that is not there") << "Jane Doe/Richard Roe.json"
                                                    << "*.json: could not be written";
        QTest::newRow("a session whose study is missing") << "roe.session.json"
                                                          << "Study 2, the volume of this session, was not found.";
        QTest::newRow("a file that is no volume") << "Richard Roe"
                                                  << "Study 2: ";
    }
    void whatIsOnTheScreenKeepsNoName() {
        QFETCH(QString, file);
        QFETCH(QString, said);
        const QString path = inFolder(file);
        const QString row = QTest::currentDataTag();
        if (row.endsWith("missing")) {
            SavedSession session{.document = document(), .snapshots = {}, .file = {}};
            session.document.study = StudyFile{.path = "roe", .options = {}, .checksum = {}, .bytes = 1};
            QVERIFY(writeSession(path.toStdString(), session).has_value());
            window().open(path);
        } else if (row.endsWith("volume")) {
            QFile other(path);
            QVERIFY(other.open(QIODevice::WriteOnly) && other.write("no volume") > 0);
            other.close();
            window().open(path);
        } else if (row.endsWith("session")) {
            window().sessionKeeping().saveAs(path);
        } else {
            (void)window().saveCurve(path);
        }
        QTRY_VERIFY2(!message()->text().isEmpty(), qPrintable(row));
        waitUntilIdle();
        (void)recentMenu();
        QVERIFY(!told().isEmpty());  // so that the search is seen to find
        const QString named = message()->text();
        showNumbers();
        QVERIFY2(message()->text().startsWith(said), qPrintable(message()->text()));
        QCOMPARE(told(), QString());
        // It is the same message that bears its names again.
        child<QAction>("view.numbersForNames")->trigger();
        QCOMPARE(message()->text(), named);
        // What was taken away leaves nothing either.
        QTest::mouseClick(child<QAbstractButton>("message.close"), Qt::LeftButton);
        showNumbers();
        QCOMPARE(told(), QString());
    }
};

ECHOLUCENT_TEST_CLASS(TestSessionNames)

#include "test_session_names.moc"
