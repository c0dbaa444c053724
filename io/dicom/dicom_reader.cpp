#include "io/dicom/dicom_reader.h"

#include <pthread.h>

#include <exception>
#include <functional>

#include "io/dicom/dicom_study.h"

namespace echolucent {

namespace {

// DCMTK recurses where data sets nest and when it frees them. The scan refuses deep nesting; this is the second net,
// for files that DCMTK reads in another way than the scan does. Only touched pages cost memory.
constexpr std::size_t stackBytes = std::size_t{256} << 20;

/// Runs `work` in a thread of its own with a large stack and waits for it; exceptions come back to the caller.
void runWithLargeStack(const std::function<void()>& work) {
    struct Job {
        const std::function<void()>& work;
        std::exception_ptr thrown;
    } job{work, nullptr};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stackBytes);
    pthread_t thread{};
    const int started = pthread_create(
        &thread, &attributes,
        [](void* argument) -> void* {
            auto& own = *static_cast<Job*>(argument);
            try {
                own.work();
            } catch (...) {
                own.thrown = std::current_exception();
            }
            return nullptr;
        },
        &job);
    pthread_attr_destroy(&attributes);
    if (started != 0) {
        work();
        return;
    }
    pthread_join(thread, nullptr);
    if (job.thrown) std::rethrow_exception(job.thrown);
}

bool isVrLetter(char character) { return character >= 'A' && character <= 'Z'; }

}  // namespace

bool looksLikeDicom(std::string_view beginning) {
    if (beginning.size() >= 132 && beginning.substr(128, 4) == "DICM") return true;
    // A file without preamble begins with an element of the meta header (0002,xxxx) or the data set (0008,xxxx).
    if (beginning.size() < 16) return false;
    const auto byte = [&](std::size_t index) { return static_cast<unsigned char>(beginning[index]); };
    const bool little = (byte(0) == 0x02 || byte(0) == 0x08) && byte(1) == 0x00;
    const bool big = byte(0) == 0x00 && byte(1) == 0x08;
    if (!little && !big) return false;
    if (isVrLetter(beginning[4]) && isVrLetter(beginning[5])) return true;
    // Without value representations, a short first value in a low element gives it away.
    return little && byte(3) <= 0x01 && byte(5) == 0 && byte(6) == 0 && byte(7) == 0 && byte(4) > 0 && byte(4) % 2 == 0;
}

Result<Study> readDicom(const InputFile& file, const ReadOptions& options, const Progress& progress) {
    Result<Study> study = fail(FailureKind::unreadable, file.path(), "", "was not read");
    runWithLargeStack([&] {
        const auto loaded = DicomFile::load(file, false, progress);
        study = loaded ? readMultiframe(*loaded, options, progress) : Result<Study>(tl::unexpected(loaded.error()));
    });
    return study;
}

Result<Study> readDicomFolder(const std::string& path, const ReadOptions& options, const Progress& progress) {
    Result<Study> study = fail(FailureKind::unreadable, path, "", "was not read");
    runWithLargeStack([&] { study = readSeriesFolder(path, options, progress); });
    return study;
}

}  // namespace echolucent
