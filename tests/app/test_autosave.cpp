// What is kept of a session is on disk, whatever follows and whatever fails for a while.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <fstream>
#include <memory>

#include "app/sessions/autosave.h"
#include "io/document/session_file.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestAutosave : public QObject {
    Q_OBJECT

    Works m_works;

    SavedSession m_present;

    /// What has arrived in a pipe since it was read last.
    static QByteArray readPipe(int pipe) {
        QByteArray bytes;
        std::array<char, 4096> part{};
        for (ssize_t count = 0; (count = ::read(pipe, part.data(), part.size())) > 0;) bytes.append(part.data(), count);
        return bytes;
    }
    /// A pipe that nobody reads yet holds a write up; files are written as always.
    static Result<void> writeIntoPipes(const std::string& file, const SavedSession& session) {
        struct stat present {};
        if (stat(file.c_str(), &present) != 0 || !S_ISFIFO(present.st_mode)) return writeSession(file, session);
        std::ofstream(file) << jsonOf(session);
        return {};
    }
    void change(Autosave& autosave, double speed) {
        m_present.document.motion.speed = speed;
        autosave.noteChange();
    }
    std::unique_ptr<Autosave> autosaveIn(const QString& folder) {
        auto autosave = std::make_unique<Autosave>(m_works, folder, [this] { return m_present; });
        autosave->setInterval(0);
        autosave->setWrite(&writeIntoPipes);
        return autosave;
    }
    /// What an earlier run left, with its lock held.
    static Autosave::Left leftBefore(const QTemporaryDir& folder, const QString& name) {
        const QString file = folder.filePath(name + QStringLiteral(".autosave.json"));
        auto lock = std::make_shared<QLockFile>(Autosave::lockOf(file));
        return {writeSession(file.toStdString(), SavedSession{}) && lock->tryLock(0) ? file : QString(), lock};
    }
    /// The speed in the session that the file holds; 0 where it holds none.
    static double speedIn(const QString& file) {
        const auto session = readSession(file.toStdString());
        return session ? session->document.motion.speed : 0.0;
    }

