// The program is killed at random moments while a hand drags and saves: what is on disk is whole, and newer than the
// bound. The suite kills it 12 times; ECHOLUCENT_KILLS=200 does it as often as that.
#include <QCryptographicHash>
#include <QDir>
#include <QElapsedTimer>
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

using namespace echolucent;

namespace {

// As 10 s are to the program's own interval.
constexpr int interval = 800;  // ms
constexpr int bound = interval * 10'000 / Autosave::standardIntervalMilliseconds;

/// A document by what a hand changes of it: the study's path is another one in each file.
QByteArray fingerprint(Document document) {
    document.study = {};
    const std::string text = jsonOf(document);
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Md5).toHex();
}

/// Drags, saves and tells every change on stdout, until it is killed.
class Driven : public QObject {
public:
    Driven(const QString& folder, unsigned seed)
        : m_window(folder + "/settings.ini"), m_random(seed), m_folder(folder) {
        m_window.resize(700, 520);
        m_window.sessionKeeping().autosave().setInterval(interval);
        Document plain = m_window.document().document();
        lookOf(plain, 1) = Look{};
        m_window.document().begin(plain);
        connect(&m_window.session(), &Session::otfComputed, this, [this] {
            if (std::exchange(m_begun, true)) return;
            connect(&m_window.document(), &DocumentModel::changed, this, &Driven::tell);
            connect(&m_timer, &QTimer::timeout, this, &Driven::act);
            m_timer.start(15);
        });
        m_window.show();
        m_window.open(folder + "/scan.mha");
    }

private:
    void tell() {
        std::printf("%s\n", fingerprint(m_window.document().document()).constData());
        std::fflush(stdout);
    }
    void act() {
        QWindow* picture = m_window.windowHandle()->findChild<QWindow*>("view3d.surface");
        const auto place = [this] {
            return QPoint(60 + static_cast<int>(m_random() % 150), 60 + static_cast<int>(m_random() % 150));
        };
        switch (m_step++ % 12) {
            case 0: return QTest::mousePress(picture, Qt::LeftButton, {}, place());
            case 10: return QTest::mouseRelease(picture, Qt::LeftButton, {}, place());
            case 11:
                if (m_random() % 3 == 0) m_window.sessionKeeping().saveAs(m_folder + "/scan.session.json");
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
    QTimer m_timer;
    int m_step = 0;
    bool m_begun = false;
};

}  // namespace

class TestSessionKill : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { m_scan = file("scan.mha", {smallPhantom(PhantomScene::shapes, 5)}); }
    void whatIsOnDiskIsWholeAndNew_data() {
        QTest::addColumn<unsigned>("seed");
        const unsigned kills =
            qEnvironmentVariableIsSet("ECHOLUCENT_KILLS") ? qEnvironmentVariable("ECHOLUCENT_KILLS").toUInt() : 12;
        for (unsigned kill = 0; kill < kills; ++kill) QTest::addRow("kill %u", kill) << kill;
    }
    void whatIsOnDiskIsWholeAndNew() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        const QString folder = temporaryFolder().filePath(QString("kill-%1").arg(seed));
        QVERIFY(QDir().mkpath(folder));
        QVERIFY(QFile::copy(m_scan, folder + "/scan.mha"));
        QProcess child;
        child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        child.start(QCoreApplication::applicationFilePath(), {"--driven", folder, QString::number(random())});
        QVERIFY(child.waitForStarted());
        QElapsedTimer clock;
        clock.start();
        QList<QPair<QByteArray, qint64>> told;
        const auto hear = [&] {
            while (child.canReadLine()) told << qMakePair(child.readLine().trimmed(), clock.elapsed());
        };
        while (told.isEmpty()) {
            QVERIFY2(child.waitForReadyRead(60000), "the program changes nothing");
            hear();
        }
        const qint64 end = clock.elapsed() + random() % 3000;
        while (clock.elapsed() < end)
            if (child.waitForReadyRead(static_cast<int>(std::max<qint64>(1, end - clock.elapsed())))) hear();
        ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
        const qint64 killed = clock.elapsed();
        QVERIFY(child.waitForFinished());
        hear();
        m_changes += told.size();
        ++m_kills;

        QStringList files;
        for (const QFileInfo& info :
             QDir(folder + "/settings-data/autosaves").entryInfoList({"*.autosave.json"}, QDir::Files))
            files << info.filePath();
        m_withAutosave += files.isEmpty() ? 0 : 1;
        if (QFile::exists(folder + "/scan.session.json")) {
            files << folder + "/scan.session.json";
            ++m_withSession;
        }
        m_halves += static_cast<int>(
            QDir(folder).entryList({"*.json.??????"}, QDir::Files).size() +
            QDir(folder + "/settings-data/autosaves").entryList({"*.json.??????"}, QDir::Files).size());
        qsizetype newest = -1;
        for (const QString& saved : files) {
            const auto session = readSession(saved.toStdString());
            QVERIFY2(session, session ? "" : qPrintable(QString::fromStdString(session.error().sentence())));
            const QByteArray print = fingerprint(session->document);
            for (qsizetype i = told.size() - 1; i > newest; --i)
                if (told[i].first == print) newest = i;
        }
        const qint64 age = newest + 1 < told.size() ? killed - told[newest + 1].second : 0;
        QVERIFY2(age <= bound, qPrintable(QString("%1 ms old, of %2 changes").arg(age).arg(told.size())));
        m_oldest = std::max(m_oldest, age);
        QVERIFY(QDir(folder).removeRecursively());
    }
    void cleanupTestCase() {
        std::printf(
            "killed %d times in %lld changes: %d left an autosave, %d a session file, %d the unnamed beginning of "
            "one; the oldest was %lld ms behind (bound %d ms, interval %d ms)\n",
            m_kills, static_cast<long long>(m_changes), m_withAutosave, m_withSession, m_halves,
            static_cast<long long>(m_oldest), bound, interval);
        if (m_kills >= 12) QVERIFY(m_withAutosave > 0 && m_withSession > 0);
    }

private:
    QString m_scan;
    int m_kills = 0, m_withAutosave = 0, m_withSession = 0, m_halves = 0;
    qint64 m_changes = 0, m_oldest = 0;
};

int main(int count, char** arguments) {
    VolumeViewWidget::prepareApplication();
    QApplication application(count, arguments);
    if (count == 4 && QString(arguments[1]) == "--driven") {
        const Driven driven(arguments[2], QString(arguments[3]).toUInt());
        return QApplication::exec();
    }
    TestSessionKill test;
    return QTest::qExec(&test, count, arguments);
}

#include "test_session_kill.moc"
