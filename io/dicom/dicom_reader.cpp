#include "io/dicom/dicom_reader.h"

#include "io/dicom/dicom_study.h"
#include "io/dicom/large_stack.h"
#include "io/series_list.h"

namespace echolucent {

namespace {

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
    const auto list = listSeries(path, progress);
    if (!list) return tl::unexpected(list.error());
    const auto entry = findSeries(*list, options.series);
    if (!entry) return tl::unexpected(entry.error());
    return readSeries(*list, **entry, options, progress);
}

}  // namespace echolucent