private slots:
    void whatIsLeftBehindIsWrittenWhateverFollows() {
        const QTemporaryDir folder;
        Autosave autosave(m_works, folder.path(), [this] { return m_present; });
        autosave.setInterval(0);
        autosave.setWrite(&writeIntoPipes);
        const QByteArray first = autosave.file().toUtf8();
        QCOMPARE(mkfifo(first.constData(), 0600), 0);
        change(autosave, 2.0);
        QTRY_VERIFY(autosave.busy());
        m_present.document.motion.speed = 4.0;
        const Autosave::Left left = autosave.leaveBehind();
        QCOMPARE(left.file.toUtf8(), first);
        // The next study's changes come while that one is still being written.
        const QString second = autosave.file();
        change(autosave, 8.0);
        QTRY_VERIFY(readSession(second.toStdString()).has_value());
        QCOMPARE(readSession(second.toStdString())->document.motion.speed, 8.0);
        QVERIFY(autosave.busy());

        const int pipe = ::open(first.constData(), O_RDONLY | O_NONBLOCK);
        QVERIFY(pipe >= 0);
        QByteArray written;
        QTRY_VERIFY(written.append(readPipe(pipe)).contains("\"speed\": 4.0"));
        QTRY_VERIFY(!autosave.busy());
        ::close(pipe);
    }

    void whatIsLeftBehindIsWrittenWhereTheProgramEnds() {
        const QTemporaryDir folder;
        auto autosave = autosaveIn(folder.path());
        const QByteArray first = autosave->file().toUtf8();
        QCOMPARE(mkfifo(first.constData(), 0600), 0);
        change(*autosave, 2.0);
        QTRY_VERIFY(autosave->busy());
        m_present.document.motion.speed = 4.0;
        const Autosave::Left left = autosave->leaveBehind();
        // The first write goes on, and nobody hears of its end: the newest still waits.
        const int pipe = ::open(first.constData(), O_RDONLY | O_NONBLOCK);
        QVERIFY(pipe >= 0);
        autosave.reset();
        QVERIFY(readPipe(pipe).contains("\"speed\": 4.0"));
        ::close(pipe);
    }

    void whatIsToGoGoesWhereTheProgramEnds() {
        const QTemporaryDir folder;
        auto autosave = autosaveIn(folder.path());
        const QByteArray file = autosave->file().toUtf8();
        QCOMPARE(mkfifo(file.constData(), 0600), 0);
        change(*autosave, 2.0);
        QTRY_VERIFY(autosave->busy());
        const Autosave::Left before = leftBefore(folder, QStringLiteral("before"));
        QVERIFY(QFile::exists(before.file));
        autosave->replace(before);
        autosave->forget();
        const int pipe = ::open(file.constData(), O_RDONLY | O_NONBLOCK);
        QVERIFY(pipe >= 0);
        autosave.reset();
        QVERIFY(!QFile::exists(before.file));
        QVERIFY(!QFile::exists(file));
        ::close(pipe);
    }

    void whatIsToGoGoesWhateverFollows() {
        const QTemporaryDir folder;
        const auto autosave = autosaveIn(folder.path());
        const QByteArray file = autosave->file().toUtf8();
        QCOMPARE(mkfifo(file.constData(), 0600), 0);
        change(*autosave, 2.0);
        QTRY_VERIFY(autosave->busy());
        // While that is written, a session that was left is opened and nothing of it is to be kept; so is another.
        const Autosave::Left before = leftBefore(folder, QStringLiteral("before"));
        QVERIFY(QFile::exists(before.file));
        autosave->replace(before);
        autosave->forget();
        const Autosave::Left next = leftBefore(folder, QStringLiteral("next"));
        QVERIFY(QFile::exists(next.file));
        autosave->replace(next);
        change(*autosave, 4.0);
        QTRY_VERIFY(!autosave->waits());
        QVERIFY(QFile::exists(before.file));
        QVERIFY(QFile::exists(next.file));
        const int pipe = ::open(file.constData(), O_RDONLY | O_NONBLOCK);
        QVERIFY(pipe >= 0);
        QTRY_VERIFY(!autosave->busy());
        QVERIFY(!QFile::exists(before.file));
        QVERIFY(!QFile::exists(next.file));
        ::close(pipe);
    }

    void whatCouldNotBeWrittenIsTriedAgain() {
        const QTemporaryDir folder;
        const auto autosave = autosaveIn(folder.path());
        QSignalSpy failed(autosave.get(), &Autosave::failed);
        const QString file = autosave->file();
        // A folder in its place, which no file can take.
        QVERIFY(QDir().mkpath(file));
        change(*autosave, 2.0);
        QTRY_COMPARE(failed.count(), 1);
        // It is tried again and again, and said once.
        QSignalSpy tries(&m_works, &Works::changed);
        QTRY_VERIFY(tries.count() >= 4);
        QCOMPARE(failed.count(), 1);
        QVERIFY(autosave->keeps());
        QVERIFY(QDir().rmdir(file));
        QTRY_COMPARE(speedIn(file), 2.0);
    }

    void whatWasForgottenIsNotTriedAgain() {
        const QTemporaryDir folder;
        const auto autosave = autosaveIn(folder.path());
        QSignalSpy failed(autosave.get(), &Autosave::failed);
        const QString file = autosave->file();
        QVERIFY(QDir().mkpath(file));
        change(*autosave, 2.0);
        QTRY_COMPARE(failed.count(), 1);
        autosave->forget();
        QTRY_VERIFY(!autosave->busy());
        QVERIFY(QDir().rmdir(file));
        // What is written next is the next change, and nothing before it.
        QSignalSpy written(autosave.get(), &Autosave::written);
        change(*autosave, 4.0);
        QTRY_COMPARE(speedIn(file), 4.0);
        QTRY_VERIFY(!autosave->busy());
        QCOMPARE(written.count(), 1);
        autosave->forget();
        QTRY_VERIFY(!autosave->busy());
        QVERIFY(!QFile::exists(file));
    }

    void aFolderThatIsNotThereIsTriedAgain() {
        const QTemporaryDir folder;
        const QString inside = folder.filePath(QStringLiteral("autosaves"));
        QFile inTheWay(inside);
        QVERIFY(inTheWay.open(QFile::WriteOnly));
        const auto autosave = autosaveIn(inside);
        QSignalSpy failed(autosave.get(), &Autosave::failed);
        change(*autosave, 2.0);
        QTRY_COMPARE(failed.count(), 1);
        // So is what was left behind meanwhile.
        const Autosave::Left left = autosave->leaveBehind();
        change(*autosave, 4.0);
        QTRY_VERIFY(!autosave->waits());
        QCOMPARE(failed.count(), 1);
        QVERIFY(inTheWay.remove());
        QTRY_COMPARE(speedIn(left.file), 2.0);
        QVERIFY(left.lock->isLocked());
        QTRY_COMPARE(speedIn(autosave->file()), 4.0);
    }

    void whatFailedWhenItWasLeftIsTriedAgain() {
        const QTemporaryDir folder;
        auto autosave = autosaveIn(folder.path());
        QSignalSpy failed(autosave.get(), &Autosave::failed);
        QVERIFY(QDir().mkpath(autosave->file()));
        m_present.document.motion.speed = 2.0;
        const Autosave::Left first = autosave->leaveBehind();
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(QDir().rmdir(first.file));
        QTRY_COMPARE(speedIn(first.file), 2.0);
        QTRY_VERIFY(!autosave->busy());
        // Also where the program ends before that.
        autosave->setInterval(600'000);
        QVERIFY(QDir().mkpath(autosave->file()));
        m_present.document.motion.speed = 4.0;
        const Autosave::Left second = autosave->leaveBehind();
        QTRY_COMPARE(failed.count(), 2);
        QVERIFY(QDir().rmdir(second.file));
        autosave.reset();
        QCOMPARE(speedIn(second.file), 4.0);
    }

    void whatWasLeftAndLetGoOfIsNotTriedAgain() {
        const QTemporaryDir folder;
        auto autosave = autosaveIn(folder.path());
        QSignalSpy failed(autosave.get(), &Autosave::failed);
        const QString file = autosave->file();
        QVERIFY(QDir().mkpath(file));
        m_present.document.motion.speed = 2.0;
        autosave->setInterval(600'000);
        autosave->leaveBehind();
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(QDir().rmdir(file));
        autosave.reset();
        QVERIFY(!QFile::exists(file));
    }

    void whatTheSessionTakesThePlaceOfStaysWhereItCannotBeWritten() {
        const QTemporaryDir folder;
        const QString inside = folder.filePath(QStringLiteral("autosaves"));
        QFile inTheWay(inside);
        QVERIFY(inTheWay.open(QFile::WriteOnly));
        const Autosave::Left before = leftBefore(folder, QStringLiteral("before"));
        QVERIFY(QFile::exists(before.file));
        auto autosave = autosaveIn(inside);
        autosave->replace(before);
        autosave->keepAtEnd(true);
        autosave.reset();
        QVERIFY(QFile::exists(before.file));
    }

    void theFilesLieInTheFolderWhateverItsName() {
        const QTemporaryDir folder;
        const QString inside = folder.filePath(QStringLiteral("50%1 %2"));
        const auto autosave = autosaveIn(inside);
        QVERIFY2(autosave->file().startsWith(inside + '/'), qPrintable(autosave->file()));
        change(*autosave, 2.0);
        QTRY_COMPARE(speedIn(autosave->file()), 2.0);
    }
};

ECHOLUCENT_TEST_CLASS(TestAutosave)
#include "test_autosave.moc"
