// The program is killed at random moments while a hand drags and saves: what is on disk is whole, and newer than the
// bound, counted by the program's own clock. Every run kills it 3 times, the long one 12 times, ECHOLUCENT_KILLS=200 as
// often as that. Of three kills one comes at any moment, one once an autosave was there and one once a session was
// saved.
#include <QCryptographicHash>
#include <QDeadlineTimer>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTextStream>
#include <QTimer>
#include <csignal>
#include <cstdio>
#include <random>

#include "app/sessions/autosave.h"
#include "app/sessions/session_keeping.h"
#include "io/document/session_file.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

constexpr int interval = 800;  // ms
/// So many whole intervals of the killed program's own clock lie within 10 s at the interval that it is delivered with.
constexpr int bound = 10'000 / Autosave::standardIntervalMilliseconds;
/// What the program tells beside its changes.
constexpr const char *intervalOver = "interval", *writingBegins = "begins", *written = "written",
                     *savingBegins = "saving", *saved = "saved";
/// What a hand does beside dragging. What is saved by hand is kept by Autosave no longer.
enum class Hand { savesToo, onlyDrags };
constexpr const char* neverSaves = "never-saves";

/// A document by what a hand changes of it: the study's path is another one in each file.
QByteArray fingerprint(Document document) {
    document.study = {};
    const std::string text = jsonOf(document);
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Md5).toHex();
}

/// Drags, saves where the hand does, and tells every change on stdout, until it is killed.
class SessionUntilKilled : public QObject {
public:
    SessionUntilKilled(const QString& folder, unsigned seed, Hand hand)
        : m_window(folder + "/settings.ini"), m_random(seed), m_folder(folder), m_hand(hand) {
        m_window.resize(700, 520);
        Autosave& autosave = m_window.sessionKeeping().autosave();
        autosave.setInterval(interval);
        connect(&m_window.works(), &Works::changed, this, [&autosave, writes = false]() mutable {
            if (!std::exchange(writes, autosave.busy()) && writes) say(writingBegins);
        });
        connect(&autosave, &Autosave::written, this, [] { say(written); });
        connect(&m_window.sessionKeeping(), &SessionKeeping::saved, this, [] { say(saved); });
        connect(&m_clock, &QTimer::timeout, this, [] { say(intervalOver); });
        m_clock.start(interval);
        Document plain = m_window.document().document();
        plain.scene.look = Look{};
        m_window.document().begin(plain);
        connect(&m_window.otfs(), &PaneOtfs::computed, this, [this] {
            if (std::exchange(m_begun, true)) return;
            connect(&m_window.document(), &DocumentModel::changed, this, &SessionUntilKilled::tell);
            connect(&m_timer, &QTimer::timeout, this, &SessionUntilKilled::act);
            m_timer.start(15);
        });
        m_window.show();
        m_window.open(folder + "/scan.mha");
    }

private:
    static void say(const char* line) {
        std::printf("%s\n", line);
        std::fflush(stdout);
    }
    void tell() { say(fingerprint(m_window.document().document()).constData()); }
    void act() {
        QWindow* picture = m_window.windowHandle()->findChild<QWindow*>("view3d.surface");
        const auto place = [this] {
            return QPoint(60 + static_cast<int>(m_random() % 150), 60 + static_cast<int>(m_random() % 150));
        };
        switch (m_step++ % 12) {
            case 0: return QTest::mousePress(picture, Qt::LeftButton, {}, place());
            case 10: return QTest::mouseRelease(picture, Qt::LeftButton, {}, place());
            case 11:
                if (m_hand == Hand::onlyDrags || m_random() % 6 != 0) return;
                if (!m_window.sessionKeeping().saving()) say(savingBegins);
                m_window.sessionKeeping().saveAs(m_folder + "/scan.session.json");
                return;
            default: {
                QMouseEvent move(QEvent::MouseMove, QPointF(place()), picture->mapToGlobal(QPointF(place())),
                                 Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
                QCoreApplication::sendEvent(picture, &move);
            }
        }
    }

    MainWindow m_window;
    std::mt19937 m_random;
    QString m_folder;
    Hand m_hand;
    QTimer m_timer, m_clock;
    int m_step = 0;
    bool m_begun = false;
};

constexpr const char* sessionUntilKilled = "--session-until-killed";
[[maybe_unused]] const bool sessionIsRegistered =
    drivenPrograms()
        .try_emplace(sessionUntilKilled,
                     DrivenProgram{{},
                                   [](const QStringList& words) {
                                       const Hand hand =
                                           words.value(3) == neverSaves ? Hand::onlyDrags : Hand::savesToo;
                                       const SessionUntilKilled session(words.at(1), words.at(2).toUInt(), hand);
                                       return QApplication::exec();
                                   }})
        .second;

}  // namespace

