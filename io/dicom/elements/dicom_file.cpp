#include "io/dicom/elements/dicom_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/oflog/oflog.h>
#include <fmt/format.h>

#include <mutex>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/elements/dicom_parse.h"
#include "io/files/input_problems.h"

namespace echolucent {

namespace {

/// Silences DCMTK, whose messages go to stderr and may hold patient data. Lets DCMTK read values of VR UN as its
/// dictionary says.
void prepareLibrary() {
    static std::once_flag once;
    std::call_once(once, [] {
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        dcmEnableUnknownVRConversion.set(OFTrue);
    });
}

bool isDeflated(const DicomScan& scan) {
    return DcmXfer(scan.transferSyntax.c_str()).getStreamCompression() != ESC_none;
}

/// Why DCMTK must not get the file, by where the scan ended; no value if it may. It may get every QLAB file with
/// pixels. It must not get a file with DicomScan::lacking, nor broken deflated data. Of other damaged files it may get
/// those whose pixels end before the damage, and a DICOMDIR that is cut.
std::optional<Failure> whereItEnds(const std::string& path, const DicomScan& scan, bool qlab) {
    const auto refuse = [&](const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unreadable, path, "", problem, remedy).value();
    };
    // The lengths that QLAB declares are often false. readPhilipsVolume() looks at what the file holds.
    if (qlab && scan.hasPixelData) return std::nullopt;
    if (const auto& lacking = scan.lacking)
        return fail(FailureKind::unreadable, path, tagText(lacking->tag),
                    fmt::format("declares {} bytes where the file holds only {}", lacking->bytesDeclared,
                                lacking->bytesHeld),
                    damagedFile)
            .value();
    // DCMTK gets no broken deflated data, even if everything before the damage is whole. DCMTK takes memory for each
    // deflated value before it looks for the bytes, and behind damage it may read other lengths than the walk did.
    const bool mayGoOn = !isDeflated(scan);
    // The reader of a DICOMDIR itself finds out which of the listed files are there.
    if (mayGoOn && scan.sopClass == directorySopClass && scan.end == DicomScanEnd::cut) return std::nullopt;
    switch (scan.end) {
        case DicomScanEnd::inMeta:
            return refuse(fmt::format("ends after {} bytes, before its data set begins", scan.fileBytes), damagedFile);
        case DicomScanEnd::deflate:
            return refuse(fmt::format("holds deflated data that end too early or are damaged, after {} bytes unpacked",
                                      scan.endPosition),
                          damagedFile);
        case DicomScanEnd::cut:
            if (mayGoOn && scan.pixelsEnd) return std::nullopt;
            return refuse(fmt::format("ends after {} bytes in the middle of an element", scan.fileBytes), damagedFile);
        case DicomScanEnd::damaged:
            if (mayGoOn && scan.pixelsEnd) return std::nullopt;
            return refuse(fmt::format("is damaged: what stands at byte {} is no DICOM element", scan.endPosition),
                          copyAgain);
        default: return std::nullopt;
    }
}

std::optional<Failure> refusal(const std::string& path, const DicomScan& scan, bool qlab) {
    const auto refuse = [&](const std::string& element, const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unreadable, path, element, problem, remedy).value();
    };
    if (!qlab && scan.hasPixelData && scan.pixelBytesDeclared > scan.pixelBytesHeld)
        return refuse(
            "(7fe0,0010) Pixel Data",
            fmt::format("declares {} bytes where the file holds only {}", scan.pixelBytesDeclared, scan.pixelBytesHeld),
            incompleteFile);
    const E_TransferSyntax syntax = DcmXfer(scan.transferSyntax.c_str()).getXfer();
    if (!scan.transferSyntax.empty() && syntax == EXS_Unknown)
        return refuse("(0002,0010) Transfer Syntax",
                      "is " + transferSyntaxName(scan.transferSyntax) + ", which cannot be read",
                      "Save it uncompressed, or with RLE, JPEG, JPEG-LS or JPEG 2000.");
    if (auto stopped = whereItEnds(path, scan, qlab)) return stopped;
    if (qlab) return std::nullopt;
    if (scan.pixelBytesDeclared > 0 && DcmXfer(syntax).isEncapsulated())
        return refuse("(7fe0,0010) Pixel Data",
                      "is not split into fragments, as the transfer syntax (" +
                          transferSyntaxName(scan.transferSyntax) + ") needs",
                      "The transfer syntax (0002,0010) is false: export it again.");
    if (scan.pixelsInFragments && !DcmXfer(syntax).isEncapsulated())
        return refuse("(7fe0,0010) Pixel Data",
                      scan.transferSyntax.empty()
                          ? std::string("is split into fragments, and no transfer syntax says how they are coded")
                          : "is split into fragments, which the transfer syntax (" +
                                transferSyntaxName(scan.transferSyntax) + ") does not have",
                      "The transfer syntax (0002,0010) is false: export it again.");
    return std::nullopt;
}

