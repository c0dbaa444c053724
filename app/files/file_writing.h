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

/// Writes one file at a time. Tells the end of a cancelled file too: a failure with FailureKind::cancelled, or success
/// if the file was whole before it was cancelled.
class FileWriting {
public:
    /// Runs in the thread and polls progress.cancelled(). If it is cancelled in time, it leaves no file and fails with
    /// FailureKind::cancelled. What it throws becomes a failure that names `path`.
    using Write = std::function<Result<void>(const Progress& progress)>;
    /// Runs in the thread that made this object.
    using Tell = std::function<void(const Result<void>& written)>;

    /// `work` describes the writing. If it has no `cancel`, it gets cancel() of this object.
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