class TestSessionKill : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { m_scan = file("scan.mha", {smallPhantom(PhantomScene::shapes, 5)}); }
    void whatIsOnDiskIsWholeAndNew_data() {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<Hand>("hand");
        QTest::addColumn<QByteArray>("awaited");  // what is told before the moment is drawn; any change where empty
        const unsigned kills = qEnvironmentVariableIsSet("ECHOLUCENT_KILLS")
                                   ? qEnvironmentVariable("ECHOLUCENT_KILLS").toUInt()
                                   : (isLongRun() ? 12 : 3);
        for (unsigned kill = 0; kill < kills; ++kill) {
            switch (kill % 3) {
                case 0: QTest::addRow("kill %u, at any moment", kill) << kill << Hand::savesToo << QByteArray(); break;
                case 1:
                    QTest::addRow("kill %u, after an autosave", kill) << kill << Hand::onlyDrags << QByteArray(written);
                    break;
                default: QTest::addRow("kill %u, after a save", kill) << kill << Hand::savesToo << QByteArray(saved);
            }
        }
    }
    void whatIsOnDiskIsWholeAndNew() {
        QFETCH(unsigned, seed);
        QFETCH(Hand, hand);
        QFETCH(QByteArray, awaited);
        std::mt19937 random(seed);
        const QString folder = temporaryFolder().filePath(QString("kill-%1").arg(seed));
        QVERIFY(QDir().mkpath(folder));
        QVERIFY(QFile::copy(m_scan, folder + "/scan.mha"));
        QProcess child;
        child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        QStringList words{sessionUntilKilled, folder, QString::number(random())};
        if (hand == Hand::onlyDrags) words << neverSaves;
        child.start(QCoreApplication::applicationFilePath(), words);
        QVERIFY(child.waitForStarted());
        QList<QByteArray> told;  // changes
        // So many changes were there when each began that is under way, and so many are on disk.
        qsizetype begunWriting = 0, begunSaving = 0, safe = 0;
        int waits = 0, longest = 0;  // whole intervals in which what changed first was not begun to be written
        bool toldWritten = false, toldSaved = false;
        const auto hear = [&] {
            while (child.canReadLine()) {
                const QByteArray line = child.readLine().trimmed();
                if (line == writingBegins || line == savingBegins) {
                    (line == writingBegins ? begunWriting : begunSaving) = told.size();
                    waits = 0;
                } else if (line == written || line == saved) {
                    safe = std::max(safe, line == written ? begunWriting : begunSaving);
                    (line == written ? toldWritten : toldSaved) = true;
                } else if (line == intervalOver) {
                    waits = told.size() > std::max(begunWriting, begunSaving) ? waits + 1 : 0;
                    longest = std::max(longest, waits);
                } else {
                    told << line;
                }
            }
        };
        const QDeadlineTimer patience(60000);
        const auto awaits = [&] {
            return told.isEmpty() || (awaited == written && !toldWritten) || (awaited == saved && !toldSaved);
        };
        while (awaits()) {
            QVERIFY2(!patience.hasExpired() && child.waitForReadyRead(60000), "the program changes or keeps nothing");
            hear();
        }
        const QDeadlineTimer moment(static_cast<qint64>(random() % 3000));
        while (!moment.hasExpired())
            if (child.waitForReadyRead(static_cast<int>(std::max<qint64>(1, moment.remainingTime())))) hear();
        ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
        QVERIFY(child.waitForFinished());
        hear();
        m_changes += told.size();
        ++m_kills;

        QStringList files;
        for (const QFileInfo& info :
             QDir(folder + "/settings-data/autosaves").entryInfoList({"*.autosave.json"}, QDir::Files))
            files << info.filePath();
        m_withAutosave += files.isEmpty() ? 0 : 1;
        if (toldWritten && hand == Hand::onlyDrags) QCOMPARE(static_cast<int>(files.size()), 1);
        if (toldSaved) QVERIFY(QFile::exists(folder + "/scan.session.json"));
        if (QFile::exists(folder + "/scan.session.json")) {
            files << folder + "/scan.session.json";
            ++m_withSession;
        }
        m_halves += static_cast<int>(
            QDir(folder).entryList({"*.json.??????"}, QDir::Files).size() +
            QDir(folder + "/settings-data/autosaves").entryList({"*.json.??????"}, QDir::Files).size());
        qsizetype newest = -1;
        for (const QString& path : files) {
            const auto session = readSession(path.toStdString());
            QVERIFY2(session, session ? "" : qPrintable(QString::fromStdString(session.error().sentence())));
            const QByteArray print = fingerprint(session->document);
            for (qsizetype i = told.size() - 1; i > newest; --i)
                if (told[i] == print) newest = i;
        }
        QVERIFY2(newest + 1 >= safe, qPrintable(QString("%1 of %2 changes are on disk, and %3 were told to be")
                                                    .arg(newest + 1)
                                                    .arg(told.size())
                                                    .arg(safe)));
        QVERIFY2(longest <= bound, qPrintable(QString("a change waited for %1 intervals").arg(longest)));
        m_longest = std::max(m_longest, longest);
        QVERIFY(QDir(folder).removeRecursively());
    }
    void cleanupTestCase() {
        std::printf(
            "killed %d times in %lld changes: %d left an autosave, %d a session file, %d the unnamed beginning of "
            "one; a change waited for at most %d intervals (bound %d)\n",
            m_kills, static_cast<long long>(m_changes), m_withAutosave, m_withSession, m_halves, m_longest, bound);
        if (m_kills >= 12) QVERIFY(m_withAutosave >= m_kills / 3 && m_withSession >= m_kills / 3);
    }

private:
    QString m_scan;
    int m_kills = 0, m_withAutosave = 0, m_withSession = 0, m_halves = 0;
    int m_longest = 0;
    qint64 m_changes = 0;
};

ECHOLUCENT_TEST_CLASS(TestSessionKill, "whatIsOnDiskIsWholeAndNew")

#include "test_session_kill.moc"