/// Why DCMTK could not go on, in words.
tl::unexpected<Failure> damaged(const InputFile& input, const DicomParsed& parsed) {
    const auto refuse = [&](const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unreadable, input.path(), "", problem, remedy);
    };
    switch (parsed.end) {
        case DicomParseEnd::tooDeep: return refuse(nestedTooDeep(), doNotOpen);
        case DicomParseEnd::tooMuch: return refuse(tooManyElements(), doNotOpen);
        case DicomParseEnd::damaged:
            return refuse(fmt::format("is damaged: what stands before byte {} is no DICOM element", parsed.position),
                          copyAgain);
        default:
            return refuse(fmt::format("ends after {} bytes in the middle of an element", input.size()), damagedFile);
    }
}

bool beginsAsDicom(const InputFile& input) {
    const auto beginning = input.beginning(132);
    return beginning && looksLikeDicom(*beginning);
}

}  // namespace

DicomFile::DicomFile(std::string path, DicomScan scan)
    : m_path(std::move(path)), m_scan(std::move(scan)), m_dataset(std::make_unique<DcmDataset>()) {}
DicomFile::DicomFile(DicomFile&&) noexcept = default;
DicomFile& DicomFile::operator=(DicomFile&&) noexcept = default;
DicomFile::~DicomFile() = default;

DcmDataset& DicomFile::dataset() const { return *m_dataset; }

Result<DicomFile> DicomFile::load(const InputFile& input, bool headerOnly, const Progress& progress) {
    prepareLibrary();
    const std::string& path = input.path();
    if (!beginsAsDicom(input))
        return fail(FailureKind::unreadable, path, "", "does not begin as a DICOM file does",
                    "Copy or export it again, or name it as what it is.");
    auto scan = scanDicom(input, progress, headerOnly);
    if (!scan) return tl::unexpected(scan.error());
    const bool qlab = scan->sopClass == qlabSopClass;
    const bool pixelsWanted = !headerOnly && !qlab;
    if (auto refused = refusal(path, *scan, qlab)) return tl::unexpected(*refused);
    DicomFile file(path, *scan);
    const DicomParsed parsed = parseDicom(file.dataset(), input, *scan, pixelsWanted, progress);
    if (progress.cancelled()) return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
    const bool whole = parsed.end == DicomParseEnd::whole;
    if (whole && (!pixelsWanted || !scan->usedBytes)) return file;
    const bool enough = pixelsWanted && scan->pixelsEnd && file.dataset().tagExists(DCM_PixelData);
    if (!whole && !enough) return damaged(input, parsed);
    file.m_scan.notes.emplace_back("What stands behind the pixels is no DICOM; it is left out.");
    return file;
}

Result<DicomFile> DicomFile::loadRest(const InputFile& input, const Progress& progress) {
    prepareLibrary();
    if (!beginsAsDicom(input))
        return fail(FailureKind::unreadable, input.path(), "", "does not begin as a DICOM file does", copyAgain);
    auto scan = scanDicom(input, progress, true);
    if (!scan) return tl::unexpected(scan.error());
    if (scan->lacking || isDeflated(*scan))
        if (auto refused = whereItEnds(input.path(), *scan, false)) return tl::unexpected(*refused);
    DicomFile file(input.path(), *scan);
    const DicomParsed parsed = parseDicom(file.dataset(), input, *scan, false, progress);
    if (progress.cancelled()) return fail(FailureKind::cancelled, input.path(), "", "was not read: cancelled");
    if (parsed.end == DicomParseEnd::tooDeep || parsed.end == DicomParseEnd::tooMuch) return damaged(input, parsed);
    return file;
}

Result<DicomFile> DicomFile::load(const std::string& path, bool headerOnly, const Progress& progress) {
    const auto input = InputFile::open(path);
    if (!input) return tl::unexpected(input.error());
    return load(*input, headerOnly, progress);
}

}  // namespace echolucent
