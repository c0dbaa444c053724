// The history of steps and snapshots, and what is kept of a session that nobody saved.
#include <QAction>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <atomic>
#include <thread>

#include "app/sessions/leftovers.h"
#include "app/sessions/session_keeping.h"
#include "io/document/session_file.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

class TestMainWindowHistory : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAlongAssumedBeam();
        lookAtNoPicture();
        QLocale::setDefault(QLocale::c());
        m_file = file("heart.mha", {smallPhantom(PhantomScene::shapes, 5)});
    }
    void init() {
        show();
        keeping().autosave().setInterval(50);
        useLook(Look{});
        open(m_file);
    }
    void cleanup() { close(); }

    void aClickInTheListOfStepsGoesThere() {
        std::vector<Document> states{document()};
        for (const double azimuth : {20.0, 40.0, 60.0}) {
            lookFrom(window(), Viewpoint{.azimuthDegrees = azimuth});
            states.push_back(document());
        }
        openHistory();
        auto* list = child<QListView>("history.list");
        QCOMPARE(list->model()->rowCount(), 4);
        for (const int row : {1, 3, 0}) {
            clickRow(*list, row);
            QCOMPARE(list->currentIndex().row(), row);
            QCOMPARE(document().scene.pose, states[static_cast<std::size_t>(row)].scene.pose);
        }
        waitUntilIdle();
    }

    void snapshotsAreKeptChosenRenamedAndRemoved() {
        openHistory();
        lookFrom(window(), Viewpoint{.azimuthDegrees = 30});
        const Document kept = document();
        click("history.keep");
        auto* list = child<QListWidget>("history.snapshots");
        QCOMPARE(list->count(), 1);
        auto* name = list->findChild<QWidget*>("qt_editing_widget");
        if (name == nullptr) name = list->viewport()->findChild<QLineEdit*>();
        QVERIFY(name != nullptr);
        QTest::keyClicks(name, "four chambers");
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_COMPARE(QString::fromStdString(keeping().snapshots().list().front().name), QString("four chambers"));
        QTRY_VERIFY(window().isWindowModified());
        lookFrom(window(), Viewpoint{.azimuthDegrees = 90});
        const Document later = document();
        const int steps = window().document().steps().count();
        clickRow(*list, 0);
        QVERIFY(document() == kept);
        QCOMPARE(window().document().steps().count(), steps + 1);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(document() == later);
        click("history.remove");
        QCOMPARE(list->count(), 0);
        QCOMPARE(child<QAbstractButton>("message.action.0")->text(), "Bring back");
        click("message.action.0");
        QCOMPARE(list->count(), 1);
        QVERIFY(keeping().snapshots().list().front().document == kept);
        waitUntilIdle();
    }

    void nothingIsWrittenWhileNothingChanges() {
        QSignalSpy written(&keeping().autosave(), &Autosave::written);
        QTRY_VERIFY(window().sessionKeeping().atRest());  // so that nothing is about to be written
        QVERIFY(written.isEmpty());
        QVERIFY(files().isEmpty());
        Document next = document();
        next.scene.pose.magnification = 1.5;
        window().document().preview(next, "drag");  // a drag that goes on
        QTRY_COMPARE(written.count(), 1);
        QCOMPARE(files().size(), 1);
        const auto kept = readSession(path(files().first()).toStdString());
        QVERIFY(kept && kept->document.scene.pose == next.scene.pose);
        QTRY_VERIFY(keeping().atRest());
        QCOMPARE(written.count(), 1);
        window().document().cancelPreview();
        waitUntilIdle();
    }

    void theFrameOfAMotionAloneIsNotWrittenAgain() {
        QSignalSpy written(&keeping().autosave(), &Autosave::written);
        lookFrom(window(), Viewpoint{.azimuthDegrees = 30});
        QTRY_COMPARE(written.count(), 1);
        window().motionPlayer().setAngle(9);
        QCOMPARE(document().scene.motionAngle, 9);
        QTRY_VERIFY(keeping().atRest());
        QCOMPARE(written.count(), 1);
        waitUntilIdle();
    }

    /// What is opened is on disk until it is kept anew, whatever else is written meanwhile.
    void aLeftoverStaysUntilItIsKeptAnew() {
        leave("100-dead");
        close();
        startAgain();
        open(m_file);
        QTRY_VERIFY(message()->text().startsWith("A session of"));
        keeping().autosave().setInterval(600'000);
        measure();
        QSignalSpy written(&keeping().autosave(), &Autosave::written);
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        QTRY_COMPARE(written.count(), 1);  // what was left for it
        QCOMPARE(files().size(), 2);
        QVERIFY(files().contains("100-dead.autosave.json"));
        waitUntilIdle();
    }

    void aCurveDrawnByHandIsWorkOfALeftover() {
        Document next = document();
        next.curves.manual.nodes = {{0.1, 0}, {0.4, 0.7}, {1, 0.2}};
        QVERIFY(QDir().mkpath(folder()));
        QVERIFY(writeSession(path("100-dead.autosave.json").toStdString(), SavedSession{.document = next}).has_value());
        close();
        startAgain();
        open(m_file);
        QTRY_VERIFY(message()->text().startsWith("A session of"));
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        waitUntilIdle();
        QVERIFY(document().curves.manual == next.curves.manual);
        QVERIFY(window().otfEditor().isManualModified());
        QVERIFY(window().isWindowModified());
        QTRY_VERIFY(!files().contains("100-dead.autosave.json") && files().size() == 1);
        close();
        QCOMPARE(files().size(), 1);
        QVERIFY(readSession(path(files().first()).toStdString()).value().document.curves.manual == next.curves.manual);
    }

    void whatASessionTakesThePlaceOfIsLeftBehind() {
        const QString session = temporaryFolder().filePath("plain.session.json");
        QVERIFY(writeSession(session.toStdString(), SavedSession{.document = document()}).has_value());
        Document next = document();
        next.curves.manual.nodes = {{0.1, 0}, {0.4, 0.7}, {1, 0.2}};
        window().document().edit(next, "draw");
        open(session);
        QVERIFY(document().curves.manual != next.curves.manual);
        QTRY_VERIFY2(message()->text().startsWith("A session of heart.mha was left unsaved"),
                     qPrintable(message()->text()));
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        waitUntilIdle();
        QVERIFY(document().curves.manual == next.curves.manual);
    }

    void whatACrashLeftIsOfferedAndOpens() {
        const Document left = leave("100-dead");
        close();
        startAgain();
        QSignalSpy computed(&window().otfs(), &PaneOtfs::computed);
        window().open(m_file);
        QVERIFY(computed.wait(patience));
        waitUntilIdle();
        QTRY_VERIFY2(message()->text().startsWith("A session of heart.mha was left unsaved ("),
                     qPrintable(message()->text()));
        computed.clear();
        click("message.action.0");
        QVERIFY(computed.wait(patience));
        waitUntilIdle();
        QVERIFY(document().scene.pose == left.scene.pose);
        QVERIFY(document().measurements == left.measurements);
        QVERIFY(window().isWindowModified());
        // Kept anew before the old one goes.
        QTRY_VERIFY(!files().contains("100-dead.autosave.json") && files().size() == 1);
    }

    void itIsDiscardedOnlyWhenToldSo() {
        leave("100-dead");
        close();
        startAgain();
        open(m_file);
        QTRY_VERIFY(message()->text().startsWith("A session of"));
        QVERIFY(files().contains("100-dead.autosave.json"));
        click("message.action.1");
        QVERIFY(files().isEmpty());
        QVERIFY(!child<QMenu>("file.leftUnsaved")->menuAction()->isEnabled());
    }

    void itIsOfferedOnceAndStandsInTheMenu() {
        leave("100-dead");
        leave("200-dead");
        // The menu begins with the oldest, and files written at once may have one time.
        QFile older(path("100-dead.autosave.json"));
        QVERIFY(older.open(QIODevice::ReadWrite));
        QVERIFY(older.setFileTime(QDateTime::currentDateTime().addSecs(-60), QFileDevice::FileModificationTime));
        older.close();
        close();
        startAgain();
        message()->setConfirmationMilliseconds(0);
        open(m_file);
        QTRY_COMPARE(left().size(), std::size_t{2});
        QTRY_VERIFY(message()->text().isEmpty());  // it leaves by itself
        auto* menu = child<QMenu>("file.leftUnsaved");
        QCOMPARE(menu->title(), QString("Left &unsaved (2)"));
        message()->setConfirmationMilliseconds(600'000);
        open(file("other.mha", {smallPhantom(PhantomScene::fetus, 2)}));
        QVERIFY2(!message()->text().contains("left unsaved"), qPrintable(message()->text()));
        emit menu->aboutToShow();
        QVERIFY2(child<QMenu>("file.leftUnsaved.1")->title().startsWith("heart.mha, "),
                 qPrintable(child<QMenu>("file.leftUnsaved.1")->title()));
        child<QAction>("file.leftUnsaved.1.discard")->trigger();
        QCOMPARE(menu->title(), QString("Left &unsaved (1)"));
        QTRY_COMPARE(files(), QStringList{"200-dead.autosave.json"});
        emit menu->aboutToShow();
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        child<QAction>("file.leftUnsaved.1.open")->trigger();
        // The session is called by its study, not by the file that the program keeps.
        QVERIFY2(window().windowTitle().contains("opening heart.mha"), qPrintable(window().windowTitle()));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        waitUntilIdle();
        QVERIFY(left().empty());
        QCOMPARE(document().measurements.size(), std::size_t{1});
    }

    void whatIsPutAwayDoesNotComeBack() {
        leave("100-dead");
        close();
        for (const bool again : {false, true}) {
            startAgain();
            open(m_file);
            QTRY_COMPARE(left().size(), std::size_t{1});
            if (!again) {
                QTRY_VERIFY(message()->text().contains("left unsaved"));
                click("message.close");
            }
            waitUntilIdle();
            QVERIFY2(message()->text().isEmpty(), qPrintable(message()->text()));
            QVERIFY(child<QMenu>("file.leftUnsaved")->menuAction()->isEnabled());
            window().close();
            close();
            QVERIFY(files().contains("100-dead.autosave.json"));
        }
    }

    /// A program that ends at once must not keep what was discarded while it was still being written.
    void whatIsDiscardedIsGoneThoughTheProgramEnds() {
        Document next = document();
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        window().document().edit(next, "distance");
        waitUntilIdle();
        std::atomic<bool> held = true;
        keeping().autosave().setWrite([&held](const std::string& where, const SavedSession& session) {
            while (held) std::this_thread::yield();
            return writeSession(where, session);
        });
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        window().open(file("other.mha", {smallPhantom(PhantomScene::fetus, 2)}));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
        QCOMPARE(left().size(), std::size_t{1});
        keeping().leftUnsaved().discard(left().front().file);
        held = false;
        close();
        QVERIFY2(files().isEmpty(), qPrintable(files().join(' ')));
    }

    void aDamagedOneIsSaidAndPutAside() {
        close();
        QVERIFY(QDir().mkpath(folder()));
        QFile damaged(path("1-bad.autosave.json"));
        QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write("{\"format\": \"echolucent-docu") > 0);
        damaged.close();
        QFile half(path("1-bad.autosave.json.a1B2c3"));
        QVERIFY(half.open(QIODevice::WriteOnly));
        half.close();
        startAgain();
        open(m_file);
        QTRY_VERIFY2(message()->text().contains("is damaged and was put aside"), qPrintable(message()->text()));
        QVERIFY(QFile::exists(path("1-bad.autosave.json.damaged")));
        QVERIFY(files().isEmpty());
        QVERIFY(!QFile::exists(path("1-bad.autosave.json.a1B2c3")));
    }

    void twoRunningProgramsLeaveEachOtherAlone() {
        Document next = document();
        next.scene.pose.magnification = 1.5;
        QSignalSpy written(&keeping().autosave(), &Autosave::written);
        window().document().edit(next, "zoom");
        QTRY_COMPARE(written.count(), 1);
        QCOMPARE(files().size(), 1);
        QVERIFY(takeLeftovers(folder()).empty());
    }

    void workThatIsLeftForAnotherStudyIsOfferedAgain() {
        Document next = document();
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        window().document().edit(next, "distance");
        waitUntilIdle();
        open(file("other.mha", {smallPhantom(PhantomScene::fetus, 2)}));
        QTRY_VERIFY2(message()->text().startsWith("A session of heart.mha was left unsaved"),
                     qPrintable(message()->text()));
        click("message.action.0");
        QTRY_COMPARE_WITH_TIMEOUT(window().openStudy().path(), m_file, patience);
        waitUntilIdle();
        QVERIFY(document().measurements == next.measurements);
    }

    void workStaysWhereTheWindowClosesAtOnce() {
        keeping().autosave().setInterval(600'000);
        Document next = document();
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        window().document().edit(next, "distance");
        QVERIFY(files().isEmpty());
        window().close();
        close();
        QCOMPARE(files().size(), 1);
        const auto kept = readSession(path(files().first()).toStdString());
        QVERIFY(kept && kept->document.measurements == next.measurements);
    }

    void lookingAroundLeavesNothingBehind() {
        lookFrom(window(), Viewpoint{.azimuthDegrees = 30});
        QTRY_COMPARE(files().size(), 1);
        window().close();
        close();
        QVERIFY(files().isEmpty());
    }

private:
    [[nodiscard]] const Document& document() { return window().document().document(); }
    SessionKeeping& keeping() { return window().sessionKeeping(); }
    const std::deque<Leftover>& left() { return keeping().leftUnsaved().list(); }
    MessageBar* message() { return child<MessageBar>("message"); }
    QString folder() { return temporaryFolder().filePath("settings-data/autosaves"); }
    QString path(const QString& name) { return folder() + '/' + name; }
    QStringList files() { return QDir(folder()).entryList({"*.autosave.json"}, QDir::Files); }
    void measure() {
        Document next = document();
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        window().document().edit(next, "distance");
    }
    void openHistory() {
        QTest::keyClick(&window(), Qt::Key_H, Qt::ControlModifier);
        QTRY_VERIFY(child<QWidget>("history.list")->isVisible());
        QVERIFY(child<QWidget>("dock.study")->width() <= 345);
    }
    static void clickRow(QAbstractItemView& list, int row) {
        const QModelIndex index = list.model()->index(row, 0);
        list.scrollTo(index);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualRect(index).center());
    }
    /// What a program that died while a person measured would have left.
    Document leave(const QString& name) {
        Document next = document();
        next.measurements.push_back({.id = 1, .placesMm = {{10, 12, 14}, {30, 20, 14}}});
        next.scene.pose.magnification = 1.5;
        if (!QDir().mkpath(folder()) ||
            !writeSession(path(name + ".autosave.json").toStdString(), SavedSession{.document = next}))
            qFatal("cannot write");
        return next;
    }
    /// As after a start: what the run before left stays.
    void startAgain() {
        showAgain();
        keeping().autosave().setInterval(50);
        useLook(Look{});
    }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowHistory)

#include "test_main_window_history.moc"
