// A signal that ends the window while it writes a movie leaves nothing of that movie behind.
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>

#include "io/output/interruption.h"
#include "tests/app/movie_fixture.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

constexpr const char* movieUntilASignal = "--movie-until-a-signal";

/// Opens a study, plays it and writes a movie of it, again and again, until a signal comes.
class MovieUntilASignal : public QObject {
public:
    explicit MovieUntilASignal(const QString& folder) : m_window(folder + "/settings.ini"), m_folder(folder) {
        m_window.resize(700, 520);
        connect(&m_window.otfs(), &PaneOtfs::computed, this, [this] {
            if (!std::exchange(m_begun, true)) write();
        });
        connect(&m_window.movieFiles(), &MovieFiles::ended, this, &MovieUntilASignal::write);
        m_window.show();
        m_window.open(folder + "/scan.mha");
    }

private:
    void write() {
        m_window.movieFiles().begin(FrameOutput::movie,
                                    {.path = m_folder + "/out/heart.mkv", .size = {256, 256}, .replace = true});
    }
    MainWindow m_window;
    QString m_folder;
    bool m_begun = false;
};

[[maybe_unused]] const bool movieIsRegistered =
    drivenPrograms()
        .try_emplace(movieUntilASignal, DrivenProgram{removeUnfinishedOnSignals,
                                                      [](const QStringList& words) {
                                                          const MovieUntilASignal movie(words.at(1));
                                                          return QApplication::exec();
                                                      }})
        .second;

}  // namespace

class TestEndedBySignal : public QObject, private MovieFixture {
    Q_OBJECT

    /// Starts a program with the signals as they are at a terminal: a test that runs in the background ignores some.
    static void start(QProcess& process, const QString& program, const QStringList& arguments) {
        process.setProcessChannelMode(QProcess::ForwardedChannels);
        process.setChildProcessModifier([] {
            for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
        });
        process.start(program, arguments);
        QVERIFY(process.waitForStarted());
    }
    /// Whether a process has a handler of its own for each of the signals that end it.
    static bool handlesSignals(qint64 process) {
        QFile status(QString("/proc/%1/status").arg(process));
        if (!status.open(QIODevice::ReadOnly)) return false;
        static const QRegularExpression caught("SigCgt:\\s*([0-9a-f]+)");
        const qulonglong mask =
            caught.match(QString::fromLatin1(status.readAll())).captured(1).toULongLong(nullptr, 16);
        const std::array ending{SIGINT, SIGTERM, SIGHUP};
        return std::ranges::all_of(ending, [mask](int signal) { return (mask >> (signal - 1) & 1U) != 0; });
    }

private slots:
    void initTestCase() { writeStudies(); }
    void leavesNothing_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl-C") << SIGINT;
        QTest::newRow("end") << SIGTERM;
        QTest::newRow("the terminal is gone") << SIGHUP;
    }
    void leavesNothing() {
        QFETCH(int, signal);
        const QString folder = temporaryFolder().filePath(QString("signal-%1").arg(signal));
        QVERIFY(QDir().mkpath(folder + "/out"));
        QVERIFY(QFile::copy(moving(), folder + "/scan.mha"));
        QProcess child;
        start(child, QCoreApplication::applicationFilePath(), {movieUntilASignal, folder});
        const QDir out(folder + "/out");
        // Something of the movie is there that is not the movie.
        QTRY_VERIFY_WITH_TIMEOUT(!out.entryList({"heart.mkv.*"}, QDir::Files).isEmpty(), 60000);
        ::kill(static_cast<pid_t>(child.processId()), signal);
        QVERIFY(child.waitForFinished());
        QCOMPARE(child.exitStatus(), QProcess::CrashExit);
        QCOMPARE(child.exitCode(), signal);  // which the parent sees
        QCOMPARE(out.entryList({"heart.mkv.*"}, QDir::Files), QStringList());
    }
    void theProgramTakesCareOfIt() {
        QProcess program;
        start(program, QStringLiteral(ECHOLUCENT_PROGRAM), {moving()});
        QTRY_VERIFY_WITH_TIMEOUT(handlesSignals(program.processId()), patience);
        program.terminate();
        QVERIFY(program.waitForFinished());
        QCOMPARE(program.exitCode(), SIGTERM);
    }
};

ECHOLUCENT_TEST_CLASS(TestEndedBySignal)

#include "test_ended_by_signal.moc"
