#include "io/dicom/dicom_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrma.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/oflog/oflog.h>
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <span>
#include <stdexcept>

#include "io/dicom/dicom_names.h"

namespace echolucent {

namespace {

/// Silences DCMTK, whose own messages go to stderr and may hold patient data, and lets it take values of VR UN for what
/// its dictionary knows of them.
void prepareLibrary() {
    static std::once_flag once;
    std::call_once(once, [] {
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        dcmEnableUnknownVRConversion.set(OFTrue);
    });
}

std::optional<Failure> refusal(const std::string& path, const DicomScan& scan) {
    const auto refuse = [&](const std::string& element, const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unreadable, path, element, problem, remedy).value();
    };
    if (scan.hasPixelData && scan.pixelBytesDeclared > scan.pixelBytesHeld)
        return refuse(
            "(7fe0,0010) Pixel Data",
            fmt::format("declares {} bytes where the file holds only {}", scan.pixelBytesDeclared, scan.pixelBytesHeld),
            "The file is incomplete: copy or export it again.");
    const E_TransferSyntax syntax = DcmXfer(scan.transferSyntax.c_str()).getXfer();
    if (!scan.transferSyntax.empty() && syntax == EXS_Unknown)
        return refuse("(0002,0010) Transfer Syntax",
                      "is " + transferSyntaxName(scan.transferSyntax) + ", which cannot be read",
                      "Save it uncompressed, or with RLE, JPEG, JPEG-LS or JPEG 2000.");
    if (scan.pixelBytesDeclared > 0 && DcmXfer(syntax).isEncapsulated())
        return refuse("(7fe0,0010) Pixel Data",
                      "is not split into fragments, as the transfer syntax (" +
                          transferSyntaxName(scan.transferSyntax) + ") needs",
                      "The transfer syntax (0002,0010) is false: export it again.");
    return std::nullopt;
}

/// The bytes of an opened file with its repairs.
class RepairedBytes {
public:
    RepairedBytes(InputFile file, std::vector<DicomRepair> repairs) : m_file(std::move(file)), m_size(m_file.size()) {
        std::ranges::sort(repairs, {}, &DicomRepair::offset);
        for (const DicomRepair& repair : repairs)
            m_size = std::max<std::uint64_t>(m_size, repair.offset + repair.bytes.size());
        m_repairs = std::make_shared<const std::vector<DicomRepair>>(std::move(repairs));
    }
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// Fills `bytes` from `position` on; they lie within size().
    [[nodiscard]] bool read(std::uint64_t position, std::span<std::uint8_t> bytes) const {
        const std::uint64_t held = m_file.size() - std::min(position, m_file.size());
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), held));
        if (!m_file.readAt(position, bytes.first(count))) return false;
        const std::uint64_t end = position + bytes.size();
        // Repairs do not overlap, so that their ends are in order as well.
        auto repair = std::ranges::lower_bound(*m_repairs, position + 1, {},
                                               [](const DicomRepair& one) { return one.offset + one.bytes.size(); });
        for (; repair != m_repairs->end() && repair->offset < end; ++repair)
            for (std::uint64_t at = std::max(position, repair->offset);
                 at < std::min<std::uint64_t>(end, repair->offset + repair->bytes.size()); ++at)
                bytes[static_cast<std::size_t>(at - position)] =
                    static_cast<std::uint8_t>(repair->bytes[static_cast<std::size_t>(at - repair->offset)]);
        return true;
    }

private:
    InputFile m_file;
    std::shared_ptr<const std::vector<DicomRepair>> m_repairs;  // copies share them: DCMTK makes one a long value
    std::uint64_t m_size;
};

/// Hands the bytes of a file to DCMTK, until the person cancels.
class FileProducer : public DcmProducer {
public:
    FileProducer(RepairedBytes file, std::uint64_t position, const Progress* progress)
        : m_file(std::move(file)), m_position(std::min(position, m_file.size())), m_progress(progress) {}
    [[nodiscard]] OFBool good() const override { return status().good(); }
    [[nodiscard]] OFCondition status() const override {
        return m_failed || (m_progress != nullptr && m_progress->cancelled()) ? EC_InvalidStream : EC_Normal;
    }
    OFBool eos() override { return m_position >= m_file.size(); }
    offile_off_t avail() override { return static_cast<offile_off_t>(m_file.size() - m_position); }
    offile_off_t read(void* bytes, offile_off_t count) override {
        const std::span whole(static_cast<std::uint8_t*>(bytes), static_cast<std::size_t>(within(count)));
        std::span rest = whole;
        while (!rest.empty()) {
            const std::size_t taken = take(rest);
            if (taken == 0) return 0;
            rest = rest.subspan(taken);
        }
        return static_cast<offile_off_t>(whole.size());
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
    /// Copies what comes next into the front of `bytes`; returns how much, 0 where it cannot be read. DCMTK asks for
    /// headers in pieces of two bytes, so that a block is kept.
    std::size_t take(std::span<std::uint8_t> bytes) {
        const bool kept = m_position >= m_blockStart && m_position < m_blockStart + m_block.size();
        if (!kept && bytes.size() >= blockBytes) {
            m_failed = !m_file.read(m_position, bytes);
            m_position += m_failed ? 0 : bytes.size();
            return m_failed ? 0 : bytes.size();
        }
        if (!kept) {
            m_block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(blockBytes, m_file.size() - m_position)));
            m_blockStart = m_position;
            m_failed = !m_file.read(m_position, m_block);
            if (m_failed) return 0;
        }
        const auto from = static_cast<std::size_t>(m_position - m_blockStart);
        const std::size_t count = std::min(bytes.size(), m_block.size() - from);
        std::copy_n(m_block.begin() + static_cast<std::ptrdiff_t>(from), count, bytes.begin());
        m_position += count;
        return count;
    }

    static constexpr std::size_t blockBytes = 8192;
    RepairedBytes m_file;
    std::uint64_t m_position;
    const Progress* m_progress;
    std::vector<std::uint8_t> m_block;
    std::uint64_t m_blockStart = 0;
    bool m_failed = false;
};

