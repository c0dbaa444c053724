#include "io/dicom/dicom_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrma.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/oflog/oflog.h>
#include <fmt/format.h>

#include <algorithm>
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

/// Hands the bytes of an opened file to DCMTK, until the person cancels.
class FileProducer : public DcmProducer {
public:
    FileProducer(InputFile file, std::uint64_t position, const Progress* progress)
        : m_file(std::move(file)), m_position(std::min(position, m_file.size())), m_progress(progress) {}
    [[nodiscard]] OFBool good() const override { return status().good(); }
    [[nodiscard]] OFCondition status() const override {
        return m_failed || (m_progress != nullptr && m_progress->cancelled()) ? EC_InvalidStream : EC_Normal;
    }
    OFBool eos() override { return m_position >= m_file.size(); }
    offile_off_t avail() override { return static_cast<offile_off_t>(m_file.size() - m_position); }
    offile_off_t read(void* bytes, offile_off_t count) override {
        const auto length = static_cast<std::size_t>(within(count));
        if (!m_file.readAt(m_position, {static_cast<std::uint8_t*>(bytes), length})) {
            m_failed = true;
            return 0;
        }
        m_position += length;
        return static_cast<offile_off_t>(length);
    }
    offile_off_t skip(offile_off_t count) override {
        const std::uint64_t skipped = within(count);
        m_position += skipped;
        return static_cast<offile_off_t>(skipped);
    }
    void putback(offile_off_t count) override { m_position -= std::min(static_cast<std::uint64_t>(count), m_position); }

private:
    [[nodiscard]] std::uint64_t within(offile_off_t count) const {
        return count < 0 ? 0 : std::min(static_cast<std::uint64_t>(count), m_file.size() - m_position);
    }
    InputFile m_file;
    std::uint64_t m_position;
    const Progress* m_progress;
    bool m_failed = false;
};

/// The stream from which DCMTK parses: its own file stream opens files by name and cannot be cancelled, and a file may
/// be made so that parsing takes minutes (elements in descending order are sorted in one by one).
class FileStream : public DcmInputStream {
public:
    // The base class only keeps the pointer until the first read.
    FileStream(const InputFile& file, std::uint64_t position, const Progress* progress)
        : DcmInputStream(&m_producer), m_file(file), m_start(position), m_producer(file, position, progress) {}
    /// Lets DCMTK read long values later; what is compressed has to be read at once.
    [[nodiscard]] DcmInputStreamFactory* newFactory() const override;

private:
    InputFile m_file;
    std::uint64_t m_start;
    FileProducer m_producer;
};

/// Makes streams that begin where a long value does.
class FileStreamFactory : public DcmInputStreamFactory {
public:
    FileStreamFactory(InputFile file, std::uint64_t position) : m_file(std::move(file)), m_position(position) {}
    [[nodiscard]] DcmInputStream* create() const override { return new FileStream(m_file, m_position, nullptr); }
    [[nodiscard]] DcmInputStreamFactory* clone() const override { return new FileStreamFactory(*this); }
    [[nodiscard]] DcmInputStreamFactoryType ident() const override { return DFT_DcmInputFileStreamFactory; }

private:
    InputFile m_file;
    std::uint64_t m_position;
};

DcmInputStreamFactory* FileStream::newFactory() const {
    if (currentProducer() != &m_producer) return nullptr;
    return new FileStreamFactory(m_file, m_start + static_cast<std::uint64_t>(tell()));
}

}  // namespace

DicomFile::DicomFile(std::string path, DicomScan scan)
    : m_path(std::move(path)), m_scan(std::move(scan)), m_file(std::make_unique<DcmFileFormat>()) {}
DicomFile::DicomFile(DicomFile&&) noexcept = default;
DicomFile& DicomFile::operator=(DicomFile&&) noexcept = default;
DicomFile::~DicomFile() = default;

DcmDataset& DicomFile::dataset() const { return *m_file->getDataset(); }

Result<DicomFile> DicomFile::load(const InputFile& input, bool headerOnly, const Progress& progress) {
    quietLibrary();
    const std::string& path = input.path();
    auto scan = scanDicom(input, progress);
    if (!scan) return tl::unexpected(scan.error());
    if (auto refused = refusal(path, *scan)) return tl::unexpected(*refused);
    DicomFile file(path, *scan);
    FileStream stream(input, 0, &progress);
    file.m_file->transferInit();
    const OFCondition done = file.m_file->readUntilTag(stream, EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                                                       headerOnly ? DCM_PixelData : DCM_UndefinedTagKey);
    file.m_file->transferEnd();
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    if (done.bad())
        return fail(FailureKind::unreadable, path, "",
                    fmt::format("is damaged or not DICOM ({})", lowerCase(done.text())), "Copy or export it again.");
    return file;
}

Result<DicomFile> DicomFile::load(const std::string& path, bool headerOnly, const Progress& progress) {
    const auto input = InputFile::open(path);
    if (!input) return tl::unexpected(input.error());
    return load(*input, headerOnly, progress);
}

}  // namespace echolucent
