#include "app/files/file_writing.h"

#include <exception>
#include <new>
#include <utility>

namespace echolucent {

namespace {

Result<void> writtenBy(const FileWriting::Write& write, const std::string& path, const Progress& progress) {
    try {
        return write(progress);
    } catch (const std::bad_alloc&) {
        return fail(FailureKind::unwritable, path, {}, "needs more memory than this machine has");
    } catch (const std::exception& problem) {
        return fail(FailureKind::unwritable, path, {}, std::string("could not be written: ") + problem.what());
    }
}

}  // namespace

FileWriting::FileWriting(Works& works, const QString& threadName, const Work& work)
    : m_thread(works, threadName, withCancel(work, [this] { cancel(); })) {}

FileWriting::~FileWriting() { cancel(); }

void FileWriting::begin(const QString& path, Write write, Tell tell) {
    m_cancel = std::make_shared<std::atomic<bool>>(false);
    // The thread drops the result of a job that it cancels itself. This flag only ends the work.
    m_thread.submit([path = path.toStdString(), write = std::move(write), tell = std::move(tell),
                     cancel = m_cancel](const Progress& progress) -> NewestWinsThread::Deliver {
        const auto written = writtenBy(write, path, {progress.report, cancel.get()});
        return [tell, written] { tell(written); };
    });
}

void FileWriting::cancel() {
    if (m_cancel) *m_cancel = true;
}

QString cancelledSentence(const QString& names) {
    return QObject::tr("Writing %1 was cancelled; no file is left of it.").arg(names);
}

}  // namespace echolucent