/// The stream from which DCMTK parses: its own file stream opens files by name and cannot be cancelled, and a file may
/// be made so that parsing takes minutes (elements in descending order are sorted in one by one).
class FileStream : public DcmInputStream {
public:
    // The base class only keeps the pointer until the first read.
    FileStream(const RepairedBytes& file, std::uint64_t position, const Progress* progress)
        : DcmInputStream(&m_producer), m_file(file), m_start(position), m_producer(file, position, progress) {}
    /// Lets DCMTK read long values later; what is compressed has to be read at once.
    [[nodiscard]] DcmInputStreamFactory* newFactory() const override;

private:
    RepairedBytes m_file;
    std::uint64_t m_start;
    FileProducer m_producer;
};

/// Makes streams that begin where a long value does.
class FileStreamFactory : public DcmInputStreamFactory {
public:
    FileStreamFactory(RepairedBytes file, std::uint64_t position) : m_file(std::move(file)), m_position(position) {}
    [[nodiscard]] DcmInputStream* create() const override { return new FileStream(m_file, m_position, nullptr); }
    [[nodiscard]] DcmInputStreamFactory* clone() const override { return new FileStreamFactory(*this); }
    [[nodiscard]] DcmInputStreamFactoryType ident() const override { return DFT_DcmInputFileStreamFactory; }

private:
    RepairedBytes m_file;
    std::uint64_t m_position;
};

OFCondition parse(DcmFileFormat& file, DcmInputStream& stream, const DcmTagKey& end) {
    file.transferInit();
    OFCondition done;
    try {
        done = file.readUntilTag(stream, EXS_Unknown, EGL_noChange, DCM_MaxReadLength, end);
    } catch (const std::out_of_range&) {
        done = EC_CorruptedData;  // DCMTK 3.6.7 stumbles over damaged names of directory records
    }
    file.transferEnd();
    return done;
}

/// Says in words why DCMTK could not go on.
tl::unexpected<Failure> damaged(const InputFile& input, const OFCondition& done, std::uint64_t position) {
    const bool atEnd = position >= input.size() || done == EC_StreamNotifyClient || done == EC_EndOfStream;
    if (!atEnd)
        return fail(FailureKind::unreadable, input.path(), "",
                    fmt::format("is damaged: what stands before byte {} is no DICOM element", position),
                    "Copy or export it again.");
    return fail(FailureKind::unreadable, input.path(), "",
                fmt::format("ends after {} bytes in the middle of an element", input.size()),
                "The file is incomplete or damaged: copy or export it again.");
}

/// Whether the file begins with a preamble, or with an element that a data set or its meta header begins with.
bool beginsAsDicom(const InputFile& input) {
    const auto beginning = input.beginning(132);
    return beginning && looksLikeDicom(*beginning);
}

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
    prepareLibrary();
    const std::string& path = input.path();
    if (!beginsAsDicom(input))
        return fail(FailureKind::unreadable, path, "", "does not begin as a DICOM file does",
                    "Copy or export it again, or name it as what it is.");
    auto scan = scanDicom(input, progress, headerOnly);
    if (!scan) return tl::unexpected(scan.error());
    // The lengths that QLAB declares are often false; its reader looks at what the file holds.
    const bool qlab = scan->sopClass == qlabSopClass;
    const bool pixelsWanted = !headerOnly && !qlab;
    if (auto refused = qlab ? std::nullopt : refusal(path, *scan); refused) return tl::unexpected(*refused);
    DicomFile file(path, *scan);
    FileStream stream(RepairedBytes(input, scan->repairs), 0, &progress);
    const OFCondition done = parse(*file.m_file, stream, pixelsWanted ? DCM_UndefinedTagKey : DCM_PixelData);
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    if (done.good()) return file;
    if (!pixelsWanted || !scan->pixelsEnd || !file.dataset().tagExists(DCM_PixelData))
        return damaged(input, done, static_cast<std::uint64_t>(stream.tell()));
    file.m_scan.notes.emplace_back("What stands behind the pixels is no DICOM; it is left out.");
    return file;
}

Result<DicomFile> DicomFile::load(const std::string& path, bool headerOnly, const Progress& progress) {
    const auto input = InputFile::open(path);
    if (!input) return tl::unexpected(input.error());
    return load(*input, headerOnly, progress);
}

}  // namespace echolucent
