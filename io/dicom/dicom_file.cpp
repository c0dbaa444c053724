#include "io/dicom/dicom_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrmf.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/oflog/oflog.h>
#include <fmt/format.h>

#include <mutex>

#include "io/headers/header_text.h"

namespace echolucent {

namespace {

/// Silences DCMTK, whose own messages go to stderr and may hold patient data.
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

/// Reads a file, until the person cancels.
class CancellableProducer : public DcmProducer {
public:
    CancellableProducer(const std::string& path, const Progress& progress)
        : m_file(path.c_str()), m_progress(progress) {}
    [[nodiscard]] OFBool good() const override { return m_file.good() && !m_progress.cancelled(); }
    [[nodiscard]] OFCondition status() const override {
        return m_progress.cancelled() ? EC_InvalidStream : m_file.status();
    }
    OFBool eos() override { return m_file.eos(); }
    offile_off_t avail() override { return m_file.avail(); }
    offile_off_t read(void* bytes, offile_off_t count) override { return m_file.read(bytes, count); }
    offile_off_t skip(offile_off_t count) override { return m_file.skip(count); }
    void putback(offile_off_t count) override { m_file.putback(count); }

private:
    DcmFileProducer m_file;
    const Progress& m_progress;
};

/// The stream from which DCMTK parses: its own file stream cannot be cancelled, and a file may be made so that parsing
/// takes minutes (elements in descending order are sorted in one by one).
class CancellableStream : public DcmInputStream {
public:
    // The base class only keeps the pointer until the first read.
    CancellableStream(const std::string& path, const Progress& progress)
        : DcmInputStream(&m_producer), m_path(path), m_producer(path, progress) {}
    /// Lets DCMTK read long values later; what is compressed has to be read at once.
    [[nodiscard]] DcmInputStreamFactory* newFactory() const override {
        if (currentProducer() != &m_producer) return nullptr;
        return new DcmInputFileStreamFactory(m_path.c_str(), tell());
    }

private:
    std::string m_path;
    CancellableProducer m_producer;
};

}  // namespace

DicomFile::DicomFile(std::string path, DicomScan scan)
    : m_path(std::move(path)), m_scan(std::move(scan)), m_file(std::make_unique<DcmFileFormat>()) {}
DicomFile::DicomFile(DicomFile&&) noexcept = default;
DicomFile& DicomFile::operator=(DicomFile&&) noexcept = default;
DicomFile::~DicomFile() = default;

DcmDataset& DicomFile::dataset() const { return *m_file->getDataset(); }

Result<DicomFile> DicomFile::load(const std::string& path, bool headerOnly, const Progress& progress) {
    quietLibrary();
    auto scan = scanDicom(path, progress);
    if (!scan) return tl::unexpected(scan.error());
    if (auto refused = refusal(path, *scan)) return tl::unexpected(*refused);
    DicomFile file(path, *scan);
    CancellableStream stream(path, progress);
    OFCondition done = stream.status();
    if (done.good()) {
        file.m_file->transferInit();
        done = file.m_file->readUntilTag(stream, EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                                         headerOnly ? DCM_PixelData : DCM_UndefinedTagKey);
        file.m_file->transferEnd();
    }
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    if (done.bad())
        return fail(FailureKind::unreadable, path, "",
                    fmt::format("is damaged or not DICOM ({})", lowerCase(done.text())), "Copy or export it again.");
    return file;
}

}  // namespace echolucent
