// Writes files in a thread of their own, and always tells how that ended.
#pragma once

#include <QString>
#include <atomic>
#include <functional>
#include <memory>

#include "processing/progress.h"
#include "processing/result.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Writes one file at a time. A cancelled one is told of too: as cancelled, or as written if it was whole before.
class FileWriting {
public:
    /// Runs in the thread and polls progress.cancelled(). If it is cancelled in time, it leaves no file and fails with
    /// FailureKind::cancelled. What it throws becomes a failure that names `path`.
    using Write = std::function<Result<void>(const Progress& progress)>;
    /// Runs in this object's thread.
    using Tell = std::function<void(const Result<void>& written)>;

    /// A work without a cancel gets cancel().
    FileWriting(Works& works, const QString& threadName, const Work& work);
    /// Cancels the file that is being written and waits for it. Nothing is told afterwards.
    ~FileWriting();
    FileWriting(const FileWriting&) = delete;
    FileWriting& operator=(const FileWriting&) = delete;

    /// Call it only if busy() is false.
    void begin(const QString& path, Write write, Tell tell);
    [[nodiscard]] bool busy() const { return m_thread.busy(); }
    void cancel();
    /// As NewestWinsThread::setWords().
    void setWords(const QString& words) { m_thread.setWords(words); }

private:
    std::shared_ptr<std::atomic<bool>> m_cancel;  ///< of the newest file; null before the first
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

/// "Writing heart.mp4 was cancelled; no file is left of it."
[[nodiscard]] QString cancelledSentence(const QString& names);

}  // namespace echolucent
