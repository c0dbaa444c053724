#include "io/dicom/dicom_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/oflog/oflog.h>
#include <fmt/format.h>

#include <mutex>

#include "io/headers/header_text.h"

namespace echolucent {

namespace {

/// DCMTK's own messages go to stderr and may hold patient data: silence them.
void quietLibrary() {
    static std::once_flag once;
    std::call_once(once, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
}

std::optional<Failure> refusal(const std::string& path, const DicomScan& scan) {
    const auto refuse = [&](const std::string& element, const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unreadable, path, element, problem, remedy).value();
    };
    if (scan.sopClass == "1.2.840.10008.1.3.10")
        return refuse("", "is a DICOMDIR, a list of files and no image", "Open the folder that holds the images.");
    if (scan.sopClass == "1.2.840.113543.6.6.1.3.10002")
        return refuse("", "is a Philips QLAB Cartesian export, which cannot be read yet",
                      "Convert it to MetaImage, NRRD or DICOM slices.");
    if (scan.hasPixelData && scan.pixelBytesDeclared > scan.pixelBytesHeld)
        return refuse(
            "(7fe0,0010) Pixel Data",
            fmt::format("declares {} bytes where the file holds only {}", scan.pixelBytesDeclared, scan.pixelBytesHeld),
            "The file is incomplete: copy or export it again.");
    if (!scan.transferSyntax.empty() && DcmXfer(scan.transferSyntax.c_str()).getXfer() == EXS_Unknown)
        return refuse("(0002,0010) Transfer Syntax", "is " + quotedText(scan.transferSyntax) + ", which cannot be read",
                      "Save it uncompressed, or with RLE, JPEG, JPEG-LS or JPEG 2000.");
    return std::nullopt;
}

}  // namespace

DicomFile::DicomFile(std::string path, DicomScan scan)
    : m_path(std::move(path)), m_scan(std::move(scan)), m_file(std::make_unique<DcmFileFormat>()) {}
DicomFile::DicomFile(DicomFile&&) noexcept = default;
DicomFile& DicomFile::operator=(DicomFile&&) noexcept = default;
DicomFile::~DicomFile() = default;

DcmDataset& DicomFile::dataset() const { return *m_file->getDataset(); }

Result<DicomFile> DicomFile::load(const std::string& path, bool headerOnly) {
    quietLibrary();
    auto scan = scanDicom(path);
    if (!scan) return tl::unexpected(scan.error());
    if (auto refused = refusal(path, *scan)) return tl::unexpected(*refused);
    DicomFile file(path, *scan);
    const OFCondition done =
        file.m_file->loadFileUntilTag(path.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect,
                                      headerOnly ? DCM_PixelData : DCM_UndefinedTagKey);
    if (done.bad())
        return fail(FailureKind::unreadable, path, "",
                    fmt::format("is damaged or not DICOM ({})", lowerCase(done.text())), "Copy or export it again.");
    return file;
}

}  // namespace echolucent
