#include "io/restricted/restricted_reader.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>

#include "io/dicom/series/dicom_directory.h"
#include "io/file_formats.h"
#include "io/files/file_access.h"
#include "io/files/input_file.h"
#include "io/files/input_problems.h"
#include "io/restricted/reader_process.h"
#include "io/restricted/request.h"
#include "io/restricted/shared_study.h"
#include "io/restricted/taken_words.h"

namespace echolucent::restricted {

namespace {

/// The process that waits for the next request.
class Spare {
public:
    void prepare(Readiness readiness) {
        const std::lock_guard alone(m_access);
        m_always = m_always || readiness == Readiness::always;
        fill();
    }
    void dismiss() {
        const std::lock_guard alone(m_access);
        m_always = false;
        m_waiting.reset();
    }
    /// The waiting process, or null.
    std::unique_ptr<ReaderProcess> take() {
        const std::lock_guard alone(m_access);
        return std::exchange(m_waiting, nullptr);
    }
    void refill() {
        const std::lock_guard alone(m_access);
        if (m_always) fill();
    }

private:
    void fill() {
        if (m_waiting) return;
        if (auto started = ReaderProcess::start(m_always)) m_waiting = std::move(*started);
    }
    std::mutex m_access;
    bool m_always = false;
    std::unique_ptr<ReaderProcess> m_waiting;
};

Spare& spare() {
    static Spare spare;
    return spare;
}

Request requestFor(Task task, const std::string& path = {}) {
    Request request;
    request.task = task;
    request.path = path;
    request.threads = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    return request;
}

Result<ReaderProcess::Answer> ask(const Request& request, FileBroker broker, const std::string& file,
                                  const Progress& progress) {
    if (progress.cancelled()) return fail(FailureKind::cancelled, file, "", "was not read: cancelled");
    const std::string bytes = messageOf(request);
    if (auto waiting = spare().take(); waiting && waiting->request(bytes)) {
        auto answer = waiting->serve(broker, file, progress);
        const bool counts = answer || waiting->hasBegun() || answer.error().kind == FailureKind::cancelled;
        waiting.reset();
        spare().refill();
        // A process may end while it waits. It has read nothing then, so ask another.
        if (counts) return answer;
    }
    auto started = ReaderProcess::start(false);
    if (!started) return tl::unexpected(started.error());
    // If the process has ended since, serve() finds out.
    static_cast<void>((*started)->request(bytes));
    auto answer = (*started)->serve(broker, file, progress);
    spare().refill();
    return answer;
}

tl::unexpected<Failure> noSense(const std::string& file) {
    return fail(FailureKind::unreadable, file, "",
                "was not read: the process that reads files answered what makes no sense", doNotOpen);
}

tl::unexpected<Failure> refused(Failure failure) {
    makeHarmless(failure);
    return tl::unexpected(std::move(failure));
}

MessageReader readerOf(const ReaderProcess::Answer& answer) {
    return MessageReader({reinterpret_cast<const std::uint8_t*>(answer.bytes.data()), answer.bytes.size()});
}

/// Whether the reader asked for all these files. The workstation later opens them, for a checksum or for their patient.
bool haveBeenAskedFor(const std::vector<std::string>& files, const std::set<std::string>& asked) {
    return std::ranges::all_of(files, [&](const std::string& file) { return asked.contains(file); });
}

bool haveBeenAskedFor(const SeriesList& list, const std::set<std::string>& asked) {
    return haveBeenAskedFor(list.files, asked) && std::ranges::all_of(list.series, [&](const SeriesEntry& entry) {
               return std::ranges::all_of(entry.files,
                                          [&](const SeriesFile& file) { return asked.contains(file.path); });
           });
}

/// Whether an entry has the files of its phases.
bool isSound(const SeriesEntry& entry) {
    const auto files = static_cast<std::int64_t>(entry.files.size());
    const SeriesPhases& phases = entry.phases;
    const bool timed = phases.seconds.empty() || static_cast<std::int64_t>(phases.seconds.size()) == phases.count;
    return files > 0 && timed && phases.count > 0 && phases.count <= files && files % phases.count == 0;
}

template <typename Value>
Result<Value> valueOf(const Result<ReaderProcess::Answer>& answer, const std::string& file) {
    if (!answer) return tl::unexpected(answer.error());
    std::optional<Failure> failure;
    std::optional<Value> value;
    MessageReader reader = readerOf(*answer);
    reader(failure, value);
    if (!reader.complete() || failure.has_value() == value.has_value()) return noSense(file);
    if (failure) return refused(std::move(*failure));
    makeHarmless(*value);
    return std::move(*value);
}

/// The study may name only files that its reader asked for, or those in `listed`. These are the files of a list of
/// series, for which the reader that made the list has asked.
Result<Study> studyOf(const Result<ReaderProcess::Answer>& answer, const std::string& file,
                      const std::vector<std::string>& listed = {}) {
    if (!answer) return tl::unexpected(answer.error());
    std::optional<Failure> failure;
    MessageReader reader = readerOf(*answer);
    reader(failure);
    if (!reader.good()) return noSense(file);
    if (failure) return refused(std::move(*failure));
    if (answer->files.size() != 1) return noSense(file);
    auto study = takeStudy(reader.rest(), answer->files.front());
    if (!study) return noSense(file);
    std::set<std::string> asked = answer->asked;
    asked.insert(listed.begin(), listed.end());
    if (!haveBeenAskedFor(study->files, asked)) return noSense(file);
    makeHarmless(*study);
    if (!answer->systemCallsFiltered)
        study->warnings.emplace_back(
            "The process that read this file was not restricted: the kernel does not filter its system calls.");
    return std::move(*study);
}

/// The first bytes of a file; empty if they cannot be read.
std::string beginningOf(const std::string& path) {
    const auto input = InputFile::open(path);
    return input ? input->beginning(4096).value_or("") : "";
}

/// Whether a file or folder may be DICOM, so that DICOM's tables must be loaded before reading.
bool mayBeDicom(const std::string& path) {
    if (fileAccess().kindOf(path) != FileKind::file) return true;
    const FileFormat* format = formatFromContent(beginningOf(path));
    return format == nullptr || format->needsDicomTables;
}

}  // namespace

void prepareReader(Readiness readiness) { spare().prepare(readiness); }
void dismissReader() { spare().dismiss(); }

Result<Study> readStudy(const std::string& path, const ReadOptions& options, const Progress& progress) {
    Request request = requestFor(Task::readStudy, path);
    request.options = options;
    request.mayBeDicom = mayBeDicom(path);
    request.wantsCoarse = progress.coarse != nullptr;
    return studyOf(ask(request, FileBroker(path), path, progress), path);
}

Result<SeriesList> listSeries(const std::string& path, const Progress& progress) {
    const auto answer = ask(requestFor(Task::listSeries, path), FileBroker(path), path, progress);
    auto list = valueOf<SeriesList>(answer, path);
    if (!list) return list;
    const bool areSound = std::all_of(list->series.begin(), list->series.end(), isSound);
    if (list->series.empty() || !areSound || list->path != path || !haveBeenAskedFor(*list, answer->asked))
        return noSense(path);
    return list;
}

bool holdsSeries(const std::string& path) {
    // Folders and other kinds of files need no reader.
    const FileKind kind = fileAccess().kindOf(path);
    if (kind != FileKind::file) return kind == FileKind::folder;
    if (!mayBeDirectory(beginningOf(path))) return false;
    return valueOf<bool>(ask(requestFor(Task::holdsSeries, path), FileBroker(path), path, {}), path).value_or(false);
}

Result<Study> readSeries(const SeriesList& list, const SeriesEntry& entry, const ReadOptions& options,
                         const Progress& progress) {
    Request request = requestFor(Task::readSeries);
    request.list = {list.path, {entry}, list.files, list.warnings};
    request.options = options;
    request.wantsCoarse = progress.coarse != nullptr;
    return studyOf(ask(request, FileBroker(list.path), list.path, progress), list.path, list.files);
}

Result<SmallPicture> middlePicture(const SeriesEntry& entry, int longestEdge, const Progress& progress) {
    Request request = requestFor(Task::middlePicture);
    request.list.series = {entry};
    request.longestEdge = longestEdge;
    std::vector<std::string> files;
    for (const SeriesFile& file : entry.files) files.push_back(file.path);
    const std::string& first = files.front();
    auto picture = valueOf<SmallPicture>(ask(request, FileBroker(files), first, progress), first);
    const bool sensible =
        !picture ||
        (picture->width > 0 && picture->height > 0 && picture->width <= longestEdge && picture->height <= longestEdge &&
         picture->grey.size() == static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height));
    return sensible ? std::move(picture) : noSense(first);
}

Result<Patient> readPatient(const std::vector<std::string>& files, const std::string& series,
                            const Progress& progress) {
    Request request = requestFor(Task::readPatient);
    request.files = files;
    request.series = series;
    const std::string& first = files.empty() ? series : files.front();
    return valueOf<Patient>(ask(request, FileBroker(files), first, progress), first);
}

}  // namespace echolucent::restricted
