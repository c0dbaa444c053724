#include "io/dicom/elements/dicom_scan.h"

#include "io/dicom/elements/dicom_walk.h"

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
    // Without value representations, look for a short first value in an element of a low number.
    return little && byte(3) <= 0x01 && byte(5) == 0 && byte(6) == 0 && byte(7) == 0 && byte(4) > 0 && byte(4) % 2 == 0;
}

Result<DicomScan> scanDicom(const InputFile& file, const Progress& progress, bool headerOnly) {
    const std::string& path = file.path();
    DicomScan scan;
    DicomWalk walk(file, scan, progress);
    walk.run(headerOnly);
    if (const auto harm = walk.harm())
        return fail(FailureKind::unreadable, path, harm->element, harm->problem, harm->remedy);
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    return scan;
}

}  // namespace echolucent
