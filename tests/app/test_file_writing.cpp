// What becomes of a file that is being written is told, however it ends.
#include <QCoreApplication>
#include <QSemaphore>
#include <QTest>
#include <QThread>
#include <optional>
#include <stdexcept>

#include "app/files/file_writing.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestFileWriting : public QObject {
    Q_OBJECT

    Works m_works;

    std::optional<Result<void>> m_told;

    /// Begins to write in this way and waits for the end.
    Result<void> endOf(FileWriting& writing, FileWriting::Write write, bool cancels = false) {
        m_told.reset();
        writing.begin("heart.mp4", std::move(write), [this](const Result<void>& written) { m_told = written; });
        if (cancels) writing.cancel();
        if (!QTest::qWaitFor([this] { return m_told.has_value(); }, 30000)) qFatal("nothing was told");
        return *m_told;
    }
    static Result<void> untilCancelled(const Progress& progress) {
        while (!progress.cancelled()) QThread::yieldCurrentThread();
        return fail(FailureKind::cancelled, "heart.mp4", {}, "was cancelled");
    }

private slots:
    void theEndIsToldHoweverItComes() {
        FileWriting writing(m_works, "test", {});
        QVERIFY(endOf(writing, [](const Progress&) { return Result<void>(); }));
        QCOMPARE(endOf(writing, untilCancelled, true).error().kind, FailureKind::cancelled);
        // What was whole before it was cancelled is there, and told of.
        QSemaphore cancelled;
        m_told.reset();
        writing.begin(
            "heart.mp4",
            [&](const Progress&) {
                cancelled.acquire();
                return Result<void>();
            },
            [this](const Result<void>& written) { m_told = written; });
        writing.cancel();
        cancelled.release();
        QTRY_VERIFY(m_told.has_value());
        QVERIFY(m_told->has_value());
        QTRY_VERIFY(!writing.busy());
    }

    void whatIsThrownIsAFailureOfTheFile() {
        FileWriting writing(m_works, "test", {});
        const auto broken = endOf(writing, [](const Progress&) -> Result<void> { throw std::runtime_error("no PNG"); });
        QCOMPARE(broken.error().file, std::string("heart.mp4"));
        QVERIFY(broken.error().sentence().find("no PNG") != std::string::npos);
        const auto large = endOf(writing, [](const Progress&) -> Result<void> { throw std::bad_alloc(); });
        QVERIFY(large.error().sentence().find("memory") != std::string::npos);
    }

    void itsEndEndsWhatIsWrittenAndTellsNothing() {
        m_told.reset();
        {
            FileWriting writing(m_works, "test", {});
            writing.begin("heart.mp4", untilCancelled, [this](const Result<void>& written) { m_told = written; });
        }
        QCoreApplication::processEvents();
        QVERIFY(!m_told);
    }
};

ECHOLUCENT_TEST_CLASS(TestFileWriting)
#include "test_file_writing.moc"
