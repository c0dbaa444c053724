// Files that a person asked for are written in a thread of their own, and what became of them is always told.
#pragma once

#include <QString>
#include <atomic>
#include <functional>
#include <memory>

#include "processing/progress.h"
#include "processing/result.h"
#include "widgets/threads/newest_wins_thread.h"

namespace echolucent {

/// Writes one order at a time. One that was cancelled is told of like any other: as cancelled, or as written where it
/// was whole before.
class FileWriting {
public:
    /// Runs in the thread, and polls progress.cancelled(); where it was cancelled in time, it leaves no file and fails
    /// with FailureKind::cancelled. What it throws becomes a failure that names `path`.
    using Write = std::function<Result<void>(const Progress& progress)>;
    /// Runs in this object's thread.
    using Tell = std::function<void(const Result<void>& written)>;

    /// If the work has no cancel, it is cancel().
    FileWriting(Works& works, const QString& threadName, const Work& work);
    /// Cancels what is being written and waits for it; nothing is told afterwards.
    ~FileWriting();
    FileWriting(const FileWriting&) = delete;
    FileWriting& operator=(const FileWriting&) = delete;

    /// Nothing else may be under way (busy()).
    void begin(const QString& path, Write write, Tell tell);
    [[nodiscard]] bool busy() const { return m_thread.busy(); }
    void cancel();
    /// As NewestWinsThread::setWords().
    void setWords(const QString& words) { m_thread.setWords(words); }

private:
    std::shared_ptr<std::atomic<bool>> m_cancel;  ///< of what was begun last; null before the first
    // Last, so that its thread has ended before anything above is destroyed.
    NewestWinsThread m_thread;
};

/// "Writing heart.mp4 was cancelled; no file is left of it."
[[nodiscard]] QString cancelledSentence(const QString& names);

}  // namespace echolucent
