// What was left behind is written whatever follows it.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>
#include <array>

#include "app/sessions/autosave.h"
#include "io/document/session_file.h"

using namespace echolucent;

class TestAutosave : public QObject {
    Q_OBJECT

    SavedSession m_present;

    /// What has arrived in a pipe since it was read last.
    static QByteArray readPipe(int pipe) {
        QByteArray bytes;
        std::array<char, 4096> part{};
        for (ssize_t count = 0; (count = ::read(pipe, part.data(), part.size())) > 0;) bytes.append(part.data(), count);
        return bytes;
    }
    void change(Autosave& autosave, double speed) {
        m_present.document.motion.speed = speed;
        autosave.noteChange();
    }

private slots:
    void whatIsLeftBehindIsWrittenWhateverFollows() {
        const QTemporaryDir folder;
        Autosave autosave(folder.path(), [this] { return m_present; });
        autosave.setInterval(0);
        // A pipe that nobody reads yet holds the first write up.
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

    void theFilesLieInTheFolderWhateverItsName() {
        const QTemporaryDir folder;
        const QString inside = folder.filePath(QStringLiteral("50%1 %2"));
        Autosave autosave(inside, [this] { return m_present; });
        autosave.setInterval(0);
        QVERIFY2(autosave.file().startsWith(inside + '/'), qPrintable(autosave.file()));
        change(autosave, 2.0);
        QTRY_VERIFY(readSession(autosave.file().toStdString()).has_value());
    }
};

QTEST_GUILESS_MAIN(TestAutosave)
#include "test_autosave.moc"
